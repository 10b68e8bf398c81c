//! The faults of the chart "what goes wrong", each against its derivation.

#[path = "../../examples/charts/wrong/clock.rs"]
mod clock;
#[path = "../../examples/charts/wrong/far.rs"]
mod far;
#[path = "../../examples/charts/wrong/rounding.rs"]
mod rounding;
#[path = "../../examples/charts/wrong/springs.rs"]
mod springs;

use std::f64::consts::TAU;

use fixstep::fixed::types::I16F16;
use fixstep::{Euler, SemiImplicitEuler, Verlet, World};

use crate::support::*;
use springs::{Q, doubling, euler_growth, held, held_growth, held_step};

const UNIT: f64 = 1.0 / 65536.0;

fn last(points: &[[f64; 2]]) -> f64 {
    points.last().map_or(f64::NAN, |point| point[1])
}

/// The area that a step makes of a unit square of the phase plane: its determinant. Four substeps of
/// ten roundings at most, of numbers below 2 ω.
#[test]
fn a_force_held_over_substeps_grows_as_derived() {
    for n in [1, 2, 4, 8] {
        let mut world: World<_, 1> = world([point([1.0, 0.0], [0.0, TAU], 1.0)]);
        held_step(n)(&mut world);
        let body = &world.bodies()[0];
        let (x, u) = (body.position(), body.velocity().map(|v| v / TAU));
        let error = (x.x * u.y - x.y * u.x - held_growth(Q, n)).abs();
        let bound = f64::from(10 * n) * 2.0 * TAU * f64::EPSILON;
        assert!(error <= bound, "{n}: {error:e}");
    }
}

/// The energy of every step of ten seconds lies within what its ellipse allows. That is why a run doubles
/// its energy for the first time up to 16 steps before or after the 169th.
#[test]
fn a_held_spring_doubles_its_energy_in_169_steps() {
    let (growth, half) = (held_growth(Q, 4), 5.0 / 16.0 * Q);
    let stretch = (1.0 + half) / (1.0 - half);
    for (n, [_, energy]) in held(4, 600, 1).into_iter().enumerate() {
        let share = energy / growth.powi(n as i32);
        assert!((1.0 / stretch..=stretch).contains(&share), "{n}: {share}");
    }
    // ln 2 / ln(1 + 3 q²/8), with q² = (2π/60)² = 0.010966227.
    assert!((doubling(growth) - 168.9).abs() <= 0.05);
    assert_eq!(doubling(growth).round(), 169.0);
}

/// Explicit Euler stretches the plane alike in all directions. Each of 600 steps rounds x by half a unit
/// and v by one, of a swing of 1 m or more; twice of that is energy. Of the others the energy stays within
/// the stretch of their ellipses, `x² + u² - q x u` and `x² + (1 - q²/4) u²`, and as much by rounding.
#[test]
fn euler_doubles_its_energy_in_64_steps_and_others_keep_it() {
    let rounding = 1.0 + 600.0 * 2.0 * 1.5 * UNIT;
    for (n, [_, energy]) in springs::by(Euler::new(), 600, 1).into_iter().enumerate() {
        let share = energy / euler_growth(Q).powi(n as i32);
        assert!((1.0 / rounding..=rounding).contains(&share), "{n}: {share}");
    }
    assert_eq!(doubling(euler_growth(Q)).round(), 64.0);
    let bound = rounding * (1.0 + Q / 2.0) / (1.0 - Q / 2.0);
    let semi = springs::by(SemiImplicitEuler, 600, 1);
    for [t, energy] in semi.into_iter().chain(springs::by(Verlet, 600, 1)) {
        assert!((1.0 / bound..=bound).contains(&energy), "{t} s: {energy}");
    }
}

/// `546 * 120 < 65536 <= 546 * 121`; of a loss to nearest, `546.13 * 60 < 32768`.
#[test]
fn drag_stops_where_its_loss_rounds_to_nothing() {
    assert_eq!(last(&rounding::naive_drag(400, 20)), 120.0);
    assert_eq!(last(&rounding::naive_drag(-400, 20)), 0.0);
    assert_eq!(last(&rounding::linear_drag(400, 20)), 60.0);
    assert_eq!(last(&rounding::exact_drag(400, 20)), 0.0);
    let exact = 400.0 * (-10.0_f64).exp();
    assert!((last(&rounding::exact(400, 20)) - exact).abs() <= 1e-12);
}

/// Half a unit a step, in mm.
#[test]
fn a_mirrored_pair_leaves_its_middle_by_half_a_unit_a_step() {
    assert_eq!(last(&rounding::naive_middle(60)), -1800.0 * UNIT * 1000.0);
    assert_eq!(last(&rounding::crate_middle(60)), 0.0);
}

/// 3600 steps of `1092/65536 * 1000` m, which `I16F16` holds exactly, less a turn of 65536 m; km.
#[test]
fn the_range_wraps_or_holds() {
    let wrapped = 3600.0 * 1_092_000.0 / 65536.0 - 65536.0;
    assert_eq!(last(&rounding::naive_flight(60)), wrapped / 1000.0);
    let held = I16F16::MAX.to_num::<f64>() / 1000.0;
    assert_eq!(last(&rounding::crate_flight(60)), held);
}

/// At 10^5 m a step of 60 Hz is nothing or a value of `f32`, 2^-7 m.
#[test]
fn f32_far_away_stands_or_runs() {
    assert_eq!(last(&far::cruise::<f32>(far::FLOAT, 0.2)), 0.0);
    assert_eq!(last(&far::cruise::<f32>(far::FLOAT, 0.3)), 600.0 / 128.0);
    // Near the origin 600 drifts round by half a value below 4 m, and h and v by 2^-25 of the path.
    let error = (last(&far::cruise::<f32>(0.0, 0.3)) - 3.0).abs();
    assert!(error <= 600.0 * 2.0_f64.powi(-23) + 3.0 * 2.0_f64.powi(-24));
    // Fixed point has the same bits everywhere.
    let (far, near) = (
        far::cruise::<I16F16>(far::FIXED, 0.3),
        far::cruise::<I16F16>(0.0, 0.3),
    );
    assert_eq!(far, near);
}

/// `g h² n` reaches 2^-8 m between steps 143 and 144; a point is taken at each sixth.
#[test]
fn f32_far_away_hangs_before_it_falls() {
    let falls = far::fall::<f32>(far::FLOAT);
    assert!(falls[..=23].iter().all(|&[_, moved]| moved == 0.0));
    assert_eq!(falls[24][1], -1.0 / 128.0);
    assert_eq!(far::fall::<I16F16>(far::FIXED), far::fall::<I16F16>(0.0));
    // `I16F16` rounds 300 drifts by half a unit, and its speed once.
    for ([t, moved], [_, exact]) in far::fall::<I16F16>(0.0).into_iter().zip(far::exact_fall()) {
        let error = (moved - exact).abs();
        assert!(
            error <= 300.0 * 0.5 * UNIT + 0.5 * UNIT * t,
            "{t} s: {error:e}"
        );
    }
}

/// The sum of a day, run through octave by octave: between `2^k` and `2^(k+1)` each step adds the same
/// whole number of values of `f32`, `2^(k-23)` apart. Only a step into another octave may round otherwise,
/// by a value of that: all of them to the last are less than 2^-6 s.
#[test]
fn seconds_that_are_added_up_run_as_their_octaves_say() {
    let (h, mut left) = (f64::from(1.0_f32 / 60.0), 24.0 * 216_000.0 - 1.0);
    let mut t = h;
    for k in -6..=16 {
        let (value, end) = (2.0_f64.powi(k - 23), 2.0_f64.powi(k + 1));
        let add = (h / value).round() * value;
        let steps = ((end - t) / add).ceil().min(left).max(0.0);
        (t, left) = (t + steps * add, left - steps);
    }
    assert_eq!(left, 0.0);
    let error = (last(&clock::added()) - (t - 86_400.0)).abs();
    assert!(error <= 2.0_f64.powi(-6), "{error}");
    // A clock of ticks is off by what `f32` rounds at a day, once.
    let off = clock::counted()
        .iter()
        .map(|point| point[1].abs())
        .collect::<Vec<_>>();
    assert!(maximum(&off) <= 2.0_f64.powi(-8));
}
