//! Angular momentum of two bodies that draw each other, about their centre: a central force that is no
//! spring. With f = -h G M / s³ of their distance, as in `invariants.rs`.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{AllPairs, Point, Pull, Step, World};

use crate::invariants::RATE;
use crate::support::*;

const MASSES: [f64; 2] = [1.37, 2.91];
const STEPS: u32 = long(10_000) as u32;

/// How large a scene is: a thousandth of the range, within 1 and 10 m.
fn length<S: Format>() -> f64 {
    (S::MAX.to_f64() / 1000.0).clamp(1.0, 10.0)
}

/// `G M`, for a turn in two seconds at this distance.
fn strength<S: Format>() -> f64 {
    10.0 * length::<S>().powi(3)
}

/// Pair `i`: its line at its own angle, 0.8 of the speed of a circle, the centre at rest in the origin.
fn pair<S: Format>(i: usize) -> World<Point<S>, 2> {
    let ((sin, cos), length) = (angle(i).sin_cos(), length::<S>());
    let speed = 0.8 * (strength::<S>() / length).sqrt();
    let total = MASSES[0] + MASSES[1];
    let body = |mass: f64, share: f64| {
        let (r, v) = (length * share, speed * share);
        point([r * cos, r * sin], [-v * sin, v * cos], mass)
    };
    world([
        body(MASSES[0], -MASSES[1] / total),
        body(MASSES[1], MASSES[0] / total),
    ])
}

/// What a pair is: its distance with the softening, and its angular momentum.
fn read<S: Format>(world: &World<Point<S>, 2>, softening: f64) -> [f64; 2] {
    let [a, b] = [0, 1].map(|i| {
        let body = &world.bodies()[i];
        (body.position().to_f64(), body.velocity().to_f64())
    });
    let turn = |i: usize, (x, v): (fixstep::Vec2<f64>, fixstep::Vec2<f64>)| {
        MASSES[i] * (x.x * v.y - x.y * v.x)
    };
    let d = b.0 - a.0;
    [
        (d.x * d.x + d.y * d.y + softening * softening).sqrt(),
        turn(0, a) + turn(1, b),
    ]
}

/// What a step makes of L: `1 - h f`, or half of it, or nothing.
fn gain(scheme: Scheme, strength: f64, distance: f64) -> f64 {
    let full = strength / distance.powi(3) / (RATE * RATE);
    match scheme {
        Scheme::Euler => full,
        Scheme::ConstantAcceleration => full / 2.0,
        _ => 0.0,
    }
}

/// The largest change of `ln L` beyond that law, by what is allowed. Rounding as in `invariants.rs`,
/// for each body by its mass, at the largest speed: bound by energy, from 0.8 of a circle's at the far
/// end the near end is 0.47 of it, with 1.7 times its speed; the two that gain L move outwards, and
/// slow down, as far as is seen. Four roundings of a kick in floats, of the product, the sum and the
/// two differences of positions. Masses and the law are off by 9 times `COEFFICIENT`, and so are both
/// impulses, of which a difference turns the pair by as much as the centre is off its line: nothing.
/// What gains L gains it by a part that is off by as much.
fn check<S: Format>(scheme: Scheme) {
    let (softening, strength) = (0.01 * length::<S>(), strength::<S>());
    let constant = strength / (MASSES[0] + MASSES[1]);
    let speed = 1.7 * (strength / length::<S>()).sqrt();
    let errors: [f64; 16] = std::array::from_fn(|i| {
        let mut world = pair::<S>(i);
        let mut pull = AllPairs(Pull::new(ratio(constant), ratio(softening)).unwrap());
        let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
        let [_, start] = read(&world, softening);
        let (mut exact, mut largest, mut longest) = (0.0, 0.0, 0.0);
        for _ in 0..STEPS {
            let [distance, _] = read(&world, softening);
            longest = maximum(&[longest, distance]);
            exact += gain(scheme, strength, distance).ln_1p();
            world.step(&mut method, &mut pull, &step);
            let [_, now] = read(&world, softening);
            largest = maximum(&[largest, ((now / start).ln() - exact).abs()]);
        }
        let kick = longest * S::unit(speed);
        let drift = scheme.drifts() * speed * S::unit(longest);
        let variance = f64::from(STEPS) / 12.0 * (4.0 * kick * kick + 2.0 * drift * drift);
        let mass = MASSES[0].hypot(MASSES[1]);
        let allowed = 6.0 * mass * variance.sqrt() / start + 9.0 * S::COEFFICIENT * (1.0 + exact);
        largest / allowed
    });
    within(
        1.0,
        &format!("{} {scheme:?} pair, of the allowance", S::name()),
        &errors,
    );
}

fn check_all<S: Format>() {
    SCHEMES.into_iter().for_each(check::<S>);
}

#[test]
fn angular_momentum_of_a_pair() {
    check_all::<f32>();
    check_all::<f64>();
    check_all::<I16F16>();
    check_all::<I12F20>();
    check_all::<I8F24>();
    check_all::<I20F12>();
}
