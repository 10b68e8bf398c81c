//! A body that hangs in a spring: where it comes to rest.
//!
//! Told of gravity, the spring rests at `point + g/ω²` exactly. A body that keeps no remainders stops
//! nearby, where what a step would change rounds to nothing: there `(P - 1) y = r` with r no larger
//! than the roundings of one step, so that `|y| <= |(P - 1)^-1| r`. The dead zone is that of x: about
//! `2 ζ/q + 1/2` units of x and `1/(ω q)` of v. Weakly damped, roundings may keep a swing alive
//! instead; it obeys `|y| <= sum(|P^k|) r`, wider by about `1/(π ζ²)`. A body that keeps remainders
//! has no dead zone.

use std::fmt::Debug;

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{
    Body, Carried, DyadicStep, ExactSpring, Gravity, Point, Ratio, Step, TimeStep, dec,
    scalar::Carry,
};

use crate::exact_spring::flow::{Double, Matrix, flow, step_of};
use crate::exact_spring::hanging::{Case, POINT, case};
use crate::exact_spring::rounding::is_fixed;
use crate::exact_spring::splitting::{SPLITTINGS, Splitting};
use crate::support::*;

const DAMPING: [Ratio; 4] = [dec!(0.1), dec!(0.5), dec!(1), dec!(2)];

/// Errors along both axes at sixteen frequencies, in parts of `allowed`; `still` hears of each whether
/// the body stood.
fn parts<S: Format, B>(
    scheme: Splitting,
    zeta: Ratio,
    step: &impl TimeStep<S>,
    allowed: impl Fn(&Case<S>, usize) -> f64,
    mut still: impl FnMut(&Case<S>, bool),
) -> Vec<f64>
where
    B: Body<S = S> + From<Point<S>> + Debug + PartialEq,
{
    let mut errors = Vec::new();
    for i in 0..16 {
        let case = case(i, zeta, step.seconds());
        let (off, stood) = case.hung::<B>(scheme, step);
        errors.extend([0, 1].map(|k| off[k] / allowed(&case, k)));
        still(&case, stood);
    }
    errors
}

fn what<S: Format>(scheme: Splitting, zeta: Ratio, body: &str) -> String {
    let zeta = zeta.to_f64();
    format!(
        "{} {body} {scheme:?} ζ = {zeta:.1}, sag, of the allowance",
        S::name()
    )
}

/// From half the critical damping on, a body in fixed point stands still to the bit.
fn check<S: Format>() {
    let step = Step::<S>::hz(60).unwrap();
    let dyadic = DyadicStep::<S, 1, 6>::new().unwrap();
    for scheme in SPLITTINGS {
        for zeta in DAMPING {
            let allowed = |case: &Case<S>, k| case.allowed(scheme, k);
            let still = |case: &Case<S>, stands| {
                let stops = is_fixed::<S>() && case.zeta.to_f64() >= 0.5;
                assert!(stands || !stops, "{} at {} Hz", S::name(), case.hertz);
            };
            let mut errors = parts::<S, Point<S>>(scheme, zeta, &step, allowed, still);
            errors.extend(parts::<S, Point<S>>(scheme, zeta, &dyadic, allowed, still));
            within(1.0, &what::<S>(scheme, zeta, "Point"), &errors);
        }
    }
}

#[test]
fn a_spring_under_gravity_hangs_where_it_should() {
    check::<f32>();
    check::<I16F16>();
    if LAB {
        check::<f64>();
        check::<I12F20>();
        check::<I8F24>();
    }
}

/// A unit: half of one as the point of rest is rounded, half as the place of the body is. Its remainders are
/// seen to `2^-15` of a unit; the dead zone of a point, `2 ζ/q + 1/2 + 1/(ω q)` units at most 150 here, is
/// that much smaller: 0.01 more. Floats round the product and the sum of the sag as well: two.
fn check_carried<S: Format + Carry>() {
    let step = Step::<S>::hz(60).unwrap();
    let dyadic = DyadicStep::<S, 1, 6>::new().unwrap();
    for scheme in SPLITTINGS {
        for zeta in DAMPING {
            let allowed = |case: &Case<S>, k: usize| {
                let sag = case.rest[k] - POINT[k];
                let unit = S::unit(sag.abs().max(POINT[k]));
                if is_fixed::<S>() {
                    1.01 * unit
                } else {
                    2.0 * unit
                }
            };
            let mut errors = parts::<S, Carried<S>>(scheme, zeta, &step, allowed, |_, _| ());
            errors.extend(parts::<S, Carried<S>>(
                scheme,
                zeta,
                &dyadic,
                allowed,
                |_, _| (),
            ));
            within(1.0, &what::<S>(scheme, zeta, "Carried"), &errors);
        }
    }
}

#[test]
fn a_body_that_keeps_remainders_hangs_within_a_unit() {
    check_carried::<f32>();
    check_carried::<I16F16>();
    if LAB {
        check_carried::<f64>();
        check_carried::<I12F20>();
        check_carried::<I8F24>();
    }
}

/// A spring that is not told of gravity kicks its body by `h g` and swings on about `point`: where a step
/// ends, the fixed point is `(1 - P)^-1 P (0, h g)`, after the kick in the middle of `Verlet`
/// `(1 - P)^-1 P½ (0, h g)`. Undamped the sag is `q/2 cot(q/2)` of g/ω², in `Verlet`
/// `q/2 / sin(q/2)`: at 10 Hz and 60 Hz (q = 1.05) 0.907 and 1.047 of it.
fn told_nothing(mut scheme: Splitting, i: usize) -> f64 {
    let step = Step::<f64>::hz(60).unwrap();
    let case = case::<f64>(i, [dec!(0.1), dec!(0.7), dec!(1.6)][i % 3], step.seconds());
    let mut world = world([point::<f64>(POINT, [0.0; 2], 1.37)]);
    let at = vector(POINT[0], POINT[1]);
    let spring = ExactSpring::new(world.ids()[0], at, case.hertz, case.zeta).unwrap();
    let mut forces = (spring, Gravity::new(case.pull));
    for _ in 0..case.patience() {
        world.step(&mut scheme, &mut forces, &step);
    }
    let kicked = match scheme {
        Splitting::SemiImplicitEuler => case.whole,
        Splitting::Verlet => case.half,
    };
    let rest = Matrix::identity()
        .less(&case.whole)
        .inverse()
        .times(&kicked)
        .to_f64();
    let sag = rest[0][1] * case.pull.y * case.seconds / case.omega;
    (world.bodies()[0].position().y - POINT[1] - sag).abs()
}

/// Within the dead zone of a spring that is told, which `a_spring_under_gravity...` holds: 1e-13 m covers
/// it for f64, and the least of the sags is 3e-4 m.
#[test]
fn a_spring_that_is_not_told_hangs_off_by_its_law() {
    for scheme in SPLITTINGS {
        let errors: [f64; 16] = std::array::from_fn(|i| told_nothing(scheme, i));
        within(
            1e-13,
            &format!("f64 {scheme:?} sag without `under`"),
            &errors,
        );
    }
    // The closed forms, at 10 Hz and next to no damping.
    let (omega, whole) = step_of(dec!(10), dec!(0), Ratio::new(1, 60).unwrap());
    let q = omega.to_f64() / 60.0;
    let half = flow(Double::of(q / 2.0), Double::of(0.0));
    let of = |kicked: &Matrix| {
        Matrix::identity()
            .less(&whole)
            .inverse()
            .times(kicked)
            .to_f64()[0][1]
            * q
    };
    assert!((of(&whole) - 0.5 * q / (0.5 * q).tan()).abs() < 1e-14);
    assert!((of(&half) - 0.5 * q / (0.5 * q).sin()).abs() < 1e-14);
}
