//! The body that remembers: it moves as the one inside, and each verb looks at the range.

use fixstep::fixed::types::{I16F16, I32F32};
use fixstep::world::snapshot::SnapshotError;
use fixstep::{GravityY, LinearDrag, Pairs, QuadraticDrag, Ratio, Saved, Spring, Vec2, dec};

use super::*;
use crate::support::{SCHEMES, point, ratio, spread, vector, world};

type Ball = RangeChecked<Point<I16F16>>;

/// A verb with its arguments.
type Verb<'a> = &'a dyn Fn(&mut Ball);

fn ball(x: f64, v: f64) -> Ball {
    RangeChecked::new(point([0.0, x], [v, 0.0], 1.0))
}

#[test]
fn it_takes_four_bytes() {
    assert_eq!((size_of::<Point<I16F16>>(), size_of::<Ball>()), (20, 24));
    assert_eq!(size_of::<RangeChecked<Point<I32F32>>>(), 48);
}

/// The same bits as plain points, drags and all: `step_back` is what they cannot have.
#[test]
fn it_moves_as_the_body_inside() {
    let step = Step::<I16F16>::hz(60).unwrap();
    for scheme in SCHEMES {
        for start in 0..16 {
            let of = |i: usize| {
                let at = spread(3 * start + i);
                point([at, 3.0 * at], [2.0 - at, at], 0.5 + at)
            };
            let points: [Point<I16F16>; 2] = [of(0), of(1)];
            let (mut plain, mut watching) = (world(points), watched(points));
            let [a, b] = plain.ids() else { unreachable!() };
            let mut forces = (
                GravityY::new(ratio(-9.81)).unwrap(),
                LinearDrag::new(ratio(0.31)).unwrap(),
                QuadraticDrag::new(ratio(0.17)).unwrap(),
                Pairs::new(Spring::new(2, ratio(7.1), ratio(0.9)).unwrap(), [[*a, *b]]),
            );
            let (mut one, mut other) = (scheme.method(), scheme.method());
            for _ in 0..200 {
                plain.step(&mut one, &mut forces, &step);
                watching.step(&mut other, &mut forces, &step);
                assert_eq!(plain.state_hash(), watching.state_hash(), "{scheme:?}");
            }
            let inside = watching.bodies().iter().map(|ball| *ball.body());
            assert!(inside.eq(plain.bodies().iter().copied()));
            assert!(watching.bodies().iter().all(|ball| !ball.was_outside()));
        }
    }
}

/// Each verb once from 20 km or 20 km/s by as much again, and back where it was: only the mark tells.
#[test]
fn each_verb_sees_the_end_of_the_range() {
    let step = DyadicStep::<I16F16, 1, 1>::new().unwrap();
    let coef = |k: i64| {
        let k = Ratio::new(k, 1).unwrap();
        <<I16F16 as Scalar>::Coef as fixstep::Factor<I16F16>>::new(k).unwrap()
    };
    let [up, x, y] = [20_000.0, 10_000.0, 0.0];
    let along: Vec2<I16F16> = vector(x, y);
    let verbs: [(&str, Verb); 11] = [
        ("kick", &|ball| ball.kick(vector(up, 0.0))),
        ("kick_y", &|ball| {
            ball.kick_y(I16F16::from_num(32_767) + I16F16::DELTA * 65_535)
        }),
        ("kick_by", &|ball| ball.kick_by(along, coef(2))),
        ("brake_by", &|ball| ball.brake_by(along, coef(-2))),
        ("push", &|ball| ball.push(vector(up, 0.0))),
        ("damp", &|ball| ball.damp(coef(-1))),
        ("shift", &|ball| ball.shift(vector(0.0, up))),
        ("move_by", &|ball| {
            ball.move_by(Vec2::new(along.y, along.x), coef(2))
        }),
        ("drift_by", &|ball| ball.drift_by(coef(2))),
        ("drift", &|ball| (0..4).for_each(|_| ball.drift(&step))),
        ("drift_half", &|ball| {
            (0..8).for_each(|_| ball.drift_half(&step))
        }),
    ];
    for (name, verb) in verbs {
        let mut far = ball(20_000.0, 20_000.0);
        verb(&mut far);
        assert!(far.was_outside(), "{name}");
        far.change(|point| point.teleport(Vec2::ZERO)).unwrap();
        far.change(|point| point.set_velocity(Vec2::ZERO)).unwrap();
        assert!(far.is_inside() && far.was_outside(), "{name}");
        far.forget();
        assert!(!far.was_outside(), "{name}");
    }
    let mut near = ball(1.0, 1.0);
    verbs
        .iter()
        .filter(|(name, _)| *name != "kick_y")
        .for_each(|(_, verb)| {
            verb(&mut near);
            near.change(|point| point.set_velocity(vector(1.0, 0.0)))
                .unwrap();
            near.change(|point| point.teleport(Vec2::ZERO)).unwrap();
        });
    assert!(!near.was_outside());
}

#[test]
fn a_body_at_the_end_is_marked_from_the_start_and_by_hand() {
    let end = Vec2::new(I16F16::MIN, I16F16::ZERO);
    let at_end = RangeChecked::new(Point::new(end, Vec2::ZERO, 1).unwrap());
    assert!(at_end.was_outside());
    let mut placed = ball(0.0, 0.0);
    placed.change(|point| point.teleport(end)).unwrap();
    assert!(placed.was_outside());
    placed.forget(); // it stands there still
    assert!(placed.was_outside());
}

#[test]
fn a_snapshot_keeps_the_mark() {
    type Scene = World<Ball, 2>;
    let mut scene: Scene = watched([point([1.0, 2.0], [3.0, 4.0], 0.7); 2]);
    let second = scene.ids()[1];
    let far = scene.get_mut(second).unwrap();
    far.kick(vector(32_000.0, 0.0));
    far.kick(vector(32_000.0, 0.0));
    far.kick(vector(-32_000.0, 0.0));
    let step = Step::hz(60).unwrap();
    let mut fall = GravityY::new(dec!(-9.81)).unwrap();
    scene.step(&mut Verlet, &mut fall, &step);
    let mut bytes = [0; Scene::SNAPSHOT];
    assert_eq!(scene.save(&mut bytes), Ok(40 + 2 * (4 + 20 + 1)));
    let mut again = Scene::load(&bytes).unwrap();
    assert_eq!(state(&again), state(&scene));
    let refused = fixstep::RewindError::Saturated { body: second };
    assert_eq!(again.step_back(&mut Verlet, &mut fall, &step), Err(refused));
    let plain = World::<Point<I16F16>, 2>::load(&bytes);
    assert_eq!(plain.map(drop), Err(SnapshotError::Kind(0x4001)));
}

/// A mark is one of two bytes, and a body at the end of the range has it whatever its byte says.
#[test]
fn a_forged_mark_is_refused_or_mended() {
    let load = |body: Ball, mark: u64| {
        let mut words = Vec::new();
        body.save(&mut |word, _| words.push(word));
        *words.last_mut().unwrap() = mark;
        let mut words = words.into_iter();
        Ball::load(&mut |_| words.next().unwrap()).map(|body| body.was_outside())
    };
    let end =
        RangeChecked::new(Point::new(Vec2::new(I16F16::MAX, I16F16::ZERO), Vec2::ZERO, 1).unwrap());
    assert_eq!(load(ball(1.0, 2.0), 0), Some(false));
    assert_eq!(load(ball(1.0, 2.0), 1), Some(true));
    assert_eq!(load(ball(1.0, 2.0), 2), None);
    assert_eq!(load(end, 0), Some(true));
}
