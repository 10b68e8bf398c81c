//! A million steps at constant speed: nothing is lost at a dyadic rate, and at 60 Hz no more than the
//! last digit of `h`.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Body, Carried, DyadicStep, Point, Scalar, SemiImplicitEuler, Step, TimeStep, Verlet, World,
};

use super::bits::{Fine, coef, places};
use crate::support::*;

const STEPS: u32 = 1_000_000;

/// Bodies that pass it are shifted back by as much, remainders and all.
const WRAP: f64 = 64.0;

/// 1.2345 m/s first, then others between 0.5 and 3 m/s, to either side.
fn speed(i: usize) -> f64 {
    match i {
        0 => 1.2345,
        _ => (0.5 + 2.5 * spread(i)) * if i.is_multiple_of(2) { 1.0 } else { -1.0 },
    }
}

type Scene<B> = World<B, 17>;

/// Where the bodies start, where they are after a million steps, and how often each was shifted.
struct Flight<B> {
    starts: Scene<B>,
    ends: Scene<B>,
    laps: [i64; 17],
}

fn fly<B, H>(scheme: Scheme, step: &H) -> Flight<B>
where
    B: Body<S: Format> + From<Point<B::S>> + std::fmt::Debug,
    H: TimeStep<B::S>,
{
    let start = |i: usize| point([WRAP * spread(i + 17), 0.0], [speed(i), 0.0], 1.0).into();
    let starts: Scene<B> = world(std::array::from_fn(start));
    let (mut ends, mut laps) = (starts.clone(), [0; 17]);
    let (end, back) = (scalar::<B::S>(WRAP), vector(-WRAP, 0.0));
    for _ in 0..STEPS {
        match scheme {
            Scheme::Verlet => ends.step(&mut Verlet, &mut (), step),
            _ => ends.step(&mut SemiImplicitEuler, &mut (), step),
        }
        for ((_, body), laps) in ends.iter_mut().zip(&mut laps) {
            let x = body.position().x;
            if x >= end {
                body.shift(back);
                *laps += 1;
            } else if x <= end.negated() {
                body.shift(-back);
                *laps -= 1;
            }
        }
    }
    Flight { starts, ends, laps }
}

/// Distance flown less `v t`, m, as positions are seen.
fn seen<B: Body>(flight: &Flight<B>, h: f64) -> [f64; 17] {
    std::array::from_fn(|i| {
        let (now, then) = (&flight.ends.bodies()[i], &flight.starts.bodies()[i]);
        let [to, from] = [now, then].map(|body| body.position().x.to_f64());
        let flown = to - from + WRAP * flight.laps[i] as f64;
        (flown - then.velocity().x.to_f64() * STEPS as f64 * h).abs()
    })
}

/// Units of `2^-32` of the type's flown less `v t`, for steps of `num / den` s: `(error, den)`.
fn exact<S: Fine>(flight: &Flight<Carried<S>>, num: i128, den: i128) -> [(i128, i128); 17] {
    let lap = (scalar::<S>(WRAP).units() as i128) << 32;
    std::array::from_fn(|i| {
        let (now, then) = (&flight.ends.bodies()[i], &flight.starts.bodies()[i]);
        let flown = places(now)[0] - places(then)[0] + lap * flight.laps[i] as i128;
        let path = ((then.velocity().x.units() as i128) << 32) * STEPS as i128 * num;
        (flown * den - path, den)
    })
}

/// `h` is a coefficient of 31 bits, off by at most `2^-31` of itself: the path, less than 50 km, by as
/// much. At 60 Hz the mantissa is 1145324612.27, of which 0.27 are lost: `2.34e-10`. A product is
/// rounded to `2^-32` units, `2^-33` off, once or twice a step.
fn bound<S: Format>(scheme: Scheme, speed: f64) -> f64 {
    let roundings = STEPS as f64 * scheme.drifts() * 2.0_f64.powi(-32) * S::unit(0.0);
    2.34e-10 * speed * STEPS as f64 / 60.0 + roundings
}

fn check_60_hz<S: Fine>(scheme: Scheme) {
    let step = Step::<S>::hz(60).unwrap();
    let flight = fly::<Carried<S>, _>(scheme, &step);
    let unit = S::unit(0.0) * 2.0_f64.powi(-32);
    let errors = exact(&flight, 1, 60).map(|(error, den)| (error as f64 / den as f64 * unit).abs());
    let what = format!("{} carried {scheme:?} 60 Hz, m", S::name());
    within(bound::<S>(scheme, 3.0), &what, &errors);
    if scheme == Scheme::SemiImplicitEuler {
        crate::carry::told(&format!("Carried<{}>", S::name()), 2, &errors);
    }
    for (i, error) in errors.into_iter().enumerate() {
        assert!(error <= bound::<S>(scheme, speed(i).abs()), "{what} {i}");
        // What was asked for: 1e-5 m, which `h` keeps up to 2.5 m/s.
        assert!(
            error <= 1e-5 || speed(i).abs() > 2.5,
            "{what} {i}: {error:e}"
        );
    }
    // A position is seen to half a unit.
    let half = 0.5 * S::unit(0.0);
    within(
        bound::<S>(scheme, 3.0) + half,
        &format!("{what}, as seen"),
        &seen(&flight, 1.0 / 60.0),
    );
    // The rest of the error is that of h, to the last digit: nothing else is lost.
    let h = coef::<S>(step.coef()) >> 26;
    for (error, _) in exact(&flight, h, 1 << 36) {
        let off = error as f64 / 2.0_f64.powi(36);
        assert!(off.abs() <= STEPS as f64 * scheme.drifts(), "{off}");
    }
}

#[test]
fn a_cruise_at_60_hz_is_off_by_the_last_digit_of_h_in_i16f16() {
    check_60_hz::<I16F16>(Scheme::SemiImplicitEuler);
    check_60_hz::<I16F16>(Scheme::Verlet);
}

#[test]
fn a_cruise_at_60_hz_is_off_by_the_last_digit_of_h_in_i8f24() {
    check_60_hz::<I8F24>(Scheme::SemiImplicitEuler);
    check_60_hz::<I8F24>(Scheme::Verlet);
}

fn check_exact<S: Fine>(step: &impl TimeStep<S>, num: i128, den: i128) {
    for scheme in [Scheme::SemiImplicitEuler, Scheme::Verlet] {
        let flight = fly::<Carried<S>, _>(scheme, step);
        for (i, (error, _)) in exact(&flight, num, den).into_iter().enumerate() {
            assert_eq!(error, 0, "{} {scheme:?} {num}/{den} body {i}", S::name());
        }
    }
}

fn check_dyadic<S: Fine>() {
    check_exact::<S>(&DyadicStep::<S, 1, 6>::new().unwrap(), 1, 64);
    check_exact::<S>(&DyadicStep::<S, 1, 7>::new().unwrap(), 1, 128);
    check_exact::<S>(&DyadicStep::<S, 4389, 18>::new().unwrap(), 4389, 1 << 18);
}

#[test]
fn a_cruise_at_a_dyadic_rate_is_exact_in_i16f16() {
    check_dyadic::<I16F16>();
}

#[test]
fn a_cruise_at_a_dyadic_rate_is_exact_in_i8f24() {
    check_dyadic::<I8F24>();
}

// A step that holds its length as a coefficient, of which this one is exact.
#[test]
fn a_cruise_at_64_hz_is_exact() {
    check_exact::<I16F16>(&Step::hz(64).unwrap(), 1, 64);
}

/// Beside them, as seen: each rounds 10^6 times and shifts back.
#[test]
fn others_drift() {
    fn row<B>(bound: f64)
    where
        B: Body<S: Format> + From<Point<B::S>> + std::fmt::Debug,
    {
        let flight = fly::<B, _>(Scheme::SemiImplicitEuler, &Step::hz(60).unwrap());
        let kind = std::any::type_name::<B>().contains("Carried");
        let kind = if kind { "carried" } else { "Point" };
        let what = format!("{} {kind} cruise, m", <B::S as Format>::name());
        let errors = seen(&flight, 1.0 / 60.0);
        within(bound, &what, &errors);
        let kind = if kind == "Point" { "Point" } else { "Carried" };
        crate::carry::told(&format!("{kind}<{}>", <B::S as Format>::name()), 2, &errors);
    }
    let path = 3.0 * STEPS as f64 / 60.0;
    // Half a unit a step, and h to 2^-30 or 2^-25.
    row::<Point<I16F16>>(0.5 * 1e6 * I16F16::unit(0.0) + path * 2.0_f64.powi(-30));
    row::<Point<I8F24>>(0.5 * 1e6 * I8F24::unit(0.0) + path * 2.0_f64.powi(-30));
    row::<Point<f32>>(0.5 * 1e6 * f32::unit(63.0) + path * 2.0_f64.powi(-25));
    // h alone is off, by half a unit of its mantissa; so is each product with it.
    row::<Carried<f32>>(path * 2.0_f64.powi(-23) + f32::unit(63.0));
}
