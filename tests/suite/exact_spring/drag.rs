//! A spring that is told of gravity beside a drag: the drag takes its part of the kick that the spring
//! takes back whole.

use fixstep::{
    ExactDrag, ExactSpring, GravityY, Method, Point, SemiImplicitEuler, Step, Vec2, Verlet, World,
    dec, vec2,
};

use crate::support::*;

/// Where a body of 1 kg comes to rest above its told sag, in parts of the sag, under a drag of `k h`.
fn lift(mut method: impl Method<Point<f64>, 1>, x: f64) -> f64 {
    let mut world = World::<Point<f64>, 1>::new();
    let start = Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap();
    let id = world.add(start).unwrap();
    let spring = ExactSpring::new(id, Vec2::ZERO, dec!(0.5), 1).unwrap();
    let spring = spring.with_gravity(vec2(0, -10).unwrap()).unwrap();
    let drag = ExactDrag::new(ratio(60.0 * x)).unwrap();
    let mut forces = (GravityY::new(-10).unwrap(), spring, drag);
    let step = Step::hz(60).unwrap();
    (0..10_000).for_each(|_| world.step(&mut method, &mut forces, &step));
    let rest = spring.rest_position().y;
    (world.get(id).unwrap().position().y - rest) / -rest
}

/// What is left of the kick after a drag of x is `g h e^-x`, so the body is pushed up by `g h x`, as by
/// `g x`: x of the sag. In halves only the second sees the kick. The next terms are x and `ω h` = 0.05
/// of that.
#[test]
fn a_drag_lifts_a_told_spring_by_its_own_part() {
    for x in (1..=16).map(|i| 0.001 * i as f64) {
        for (lift, part) in [(lift(SemiImplicitEuler, x), x), (lift(Verlet, x), 0.5 * x)] {
            assert!((lift / part - 1.0).abs() <= 0.1, "{x}: {lift} {part}");
        }
    }
    assert!(lift(SemiImplicitEuler, 0.0).abs() <= 1e-12);
}
