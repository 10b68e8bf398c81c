//! The table of bad inputs in the documentation of `error`: one test a row, and no row without one.
//!
//! A row has the calls that are refused. Where an error has a field and a value, the case says which; the table must name the
//! error. What is just accepted stands beside it.

#[path = "refusals/exact.rs"]
mod exact;
#[path = "refusals/rewinds.rs"]
mod rewinds;
#[path = "refusals/shapes.rs"]
mod shapes;
#[path = "refusals/snapshots.rs"]
mod snapshots;
#[path = "refusals/text.rs"]
mod text;
#[path = "refusals/turning.rs"]
mod turning;

use std::fmt::Debug;

use fixstep::fixed::types::{I1F31, I8F24, I16F16};
use fixstep::{
    Accumulator, AllBodies, Anchor, Ballistic, Between, Body, BodyId, CentreOfMass, DyadicStep,
    Error, ExactDrag, ExactQuadraticDrag, GravityY, LinearDrag, Pairs, PerBody, Point, PointMass,
    Pull, QuadraticDrag, Ratio, SemiImplicitEuler, Spring, Stale, Step, Time, Vec2, World, dec,
    vec2,
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

/// The same for a call of which the whole error is known.
#[track_caller]
fn exact<T: Debug, E: Debug + PartialEq>(result: Result<T, E>, error: E) -> String {
    match result {
        Ok(value) => panic!("accepted {value:?}, not {error:?}"),
        Err(found) => assert_eq!(found, error),
    }
    name(error)
}

fn not_positive(field: &'static str, value: Ratio) -> Error {
    Error::NotPositive { field, value }
}

fn negative(field: &'static str, value: Ratio) -> Error {
    Error::Negative { field, value }
}

fn out_of_range(field: &'static str, value: Ratio) -> Error {
    Error::OutOfRange { field, value }
}

fn rounds_to_zero(field: &'static str, value: Ratio) -> Error {
    Error::RoundsToZero { field, value }
}

fn not_finite(field: &'static str) -> Error {
    Error::NotFinite { field }
}

fn ratio(num: i64, den: u64) -> Ratio {
    Ratio::new(num, den).unwrap()
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
    mass_of_nothing, "a mass of zero or less": masses(&[dec!(0), dec!(-1.5), ratio(-1, 1 << 62)], not_positive);
    mass_beyond, "a mass whose inverse the scalar cannot hold":
        masses(&[dec!(0.0004), ratio(1, 1 << 40), dec!(5_000_000), ratio(1 << 62, 1)], out_of_range);
    nan_number, "NaN or infinity as a number": not_finite_numbers();
    odd_fraction, "a fraction over zero, or of more than 62 bits":
        vec![refused(Ratio::new(1, 0)), refused(Ratio::new(i64::MIN, 1))];
    odd_text, "a text that is no plain decimal":
        ["1e9", "", "-", "1.2.3", "NaN"].map(|text| refused(Ratio::parse(text))).into();
    component_beyond, "a component outside of the scalar":
        components();
    nan_state, "NaN or infinity as position or velocity": not_finite_states();
    rate_of_nothing, "a rate of zero or less":
        rates_of_nothing();
    step_beyond, "a step of a quarter second or more, or too short": steps();
    coefficient_below_zero, "a coefficient below zero": coefficients(&[dec!(-0.1), ratio(-1, 1 << 62), ratio(-(1 << 62), 1)], negative);
    coefficient_beyond, "a coefficient that is too large, or a softening too small for it": too_large();
    coefficient_lost, "a coefficient or softening that would be zero, but is not": lost();
    length_beyond, "a length or acceleration outside of the scalar": vec![
        exact(Spring::<I16F16>::new(40_000, 1, 0), out_of_range("rest_length", dec!(40_000))),
        refused(Pull::<I16F16>::new(1, 40_000)),
        refused(GravityY::<I8F24>::new(200)),
    ];
    softening_of_nothing, "a softening of zero or less":
        vec![refused(Pull::<I16F16>::new(1, 0)), refused(Pull::<f32>::new(1, -1))];
    frequency_of_nothing, "a frequency of zero or less": exact::frequencies_of_nothing();
    damping_below_zero, "a damping ratio below zero": exact::damping_below_zero();
    spring_beyond, "a frequency below `2^-20` Hz or from `2^20` Hz, or a damping ratio from `2^10`": exact::beyond();
    sag_beyond, "a sag outside of the scalar, or from its point to there": exact::sags();
    no_points, "no point masses": vec![exact(set::<I16F16>(&[]), Error::Empty { field: "points" })];
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
    clock_that_stands, "a clock that stands still, or no steps a frame": clocks_that_stand();
    clock_without_unit, "a clock and a step without a common unit": clocks_without_unit();
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

fn masses(masses: &[Ratio], error: fn(&'static str, Ratio) -> Error) -> Errors {
    for mass in [dec!(0.0005), dec!(2_000_000), ratio(1, 3)] {
        assert!(point::<I16F16>(mass).is_ok());
    }
    let of = |&mass| exact(point::<I16F16>(mass), error("mass", mass));
    masses.iter().map(of).collect()
}

fn components() -> Errors {
    let large = dec!(40_000);
    assert_eq!(vec2::<f32>(large, 0), Ok(Vec2::new(40_000.0, 0.0)));
    assert!(vec2::<I8F24>(127, -127).is_ok() && vec2::<I1F31>(dec!(0.5), dec!(-0.999)).is_ok());
    vec![
        exact(vec2::<I16F16>(large, 0), out_of_range("x", large)),
        exact(vec2::<I16F16>(0, large), out_of_range("y", large)),
        exact(vec2::<I8F24>(128, 0), out_of_range("x", dec!(128))),
        exact(vec2::<I1F31>(0, 1), out_of_range("y", dec!(1))),
    ]
}

fn rates_of_nothing() -> Errors {
    let rates = [dec!(0), dec!(-60), dec!(-0.5)].map(|rate| {
        exact(Step::<f32>::hz(rate), not_positive("rate", rate));
        exact(Step::<I16F16>::hz(rate), not_positive("rate", rate))
    });
    let lengths = [dec!(0), ratio(-1, 60)].map(|length| {
        exact(
            Step::<I16F16>::from_seconds(length),
            not_positive("seconds", length),
        )
    });
    [rates.to_vec(), lengths.to_vec()].concat()
}

fn not_finite_numbers() -> Errors {
    let numbers = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300];
    numbers
        .map(|number| refused(Ratio::from_f64(number)))
        .into()
}

/// A call that is refused leaves the state as it was.
fn not_finite_states() -> Errors {
    let sound = Point::new(Vec2::new(1.0_f32, 2.0), Vec2::new(3.0, 4.0), 5).unwrap();
    let mut errors = Errors::new();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for vector in [Vec2::new(bad, 9.0), Vec2::new(9.0, bad)] {
            let mut tried = sound;
            errors.extend([
                exact(Point::new(vector, Vec2::ZERO, 1), not_finite("position")),
                exact(Point::new(Vec2::ZERO, vector, 1), not_finite("velocity")),
                exact(tried.teleport(vector), not_finite("position")),
                exact(tried.set_velocity(vector), not_finite("velocity")),
            ]);
            assert_eq!(tried, sound);
        }
    }
    for end in [f32::MAX, f32::MIN, f32::MIN_POSITIVE, -0.0] {
        assert!(Point::new(Vec2::new(end, end), Vec2::new(end, end), 1).is_ok());
    }
    let mut moved = sound;
    moved.teleport(Vec2::new(7.0, 8.0)).unwrap();
    assert_eq!(
        (moved.position(), moved.velocity()),
        (Vec2::new(7.0, 8.0), sound.velocity())
    );
    errors
}

fn steps() -> Errors {
    let mut errors = Errors::new();
    for rate in [dec!(4), dec!(3.999), dec!(1), ratio(1, 1 << 62)] {
        errors.extend([
            exact(Step::<I16F16>::hz(rate), out_of_range("rate", rate)),
            exact(Step::<I8F24>::hz(rate), out_of_range("rate", rate)),
            exact(Step::<f32>::hz(rate), out_of_range("rate", rate)),
        ]);
    }
    for rate in [ratio(1 << 40, 1), ratio(1 << 62, 1)] {
        errors.push(exact(Step::<I16F16>::hz(rate), out_of_range("rate", rate)));
    }
    for length in [dec!(0.25), dec!(0.26), dec!(60), ratio(1, 1 << 62)] {
        errors.push(exact(
            Step::<I16F16>::from_seconds(length),
            out_of_range("seconds", length),
        ));
    }
    for rate in [dec!(4.001), dec!(60), dec!(59.7275), dec!(100_000)] {
        assert!(Step::<I16F16>::hz(rate).is_ok() && Step::<f32>::hz(rate).is_ok());
    }
    assert!(DyadicStep::<I16F16, { 1 << 24 }, 1>::new().is_ok());
    assert!(DyadicStep::<f32, { 1 << 24 }, 1>::new().is_ok());
    errors
}

/// Every coefficient of every force.
fn coefficients(values: &[Ratio], error: fn(&'static str, Ratio) -> Error) -> Errors {
    let mut world = World::<Point<I16F16>, 1>::new();
    let id = world.add(point(1).unwrap()).unwrap();
    for sound in [dec!(0), ratio(1, 1 << 31), ratio(1 << 29, 1)] {
        assert!(LinearDrag::<I16F16>::new(sound).is_ok());
        assert!(Spring::<I16F16>::new(1, sound, sound).is_ok());
        assert!(Anchor::<I16F16>::new(id, Vec2::ZERO, sound, sound).is_ok());
    }
    let of = |&value: &Ratio| {
        let drag = error("drag", value);
        let [stiffness, damping] = ["stiffness", "damping"].map(|field| error(field, value));
        [
            exact(LinearDrag::<I16F16>::new(value), drag),
            exact(QuadraticDrag::<I16F16>::new(value), drag),
            exact(Pull::<I16F16>::new(value, 1), error("constant", value)),
            exact(Spring::<I16F16>::new(1, value, 0), stiffness),
            exact(Spring::<I16F16>::new(1, 1, value), damping),
            exact(Anchor::<I16F16>::new(id, Vec2::ZERO, value, 0), stiffness),
            exact(Anchor::<I16F16>::new(id, Vec2::ZERO, 1, value), damping),
            exact(ExactDrag::<I16F16>::new(value), drag),
            exact(ExactQuadraticDrag::<I16F16>::new(value), drag),
            exact(Ballistic::<I16F16>::new(Vec2::ZERO, value), drag),
        ]
    };
    values.iter().flat_map(of).collect()
}

fn too_large() -> Errors {
    let mut errors = coefficients(&[ratio(1 << 31, 1), ratio(1 << 62, 1)], out_of_range);
    errors.push(refused(Pull::<I16F16>::new(1, dec!(0.0009))));
    errors.push(refused(Pull::<f32>::new(1, dec!(0.0000001))));
    errors
}

fn lost() -> Errors {
    let mut errors = coefficients(&[ratio(1, 1 << 34), ratio(1, 1 << 62)], rounds_to_zero);
    errors.push(refused(Pull::<I16F16>::new(1, dec!(0.000001))));
    errors
}

/// What a set of point masses at rest at the origin amounts to.
fn set<S: fixstep::Scalar>(masses: &[Ratio]) -> Result<CentreOfMass<S>, Error> {
    let at_rest = |&mass| PointMass {
        position: Vec2::ZERO,
        velocity: Vec2::ZERO,
        mass,
    };
    CentreOfMass::new(&masses.iter().map(at_rest).collect::<Vec<_>>())
}

fn point_masses() -> Errors {
    let of = |value| {
        let error = not_positive("mass", value);
        exact(set::<f32>(&[dec!(1), value, dec!(-7)]), error);
        exact(set::<I16F16>(&[dec!(1), dec!(2), value]), error);
        exact(set::<I16F16>(&[value]), error)
    };
    [dec!(0), dec!(-0.5), ratio(-1, 1 << 62), ratio(0, 9)]
        .map(of)
        .into()
}

fn not_finite_point_masses() -> Errors {
    let mut errors = Errors::new();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for (vector, i) in [Vec2::new(bad, 0.0), Vec2::new(0.0, bad)]
            .into_iter()
            .flat_map(|v| [(v, 0), (v, 1), (v, 2)])
        {
            let sound = PointMass {
                position: Vec2::new(1.5, 0.0),
                velocity: Vec2::ZERO,
                mass: dec!(1),
            };
            let (mut placed, mut moving) = ([sound; 3], [sound; 3]);
            placed[i].position = vector;
            moving[i].velocity = vector;
            errors.push(exact(CentreOfMass::new(&placed), not_finite("position")));
            errors.push(exact(CentreOfMass::new(&moving), not_finite("velocity")));
        }
    }
    errors
}

/// The error names the mass that is too much, and a point refuses the total that a body of it would have.
fn totals() -> Errors {
    let most = 1 << 62;
    let mut errors = Errors::new();
    for masses in [
        [ratio(most, 1), ratio(1, 1)],
        [ratio(1, 1), ratio(most, 1)],
        [ratio(most / 2, 1), ratio(most / 2 + 1, 1)],
        [ratio(most, 1), ratio(1, 1 << 62)],
        [ratio(1 << 40, 1), ratio(1, (1 << 61) - 1)],
    ] {
        errors.push(exact(set::<f32>(&masses), out_of_range("mass", masses[1])));
    }
    assert_eq!(
        set::<f32>(&[ratio(most / 2, 1); 2]).unwrap().mass,
        ratio(most, 1)
    );
    assert_eq!(
        set::<f32>(&[ratio(1, 1 << 62); 16]).unwrap().mass,
        ratio(1, 1 << 58)
    );
    for masses in [[ratio(1_500_000, 1); 2], [dec!(0.0002); 2]] {
        let all = set::<I16F16>(&masses).unwrap();
        errors.push(exact(all.point(), out_of_range("mass", all.mass)));
        assert!(set::<f32>(&masses).unwrap().point().is_ok());
    }
    errors
}

fn clocks_that_stand() -> Errors {
    let step = ratio(1, 60);
    let mut errors = vec![
        exact(
            Accumulator::new(0, step, 4),
            not_positive("counts_per_second", dec!(0)),
        ),
        exact(
            Accumulator::new(1000, step, 0),
            not_positive("max_steps", dec!(0)),
        ),
    ];
    for seconds in [dec!(0), ratio(-1, 60), ratio(-1, 1 << 62), ratio(0, 7)] {
        errors.push(exact(
            Accumulator::new(1000, seconds, 4),
            not_positive("seconds", seconds),
        ));
    }
    assert!(Accumulator::new(1, step, 1).is_ok());
    assert!(Accumulator::new(u32::MAX, step, u32::MAX).is_ok());
    errors
}

/// One count is den / (num counts_per_second) of a step, in lowest terms, and must fit 62 bits.
fn clocks_without_unit() -> Errors {
    let most = 1_i64 << 62;
    let refused = [
        (2, ratio(most, 1)),
        (2, ratio(most / 2 + 1, 1)),
        (u32::MAX, ratio(most, 1)),
        (3, ratio(most / 2, (1 << 60) - 3)),
        (1_000_000, ratio(most - 1, 1 << 62)),
    ];
    for (counts_per_second, seconds) in [
        (1, ratio(most, 1)),
        (2, ratio(most / 2, 1)),
        (1, ratio(most - 1, 1 << 62)),
        (1 << 31, ratio(most, 1 << 31)),
        (u32::MAX, ratio(1, 1 << 62)),
        (1_000_000, dec!(0.000_000_000_000_000_01)),
    ] {
        assert!(
            Accumulator::new(counts_per_second, seconds, 4).is_ok(),
            "{seconds} s"
        );
    }
    let of = |(counts, seconds)| {
        exact(
            Accumulator::new(counts, seconds, 4),
            out_of_range("seconds", seconds),
        )
    };
    refused.map(of).into()
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
