//! Free fall for 2 s at 60 Hz against the exact parabola of the gravity that the scalar holds.
//!
//! ```text
//! x(t) = x0 + v0 t + g t²/2       Verlet, ConstantAcceleration
//!            ... ± g t h/2        + SemiImplicitEuler, - Euler
//! ```

use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Gravity, Step, Vec2, World};
use support::*;

const RATE: f64 = 60.0;
const TICKS: u32 = 120;
const TIME: f64 = TICKS as f64 / RATE;

/// Both gravities, each the nearest that the scalar holds.
const GRAVITIES: [f64; 2] = [5.0, 9.81];

type Falling<S> = World<fixstep::Point<S>, 16>;

/// Sixteen bodies thrown up and down, so that positions and velocities have all kinds of fractions.
fn thrown<S: Format>() -> Falling<S> {
    let body = |i: usize| {
        point(
            [0.0, 40.0 * spread(i)],
            [0.0, 12.0 * spread(i + 16) - 6.0],
            1.0,
        )
    };
    world(std::array::from_fn(body))
}

/// Runs the fall; `see` gets every tick with its time and gravity.
fn fall<S: Format>(scheme: Scheme, gravity: f64, mut see: impl FnMut(f64, f64, &Falling<S>)) {
    let gravity = scalar::<S>(-gravity);
    let mut forces = Gravity::new(Vec2::new(S::ZERO, gravity));
    let (mut world, mut method) = (thrown::<S>(), scheme.method());
    let step = Step::hz(60).unwrap();
    for tick in 1..=TICKS {
        world.step(&mut method, &mut forces, &step);
        see(tick as f64 / RATE, gravity.to_f64(), &world);
    }
}

/// For each body the largest error of the run, and the largest |x|; `lag` in units of g t h/2.
fn errors<S: Format>(scheme: Scheme, gravity: f64, lag: f64) -> [(f64, f64); 16] {
    let starts = thrown::<S>().bodies().to_vec();
    let mut worst = [(0.0_f64, 0.0_f64); 16];
    fall::<S>(scheme, gravity, |t, g, world| {
        for ((body, start), (error, reach)) in world.bodies().iter().zip(&starts).zip(&mut worst) {
            let (x0, v0) = (start.position().y.to_f64(), start.velocity().y.to_f64());
            let exact = x0 + v0 * t + 0.5 * g * t * (t + lag / RATE);
            let x = body.position().y.to_f64();
            *error = maximum(&[*error, (x - exact).abs()]);
            *reach = reach.max(x.abs());
        }
    });
    worst
}

fn check<S: Format>(scheme: Scheme, lag: f64, bound: impl Fn(f64) -> f64) {
    for gravity in GRAVITIES {
        let units: Vec<f64> = (errors::<S>(scheme, gravity, lag).iter())
            .map(|(error, reach)| error / S::unit(*reach))
            .collect();
        let what = format!("{} {scheme:?} g = {gravity}, units", S::name());
        within(bound(gravity), &what, &units);
    }
}

/// In fixed point every drift rounds the position by at most half a unit, evenly distributed since
/// velocities pass through all fractions: variance 1/12 each, six standard deviations for all. The
/// velocity is exact to half a unit at every tick, which makes T/2 in the position; the spans of
/// h and the gain of g are off by less than 2^-30 of the path. All of it is less than the
/// T²/(2h) + T/(2h) = 180 units that an acceleration rounded once would be allowed.
fn fixed_bound<S: Format>(scheme: Scheme, gravity: f64) -> f64 {
    let drifts = 6.0 * (scheme.drifts() * TICKS as f64 / 12.0).sqrt();
    let path = 6.0 * TIME + gravity * TIME * TIME;
    drifts + TIME / 2.0 + path * 2.0_f64.powi(-30) / S::unit(0.0)
}

fn check_fixed(scheme: Scheme, lag: f64) {
    check::<I16F16>(scheme, lag, |g| fixed_bound::<I16F16>(scheme, g));
    check::<I12F20>(scheme, lag, |g| fixed_bound::<I12F20>(scheme, g));
    check::<I8F24>(scheme, lag, |g| fixed_bound::<I8F24>(scheme, g));
    check::<I20F12>(scheme, lag, |g| fixed_bound::<I20F12>(scheme, g));
}

/// Units of the largest |x| of the run. 240 additions to x, six standard deviations of half a unit:
/// 27; h g twice rounded (1.5e-7) acts on 20 m: 2 units of 1.9e-6.
fn check_floats(scheme: Scheme, lag: f64) {
    check::<f32>(scheme, lag, |_| 32.0);
    check::<f64>(scheme, lag, |_| 32.0);
}

#[test]
fn verlet_follows_the_parabola() {
    check_fixed(Scheme::Verlet, 0.0);
    check_floats(Scheme::Verlet, 0.0);
}

#[test]
fn constant_acceleration_follows_the_parabola() {
    check_fixed(Scheme::ConstantAcceleration, 0.0);
    check_floats(Scheme::ConstantAcceleration, 0.0);
}

#[test]
fn semi_implicit_euler_is_half_a_step_ahead() {
    check_fixed(Scheme::SemiImplicitEuler, 1.0);
    check_floats(Scheme::SemiImplicitEuler, 1.0);
}

#[test]
fn euler_is_half_a_step_behind() {
    check_fixed(Scheme::Euler, -1.0);
    check_floats(Scheme::Euler, -1.0);
}

/// v = v0 + g t rounded once: half a unit. The gain's coefficient h is off by 2^-31 of g t, and its
/// fraction of 32 bits is cut once per tick.
fn check_velocity<S: Format>() {
    let starts = thrown::<S>().bodies().to_vec();
    for gravity in GRAVITIES {
        let mut worst = [0.0_f64; 16];
        fall::<S>(Scheme::Verlet, gravity, |t, g, world| {
            for ((body, start), error) in world.bodies().iter().zip(&starts).zip(&mut worst) {
                let exact = start.velocity().y.to_f64() + g * t;
                let off = (body.velocity().y.to_f64() - exact).abs() / S::unit(0.0);
                *error = maximum(&[*error, off]);
            }
        });
        let cut = TICKS as f64 * 2.0_f64.powi(-32);
        let coefficient = gravity * TIME * 2.0_f64.powi(-31) / S::unit(0.0);
        let what = format!("{} velocity, g = {gravity}, units", S::name());
        within(0.5 + cut + coefficient, &what, &worst);
    }
}

#[test]
fn the_velocity_is_exact_to_half_a_unit_at_every_tick() {
    check_velocity::<I16F16>();
    check_velocity::<I12F20>();
    check_velocity::<I8F24>();
    check_velocity::<I20F12>();
}
