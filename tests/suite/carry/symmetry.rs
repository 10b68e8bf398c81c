//! Scenes of bodies that carry which must come out the same: mirrored, shifted, with their bodies
//! added in another order. Everything is compared to the bit, places and remainders too.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Anchor, BodyId, Carried, DyadicStep, ExactDrag, Force, Gravity, LinearDrag, Pairs, PerBody,
    Point, Pull, Push, QuadraticDrag, Spring, Step, Time, TimeStep, Vec2, World,
};

use super::bits::{Fine, fine, places};
use crate::support::*;

/// What is done to a scene: a sign for each axis, then a shift in units.
#[derive(Clone, Copy, Debug)]
struct Change {
    signs: [i32; 2],
    shift: [i32; 2],
}

const NONE: Change = Change {
    signs: [1; 2],
    shift: [0; 2],
};

impl Change {
    fn direction<S: Fine>(self, v: Vec2<S>) -> Vec2<S> {
        let [x, y] = [0, 1].map(|i| S::of_units(v.array()[i].units() * self.signs[i]));
        Vec2::new(x, y)
    }

    fn place<S: Fine>(self, v: Vec2<S>) -> Vec2<S> {
        let [x, y] = self.shift.map(S::of_units);
        self.direction(v) + Vec2::new(x, y)
    }
}

type Scene<S> = World<Carried<S>, 3>;

/// Three bodies around `middle` in the order of `places`; names stay with the bodies.
fn bodies<S: Fine>(change: Change, order: [usize; 3], middle: f64) -> (Scene<S>, [BodyId; 3]) {
    let (mut world, mut ids) = (World::new(), [None; 3]);
    for i in order {
        let (sin, cos) = (2.0 * i as f64 + 0.3).sin_cos();
        let (x, v) = (
            [middle + 3.0 * cos, middle + 2.0 * sin],
            [1.7 * sin, -0.9 * cos],
        );
        let start: Point<S> = point(x, v, 0.7 + i as f64);
        let mut body = start;
        body.teleport(change.place(start.position())).unwrap();
        body.set_velocity(change.direction(start.velocity()))
            .unwrap();
        ids[i] = Some(world.add(body.into()).unwrap());
    }
    (world, ids.map(Option::unwrap))
}

/// Pushes that never settle: 31 of them in turn, of up to 3 N.
fn wind<S: Fine>(change: Change) -> impl FnMut(Time, &Carried<S>) -> Vec2<S> {
    let gust = |i| change.direction(vector(6.0 * spread(i) - 3.0, 6.0 * spread(i + 50) - 3.0));
    let table: [Vec2<S>; 31] = std::array::from_fn(gust);
    move |time, _| table[(time.half_ticks() % 31) as usize]
}

fn forces<S: Fine + fixstep::Decay>(
    change: Change,
    [a, b, c]: [BodyId; 3],
    middle: f64,
) -> impl Force<Carried<S>> {
    let hook = change.place(vector(middle + 0.37, middle + 1.21));
    let spring = |rest: f64, k: f64, c: f64, pair| {
        Pairs::new(
            Spring::new(ratio(rest), ratio(k), ratio(c)).unwrap(),
            [pair],
        )
    };
    (
        Gravity::new(change.direction(vector(1.13, -9.81))),
        LinearDrag::new(ratio(0.31)).unwrap(),
        Anchor::new(a, hook, ratio(23.0), ratio(1.7)).unwrap(),
        [
            spring(2.3, 7.1, 0.9, [a, b]),
            spring(1.1, 5.3, 1.3, [c, b]),
            spring(1.9, 3.7, 0.7, [c, a]),
        ],
        PerBody(wind(change)),
        (
            ExactDrag::new(ratio(0.07)).unwrap(),
            QuadraticDrag::new(ratio(0.17)).unwrap(),
            Pairs::new(Pull::new(ratio(3.3), ratio(0.6)).unwrap(), [[a, b], [c, a]]),
            Push::new(b, change.direction(vector(0.83, 1.57))),
        ),
    )
}

/// Place and fine velocity of all three bodies, by name, after every step.
type Track = Vec<[[[i128; 2]; 2]; 3]>;

fn track<S: Fine + fixstep::Decay>(
    scheme: Scheme,
    step: &impl TimeStep<S>,
    steps: usize,
    (change, order): (Change, [usize; 3]),
    middle: f64,
) -> Track {
    let (mut world, ids) = bodies(change, order, middle);
    let (mut method, mut forces) = (scheme.method(), forces(change, ids, middle));
    let after = |_| {
        world.step(&mut method, &mut forces, step);
        ids.map(|id| {
            let body = world.get(id).unwrap();
            [places(body), fine(body)]
        })
    };
    (0..steps).map(after).collect()
}

const ORDER: [usize; 3] = [0, 1, 2];

fn assert_same(track: &Track, other: &Track, change: Change, what: &str) {
    let signed = |v: [i128; 2], shift: [i32; 2]| {
        [0, 1].map(|i| v[i] * change.signs[i] as i128 + ((shift[i] as i128) << 32))
    };
    for (tick, (one, other)) in track.iter().zip(other).enumerate() {
        let changed = one.map(|[x, v]| [signed(x, change.shift), signed(v, [0; 2])]);
        assert!(
            changed == *other,
            "{what} tick {}: {changed:?} {other:?}",
            tick + 1
        );
    }
    let moving = track.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(
        moving > track.len() / 2 && track.len() == other.len(),
        "{what}: at rest"
    );
}

fn check_mirror<S: Fine + fixstep::Decay>(step: &impl TimeStep<S>, what: &str) {
    for scheme in SCHEMES {
        let plain = track::<S>(scheme, step, 1000, (NONE, ORDER), 0.0);
        for signs in [[-1, 1], [-1, -1]] {
            let change = Change { signs, ..NONE };
            let other = track(scheme, step, 1000, (change, ORDER), 0.0);
            let what = format!("{} {scheme:?} {what} {signs:?}", S::name());
            assert_same(&plain, &other, change, &what);
        }
    }
}

#[test]
fn mirrored_scenes_are_mirrored() {
    check_mirror::<I16F16>(&Step::hz(60).unwrap(), "60 Hz");
    check_mirror::<I16F16>(&DyadicStep::<_, 1, 6>::new().unwrap(), "1/64 s");
    check_mirror::<I8F24>(&DyadicStep::<_, 4389, 18>::new().unwrap(), "4389/2^18 s");
}

/// Forces see differences of positions. At a rate that is not dyadic no place lies half-way between
/// two positions but for one in `2^32`, so it does not matter on which side of the origin it is.
fn check_shift<S: Fine + fixstep::Decay>() {
    let step = Step::hz(60).unwrap();
    // Within 12 m of the middle, and as far from the ends.
    let room = (0.8 * S::MAX.to_f64() / S::unit(0.0)) as i32;
    for scheme in SCHEMES {
        let plain = track::<S>(scheme, &step, 300, (NONE, ORDER), 0.0);
        let part = |i: usize| ((2.0 * spread(i) - 1.0) * room as f64) as i32;
        let random = (0..16).map(|i| [part(i), part(i + 99)]);
        let near = [[1, 0], [0, -1], [room, room], [-room, room], [-room, -room]];
        for shift in near.into_iter().chain(random) {
            let change = Change { shift, ..NONE };
            let other = track(scheme, &step, 300, (change, ORDER), 0.0);
            let what = format!("{} {scheme:?} {shift:?}", S::name());
            assert_same(&plain, &other, change, &what);
        }
    }
}

#[test]
fn shifted_scenes_are_shifted() {
    check_shift::<I16F16>();
    check_shift::<I8F24>();
}

/// At a dyadic rate places do lie half-way, and are seen away from the origin: a scene that stays on
/// its side of each axis is the same wherever it is there.
fn check_dyadic_shift<S: Fine + fixstep::Decay>() {
    let step = DyadicStep::<S, 1, 6>::new().unwrap();
    for scheme in SCHEMES {
        let plain = track::<S>(scheme, &step, 1000, (NONE, ORDER), 40.0);
        assert!(
            plain
                .iter()
                .flatten()
                .all(|[x, _]| x.iter().all(|&x| x > 0))
        );
        for shift in [[1, 0], [12_345, 6_789], [S::MAX.units() / 4, 3]] {
            let change = Change { shift, ..NONE };
            let other = track(scheme, &step, 1000, (change, ORDER), 40.0);
            let what = format!("{} {scheme:?} 1/64 s {shift:?}", S::name());
            assert_same(&plain, &other, change, &what);
        }
    }
}

#[test]
fn shifted_scenes_are_shifted_at_a_dyadic_rate_on_one_side() {
    check_dyadic_shift::<I16F16>();
    check_dyadic_shift::<I8F24>();
}

fn check_order<S: Fine + fixstep::Decay>() {
    let step = Step::hz(60).unwrap();
    for scheme in SCHEMES {
        let plain = track::<S>(scheme, &step, 1000, (NONE, ORDER), 0.0);
        for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let other = track(scheme, &step, 1000, (NONE, order), 0.0);
            let what = format!("{} {scheme:?} {order:?}", S::name());
            assert_same(&plain, &other, NONE, &what);
        }
    }
}

#[test]
fn the_order_of_insertion_does_not_matter() {
    check_order::<I16F16>();
    check_order::<I8F24>();
}
