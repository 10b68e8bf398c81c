//! Scenes that must come out the same: mirrored, shifted by whole units, and with their bodies
//! added in another order. Everything is compared bit by bit, floats by `==`.

use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{
    AllBodies, AllPairs, Anchor, BodyId, DyadicStep, Force, Gravity, LinearDrag, Pairs, PerBody,
    Point, Pull, Push, QuadraticDrag, Scalar, Spring, Step, Time, TimeStep, Vec2, Window, World,
};
use support::*;

const STEPS: u32 = long(100_000) as u32;
/// Steps of a scene whose bodies are added in another order.
const LENGTH: u32 = if LAB { 5000 } else { 500 };

/// What is done to a scene: the sign of each axis, then a shift.
#[derive(Clone, Copy)]
struct Change<S> {
    signs: [bool; 2],
    shift: Vec2<S>,
}

impl<S: Scalar> Change<S> {
    const NONE: Change<S> = Change {
        signs: [false; 2],
        shift: Vec2::ZERO,
    };

    fn mirror(signs: [bool; 2]) -> Self {
        Change {
            signs,
            shift: Vec2::ZERO,
        }
    }

    /// A velocity, force or distance.
    fn direction(self, v: Vec2<S>) -> Vec2<S> {
        let part = |v: S, negate| if negate { v.negated() } else { v };
        Vec2::new(part(v.x, self.signs[0]), part(v.y, self.signs[1]))
    }

    fn place(self, v: Vec2<S>) -> Vec2<S> {
        self.direction(v) + self.shift
    }
}

/// Three bodies in the order of `places`; names stay with the bodies.
fn bodies<S: Scalar>(change: Change<S>, places: [usize; 3]) -> (World<Point<S>, 3>, [BodyId; 3]) {
    let mut world = World::new();
    let mut ids = [None; 3];
    for i in places {
        let (sin, cos) = (2.0 * i as f64 + 0.3).sin_cos();
        let start: Point<S> = point(
            [3.0 * cos, 2.0 * sin],
            [1.7 * sin, -0.9 * cos],
            0.7 + i as f64,
        );
        let mut body = start;
        body.teleport(change.place(start.position())).unwrap();
        body.set_velocity(change.direction(start.velocity()))
            .unwrap();
        ids[i] = Some(world.add(body).unwrap());
    }
    (world, ids.map(Option::unwrap))
}

/// Pushes that never settle: 31 of them in turn, of up to 3 N.
fn wind<S: Scalar>(change: Change<S>) -> impl FnMut(Time, &Point<S>) -> Vec2<S> {
    let gust = |i| change.direction(vector(6.0 * spread(i) - 3.0, 6.0 * spread(i + 50) - 3.0));
    let table: [Vec2<S>; 31] = std::array::from_fn(gust);
    move |time, _| table[(time.half_ticks() % 31) as usize]
}

/// Several forces together, damped enough for every method.
fn forces<S: Scalar>(change: Change<S>, ids: [BodyId; 3]) -> impl Force<Point<S>> {
    let [a, b, c] = ids;
    let hook = change.place(vector(0.37, 1.21));
    let springs = [
        Pairs::new(
            Spring::new(ratio(2.3), ratio(7.1), ratio(0.9)).unwrap(),
            [[a, b]],
        ),
        Pairs::new(
            Spring::new(ratio(1.1), ratio(5.3), ratio(1.3)).unwrap(),
            [[c, b]],
        ),
        Pairs::new(
            Spring::new(ratio(1.9), ratio(3.7), ratio(0.7)).unwrap(),
            [[c, a]],
        ),
    ];
    (
        Gravity::new(change.direction(vector(1.13, -9.81))),
        LinearDrag::new(ratio(0.31)).unwrap(),
        Anchor::new(a, hook, ratio(23.0), ratio(1.7)).unwrap(),
        springs,
        PerBody(wind(change)),
        (
            QuadraticDrag::new(ratio(0.17)).unwrap(),
            Pairs::new(gravitation(3.3), [[a, b], [c, a]]),
            Push::new(b, change.direction(vector(0.83, 1.57))),
            Window::new(
                500..1500,
                Push::new(c, change.direction(vector(-2.9, 0.71))),
            ),
        ),
    )
}

fn gravitation<S: Scalar>(constant: f64) -> Pull<S> {
    Pull::new(ratio(constant), ratio(0.6)).unwrap()
}

/// Methods with four force calls a step, whose bits would differ as soon, make fewer steps.
fn shortened(scheme: Scheme, steps: u32) -> u32 {
    match scheme {
        Scheme::Rk4 | Scheme::Pefrl => steps.min(long(50_000) as u32),
        _ => steps,
    }
}

/// A scene that can be stepped, whatever its forces.
fn run<S: Scalar, H: TimeStep<S>, const N: usize>(
    scheme: Scheme,
    step: &H,
    steps: u32,
    mut scene: (World<Point<S>, N>, impl Force<Point<S>>),
    mut see: impl FnMut(&World<Point<S>, N>),
) {
    let mut method = scheme.method();
    for _ in 0..shortened(scheme, steps) {
        scene.0.step(&mut method, &mut scene.1, step);
        see(&scene.0);
    }
}

type Track<S> = Vec<[[Vec2<S>; 2]; 3]>;

/// Positions and velocities of all three bodies, by name, after every step.
fn track<S: Scalar>(
    scheme: Scheme,
    step: &impl TimeStep<S>,
    steps: u32,
    change: Change<S>,
    places: [usize; 3],
) -> Track<S> {
    let (world, ids) = bodies(change, places);
    let forces = forces(change, ids);
    let mut track = Vec::with_capacity(steps as usize);
    run(scheme, step, steps, (world, forces), |world| {
        track.push(ids.map(|id| {
            let body = world.get(id).unwrap();
            [body.position(), body.velocity()]
        }));
    });
    track
}

const ORDER: [usize; 3] = [0, 1, 2];

/// Whether `other` is `track` after `change`, at every step; and neither came to rest.
fn assert_same<S: Scalar>(track: &Track<S>, other: &Track<S>, change: Change<S>, what: &str) {
    for (tick, (one, other)) in track.iter().zip(other).enumerate() {
        let changed = one.map(|[x, v]| [change.place(x), change.direction(v)]);
        assert!(
            changed == *other,
            "{what}, tick {}: {changed:?} {other:?}",
            tick + 1
        );
    }
    let moving = track.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(
        moving > track.len() / 2 && track.len() == other.len(),
        "{what}: at rest"
    );
}

/// Odd rounding and oddly spread gravity: a mirrored scene is the mirror of the scene.
fn check_mirror<S: Format>(step: &impl TimeStep<S>, what: &str) {
    for scheme in ALL_SCHEMES {
        let plain = track(scheme, step, STEPS, Change::NONE, ORDER);
        for signs in [[true, false], [true, true]] {
            let change = Change::mirror(signs);
            let other = track(scheme, step, STEPS, change, ORDER);
            assert_same(
                &plain,
                &other,
                change,
                &format!("{} {scheme:?} {what}", S::name()),
            );
        }
    }
}

fn check_mirrors<S: Format>() {
    check_mirror::<S>(&Step::hz(60).unwrap(), "60 Hz");
    check_mirror::<S>(&DyadicStep::<S, 1, 6>::new().unwrap(), "1/64 s");
    check_mirror::<S>(&DyadicStep::<S, 4389, 18>::new().unwrap(), "4389/2^18 s");
}

#[test]
fn mirrored_scenes_are_mirrored_in_f32() {
    check_mirrors::<f32>();
}

#[test]
fn mirrored_scenes_are_mirrored_in_i16f16() {
    check_mirrors::<I16F16>();
}

#[test]
fn mirrored_scenes_are_mirrored_in_i8f24() {
    check_mirrors::<I8F24>();
}

/// The largest shift of one axis towards `sign` that leaves room for a track and for how far a
/// half drift goes beyond it, h/2 v.
fn room<S: Grid>(track: &Track<S>, axis: usize, sign: i64) -> i32 {
    let all = || {
        track
            .iter()
            .flatten()
            .map(|[x, v]| [x.array()[axis], v.array()[axis]])
    };
    let reach = all().map(|[x, _]| sign * x.units() as i64).max().unwrap();
    let speed = all().map(|[_, v]| (v.units() as i64).abs()).max().unwrap();
    (sign * (i32::MAX as i64 - reach - speed / 120 - 1)) as i32
}

/// Forces see differences of positions only, and those do not change.
fn check_shift<S: Grid>() {
    const STEPS: u32 = if LAB { 2000 } else { 200 };
    let step = Step::hz(60).unwrap();
    for scheme in ALL_SCHEMES {
        let plain = track::<S>(scheme, &step, STEPS, Change::NONE, ORDER);
        let [right, left] = [1, -1].map(|sign| room(&plain, 0, sign));
        let [up, down] = [1, -1].map(|sign| room(&plain, 1, sign));
        let within = |low: i32, high: i32, i| low + ((high as f64 - low as f64) * spread(i)) as i32;
        let mut shifts = vec![
            [1, 0],
            [0, -1],
            [right, up],
            [left, down],
            [right, down],
            [left, up],
        ];
        shifts.extend((0..10).map(|i| [within(left, right, i), within(down, up, i + 99)]));
        for shift in shifts {
            let change = Change {
                signs: [false; 2],
                shift: Vec2::from_units(shift),
            };
            let other = track(scheme, &step, STEPS, change, ORDER);
            assert_same(
                &plain,
                &other,
                change,
                &format!("{} {scheme:?} {shift:?}", S::name()),
            );
        }
    }
}

trait FromUnits {
    fn from_units(units: [i32; 2]) -> Self;
}

impl<S: Grid> FromUnits for Vec2<S> {
    fn from_units([x, y]: [i32; 2]) -> Self {
        Vec2::new(S::of_units(x), S::of_units(y))
    }
}

#[test]
fn fixed_point_is_the_same_everywhere() {
    check_shift::<I16F16>();
    check_shift::<I12F20>();
    check_shift::<I8F24>();
}

const PERMUTATIONS: [[usize; 3]; 5] = [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// A force acts in the order of the list of forces, never in the order of the bodies.
fn check_order<S: Format>() {
    let step = Step::hz(60).unwrap();
    for scheme in ALL_SCHEMES {
        let plain = track::<S>(scheme, &step, LENGTH, Change::NONE, ORDER);
        for places in PERMUTATIONS {
            let other = track(scheme, &step, LENGTH, Change::NONE, places);
            assert_same(
                &plain,
                &other,
                Change::NONE,
                &format!("{} {scheme:?} {places:?}", S::name()),
            );
        }
    }
}

#[test]
fn the_order_of_insertion_does_not_matter() {
    check_order::<f32>();
    check_order::<I16F16>();
    check_order::<I8F24>();
}

/// Five bodies that draw and brake each other. Sums of fixed point do not depend on their order; those
/// of floats do, so a float that is drawn by all others must be added in its old place.
fn crowd<S: Grid>(scheme: Scheme, places: [usize; 5]) -> Vec<[[Vec2<S>; 2]; 5]> {
    let mut world = World::<Point<S>, 5>::new();
    let mut ids = [None; 5];
    for i in places {
        let (sin, cos) = (1.3 * i as f64).sin_cos();
        let body = point(
            [5.0 * cos, 4.0 * sin],
            [sin, 0.7 - cos],
            1.0 + 0.3 * i as f64,
        );
        ids[i] = Some(world.add(body).unwrap());
    }
    let ids = ids.map(Option::unwrap);
    let (pull, brake) = (scalar::<S>(1.1), scalar::<S>(0.05));
    let all = AllBodies::<_, S, 5>::new(move |_: Time, all: &[Point<S>], i: usize| {
        all.iter().fold(Vec2::ZERO, |sum, other| {
            let (dx, dv) = (
                other.position() - all[i].position(),
                other.velocity() - all[i].velocity(),
            );
            sum + dx.map(|d| d.times(pull)) + dv.map(|d| d.times(brake))
        })
    });
    let mut track = Vec::new();
    run(
        scheme,
        &Step::hz(60).unwrap(),
        LENGTH,
        (world, (all, AllPairs(gravitation(0.9)))),
        |world| {
            track.push(ids.map(|id| {
                let body = world.get(id).unwrap();
                [body.position(), body.velocity()]
            }));
        },
    );
    track
}

fn check_crowd<S: Grid>() {
    for scheme in ALL_SCHEMES {
        let plain = crowd::<S>(scheme, [0, 1, 2, 3, 4]);
        for places in [[4, 3, 2, 1, 0], [2, 0, 4, 1, 3], [1, 4, 0, 3, 2]] {
            assert!(
                plain == crowd::<S>(scheme, places),
                "{} {scheme:?} {places:?}",
                S::name()
            );
        }
        assert!(plain[plain.len() - 2] != plain[plain.len() - 1], "at rest");
    }
}

#[test]
fn the_order_of_insertion_does_not_matter_to_all_bodies() {
    check_crowd::<I16F16>();
    check_crowd::<I12F20>();
    check_crowd::<I8F24>();
}
