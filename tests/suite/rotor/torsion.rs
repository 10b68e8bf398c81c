//! A torsion spring of the scene's own: `PerBody` and `Wrench`, `I ω' = -k θ`.
//!
//! ```text
//! ω0 = sqrt(k / I)      θ(t) = θ0 cos ω0 t + s0/ω0 sin ω0 t      in turns
//! Verlet turns by a phase of Ω h a step, sin(Ω h / 2) = ω0 h / 2: ahead by (ω0 h)²/24
//! ```

use fixstep::rigid::torque::Wrench;
use fixstep::{Force, PerBody, Time};

use super::*;

const THETA: f64 = 0.1;

/// A body of 1 kg m² at an angle, with a spin.
fn pendulum<C: Middle>(spin: f64) -> World<Rigid<C>, 1> {
    let centre = Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap();
    let body = Rigid::new(C::from(centre), 1).unwrap();
    let body = body.with_angle(fixstep::Angle::turns(ratio(THETA)));
    world([body.with_spin(ratio(spin)).unwrap()])
}

/// `k` N m a radian.
fn spring<C: Middle>(k: f64) -> impl Force<Rigid<C>> {
    PerBody(move |_: Time, body: &Rigid<C>| Wrench {
        force: Vec2::ZERO,
        torque: scalar(-k * TAU * body.angle().to_f64()),
    })
}

/// How far the angle is from the exact one after two seconds.
fn error(scheme: Scheme, rate: i32) -> f64 {
    const SPIN: f64 = 0.05;
    let omega = 5.0_f64;
    let (mut world, mut force) = (pendulum::<Point<f64>>(SPIN), spring(omega * omega));
    let (mut method, step) = (scheme.method(), Step::hz(rate).unwrap());
    (0..2 * rate).for_each(|_| world.step(&mut method, &mut force, &step));
    let (sin, cos) = (2.0 * omega).sin_cos();
    (world.bodies()[0].angle().to_f64() - THETA * cos - SPIN / omega * sin).abs()
}

/// `e(h) = C h^p (1 + O(ω h))`, and `ω h` is at most 1/32: the ratio is `2^p` but for a part of that size, which
/// is less than 0.1 of an order, 7 %.
#[test]
fn methods_keep_their_order_for_a_spring_that_turns() {
    for (scheme, order) in [
        (Scheme::Euler, 1.0),
        (Scheme::SemiImplicitEuler, 1.0),
        (Scheme::Verlet, 2.0),
        (Scheme::Rk4, 4.0),
        (Scheme::Pefrl, 4.0),
    ] {
        let rate = if order == 1.0 { 640 } else { 160 };
        let [coarse, fine] = [rate, 2 * rate].map(|rate| error(scheme, rate));
        let found = (coarse / fine).log2();
        println!("{scheme:?}: {coarse:.2e}, {fine:.2e} turns, order {found:.3}");
        assert!((found - order).abs() <= 0.1, "{scheme:?}: {found}");
    }
}

/// Fifty periods at 1 Hz, from the first zero on the way up to the last: between two steps a line is off from a
/// sine by `q³ / (9 sqrt(3)) = 0.065 q³` of its phase, `q = ω0 h`. Each step rounds the spin once, by a phase
/// of a unit's 1/sqrt(12) over the largest spin at most: six standard deviations.
fn check_period<C: Middle>() {
    const PERIODS: f64 = 50.0;
    let (mut world, mut force) = (pendulum::<C>(0.0), spring(TAU * TAU));
    let (mut method, step) = (Scheme::Verlet.method(), Step::hz(60).unwrap());
    let mut zeros = Vec::new();
    let mut before = THETA;
    for n in 1..=(60 * (PERIODS as u32 + 1)) {
        world.step(&mut method, &mut force, &step);
        let now = world.bodies()[0].angle().to_f64();
        if before < 0.0 && now >= 0.0 {
            zeros.push((f64::from(n) - now / (now - before)) / RATE);
        }
        before = now;
    }
    let count = (zeros.len() - 1) as f64;
    let period = (zeros[zeros.len() - 1] - zeros[0]) / count;
    let q = TAU / RATE;
    let verlet = 0.5 * q / (0.5 * q).asin();
    let noise = 6.0 * (60.0 * count / 12.0).sqrt() * C::S::unit(0.63) / (TAU * THETA);
    let bound = (2.0 * 0.065 * q.powi(3) + noise) / (TAU * count);
    let off = (period - verlet).abs();
    println!(
        "{:<7} a period of {period:.7} s; Verlet's {verlet:.7} (off by {off:.1e} of {bound:.1e}), \
         2π sqrt(I/k) = 1 s",
        C::S::name()
    );
    assert!(count >= PERIODS - 1.0 && off <= bound);
    assert!((1.0 - period) <= 1.01 * q * q / 24.0 + bound && period <= 1.0 + bound);
}

#[test]
fn a_torsion_spring_has_its_period() {
    check_period::<Point<f64>>();
    check_period::<Point<f32>>();
    check_period::<Point<I16F16>>();
    check_period::<Point<I8F24>>();
    check_period::<Carried<I16F16>>();
}
