//! A scene of bodies that turn: what is said of it, and what the real types do.

use std::f64::consts::TAU;

use fixstep::fixed::FixedI32;
use fixstep::fixed::types::extra::{U24, U27, U28, U29, U30};
use fixstep::rigid::torque::Wrench;
use fixstep::{
    Angular, Body, Decay, Error, PerBody, Point, RangeChecked, Ratio, Rigid, Rotating, Scalar,
    Step, Time, Vec2, World, dec, vec2,
};

use crate::advise::{Advice, Question, advise, range};
use crate::flight::{Plan, Seen};
use crate::near;
use crate::noted::Noted;
use crate::notes::Role;
use crate::real::Flown;
use crate::recorded::Recorded;
use crate::report::report;
use crate::rotor::{ROTOR, Rotor, SECONDS, TITLE};
use crate::scenes::{best, question};

impl<S: Angular> Seen for RangeChecked<Rigid<Point<S>>> {
    fn turns(&self) -> f64 {
        self.angle().to_f64()
    }
}

fn fly<S: Angular + Decay>(rotor: &Rotor, plan: &Plan) -> Result<Flown, Error> {
    let mut world = World::new();
    let mut forces = rotor.build(&mut world, RangeChecked::<Rigid<Point<S>>>::new)?;
    let track = plan.fly(&mut world, &mut forces, &Step::hz(plan.rate)?)?;
    let marked = world.bodies().iter().any(RangeChecked::was_outside);
    Ok(Flown { track, marked })
}

fn fly_in(fraction: u32, rotor: &Rotor, plan: &Plan) -> Result<Flown, Error> {
    match fraction {
        24 => fly::<FixedI32<U24>>(rotor, plan),
        27 => fly::<FixedI32<U27>>(rotor, plan),
        28 => fly::<FixedI32<U28>>(rotor, plan),
        29 => fly::<FixedI32<U29>>(rotor, plan),
        30 => fly::<FixedI32<U30>>(rotor, plan),
        _ => panic!("I{}F{fraction} is not flown here", 32 - fraction),
    }
}

fn ask(rotor: &Rotor) -> Advice {
    let build = |world: &mut World<Noted, _>| rotor.build(world, Noted::from);
    let question = Question {
        beside: &[24],
        ..question(SECONDS)
    };
    advise(&build, &question).unwrap()
}

/// Torque, start spin, recommended type and what saturates first beyond it. From rest the wheel is driven to
/// `M / 2πc (1 - e^-4)`, 1.5625 turns/s for each N m; its place is 3.75 m.
const CASES: [(Ratio, Ratio, u32, Role); 4] = [
    (dec!(2), dec!(0), 29, Role::Position),
    (dec!(5), dec!(0), 28, Role::Spin),
    (dec!(-4.5), dec!(1), 28, Role::Spin),
    (dec!(0.5), dec!(-9), 27, Role::Spin),
];

/// As of points: the recommended type saturates nowhere and errs as told, as a coarser one does; the next
/// finer one saturates or is refused.
#[test]
fn a_type_is_named_for_what_turns() {
    for (torque, spin, fraction, widest) in CASES {
        let rotor = Rotor { torque, spin };
        let advice = ask(&rotor);
        let plan = &advice.question.plan;
        assert_eq!((best(&advice), advice.first()), (fraction, Some(widest)));
        assert!(!advice.is_sensitive());
        // What roundings add to the widest is some units.
        let free = (range(fraction) / advice.notes.reach(widest)).log2();
        assert!((advice.best.unwrap().headroom - free).abs() <= 1e-4);
        let reference = fly::<f64>(&rotor, plan).unwrap();
        for format in advice.formats.iter().filter(|f| f.fraction <= fraction) {
            let flown = fly_in(format.fraction, &rotor, plan).unwrap();
            assert!(!flown.marked, "{rotor:?}");
            let error = plan.apart(&flown.track, &reference.track);
            near("rotor", error, format.verdict);
        }
        let finer = fly_in(fraction + 1, &rotor, plan);
        assert!(
            finer.is_err() || finer.is_ok_and(|flown| flown.marked),
            "{rotor:?}"
        );
    }
}

/// The notes have the torque of the motor, and the spin of the closed form: in the middle of a step half of
/// its drag, a part `h / 2τ`, is still to come; two steps' parts are room for the rest.
#[test]
fn what_turns_is_noted() {
    let (torque, spin) = (dec!(5), dec!(0));
    let notes = ask(&Rotor { torque, spin }).notes;
    let told = notes.of(Role::Moment).largest * 60.0;
    assert!((told - 5.0).abs() <= 1e-12, "{told}");
    let exact = 5.0 / (TAU * 0.1) * -(-SECONDS / 2.0).exp_m1();
    let told = notes.of(Role::Spin).largest / exact;
    assert!((1.0..=1.0 + 1.0 / 60.0).contains(&told), "{told}");
    // The spring pulls the bar by its end, 0.5 m from its middle.
    assert!(notes.of(Role::Impulse).largest > 0.0);
    let text = report(TITLE, &ask(&ROTOR));
    for row in ["spin, turns/s", "torque, N m", "impulse, kg m²/s"] {
        assert!(text.contains(row), "{text}");
    }
    assert!(text.lines().count() <= 24, "more than a screen");
}

/// A function hands a torque over as a number, which the type has to hold: 200 N m do not fit the range that
/// the spin would need.
#[test]
fn a_torque_as_a_number_needs_range() {
    let build = |world: &mut World<Noted, 1>| -> Result<_, Error> {
        let point = Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?;
        world.add(Rigid::new(point, 1000)?.into())?;
        let torque = |_: Time, body: &Noted| Wrench {
            force: Vec2::ZERO,
            torque: body.position().x.plus(Recorded(200.0)),
        };
        Ok(PerBody(torque))
    };
    let notes = advise(&build, &question(1.0)).unwrap().notes;
    assert_eq!(notes.of(Role::Torque).largest, 200.0);
    assert_eq!(notes.reach(Role::Torque), 200.0);
    // 200 N m for a second are 200 kg m²/s: so many turns/s of 1000 kg m², by 60 sums.
    let exact = 200.0 / (TAU * 1000.0);
    assert!((notes.of(Role::Spin).largest - exact).abs() <= 1e-12);
}

/// What takes notes flies as `f64` does; both round by 2^-53 of a few metres some thousand times.
#[test]
fn notes_change_nothing() {
    let plan = question(SECONDS).plan;
    let mut world = World::new();
    let mut forces = ROTOR.build(&mut world, Noted::from).unwrap();
    let step = Step::hz(plan.rate).unwrap();
    let track = plan.fly(&mut world, &mut forces, &step).unwrap();
    let error = plan.apart(&track, &fly::<f64>(&ROTOR, &plan).unwrap().track);
    assert!(error <= 1e-11, "{error:e}");
}

/// An angle that is wrong is an arc at 1 m: another start spin leads away by `ds τ (1 - e^-t/τ)` turns, most
/// at the end. The damping of a step is exact, and its drift a trapezium: off by `(h/τ)² / 12`.
#[test]
fn an_angle_counts_as_an_arc() {
    let (plan, change) = (question(SECONDS).plan, 1e-6);
    let [a, b] = [dec!(0), dec!(0.000001)].map(|spin| {
        let rotor = Rotor { spin, ..ROTOR };
        fly::<f64>(&rotor, &plan).unwrap().track
    });
    let exact = TAU * change * 2.0 * -(-SECONDS / 2.0).exp_m1();
    let error = plan.apart(&a, &b) / exact - 1.0;
    assert!(error.abs() <= 1e-5, "{error:e}");
}
