//! Which bodies are drawn, which parts are taken, and what happens at the ends of the range.

use fixstep::{DyadicStep, Error, Scalar};

use super::*;

fn between<S: Scalar>(part: Ratio) -> Between<S> {
    Between::new(part, &Step::hz(RATE).unwrap()).unwrap()
}

/// A body at `x`, moving along y at 64 m/s: 1 m in 1/64 s.
fn climber(x: f64) -> Point<I16F16> {
    point([x, 0.0], [0.0, 64.0], 1.0)
}

#[test]
fn bodies_come_and_go_during_a_step() {
    let step = DyadicStep::<I16F16, 1, 6>::new().unwrap();
    let mut world = World::<_, 4>::new();
    let [first, gone, last] = [1.0, 2.0, 3.0].map(|x| world.add(climber(x)).unwrap());
    let before = world.clone();
    world.remove(gone).unwrap();
    let new = world.add(climber(4.0)).unwrap();
    world.step(&mut Verlet, &mut (), &step);
    let late = world.add(climber(5.0)).unwrap();

    let half = Between::new(dec!(0.5), &step).unwrap();
    let drawn: Vec<_> = world.between(&before, &Verlet, &half).collect();
    // The new ones stand where they are: one after its first step, one before it.
    let expected = [
        (first, 1.0, 0.5),
        (last, 3.0, 0.5),
        (new, 4.0, 1.0),
        (late, 5.0, 0.0),
    ];
    assert_eq!(drawn, expected.map(|(id, x, y)| (id, vector(x, y))));
    assert!(drawn.is_sorted_by_key(|&(id, _)| id));
    let back: Vec<_> = before.between(&before, &Verlet, &half).collect();
    assert_eq!(back.len(), 3);
}

fn refuses<S: Scalar>() {
    let (step, most) = (Step::<S>::hz(RATE).unwrap(), 1 << 62);
    let ratio = |num, den| Ratio::new(num, den).unwrap();
    for value in [
        dec!(-0.1),
        ratio(-1, most),
        ratio(most as i64, most - 1),
        dec!(1.000001),
        ratio(2, 1),
        ratio(-(most as i64), 1),
        ratio(most as i64, 1),
    ] {
        let field = "part";
        let error = Error::OutOfRange { field, value };
        assert_eq!(Between::new(value, &step).err(), Some(error));
    }
    for value in [
        ratio(0, 7),
        ratio(7, 7),
        ratio(1, most),
        ratio(most as i64 - 1, most),
        ratio(most as i64, most),
    ] {
        assert_eq!(Between::new(value, &step).err(), None, "{value}");
    }
}

#[test]
fn a_part_lies_between_0_and_1() {
    refuses::<f32>();
    refuses::<f64>();
    refuses::<I16F16>();
    refuses::<I12F20>();
    refuses::<I8F24>();
    refuses::<I20F12>();
}

// 2^-62 of a way of 100 m is below half a unit of 20 m in each type, 2^-49 m in `f64`.
fn tiny_parts_are_seen_as_none<S: Format>() {
    let (start, end) = (vector::<S>(20.0, -20.0), vector(110.0, -100.0));
    for den in [1 << 62, (1 << 62) - 1] {
        let none = between::<S>(Ratio::new(1, den).unwrap());
        let most = between::<S>(Ratio::new(den as i64 - 1, den).unwrap());
        assert_eq!(none.chord(start, end), start);
        assert_eq!(most.chord(start, end), end);
        for between in [none, most] {
            assert_eq!(between.bow(vector(100.0, -100.0)), Vec2::ZERO);
        }
    }
}

#[test]
fn parts_that_no_unit_can_tell_from_0_or_1_are_0_or_1() {
    tiny_parts_are_seen_as_none::<I16F16>();
    tiny_parts_are_seen_as_none::<I12F20>();
    tiny_parts_are_seen_as_none::<I8F24>();
}

// In floats the bow of 2^-62 is a number, and far below what a position can show.
fn tiny_parts_change_no_position<S: Format>() {
    let (before, after) = (
        point::<S>([20.0, -20.0], [100.0, -50.0], 1.0),
        point([22.0, -21.0], [120.0, -60.0], 1.0),
    );
    let none = between::<S>(Ratio::new(1, 1 << 62).unwrap());
    for scheme in SCHEMES {
        let (before, after) = (one(before), one(after));
        let at = picture(scheme, [&before, &after], &none);
        assert_eq!(at[0].1, before.bodies()[0].position());
    }
}

#[test]
fn tiny_parts_draw_the_state_before_under_every_method() {
    tiny_parts_change_no_position::<f32>();
    tiny_parts_change_no_position::<f64>();
    tiny_parts_change_no_position::<I16F16>();
    tiny_parts_change_no_position::<I20F12>();
}

fn one<S: Format>(body: Point<S>) -> Scene<S> {
    let mut world = World::new();
    world.add(body).unwrap();
    world
}

/// Every pair of states at or near an end of the range, at every part, under every method.
/// `inside` and `reached` judge what a method of one velocity draws.
fn stays_in_range<S: Format>(
    ends: [S; 6],
    inside: impl Fn(S, [S; 2]) -> bool,
    reached: impl Fn(S, [S; 2]) -> bool,
) {
    for (x0, x1) in ends.iter().flat_map(|&a| ends.map(|b| (a, b))) {
        // The change of velocity is as large: the bow of a method that has one saturates too.
        let body = |x: S| Point::new(Vec2::new(x, x), Vec2::new(x, x.negated()), 1).unwrap();
        let (before, after) = (one(body(x0)), one(body(x1)));
        for part in parts() {
            for scheme in SCHEMES {
                let at = picture(scheme, [&before, &after], &between(part))[0].1;
                assert!(at.array().iter().all(|x| x.to_f64().is_finite()));
                if matches!(scheme, Scheme::Euler | Scheme::SemiImplicitEuler) {
                    assert!(inside(at.x, [x0, x1]), "{x0:?}, {x1:?}, {part}");
                }
                assert!(part.num() != 0 || at == Vec2::new(x0, x0));
                // A way that is longer than the range ends short of the state after.
                let fits = (x1.to_f64() - x0.to_f64()).abs() <= S::MAX.to_f64();
                assert!(part != Ratio::from(1) || !fits || reached(at.x, [x0, x1]));
            }
        }
    }
}

/// Fixed point: never beyond the two states, and at the very ends.
fn fixed_stays_in_range<S: Grid>() {
    let ends = [i32::MIN, -i32::MAX, -1, 0, i32::MAX - 1, i32::MAX].map(S::of_units);
    stays_in_range(
        ends,
        |at, [x0, x1]| (x0 <= at && at <= x1) || (x1 <= at && at <= x0),
        |at, [_, x1]| at == x1,
    );
}

// A float between two states far apart has a rounded difference, up to a unit of the larger state
// off, and a rounded sum, half a unit.
#[test]
fn bodies_at_the_ends_of_the_range_are_drawn_within_it() {
    fixed_stays_in_range::<I16F16>();
    fixed_stays_in_range::<I12F20>();
    fixed_stays_in_range::<I8F24>();
    fixed_stays_in_range::<I20F12>();
    let most = f32::MAX / 2.0;
    let ends = [-most, -1.7, -0.0, 0.1, most / 3.0, most];
    let larger = |[x0, x1]: [f32; 2]| x0.abs().max(x1.abs());
    let off = |x: f32, y: f32| f64::from(x) - f64::from(y);
    stays_in_range(
        ends,
        |at, states| off(at.abs(), larger(states)) <= 1.5 * f32::unit(larger(states).into()),
        |at, states| off(at, states[1]).abs() <= 1.5 * f32::unit(larger(states).into()),
    );
}
