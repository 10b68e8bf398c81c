//! The two methods of order 4: what they compute, where they are stable, what they keep.

#[path = "high_order/drag.rs"]
mod drag;
#[path = "high_order/limits.rs"]
mod limits;
#[path = "high_order/reference.rs"]
mod reference;
#[path = "high_order/reverse.rs"]
mod reverse;
use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Between, Gravity, Pefrl, PerBody, Point, Rk4, Step, Time, Vec2, World};
use support::*;

const ORDER_4: [Scheme; 2] = [Scheme::Rk4, Scheme::Pefrl];

/// The instants, in half steps, at which the forces of three steps are taken.
fn instants(scheme: Scheme) -> Vec<u64> {
    let mut world: World<Point<f32>, 1> = world([point([0.0; 2], [1.0; 2], 1.0)]);
    let (mut method, mut seen) = (scheme.method(), Vec::new());
    let mut force = PerBody(|time: Time, _: &Point<f32>| {
        seen.push(time.half_ticks());
        Vec2::ZERO
    });
    for _ in 0..3 {
        world.step(&mut method, &mut force, &Step::hz(60).unwrap());
    }
    seen
}

#[test]
fn forces_are_taken_at_their_instants() {
    assert_eq!(instants(Scheme::Rk4), [0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6]);
    assert_eq!(
        instants(Scheme::Pefrl),
        [1, 1, 1, 1, 3, 3, 3, 3, 5, 5, 5, 5]
    );
}

/// Velocity is n g h to one unit for each sequence of gains that n steps add up, of which each is
/// rounded once in all: one for Runge-Kutta, four for PEFRL; and g and h themselves as coefficients.
/// A cruise along x, which nothing pushes, keeps its speed to the bit.
fn check_fall<S: Format>(scheme: Scheme, gains: f64) {
    const TICKS: i32 = 587;
    let errors: [f64; 16] = std::array::from_fn(|i| {
        let g = -1.0 - 9.0 * spread(i);
        let up = point([0.0; 2], [1.0 + spread(i), 3.0], 0.7);
        let mut world: World<Point<S>, 1> = world([up]);
        let mut gravity = Gravity::new(vector(0.0, g));
        let g = scalar::<S>(g).to_f64();
        let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
        for _ in 0..TICKS {
            world.step(&mut method, &mut gravity, &step);
        }
        let after = world.bodies()[0];
        assert_eq!(after.velocity().x, up.velocity().x);
        let exact = 3.0 + g * f64::from(TICKS) / 60.0;
        let slack = exact.abs() * S::COEFFICIENT;
        (after.velocity().y.to_f64() - exact).abs() / (gains * S::unit(0.0) + slack)
    });
    let what = format!("{} {scheme:?} fall, of the rounding", S::name());
    within(1.0, &what, &errors);
}

#[test]
fn gravity_keeps_its_fraction() {
    for (scheme, gains) in [(Scheme::Rk4, 1.0), (Scheme::Pefrl, 4.0)] {
        check_fall::<I16F16>(scheme, gains);
        check_fall::<I20F12>(scheme, gains);
        check_fall::<I12F20>(scheme, gains);
    }
}

/// The worst picture within steps of a spring at ω h = q, as part of `h³ ω³` times its amplitude: at
/// most `max α (1 - α) (1 - 2 α) / 12 = 0.00802`, and order h more.
fn worst_picture(scheme: Scheme, q: f64) -> f64 {
    let omega = 60.0 * q;
    let mut world: World<Point<f64>, 1> = world([point([1.0, 0.0], [0.0, omega], 1.0)]);
    let mut anchor = anchors(&world, [omega * omega]);
    let step = Step::hz(60).unwrap();
    let mut worst = 0.0;
    for tick in 0..60 {
        let before = world.clone();
        match scheme {
            Scheme::Rk4 => world.step(&mut Rk4::new(), &mut anchor, &step),
            _ => world.step(&mut Pefrl::new(), &mut anchor, &step),
        }
        for i in 0..16 {
            let part = Between::new(ratio(spread(i)), &step).unwrap();
            let at = match scheme {
                Scheme::Rk4 => world.between(&before, &Rk4::new(), &part).next(),
                _ => world.between(&before, &Pefrl::new(), &part).next(),
            };
            let (at, phase) = (at.unwrap().1, (f64::from(tick) + spread(i)) * q);
            worst = maximum(&[worst, (at.x - phase.cos()).hypot(at.y - phase.sin())]);
        }
    }
    worst / q.powi(3)
}

#[test]
fn pictures_are_of_order_3() {
    for scheme in ORDER_4 {
        let worst = [0.005, 0.01, 0.02].map(|q| worst_picture(scheme, q));
        println!("{scheme:?} pictures: {worst:.6?} of h³ ω³");
        assert!(worst.iter().all(|&worst| worst <= 0.00802 * 1.1));
        assert!(worst.iter().all(|&worst| worst >= 0.00802 * 0.9));
    }
}

// Two copies, a vector, three lengths, two coefficients and the step they were made for.
#[test]
fn rk4_stores_48_bytes_a_body_and_pefrl_none() {
    let arrays = 48 * 64;
    let sizes = [
        size_of::<Rk4<Point<I16F16>, 64>>(),
        size_of::<Rk4<Point<f32>, 64>>(),
    ];
    for size in sizes {
        assert!((arrays..=arrays + 64).contains(&size), "{size}");
    }
    assert!(size_of::<Pefrl<I8F24>>() <= 64);
}

/// A step of another length is not made with the coefficients of the last.
#[test]
fn coefficients_follow_the_step() {
    let run = |scheme: Scheme, fresh: bool| {
        let mut world: World<Point<I8F24>, 1> = world([point([1.0, 0.5], [0.2, 0.7], 1.0)]);
        let mut forces = anchors(&world, [30.0]);
        let mut method = scheme.method();
        for tick in 0..100 {
            let step = Step::hz([60, 37][tick % 2]).unwrap();
            if fresh {
                method = scheme.method();
                forces = anchors(&world, [30.0]);
            }
            world.step(&mut method, &mut forces, &step);
        }
        world.state_hash()
    };
    for scheme in ORDER_4 {
        assert_eq!(run(scheme, false), run(scheme, true));
    }
}
