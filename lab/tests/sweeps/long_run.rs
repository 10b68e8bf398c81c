//! A million steps at 60 Hz, 4.6 hours: flight at constant speed, and a spring of 16 m. The start
//! is what the scalar holds of it; its own rounding is not part of the errors.

use crate::support;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Anchor, DyadicStep, Point, Step, TimeStep, World};
use support::*;

const RATE: f64 = 60.0;
const STEPS: u32 = 1_000_000;

/// Bodies that pass it are put back by as much: exact in every scalar here.
const WRAP: f64 = 64.0;

/// 1.2345 m/s first, then others between 0.5 and 3 m/s.
fn speed(i: usize) -> f64 {
    if i == 0 {
        1.2345
    } else {
        0.5 + 2.5 * spread(i)
    }
}

/// The error in distance, m, of seventeen bodies. The position moves by the same d = round(h v) in
/// each step, so in fixed point the error is N (d - h v).
fn cruise<S: Format>() -> [f64; 17] {
    let start = |i: usize| point::<S>([WRAP * spread(i + 17), 0.0], [speed(i), 0.0], 1.0);
    let mut world: World<Point<S>, 17> = world(std::array::from_fn(start));
    let starts = world.clone();
    let (mut method, step) = (Scheme::SemiImplicitEuler.method(), Step::hz(60).unwrap());
    let mut laps = [0_u32; 17];
    for _ in 0..STEPS {
        world.step(&mut method, &mut (), &step);
        for ((_, body), laps) in world.iter_mut().zip(&mut laps) {
            let x = body.position();
            if x.x >= scalar(WRAP) {
                body.teleport(x - vector(WRAP, 0.0)).unwrap();
                *laps += 1;
            }
        }
    }
    std::array::from_fn(|i| {
        let (now, then) = (world.bodies()[i], starts.bodies()[i]);
        let flown = now.position().x.to_f64() - then.position().x.to_f64() + WRAP * laps[i] as f64;
        (flown - then.velocity().x.to_f64() * STEPS as f64 / RATE).abs()
    })
}

/// A product is off by at most half a unit, N times the same way; the span of h is off by less
/// than 2^-30 of a path of up to 3 m/s.
fn cruise_bound<S: Format>() -> f64 {
    let path = 3.0 * STEPS as f64 / RATE;
    0.5 * STEPS as f64 * S::unit(0.0) + path * 2.0_f64.powi(-30)
}

#[test]
fn cruise_is_ten_times_better_in_i8f24_than_in_f32() {
    let (float, fine, coarse) = (cruise::<f32>(), cruise::<I8F24>(), cruise::<I16F16>());
    // Half a unit of x below 64 m, 1.9e-6 m, in each of 10^6 steps; h itself is off by 3e-8 of the
    // path of 50 km.
    within(1.91, "f32 cruise 1e6 steps, m", &float);
    within(cruise_bound::<I8F24>(), "I8F24 cruise 1e6 steps, m", &fine);
    within(
        cruise_bound::<I16F16>(),
        "I16F16 cruise 1e6 steps, m",
        &coarse,
    );
    // v = 80904 units and h v = 1348.4: 0.4 units of 15.26 um, 10^6 times, are 6.1035 m.
    assert!((coarse[0] - 6.1035).abs() <= 1e-3, "{}", coarse[0]);
    assert!(10.0 * maximum(&fine) <= maximum(&float));
    assert!(10.0 * median(&fine) <= median(&float));
}

const AMPLITUDE: f64 = 16.0;

/// About 1 Hz: a frequency for each body, a phase for each axis.
fn omega(i: usize) -> f64 {
    std::f64::consts::TAU * (0.9 + 0.2 * spread(i))
}

/// Position after `n` steps of the same map in exact arithmetic, q = ω h, cos θ = 1 - q²/2:
///
/// ```text
/// SemiImplicitEuler   x cos(nθ) + (u q - x q²/2) sin(nθ) / sin θ
/// Verlet              x cos(nθ) + u q (1 - q²/4) sin(nθ) / sin θ
/// ```
fn turned(scheme: Scheme, q: f64, [x, u]: [f64; 2], n: u32) -> f64 {
    let theta = 2.0 * (q / 2.0).asin();
    let side = match scheme {
        Scheme::SemiImplicitEuler => u * q - x * q * q / 2.0,
        _ => u * q * (1.0 - q * q / 4.0),
    };
    let (sin, cos) = (n as f64 * theta).sin_cos();
    x * cos + side * sin / theta.sin()
}

/// The largest error, m, of sixteen swings of 16 m over the last two periods.
fn swing<S: Format, H: TimeStep<S>>(scheme: Scheme, step: H) -> [f64; 16] {
    let h = step.seconds().to_f64();
    let start = |i: usize| {
        let (x, v) = (AMPLITUDE, AMPLITUDE * omega(i));
        let part = |k: usize| [x * angle(k).cos(), v * angle(k).sin()];
        let (x, y) = (part(2 * i), part(2 * i + 1));
        point::<S>([x[0], y[0]], [x[1], y[1]], 1.0)
    };
    let mut world = world(std::array::from_fn(start));
    let starts = world.clone();
    let stiffness = std::array::from_fn(|i| omega(i) * omega(i));
    let mut forces: [Anchor<S>; 8] = anchors(&world, stiffness);
    let mut method = scheme.method();
    let mut worst = [0.0; 16];
    for n in 1..=STEPS {
        world.step(&mut method, &mut forces, &step);
        if n + 120 < STEPS {
            continue;
        }
        for (i, worst) in worst.iter_mut().enumerate() {
            let (now, then) = (&world.bodies()[i / 2], &starts.bodies()[i / 2]);
            let of = |v: fixstep::Vec2<S>| v.to_f64().array()[i % 2];
            let (omega, x) = (omega(i / 2), of(now.position()));
            let state = [of(then.position()), of(then.velocity()) / omega];
            let exact = turned(scheme, omega * h, state, n);
            *worst = maximum(&[*worst, (x - exact).abs()]);
        }
    }
    worst
}

/// What may come together in N steps, in m:
///
/// * ties, where h v lies half-way (v = 30 modulo 60 units): half a unit each, but along v in one
///   tick and against it in the next, so that they cancel but for chance.
/// * other roundings: a step is a rotation, so they add up as they are; 1/12 of a unit² for each
///   drift and for two products of the kick; six standard deviations.
/// * coefficients: off by `COEFFICIENT`, times the angle turned, times the amplitude.
fn swing_bound<S: Format>(scheme: Scheme) -> f64 {
    let (steps, slowest, fastest) = (STEPS as f64, 5.65, 6.92);
    let (x, u) = (S::unit(AMPLITUDE), S::unit(AMPLITUDE * fastest) / slowest);
    let other = 6.0 * (steps / 12.0 * (scheme.drifts() * x * x + 2.0 * u * u)).sqrt();
    other + S::COEFFICIENT * fastest * steps / RATE * AMPLITUDE
}

fn check_swing<S: Format>(scheme: Scheme) -> [f64; 16] {
    let errors = swing::<S, _>(scheme, Step::hz(60).unwrap());
    let what = format!("{} {scheme:?} 16 m 1 Hz 1e6 steps, m", S::name());
    within(swing_bound::<S>(scheme), &what, &errors);
    errors
}

fn check_swings(scheme: Scheme) {
    let (float, fine) = (check_swing::<f32>(scheme), check_swing::<I8F24>(scheme));
    // The best that plain rounding to nearest reached before ties were taken by turns: 5.4 cm.
    let coarse = check_swing::<I16F16>(scheme);
    assert!(maximum(&coarse) <= 5.4e-2);
    assert!(10.0 * maximum(&fine) <= maximum(&float));
    assert!(10.0 * median(&fine) <= median(&float));
}

#[test]
fn a_spring_is_ten_times_better_in_i8f24_than_in_f32_by_semi_implicit_euler() {
    check_swings(Scheme::SemiImplicitEuler);
}

#[test]
fn a_spring_is_ten_times_better_in_i8f24_than_in_f32_by_verlet() {
    check_swings(Scheme::Verlet);
}

/// Ties of a dyadic step, v = 32 modulo 64 units, all go outwards: N / 64 of them, half a unit each,
/// 2/π for the part that turns the phase, are 7.6 cm. The other roundings as in `swing_bound`.
#[test]
fn a_dyadic_step_runs_ahead_where_a_step_does_not() {
    let scheme = Scheme::SemiImplicitEuler;
    let ahead = STEPS as f64 / 64.0 * 0.5 * std::f64::consts::FRAC_2_PI * I16F16::unit(0.0);
    let dyadic = swing::<I16F16, _>(scheme, DyadicStep::<_, 1, 6>::new().unwrap());
    let off = dyadic.map(|error| (error - ahead).abs());
    within(
        swing_bound::<I16F16>(scheme),
        "I16F16 1/64 s, beside 7.6 cm, m",
        &off,
    );
    let turning = swing::<I16F16, _>(scheme, Step::hz(64).unwrap());
    within(
        swing_bound::<I16F16>(scheme),
        "I16F16 at 64 Hz, m",
        &turning,
    );
    assert!(10.0 * median(&turning) <= median(&dyadic));
}
