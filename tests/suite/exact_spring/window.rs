//! A constant force for a time, kicked beside the flow: order 2 under `Verlet`.

use std::f64::consts::TAU;

use fixstep::{ExactSpring, Push, Step, Vec2, Verlet, Window};

use crate::exact_spring::flow::{Double, flow};
use crate::support::*;

/// Error over (x, v/ω) after a push of 1/2 s and as much without, in steps of `1 / rate`.
fn error(i: usize, rate: u32) -> f64 {
    let (hertz, zeta) = (ratio(0.4 + spread(i)), ratio(0.05 * (i % 4) as f64));
    let (omega, mass, force) = (TAU * hertz.to_f64(), 1.37, 2.0 + spread(3 * i));
    let start = [angle(i).cos(), angle(i).sin()];
    let body = point([start[0], 0.0], [omega * start[1], 0.0], mass);
    let mut world = world([body]);
    let id = world.ids()[0];
    let spring = ExactSpring::new(id, Vec2::ZERO, hertz, zeta).unwrap();
    let push = Window::new(0..u64::from(rate / 2), Push::new(id, Vec2::new(force, 0.0)));
    let mut forces = (push, spring);
    let step = Step::<f64>::hz(rate as i32).unwrap();
    for _ in 0..rate {
        world.step(&mut Verlet, &mut forces, &step);
    }
    // Pushed, the body swings about the point where spring and force balance.
    let half = flow(Double::of(0.5 * omega), Double::ratio(zeta));
    let sag = Double::of(force / mass / (omega * omega));
    let pushed = half.of([Double::of(start[0]) - sag, Double::of(start[1])]);
    let exact = half.of([pushed[0] + sag, pushed[1]]).map(Double::to_f64);
    let body = world.bodies()[0];
    let off = [
        body.position().x - exact[0],
        body.velocity().x / omega - exact[1],
    ];
    off[0].hypot(off[1])
}

/// Kicks in the middle of each step are the midpoint rule for the integral of the flow: an error of
/// h²/24 and one of 7 h⁴/5760 times a further ω². Half the step divides it by 4, but for
/// `7 * 24 / 5760 (ω h)² = 0.03 (ω h)²` of itself at the longer step, where ω h < 0.28: 0.0023, times
/// 3/4. Roundings of f64 are 1e-10 of the errors.
#[test]
fn a_push_for_a_time_is_of_order_two() {
    for rate in [32, 64, 128] {
        let off = |i| (error(i, rate) / error(i, 2 * rate) / 4.0 - 1.0).abs();
        let errors: [f64; 16] = std::array::from_fn(off);
        within(
            2e-3,
            &format!("f64 Verlet 1/{rate} s, ratio over 4"),
            &errors,
        );
    }
}
