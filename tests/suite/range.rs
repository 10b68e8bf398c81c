//! Scenes pushed over the end of their range: they saturate, are reported, and neither wrap nor
//! panic. Run in debug these tests also see every overflow of an integer.

use crate::support;

use fixstep::fixed::types::{I8F24, I16F16, I20F12};
use fixstep::{
    AllBodies, AllPairs, Anchor, BodyId, Force, Gravity, LinearDrag, Pairs, PerBody, Point, Pull,
    Push, QuadraticDrag, Scalar, Spring, Step, Time, Vec2, Window, World,
};
use support::*;

fn hz60<S: Scalar>() -> Step<S> {
    Step::hz(60).unwrap()
}

/// Pulled towards one corner by a quarter of the range a second: parts of position and velocity
/// grow until they stand at the end, keep their sign, and the body is reported from then on.
fn check_corner<S: Grid>(scheme: Scheme, signs: [f64; 2]) {
    let end = S::MAX.to_f64();
    let pull = vector::<S>(0.25 * end * signs[0], 0.25 * end * signs[1]);
    let start = point::<S>(signs.map(|s| 0.9 * end * s), [0.0; 2], 1.0);
    let mut world: World<_, 2> = world([start, start]);
    let (mut method, mut gravity) = (scheme.method(), Gravity::new(pull));
    // The last tenth takes x one second, and v is at the end of the range after four.
    let mut reported = false;
    for tick in 0..360 {
        let before = world.bodies()[0];
        world.step(&mut method, &mut gravity, &hz60());
        let after = world.bodies()[0];
        for (axis, sign) in signs.into_iter().enumerate() {
            let grows = |of: fn(&Point<S>) -> Vec2<S>| {
                let [before, after] = [&before, &after].map(|b| of(b).array()[axis].to_f64());
                assert!(
                    after * sign >= before * sign,
                    "{} {scheme:?} tick {tick}",
                    S::name()
                );
            };
            grows(|body| body.position());
            grows(|body| body.velocity());
        }
        let out: Vec<BodyId> = world.out_of_range().collect();
        assert!(out.is_empty() != (reported || out.len() == 2));
        reported = !out.is_empty();
    }
    let at_end = |v: Vec2<S>| {
        v.array()
            .map(|part| part.units().unsigned_abs() >= i32::MAX as u32)
    };
    let body = world.bodies()[0];
    assert!(reported);
    assert_eq!(
        [at_end(body.position()), at_end(body.velocity())],
        [[true; 2]; 2]
    );
}

fn check_corners<S: Grid>() {
    for scheme in SCHEMES {
        for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
            check_corner::<S>(scheme, signs);
        }
    }
}

#[test]
fn fixed_point_saturates_keeps_its_sign_and_is_reported() {
    check_corners::<I16F16>();
    check_corners::<I8F24>();
    check_corners::<I20F12>();
}

/// Two bodies at `places` on a spring of `stiffness` with no rest length, after one step.
fn drawn<S: Format>(places: [Vec2<S>; 2], stiffness: f64) -> [Point<S>; 2] {
    let mut world: World<_, 2> =
        world(places.map(|place| Point::new(place, Vec2::ZERO, 1).unwrap()));
    let ids = [world.ids()[0], world.ids()[1]];
    let mut spring = Pairs::new(Spring::new(0, ratio(stiffness), ratio(0.5)).unwrap(), [ids]);
    world.step(
        &mut Scheme::SemiImplicitEuler.method(),
        &mut spring,
        &hz60(),
    );
    [world.bodies()[0], world.bodies()[1]]
}

/// Sixteen pairs up to 0.7 MAX apart, where their squared distance is beyond the range. Impulse
/// k h d: half a unit each for the length, the pull, its part along the axis and the push; and the
/// coefficient.
fn check_far<S: Grid>() {
    let end = S::MAX.to_f64();
    let errors: [f64; 16] = std::array::from_fn(|i| {
        let (sin, cos) = angle(i).sin_cos();
        let reach = end * (0.1 + 0.25 * spread(i + 20));
        let places = [
            vector::<S>(reach * cos, reach * sin),
            vector(-reach * cos, -reach * sin),
        ];
        assert!((2.0 * reach) * (2.0 * reach) > end);
        let [a, b] = drawn(places, 1.5);
        assert!(a.velocity() == -b.velocity());
        let off = |axis: usize| {
            let [from, to] = places.map(|place| place.to_f64().array()[axis]);
            let exact = 1.5 / 60.0 * (to - from);
            (a.velocity().to_f64().array()[axis] - exact).abs() / S::unit(0.0)
        };
        maximum(&[off(0), off(1)])
    });
    let coefficient = 2.0 * S::COEFFICIENT * 0.7 * end / 40.0 / S::unit(0.0);
    within(
        2.0 + coefficient,
        &format!("{} far spring, units of v", S::name()),
        &errors,
    );
}

#[test]
fn a_spring_longer_than_the_root_of_the_range_is_right() {
    check_far::<I16F16>();
    check_far::<I8F24>();
    check_far::<I20F12>();
}

/// From corner to corner: the distance itself is beyond the range. The bodies are drawn together
/// on both axes, with equal strength; the same where the pull is beyond the range too.
fn check_corner_to_corner<S: Grid>() {
    for (stiffness, (x, y)) in [1.0, 1e4, 1e8].into_iter().zip([(1, 1), (1, -1), (-1, 1)]) {
        let corner = |sign: i32| {
            Vec2::new(
                S::of_units(i32::MAX / 8 * 7 * x * sign),
                S::of_units(i32::MAX / 8 * 7 * y * sign),
            )
        };
        let [a, b] = drawn([corner(1), corner(-1)], stiffness);
        assert!(a.velocity() == -b.velocity());
        let v = a.velocity().array().map(S::units);
        assert!(
            v[0].signum() == -x && v[1].signum() == -y,
            "{} {v:?}",
            S::name()
        );
        assert!(v[0].unsigned_abs().abs_diff(v[1].unsigned_abs()) <= 1);
    }
}

#[test]
fn a_spring_longer_than_the_range_draws_the_right_way() {
    check_corner_to_corner::<I16F16>();
    check_corner_to_corner::<I8F24>();
    check_corner_to_corner::<I20F12>();
}

/// Where two bodies coincide the direction is unknown: nothing happens until they part.
fn check_coincident<S: Format>() {
    for scheme in SCHEMES {
        let body = point::<S>([1.25, -3.5], [0.0; 2], 2.0);
        let mut world: World<_, 2> = world([body, body]);
        let ids = [world.ids()[0], world.ids()[1]];
        let mut spring = Pairs::new(
            Spring::new(ratio(1.5), ratio(30.0), ratio(2.0)).unwrap(),
            [ids],
        );
        let mut method = scheme.method();
        for _ in 0..100 {
            world.step(&mut method, &mut spring, &hz60());
        }
        assert_eq!(world.bodies(), [body, body]);
        world
            .get_mut(ids[0])
            .unwrap()
            .set_velocity(vector(0.5, 0.0))
            .unwrap();
        for _ in 0..900 {
            world.step(&mut method, &mut spring, &hz60());
        }
        let length = (world.bodies()[1].position() - world.bodies()[0].position()).length();
        // The swing decays by 1/s, c over twice the reduced mass, less Euler's gain of h k / (2 m)
        // = 0.25/s: after 15 s at most 1.5 m e^-11 is left.
        assert!(
            (length.to_f64() - 1.5).abs() <= 1e-3,
            "{} {scheme:?} {length:?}",
            S::name()
        );
        assert_eq!(world.out_of_range().count(), 0);
    }
}

#[test]
fn coincident_bodies_on_a_spring_wait() {
    check_coincident::<f32>();
    check_coincident::<I16F16>();
    check_coincident::<I8F24>();
}

/// A body that flies to infinity, one that a spring to it makes NaN, and one that stays.
fn check_floats<S: Format>() {
    for scheme in SCHEMES {
        let still = point::<S>([1.0, 2.0], [0.0; 2], 1.0);
        let mut fast = still;
        fast.teleport(Vec2::new(S::MAX, S::ZERO)).unwrap();
        fast.set_velocity(Vec2::new(S::MAX, S::ZERO)).unwrap();
        let mut world: World<_, 3> = world([fast, still, still]);
        let ids = [world.ids()[0], world.ids()[1]];
        let (mut method, mut spring) = (
            scheme.method(),
            Pairs::new(Spring::new(1, 1, 1).unwrap(), [ids]),
        );
        assert_eq!(world.out_of_range().count(), 0);
        for _ in 0..120 {
            world.step(&mut method, &mut spring, &hz60());
        }
        assert!(world.out_of_range().eq(ids), "{} {scheme:?}", S::name());
        let alone = flown(scheme, fast);
        assert!(
            alone.out_of_range().eq([alone.ids()[0]]),
            "{} {scheme:?}",
            S::name()
        );
        assert!(alone.bodies()[0].position().x > S::MAX);
    }
}

/// A body alone, two seconds later.
fn flown<S: Format>(scheme: Scheme, body: Point<S>) -> World<Point<S>, 1> {
    let mut world: World<_, 1> = world([body]);
    let mut method = scheme.method();
    for _ in 0..120 {
        world.step(&mut method, &mut (), &hz60());
    }
    world
}

#[test]
fn floats_beyond_the_range_are_reported() {
    check_floats::<f32>();
    check_floats::<f64>();
}

/// Every force, with coefficients up to the largest, tied to the bodies `ids`.
fn hostile<S: Grid>(ids: [BodyId; 2], strength: f64) -> impl Force<Point<S>> {
    let wild = |v: Vec2<S>| Vec2::new(S::MAX.plus(v.x), S::MAX.minus(v.y).negated());
    let least = least_softening::<S>(strength);
    let pull = |softening: f64| Pull::new(ratio(strength), ratio(softening.max(least))).unwrap();
    let later = (
        QuadraticDrag::new(ratio(strength)).unwrap(),
        Push::new(ids[1], Vec2::new(S::MAX.negated(), S::MAX)),
        Window::new(3..7, AllPairs(pull(1.0))),
        AllPairs(pull(S::unit(0.0))),
    );
    let first = (
        Gravity::new(Vec2::new(S::MAX, S::MAX.negated())),
        LinearDrag::new(ratio(strength)).unwrap(),
        Anchor::new(
            ids[0],
            Vec2::new(S::MAX, S::ZERO),
            ratio(strength),
            ratio(strength),
        )
        .unwrap(),
        Pairs::new(
            Spring::new(1, ratio(strength), ratio(strength)).unwrap(),
            [ids],
        ),
        PerBody(move |_: Time, body: &Point<S>| wild(body.velocity())),
        AllBodies::<_, S, 4>::new(move |_: Time, all: &[Point<S>], _| wild(all[0].position())),
    );
    (first, later)
}

/// A random corner of the range: its ends, the middle, and their neighbours.
fn corner<S: Grid>(seed: &mut u64) -> S {
    let corners = [
        i32::MIN,
        i32::MIN + 1,
        -1,
        0,
        1,
        12_345_678,
        i32::MAX - 1,
        i32::MAX,
    ];
    *seed = seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    S::of_units(corners[(*seed >> 61) as usize])
}

/// All corners of the state space, masses from 1 g to 2000 t, through every method.
fn check_panics<S: Grid>() {
    let mut seed = 1;
    let mut body = |i: usize| {
        let mass = [ratio(1e-3), ratio(1.0), ratio(2e6)][i % 3];
        let [x, y, u, v] = [0; 4].map(|_| corner(&mut seed));
        Point::new(Vec2::new(x, y), Vec2::new(u, v), mass).unwrap()
    };
    for (scheme, strength) in SCHEMES
        .into_iter()
        .flat_map(|s| [1e-3, 1.0, 1e9].map(|k| (s, k)))
    {
        for _ in 0..256 {
            let mut world: World<_, 4> = world(std::array::from_fn(&mut body));
            let mut forces = hostile::<S>([world.ids()[0], world.ids()[1]], strength);
            let mut method = scheme.method();
            for _ in 0..10 {
                world.step(&mut method, &mut forces, &hz60());
            }
            assert_eq!(world.tick(), 10);
        }
    }
}

#[test]
fn nothing_panics_at_the_corners() {
    check_panics::<I16F16>();
    check_panics::<I8F24>();
    check_panics::<I20F12>();
}

/// Worlds without room and with one body; forces whose bodies are not there do nothing.
fn check_small<S: Format>() {
    let body = point::<S>([1.0, 2.0], [0.75, 0.5], 3.0);
    let elsewhere: World<_, 3> = world([body; 3]);
    let gone = [elsewhere.ids()[1], elsewhere.ids()[2]];
    for scheme in SCHEMES {
        let spring = || Pairs::new(Spring::new(1, 5, 1).unwrap(), [gone]);
        let anchor = || Anchor::new(gone[0], Vec2::ZERO, 5, 1).unwrap();
        let mut none = World::<Point<S>, 0>::new();
        assert_eq!(none.add(body).unwrap_err().body, body);
        let mut one: World<_, 1> = world([body]);
        let (mut no_method, mut method) = (scheme.method(), scheme.method());
        for _ in 0..64 {
            let step = fixstep::DyadicStep::<S, 1, 6>::new().unwrap();
            none.step(&mut no_method, &mut (spring(), anchor()), &step);
            one.step(&mut method, &mut (spring(), anchor()), &step);
        }
        assert_eq!(
            (none.tick(), none.len(), none.out_of_range().count()),
            (64, 0, 0)
        );
        // A second of 0.75 and 0.5 m/s, exact in every scalar here.
        let moved = one.bodies()[0];
        assert_eq!(moved.position(), vector(1.75, 2.5));
        assert_eq!(moved.velocity(), body.velocity());
    }
}

#[test]
fn worlds_of_none_and_one_step() {
    check_small::<f32>();
    check_small::<I16F16>();
    check_small::<I8F24>();
}
