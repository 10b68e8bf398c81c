//! The rotor's chart: no run errs so much that whole turns would be lost, and what the README says of it.

use std::f64::consts::TAU;

use crate::cost::Core;
use crate::exact::{LOOKS, turn};
use crate::figures::{Row, quantile};
use crate::fronts::rows;
use crate::rotor::{BEARING, INERTIA, TORQUES};
use crate::starts::Plan;
use crate::support::maximum;

const ROTOR: &str = include_str!("../../examples/charts/work-rotor.csv");

/// Spin and angle after a step of `h` without rounding, of a torque that gives `a` turns/s a step against a
/// drag of `q = h c / I`.
type Step = fn([f64; 2], a: f64, q: f64, h: f64) -> [f64; 2];

/// Of the methods of order 1 and 2. The torque acts first: it is of one body, and the drag of each.
const STEPS: [([&str; 2], Step); 4] = [
    (["SemiImplicitEuler", "SpinDrag"], |[s, x], a, q, h| {
        let s = (s + a) * (-q).exp();
        [s, x + h * s]
    }),
    (["Verlet", "SpinDrag"], |[s, x], a, q, h| {
        let half = (-q / 2.0).exp();
        let after = (s * half + a) * half;
        [after, x + h / 2.0 * (s + after)]
    }),
    (["SemiImplicitEuler", "Wrench"], |[s, x], a, q, h| {
        let s = (s + a) * (1.0 - q);
        [s, x + h * s]
    }),
    (["Verlet", "Wrench"], |[s, x], a, q, h| {
        let after = (s + a) * (1.0 - q);
        [after, x + h / 2.0 * (s + after)]
    }),
];

/// By how much the angle is wrong after each step, of each start.
fn errors(step: Step, rate: u32, plan: &Plan) -> Vec<Vec<f64>> {
    let (drag, inertia, h) = (BEARING.to_f64(), INERTIA.to_f64(), 1.0 / f64::from(rate));
    let mut all = Vec::new();
    for world in &plan.worlds {
        let exact = |tick: u32| turn(world, f64::from(tick) * h);
        for (i, (dot, torque)) in world.iter().zip(TORQUES).enumerate() {
            let gain = h * torque.to_f64() / (TAU * inertia);
            let mut state = [dot.v[0], dot.x[0]];
            let wrong = (1..=rate * plan.seconds).map(|tick| {
                state = step(state, gain, h * drag / inertia, h);
                (state[1] - exact(tick)[i][0]).abs()
            });
            all.push(wrong.collect());
        }
    }
    all
}

/// What roundings add to an angle at most: two units of spin a step, of which those of `τ / h` steps are
/// not damped yet.
fn rounding(unit: f64, rate: u32, plan: &Plan) -> f64 {
    let tau = INERTIA.to_f64() / BEARING.to_f64();
    2.0 * unit * tau * f64::from(rate * plan.seconds)
}

/// Whole turns are left out of an error, so a run a turn behind would look like one in its place. None is
/// half a turn behind: the methods of low order are not, with all roundings of an `I16F16`.
#[test]
fn no_run_is_half_a_turn_behind() {
    let plan = Plan::of("rotor");
    for rate in [15, 60, 960] {
        let rounding = rounding(1.0 / 65536.0, rate, &plan);
        for (name, step) in STEPS {
            let worst = maximum(&errors(step, rate, &plan).concat());
            assert!(worst + rounding < 0.5, "{rate} Hz, {name:?}: {worst}");
        }
    }
}

/// The table has the errors of the recurrences, to what an `I8F24` rounds and to five digits: no distance of
/// two sets of starts exceeds the largest of their pairs, be it of quantiles or of means.
#[test]
fn the_errors_are_those_of_the_recurrences() {
    let (plan, rate) = (Plan::of("rotor"), 60);
    let table = rows("rotor", ROTOR);
    for (name, step) in STEPS {
        let last = |wrong: &Vec<f64>| {
            let looks = wrong[(rate * (plan.seconds - 1)) as usize - 1..].iter();
            let squares: Vec<f64> = looks
                .step_by((rate / LOOKS) as usize)
                .map(|e| e * e)
                .collect();
            (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
        };
        let wrong: Vec<f64> = errors(step, rate, &plan).iter().map(last).collect();
        let line = [name[0], name[1], "I8F24"];
        let is = |row: &&Row| row.line() == line && row.rate == rate;
        let row = table.iter().find(is).unwrap();
        for (part, told) in [0.05, 0.5, 0.95].into_iter().zip(row.errors) {
            let error = quantile(&wrong, part);
            let bound = rounding((-24.0_f64).exp2(), rate, &plan) + 1e-4 * error;
            assert!(
                (told - error).abs() <= bound,
                "{name:?}: {told:e}, {error:e}"
            );
        }
    }
}

/// What the README says of bearings: by `Verlet` at 60 Hz the exact factor errs a thousandth of the same drag
/// as a function of the body, in fixed point for less; `Rk4` with the function is more exact for four to seven
/// times the price, and in `f32` on the M4F at 15 Hz for the same.
#[test]
fn a_bearing_is_solved_for_less() {
    let table = rows("rotor", ROTOR);
    let row = |line: [&str; 3], rate| -> &Row {
        let is = |row: &&Row| row.line() == line && row.rate == rate;
        table.iter().find(is).unwrap()
    };
    for (core, body) in [(Core::M0Plus, "I8F24"), (Core::M4F, "f32")] {
        let exact = row(["Verlet", "SpinDrag", body], 60);
        let by_hand = row(["Verlet", "Wrench", body], 60);
        let dear = row(["Rk4", "Wrench", body], 60);
        assert!(by_hand.errors[1] >= 1000.0 * exact.errors[1], "{body}");
        assert_eq!(exact.work(core) < by_hand.work(core), body == "I8F24");
        assert!(dear.errors[1] < 0.1 * exact.errors[1], "{body}");
        let price = dear.work(core) / exact.work(core);
        assert!((4.0..=7.0).contains(&price), "{body}: {price}");
    }
    let [fast, rare] = [("Verlet", "SpinDrag", 60), ("Rk4", "Wrench", 15)]
        .map(|(method, forces, rate)| row([method, forces, "f32"], rate));
    let price = rare.work(Core::M4F) / fast.work(Core::M4F);
    assert!((0.9..=1.1).contains(&price) && rare.errors[1] < 0.02 * fast.errors[1]);
}
