//! The table of bad inputs in the documentation of `error`: one test a row, and no row without one.
//!
//! A test hands back what it was refused with; the table must name that error.

#[path = "bad_input/exact.rs"]
mod exact;
#[path = "bad_input/rewinds.rs"]
mod rewinds;
#[path = "bad_input/shapes.rs"]
mod shapes;
#[path = "bad_input/snapshots.rs"]
mod snapshots;
#[path = "bad_input/turning.rs"]
mod turning;

use std::fmt::Debug;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Accumulator, AllBodies, Anchor, Ballistic, Between, Body, BodyId, CentreOfMass, Error,
    ExactDrag, ExactQuadraticDrag, GravityY, LinearDrag, Pairs, PerBody, Point, PointMass, Pull,
    QuadraticDrag, Ratio, SemiImplicitEuler, Spring, Stale, Step, Time, Vec2, World, dec, vec2,
};

/// The first word of each error: the name of its variant or type.
type Errors = Vec<String>;

fn name(error: impl Debug) -> String {
    let text = format!("{error:?}");
    let end = text.find(|c: char| !c.is_alphanumeric());
    text[..end.unwrap_or(text.len())].into()
}

/// What a call was refused with; a call that went through has no name that a table would know.
fn refused<T: Debug, E: Debug>(result: Result<T, E>) -> String {
    match result {
        Ok(value) => format!("accepted {value:?}"),
        Err(error) => name(error),
    }
}

/// Input and error of each row of the table.
fn table() -> Vec<(&'static str, &'static str)> {
    let rows = include_str!("../../src/error.rs").lines();
    let rows = rows.filter_map(|line| line.strip_prefix("//! | "));
    let cells = rows.map(|row| row.split(" | ").map(str::trim).collect::<Vec<_>>());
    cells.skip(1).map(|cells| (cells[0], cells[2])).collect()
}

/// The row of `input` names exactly these errors.
fn check(input: &str, errors: &Errors) {
    let row = table().into_iter().find(|row| row.0 == input);
    let (_, told) = row.unwrap_or_else(|| panic!("no row for: {input}"));
    assert!(told.starts_with("none") == errors.is_empty(), "{input}");
    for error in errors {
        assert_eq!(told, format!("`{error}`"), "{input}");
    }
}

macro_rules! rows {
    ($($name:ident, $input:literal: $errors:expr;)*) => {
        $(
            #[test]
            fn $name() {
                check($input, &$errors);
            }
        )*
        const INPUTS: &[&str] = &[$($input),*];
    };
}

rows! {
    mass_of_nothing, "a mass of zero or less": masses(&[dec!(0), dec!(-1.5)]);
    mass_beyond, "a mass whose inverse the scalar cannot hold": masses(&[dec!(0.0004), dec!(3000000)]);
    nan_number, "NaN or infinity as a number": not_finite_numbers();
    odd_fraction, "a fraction over zero, or of more than 62 bits":
        vec![refused(Ratio::new(1, 0)), refused(Ratio::new(i64::MIN, 1))];
    odd_text, "a text that is no plain decimal":
        ["1e9", "", "-", "1.2.3", "NaN"].map(|text| refused(Ratio::parse(text))).into();
    component_beyond, "a component outside of the scalar":
        vec![refused(vec2::<I16F16>(40_000, 0)), refused(vec2::<I8F24>(0, -128))];
    nan_state, "NaN or infinity as position or velocity": not_finite_states();
    rate_of_nothing, "a rate of zero or less":
        vec![refused(Step::<I16F16>::hz(0)), refused(Step::<f32>::hz(-60))];
    step_beyond, "a step of a quarter second or more, or too short": steps();
    coefficient_below_zero, "a coefficient below zero": coefficients(dec!(-0.1));
    coefficient_beyond, "a coefficient that is too large, or a softening too small for it": too_large();
    coefficient_lost, "a coefficient or softening that would be zero, but is not": lost();
    length_beyond, "a length or acceleration outside of the scalar": vec![
        refused(Spring::<I16F16>::new(40_000, 1, 0)),
        refused(Pull::<I16F16>::new(1, 40_000)),
        refused(GravityY::<I8F24>::new(200)),
    ];
    softening_of_nothing, "a softening of zero or less":
        vec![refused(Pull::<I16F16>::new(1, 0)), refused(Pull::<f32>::new(1, -1))];
    frequency_of_nothing, "a frequency of zero or less": exact::frequencies_of_nothing();
    damping_below_zero, "a damping ratio below zero": exact::damping_below_zero();
    spring_beyond, "a frequency below `2^-20` Hz or from `2^20` Hz, or a damping ratio from `2^10`": exact::beyond();
    sag_beyond, "a sag outside of the scalar, or from its point to there": exact::sags();
    no_points, "no point masses": vec![refused(CentreOfMass::<I16F16>::new(&[]))];
    point_of_no_mass, "a point mass of zero or less": point_masses();
    point_not_finite, "a point mass that is NaN or infinite": not_finite_point_masses();
    total_beyond, "a total mass that no fraction of 62 bits, or no body, can hold": totals();
    shape_of_no_length, "a radius, width or height of zero or less": shapes::of_no_length();
    shape_below_zero, "an inner radius or a length below zero": shapes::below_zero();
    ring_inside_out, "an inner radius above the outer": shapes::inside_out();
    shape_too_large, "a shape too large for 62 bits of square metres": shapes::too_large();
    shape_too_small, "a shape too small for them": shapes::too_small();
    no_vertices, "no vertices": shapes::no_vertices();
    vertices_not_finite, "a vertex that is NaN or infinite, or too many square metres for 62 bits": shapes::vertices_not_finite();
    polygon_without_area, "a polygon without area: on one line, of two vertices, in two lobes alike": shapes::without_area();
    polygon_not_convex, "a corner that is straight or turns the other way, or a second turn": shapes::not_convex();
    shape_of_no_mass, "a shape's mass or density of zero or less, or a density where it has no area": shapes::of_no_mass();
    shape_too_heavy, "a shape's mass that 62 bits cannot hold": shapes::too_heavy();
    shape_too_light, "a shape's mass of so little inertia that it would be zero": shapes::too_light();
    known_of_no_mass, "mass properties of no mass or less": shapes::known_of_no_mass();
    inertia_below_zero, "a moment of inertia below zero": shapes::inertia_below_zero();
    part_out_of_range, "a part that is moved out of the range, or a point that is NaN": shapes::places();
    no_parts, "no parts": shapes::no_parts();
    sums_of_parts_beyond, "parts whose sums 62 bits cannot hold": shapes::sums_beyond();
    hole_too_large, "a hole that takes more mass or inertia than there is": shapes::holes();
    inertia_of_nothing, "an inertia of zero or less": turning::inertia_of_nothing();
    inertia_beyond, "an inertia whose inverse the scalar cannot hold": turning::inertia_beyond();
    spin_beyond, "a spin outside of the scalar": turning::spin_beyond();
    nan_turning, "NaN or infinity as state of a body that turns": turning::nan_state();
    spin_drag_below_zero, "a drag against spin below zero": turning::drag_below_zero();
    clock_that_stands, "a clock that stands still, or no steps a frame": vec![
        refused(Accumulator::new(0, dec!(0.02), 4)),
        refused(Accumulator::new(1000, dec!(0), 4)),
        refused(Accumulator::new(1000, dec!(0.02), 0)),
    ];
    clock_without_unit, "a clock and a step without a common unit":
        vec![refused(Accumulator::new(u32::MAX, Ratio::new((1 << 62) - 1, (1 << 61) - 1).unwrap(), 4))];
    part_beyond, "a part of a step below 0 or above 1": parts();
    full_world, "a body for a full world, or one that has given `2^32` ids": full();
    stale_id, "a stale id": stale();
    stale_force, "a stale id in a force": waiting_force();
    range_left, "a scene that leaves the range": saturated();
    nan_force, "NaN in a vector or from a function that a force was given": nan_force_spreads();
    few_places, "fewer places in `AllBodies` than bodies": few_places_reach();
    short_slice, "a slice too short for a snapshot": snapshots::short_slice();
    other_length, "a cut header, or another count than the bytes hold": snapshots::other_length();
    other_bytes, "bytes that are no snapshot": snapshots::other_bytes();
    other_version, "a snapshot of another version": snapshots::other_version();
    changed_bit, "a snapshot with a changed bit, or cut behind its header": snapshots::changed_bit();
    other_kind, "a snapshot of another kind of body": snapshots::other_kind();
    other_scalar, "a snapshot of another number type": snapshots::other_scalar();
    other_room, "a snapshot of more bodies than there is room": snapshots::other_room();
    other_state, "a snapshot whose ids do not rise, or of no mass or inertia": snapshots::other_state();
    back_from_0, "to go back from tick 0": rewinds::from_0();
    back_from_outside, "to go back with a body that has left the range, or would on the way": rewinds::from_outside();
    back_through_damping, "to undo a step in which a force has damping": rewinds::through_damping();
}

#[test]
fn every_row_has_its_test() {
    let told: Vec<_> = table().into_iter().map(|row| row.0).collect();
    assert_eq!(told, INPUTS);
}

fn point<S: fixstep::Scalar>(mass: impl Into<Ratio>) -> Result<Point<S>, Error> {
    Point::new(Vec2::ZERO, Vec2::ZERO, mass)
}

fn masses(masses: &[Ratio]) -> Errors {
    let of = |&mass| refused(point::<I16F16>(mass));
    masses.iter().map(of).collect()
}

fn not_finite_numbers() -> Errors {
    let numbers = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300];
    numbers
        .map(|number| refused(Ratio::from_f64(number)))
        .into()
}

fn not_finite_states() -> Errors {
    let bad = Vec2::new(0.0, f32::NAN);
    let far = Vec2::new(f32::INFINITY, 0.0);
    let sound = Point::new(Vec2::new(1.0_f32, 2.0), Vec2::new(3.0, 4.0), 5).unwrap();
    let mut tried = sound;
    let errors = vec![
        refused(Point::new(bad, Vec2::ZERO, 1)),
        refused(Point::new(Vec2::ZERO, far, 1)),
        refused(tried.teleport(far)),
        refused(tried.set_velocity(bad)),
    ];
    assert_eq!(tried, sound);
    errors
}

fn steps() -> Errors {
    let instant = Ratio::new(1, 1 << 62).unwrap();
    vec![
        refused(Step::<I16F16>::hz(4)),
        refused(Step::<f32>::from_seconds(dec!(0.25))),
        refused(Step::<I16F16>::from_seconds(instant)),
    ]
}

fn coefficients(value: Ratio) -> Errors {
    let mut world = World::<Point<I16F16>, 1>::new();
    let id = world.add(point(1).unwrap()).unwrap();
    vec![
        refused(LinearDrag::<I16F16>::new(value)),
        refused(QuadraticDrag::<I16F16>::new(value)),
        refused(Pull::<I16F16>::new(value, 1)),
        refused(Spring::<I16F16>::new(1, value, 0)),
        refused(Spring::<I16F16>::new(1, 1, value)),
        refused(Anchor::<I16F16>::new(id, Vec2::ZERO, value, 0)),
        refused(Anchor::<I16F16>::new(id, Vec2::ZERO, 1, value)),
        refused(ExactDrag::<I16F16>::new(value)),
        refused(ExactQuadraticDrag::<I16F16>::new(value)),
        refused(Ballistic::<I16F16>::new(Vec2::ZERO, value)),
    ]
}

fn too_large() -> Errors {
    let mut errors = coefficients(dec!(3000000000));
    errors.push(refused(Pull::<I16F16>::new(1, dec!(0.0009))));
    errors.push(refused(Pull::<f32>::new(1, dec!(0.0000001))));
    errors
}

fn lost() -> Errors {
    let mut errors = coefficients(dec!(0.00000000001));
    errors.push(refused(Pull::<I16F16>::new(1, dec!(0.000001))));
    errors
}

fn point_masses() -> Errors {
    let of = |mass| PointMass {
        position: Vec2::<I16F16>::ZERO,
        velocity: Vec2::ZERO,
        mass,
    };
    let sets = [[of(dec!(1)), of(dec!(0))], [of(dec!(-2)), of(dec!(3))]];
    sets.map(|set| refused(CentreOfMass::new(&set))).into()
}

fn not_finite_point_masses() -> Errors {
    let of = |position, velocity| {
        let mass = dec!(1);
        refused(CentreOfMass::new(&[PointMass {
            position,
            velocity,
            mass,
        }]))
    };
    let bad = Vec2::new(f32::NAN, 0.0);
    vec![of(bad, Vec2::ZERO), of(Vec2::ZERO, bad)]
}

fn totals() -> Errors {
    let of = |mass| PointMass {
        position: Vec2::<I16F16>::ZERO,
        velocity: Vec2::ZERO,
        mass,
    };
    let whole = |mass| Ratio::new(mass, 1).unwrap();
    let heavy = CentreOfMass::new(&[of(whole(2_000_000)), of(whole(2_000_000))]).unwrap();
    vec![
        refused(CentreOfMass::new(&[of(whole(1 << 62)), of(whole(1))])),
        refused(heavy.point()),
    ]
}

fn parts() -> Errors {
    let step = Step::<I16F16>::hz(60).unwrap();
    [dec!(-0.01), dec!(1.01), dec!(2)]
        .map(|part| refused(Between::new(part, &step)))
        .into()
}

fn full() -> Errors {
    let (first, second) = (point::<f32>(1).unwrap(), point::<f32>(2).unwrap());
    let mut world = World::<_, 1>::new();
    let id = world.add(first).unwrap();
    let error = world.add(second).unwrap_err();
    assert_eq!((error.body, error.capacity), (second, 1));
    assert_eq!((world.get(id), world.len()), (Ok(&first), 1));
    vec![name(error), snapshots::no_id_left()]
}

/// A world of one body, and the id of another that is gone.
fn with_a_gap() -> (World<Point<I16F16>, 2>, BodyId) {
    let mut world = World::new();
    let gone = world.add(point(1).unwrap()).unwrap();
    world.add(point(2).unwrap()).unwrap();
    world.remove(gone).unwrap();
    (world, gone)
}

fn stale() -> Errors {
    let (mut world, gone) = with_a_gap();
    let before = world.state_hash();
    let errors = vec![
        name(world.get(gone).unwrap_err()),
        name(world.get_mut(gone).unwrap_err()),
        name(world.remove(gone).unwrap_err()),
        name(world.index_of(gone).unwrap_err()),
    ];
    assert_eq!(world.get(gone), Err(Stale(gone)));
    assert_eq!(world.state_hash(), before);
    errors
}

fn waiting_force() -> Errors {
    let (mut world, gone) = with_a_gap();
    let spring = Spring::new(1, 40, 1).unwrap();
    let mut forces = (
        Pairs::new(spring, [[gone, world.ids()[0]]]),
        GravityY::new(-8).unwrap(),
    );
    let step = fixstep::DyadicStep::<I16F16, 1, 6>::new().unwrap();
    world.step(&mut SemiImplicitEuler, &mut forces, &step);
    assert_eq!(world.bodies()[0].velocity(), vec2(0, dec!(-0.125)).unwrap());
    exact::waiting_springs();
    Errors::new()
}

fn saturated() -> Errors {
    let mut world = World::<Point<I16F16>, 2>::new();
    world.add(point(1).unwrap()).unwrap();
    let fast = Point::new(vec2(32_000, 0).unwrap(), vec2(30_000, 0).unwrap(), 1).unwrap();
    let fast = world.add(fast).unwrap();
    let step = Step::hz(60).unwrap();
    (0..60).for_each(|_| world.step(&mut SemiImplicitEuler, &mut (), &step));
    assert!(world.out_of_range().eq([fast]));
    assert_eq!(world.get(fast).unwrap().position().x, I16F16::MAX);
    Errors::new()
}

fn nan_force_spreads() -> Errors {
    let mut world = World::<Point<f32>, 2>::new();
    let lost = world.add(point(1).unwrap()).unwrap();
    world
        .add(Point::new(Vec2::new(1.0, 0.0), Vec2::ZERO, 1).unwrap())
        .unwrap();
    let nan_at_0 = |_: Time, body: &Point<f32>| Vec2::new(0.0 / body.position().x, 0.0);
    let step = Step::hz(60).unwrap();
    world.step(&mut SemiImplicitEuler, &mut PerBody(nan_at_0), &step);
    assert!(world.out_of_range().eq([lost]));
    Errors::new()
}

fn few_places_reach() -> Errors {
    let mut world = World::<Point<f32>, 3>::new();
    for mass in 1..=3 {
        world.add(point(mass).unwrap()).unwrap();
    }
    let wind = |_: Time, _: &[Point<f32>], _| Vec2::new(60.0, 0.0);
    let step = Step::hz(60).unwrap();
    world.step(
        &mut SemiImplicitEuler,
        &mut AllBodies::<_, f32, 2>::new(wind),
        &step,
    );
    let moved = world.bodies().iter().map(|body| body.velocity().x > 0.0);
    assert!(moved.eq([true, true, false]));
    Errors::new()
}
