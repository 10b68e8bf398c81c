//! The figures of `examples/fields`: the committed CSV files are what the example makes, and every
//! method keeps to its closed form.
//!
//! With x(n) = x0 + n h and the start (x0, y0) of a parabola y = x² + c:
//!
//! ```text
//! Euler               y(n) = y0 + h sum 2 x(i), i = 0..n-1  = x(n)² + c - n h²
//! SemiImplicitEuler   y(n) = y0 + h sum 2 x(i), i = 1..n    = x(n)² + c + n h²
//! the other two       y(n) = y0 + h sum (x(i) + x(i+1))     = x(n)² + c
//! friction, all four  v(n) = v0 (1 - k h/m)^n
//! ```
//!
//! The first from `sum 2 i = n (n - 1)`, so that `h sum 2 x(i) = 2 n h x0 + n² h² - n h²`.

#[path = "../examples/fields/csv.rs"]
mod csv;
#[path = "../examples/fields/figures.rs"]
mod figures;
#[path = "../examples/fields/flight.rs"]
mod flight;

use figures::{SECONDS, START, V0, coinciding};
use fixstep::{DyadicStep, TimeStep};
use flight::{MethodName, Run, friction, parabola};

const FIG1: &str = include_str!("../examples/fields/fig1.csv");
const FIG2: &str = include_str!("../examples/fields/fig2.csv");

/// Half the distance from 1 to the next number: the most by which one operation rounds, relatively.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Sixteen numbers that fill `-2..2` evenly and are no multiples of a power of two.
fn starts() -> impl Iterator<Item = f64> {
    (0..16).map(|i| 4.0 * (0.5 + f64::from(i) * 0.618_033_988_749_894_9).fract() - 2.0)
}

/// NaN is not within anything.
fn assert_within(bound: f64, value: f64, expected: f64, what: &str) {
    let error = (value - expected).abs();
    assert!(
        error <= bound,
        "{what}: {value} is not {expected} ± {bound:e}"
    );
}

/// What n steps leave between the method and the parabola, in units of n h².
fn lead(method: MethodName) -> f64 {
    match method {
        MethodName::Euler => -1.0,
        MethodName::SemiImplicitEuler => 1.0,
        MethodName::ConstantAcceleration | MethodName::Verlet => 0.0,
    }
}

#[test]
fn the_committed_files_are_what_the_example_makes() {
    assert_eq!(csv::fig1(&figures::fig1().unwrap()), FIG1);
    assert_eq!(csv::fig2(&figures::fig2().unwrap()), FIG2);
}

// Multiples of 1/4 below 2^5: nothing is rounded, so equality is what `f64` owes.
#[test]
fn the_points_of_fig_1_are_the_closed_form_exactly() {
    let runs = figures::fig1().unwrap();
    assert_eq!(runs.len(), 4);
    for Run {
        method, samples, ..
    } in &runs
    {
        assert_eq!(samples.len(), 9);
        for (n, sample) in (0..).map(f64::from).zip(samples) {
            let x = START[0] + n / 2.0;
            assert_eq!(sample.at, x);
            assert_eq!(sample.exact, x * x);
            assert_eq!(sample.value, x * x + lead(*method) * n / 4.0, "{method:?}");
        }
    }
}

// Powers of 1/2 and 3/2 up to the 15th and 3rd, times 2: again nothing is rounded. The exponential
// itself may be an ulp off, and its argument is exact.
#[test]
fn the_points_of_fig_2_are_the_closed_form_exactly() {
    let runs = figures::fig2().unwrap();
    assert_eq!(runs.len(), 12);
    for (run, step) in runs.iter().zip([[0.5; 4], [1.5; 4], [2.5; 4]].concat()) {
        assert_eq!(run.step, step);
        assert_eq!(run.samples.len(), 1 + (SECONDS / step) as usize);
        for (n, sample) in (0..).zip(&run.samples) {
            let t = f64::from(n) * step;
            assert_eq!(sample.at, t);
            assert_eq!(sample.value, V0 * (1.0 - step).powi(n), "{:?}", run.method);
            let exact = V0 / t.exp();
            assert_within(4.0 * exact * f64::EPSILON, sample.exact, exact, "exact");
        }
    }
}

// What the legends say.
#[test]
fn methods_coincide_where_the_pictures_say_so() {
    let labels = |runs: &[Run]| -> Vec<String> {
        let groups = coinciding(runs);
        groups.iter().map(|group| group.label()).collect()
    };
    let apart = [
        "Euler",
        "ConstantAcceleration and Verlet",
        "SemiImplicitEuler",
    ];
    assert_eq!(labels(&figures::fig1().unwrap()), apart);
    assert_eq!(labels(&figures::fig2().unwrap()), ["all four methods"; 3]);
}

/// In roundings of `largest`, which no x², y or h v exceeds. A step makes two products and two
/// additions for y at most, and one addition for 2x, whose error grows by the length of the run to
/// less than twice `largest`: six. It makes two additions for x, whose error doubles in x²: four.
/// The closed form and the start have eight between them.
fn check_parabola<H: TimeStep<f64>>(step: &H) {
    const TICKS: u32 = 20;
    let h = step.seconds().to_f64();
    for (method, x0) in MethodName::ALL
        .into_iter()
        .flat_map(|method| starts().map(move |x0| (method, x0)))
    {
        let c = 1.5 * x0 - 0.7;
        let run = parabola(method, step, TICKS, [x0, x0 * x0 + c]).unwrap();
        assert_eq!(run.samples.len(), 1 + TICKS as usize);
        for (n, sample) in (0..).map(f64::from).zip(&run.samples) {
            let x = x0 + n * h;
            let largest = 16.0 + (2.0 + n * h).powi(2);
            let bound = (6.0 * n + 8.0) * largest * ROUNDING;
            let curve = x * x + c;
            assert_within(bound, sample.at, x, "x");
            assert_within(bound, sample.exact, curve, "exact");
            let expected = curve + lead(method) * n * h * h;
            assert_within(bound, sample.value, expected, &format!("{method:?}, h {h}"));
        }
    }
}

#[test]
fn methods_leave_any_parabola_by_n_h_squared() {
    check_parabola(&DyadicStep::<f64, 1, 1>::new().unwrap());
    check_parabola(&DyadicStep::<f64, 1, 4>::new().unwrap());
    check_parabola(&DyadicStep::<f64, 3, 5>::new().unwrap());
}

/// A step rounds h v, which is |h / (1 - h)| times the new v, and the difference: relatively
/// 1 + |h / (1 - h)| roundings. The closed form, multiplied out, has one a step; twice the former
/// is room for it and for products of roundings.
fn check_friction<H: TimeStep<f64>>(step: &H) {
    const TICKS: u32 = 20;
    let h = step.seconds().to_f64();
    let factor = 1.0 - h;
    for (method, v0) in MethodName::ALL
        .into_iter()
        .flat_map(|method| starts().map(move |v0| (method, v0)))
    {
        let run = friction(method, step, TICKS, v0).unwrap();
        assert_eq!(run.samples.len(), 1 + TICKS as usize);
        let mut expected = v0;
        for (n, sample) in (0..).map(f64::from).zip(&run.samples) {
            let roundings = 2.0 * n * (1.0 + (h / factor).abs());
            let bound = roundings * expected.abs() * ROUNDING;
            assert_within(bound, sample.value, expected, &format!("{method:?}, h {h}"));
            expected *= factor;
        }
    }
}

#[test]
fn explicit_drag_is_a_power_of_one_less_k_h_over_m() {
    check_friction(&DyadicStep::<f64, 1, 1>::new().unwrap());
    check_friction(&DyadicStep::<f64, 3, 1>::new().unwrap());
    check_friction(&DyadicStep::<f64, 5, 1>::new().unwrap());
    check_friction(&DyadicStep::<f64, 3, 4>::new().unwrap());
}
