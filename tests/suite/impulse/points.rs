//! Points of a body: where they are, how they move; and what a body has of energy and momentum.

use std::f64::consts::{PI, TAU};

use super::*;

/// `v + ω r` across: 2π times a spin has two roundings of a coefficient, its product with the arm one to half a
/// unit. In floats the sum is rounded too.
fn check_velocities<C: Middle>() {
    let mut draw = Draw(Random(3));
    let mut shares = Vec::new();
    for _ in 0..2000 {
        let (body, arm) = (draw.body::<C>(), draw.vector::<C::S>(2.0));
        let (omega, r) = (TAU * body.spin().to_f64(), arm.to_f64());
        let (found, v) = (body.velocity_off(arm).to_f64(), body.velocity().to_f64());
        for (found, v, turning) in [(found.x, v.x, -omega * r.y), (found.y, v.y, omega * r.x)] {
            let allowed = 0.5 * C::S::unit(turning)
                + C::S::COEFFICIENT * turning.abs()
                + C::S::sum(v + turning);
            let error = (found - v - turning).abs();
            shares.push(error / (C::S::REFERENCE * allowed));
        }
        let point = body.position() + arm;
        let seen = body.velocity_off(point - body.position());
        assert_eq!(body.velocity_at(point), seen);
    }
    report::<C::S>("velocity of a point", &shares);
}

/// To the world: cosine and sine are off by `CIRCLE`, each part is rounded once, in floats with its products.
/// There and back: with the same two numbers, so that a length changes by their norm alone, and what was rounded
/// on the way is turned and at most `sqrt(2)` times as long along an axis.
fn check_places<C: Middle>() {
    let mut draw = Draw(Random(4));
    let (mut to, mut back) = (Vec::new(), Vec::new());
    for _ in 0..2000 {
        let (body, own) = (draw.body::<C>(), draw.vector::<C::S>(3.0));
        let (sin, cos) = (TAU * body.angle().to_f64()).sin_cos();
        let (x, p) = (body.position().to_f64(), own.to_f64());
        let (there, size) = (body.to_world(own), p.x.abs() + p.y.abs());
        let exact = [x.x + cos * p.x - sin * p.y, x.y + sin * p.x + cos * p.y];
        let turned = 0.5 * C::S::unit(0.0) + C::S::SUM_OF_PRODUCTS * size;
        let sum = C::S::sum(20.0 + size);
        let allowed = turned + C::S::CIRCLE * size + sum;
        for (found, exact) in there.to_f64().array().into_iter().zip(exact) {
            to.push((found - exact).abs() / (C::S::REFERENCE * allowed));
        }
        // The difference of positions is rounded as their sum.
        let norm = 2.0 * 2.0_f64.sqrt() * C::S::CIRCLE * size;
        let allowed = 2.0_f64.sqrt() * (turned + 2.0 * sum) + turned + norm;
        let found = (body.to_own(there) - own).to_f64();
        back.extend(found.array().map(|error| error.abs() / allowed));
        // The angle has 2^-32 turns where the reference has 2^-53 of them.
        assert_eq!(body.rotation().rotate(own) + body.position(), there);
    }
    report::<C::S>("to the world", &to);
    report::<C::S>("and back", &back);
}

/// `m v²/2 + I ω²/2`, `m v` and `x × m v + I ω` by mass and inertia as they are given: each inverse is off by
/// `INVERSE`, 2π by less. A remainder of the spin is counted: half a unit.
fn check_read_outs<C: Middle>() {
    let mut draw = Draw(Random(5));
    let mut shares = Vec::new();
    for _ in 0..100 {
        let (mass, inertia) = (draw.between(0.1, 1000.0), draw.between(0.2, 1000.0));
        let centre = Point::new(draw.vector(20.0), draw.vector(5.0), ratio(mass)).unwrap();
        let body = Rigid::new(C::from(centre), ratio(inertia)).unwrap();
        let body = body.with_spin(ratio(draw.within(5.0))).unwrap();
        let mut driven = Rigid::<C>::kinematic(draw.vector(9.0), draw.vector(9.0)).unwrap();
        driven.set_spin(scalar(7.0)).unwrap();
        let world = world([body, driven]);
        let (x, v) = (body.position().to_f64(), body.velocity().to_f64());
        let (omega, about) = (TAU * body.spin().to_f64(), Vec2::new(1.5, -0.5));
        let (arm, p) = (x - about, v.map(|v| v * mass));
        let orbit = [arm.x * p.y, -arm.y * p.x];
        let exact = [
            (
                world.kinetic_energy(),
                0.5 * mass * v.dot(v),
                0.5 * inertia * omega * omega,
            ),
            (world.momentum().x, p.x, 0.0),
            (world.momentum().y, p.y, 0.0),
            (
                world.angular_momentum(about),
                orbit[0] + orbit[1],
                inertia * omega,
            ),
            (
                body.spin_energy(),
                0.0,
                PI * inertia * omega * body.spin().to_f64(),
            ),
        ];
        for (found, line, turn) in exact {
            let size = orbit[0].abs() + orbit[1].abs() + line.abs() + turn.abs();
            shares.push((found - line - turn).abs() / (2.0 * C::S::INVERSE * size + 1e-13 * size));
        }
    }
    report::<C::S>("read-outs", &shares);
}

fn check<C: Middle>() {
    check_velocities::<C>();
    check_places::<C>();
    check_read_outs::<C>();
}

#[test]
fn points_of_a_body_are_where_they_should_be() {
    check::<Point<I16F16>>();
    check::<Point<I8F24>>();
    check::<Point<f32>>();
    check::<Point<f64>>();
    check::<Carried<I8F24>>();
    check::<Carried<f32>>();
}
