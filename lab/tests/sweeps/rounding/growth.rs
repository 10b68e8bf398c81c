//! How the error of an oscillator grows by rounding alone: the powers of Brouwer, the sizes that
//! `noise.rs` derives, and what keeping remainders is worth.
//!
//! Energies walk, and times with them, until a phase is lost; from there on an error is as large as
//! the orbit. Counts are judged where no orbit should have turned by more than `LINEAR`. An `I16F16` does
//! not walk on for ever: its step is reversible and odd, so that an orbit which meets its mirror image
//! on the grid runs back, and its energy with it (`closed.rs`).

use std::sync::OnceLock;

use fixstep::fixed::FixedI64;
use fixstep::fixed::types::extra::U56;
use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{Body, Carried, Carry, Point};

use crate::rounding::duffing::{
    COUNTS, Errors, Lengths, STARTS, Setup, energy, frequency, run, start,
};
use crate::rounding::noise::{self, Law, Noise};
use crate::support::*;

const SETUPS: [Setup; 2] = [
    Setup {
        scheme: Scheme::SemiImplicitEuler,
        rate: (60, 1),
    },
    Setup {
        scheme: Scheme::Verlet,
        rate: (61_803, 1000),
    },
];

/// The phase by which an orbit may be off and its error still be a straight piece of it, rad.
const LINEAR: f64 = 0.3;

/// A number type and a kind of body.
struct Row {
    name: String,
    law: Law,
    found: Vec<Errors>,
}

impl Row {
    fn new<B>(name: String, setup: &Setup, lengths: Lengths, noise: Noise) -> Row
    where
        B: Body + From<Point<B::S>> + std::fmt::Debug,
    {
        Row {
            name,
            law: Law::new(setup, &lengths, noise),
            found: run::<B>(setup, &lengths, &COUNTS),
        }
    }

    fn point<S: Format>(setup: &Setup) -> Row {
        let (name, lengths) = (S::name() + " Point", Lengths::point::<S>(setup));
        Row::new::<Point<S>>(name, setup, lengths, noise::point::<S>)
    }

    fn carried<S: Format + Carry>(setup: &Setup) -> Row {
        let (name, lengths) = (S::name() + " Carried", Lengths::carried::<S>(setup));
        Row::new::<Carried<S>>(name, setup, lengths, noise::carried::<S>)
    }

    /// How many counts are judged.
    fn linear(&self) -> usize {
        let turned = |n| {
            let phase = |i| frequency(energy(start(i))) * self.law.ahead(i, n);
            maximum(&std::array::from_fn::<_, STARTS, _>(phase))
        };
        COUNTS.iter().filter(|&&n| turned(n) <= LINEAR).count()
    }

    /// The power of N in the medians of an error.
    fn power(&self, of: impl Fn(&Errors) -> f64) -> f64 {
        let logs: Vec<f64> = self.found.iter().map(|e| of(e).log10()).collect();
        let (x, y) = (decades(self.linear()), &logs[..self.linear()]);
        let sum: f64 = x.iter().zip(y).map(|(x, y)| x * y).sum();
        sum / spread_of(&x)
    }

    /// Errors of a count by their standard deviation, root mean square over all starts.
    fn share(&self, count: usize, errors: &[f64], law: impl Fn(usize, u32) -> f64) -> f64 {
        let share = |(i, error): (usize, &f64)| (error / law(i, COUNTS[count])).powi(2);
        let sum: f64 = errors.iter().enumerate().map(share).sum();
        (sum / errors.len() as f64).sqrt()
    }
}

/// Counts by their logarithms, from the middle.
fn decades(counts: usize) -> Vec<f64> {
    let logs: Vec<f64> = COUNTS[..counts]
        .iter()
        .map(|&n| f64::from(n).log10())
        .collect();
    let middle = logs.iter().sum::<f64>() / counts as f64;
    logs.iter().map(|log| log - middle).collect()
}

fn spread_of(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum()
}

fn typical(errors: &[f64]) -> f64 {
    median(&errors.iter().map(|e| e.abs()).collect::<Vec<_>>())
}

fn measure(setup: &Setup) -> Vec<Row> {
    let rows: [fn(&Setup) -> Row; 7] = [
        Row::point::<f32>,
        Row::point::<I16F16>,
        Row::point::<I12F20>,
        Row::point::<I8F24>,
        Row::carried::<f32>,
        Row::carried::<I16F16>,
        Row::carried::<I8F24>,
    ];
    let rows: Vec<Row> = rows.iter().map(|row| row(setup)).collect();
    let mut text = format!("{:?}, {:.3} Hz\n", setup.scheme, 1.0 / setup.seconds());
    for (title, of) in [
        (
            "state: median",
            (|e| median(&e.state)) as fn(&Errors) -> f64,
        ),
        ("state: maximum", |e| maximum(&e.state)),
        ("energy, J: median", |e| typical(&e.energy)),
    ] {
        text += &format!("{title:<18}");
        text += &COUNTS.map(|n| format!("{n:>9}")).concat();
        text += "  power\n";
        for row in &rows {
            let cells: String = row
                .found
                .iter()
                .map(|e| format!("{:9.1e}", of(e)))
                .collect();
            text += &format!("{:<18}{cells}  {:5.2}\n", row.name, row.power(of));
        }
    }
    println!("{text}");
    rows
}

fn measured(setup: usize) -> &'static [Row] {
    static ALL: [OnceLock<Vec<Row>>; 2] = [OnceLock::new(), OnceLock::new()];
    ALL[setup].get_or_init(|| measure(&SETUPS[setup]))
}

/// A median of 32 magnitudes of a normal number is off by `1 / (2 p sqrt(32))`, p = 0.636 its density
/// there, which is 0.206 of it or 0.09 decades; counts half a decade apart are nearly independent.
/// Five standard deviations of a straight line through them.
fn check_powers(setup: usize) {
    for row in measured(setup) {
        let counts = row.linear();
        assert!(counts >= 4, "{}: phases lost at {counts}", row.name);
        let band = 5.0 * 0.09 / spread_of(&decades(counts)).sqrt();
        let state = row.power(|e| median(&e.state));
        let energy = row.power(|e| typical(&e.energy));
        assert!((state - 1.5).abs() <= band, "{}: {state}", row.name);
        assert!((energy - 0.5).abs() <= band, "{}: {energy}", row.name);
    }
}

/// Squares of 32 normal numbers have a mean of 1, which 1 in 10⁶ times is below 0.21 or above 2.7: its
/// root below 0.46 or above 1.64. Before 10⁴ steps the phase's own walk and what is seen of a
/// `Carried` count too.
fn check_sizes(row: &Row) {
    for (count, steps) in COUNTS.iter().enumerate().take(row.linear()).skip(2) {
        let (law, errors) = (&row.law, &row.found[count]);
        let ahead = row.share(count, &errors.ahead, |i, n| law.ahead(i, n));
        let energy = row.share(count, &errors.energy, |i, n| law.energy(i, n));
        let name = &row.name;
        println!("{name:<16} {steps:>8} steps, of the law: ahead {ahead:.2} energy {energy:.2}");
        for share in [ahead, energy] {
            assert!((0.46..=1.64).contains(&share), "{name}: {share}");
        }
    }
}

#[test]
fn errors_grow_by_brouwers_powers_under_semi_implicit_euler() {
    check_powers(0);
}

#[test]
fn errors_grow_by_brouwers_powers_under_verlet() {
    check_powers(1);
}

#[test]
fn errors_are_as_large_as_derived_under_semi_implicit_euler() {
    measured(0).iter().for_each(check_sizes);
}

#[test]
fn errors_are_as_large_as_derived_under_verlet() {
    measured(1).iter().for_each(check_sizes);
}

/// At every count from 10⁴, against `f32`; and each number type against itself for as long as the point
/// has a phase: once lost, its error is as large as the orbit, and so may that of the other be.
#[test]
fn keeping_remainders_beats_f32() {
    for setup in 0..SETUPS.len() {
        let rows = measured(setup);
        for [carried, point] in [[6, 0], [6, 3], [5, 1], [4, 0]] {
            let last = if point == 0 {
                COUNTS.len()
            } else {
                rows[point].linear()
            };
            assert!(last > 2);
            let [carried, point] = [carried, point].map(|k: usize| &rows[k]);
            for (count, n) in COUNTS.iter().enumerate().take(last).skip(2) {
                let [a, b] = [carried, point].map(|row| &row.found[count].state);
                let what = format!("{} against {}, {n} steps", carried.name, point.name);
                assert!(median(a) < median(b), "{what}");
                assert!(maximum(a) < maximum(b), "{what}");
            }
        }
    }
}

/// The reference rounds too. Beside fixed point with 56 fractional bits, a sixteenth of its unit, it
/// shows the law of an `f64`. That is the law of an `f32` by 2^-29, which is a hundred times that of
/// the finest `Carried`: a millionth at most. h differs by 2^-54 of itself, a hundredth of the law.
#[test]
fn the_reference_is_six_digits_finer() {
    let (setup, finest) = (&SETUPS[0], &measured(0)[6]);
    let lengths = Lengths::point::<f64>(setup);
    let row = Row {
        name: "f64 beside I8F56".into(),
        law: Law::new(setup, &lengths, noise::point::<f64>),
        found: run::<Point<FixedI64<U56>>>(setup, &lengths, &COUNTS[..5]),
    };
    for (count, errors) in row.found.iter().enumerate().skip(2) {
        let ahead = row.share(count, &errors.ahead, |i, n| row.law.ahead(i, n));
        let (n, state) = (COUNTS[count], median(&errors.state));
        println!(
            "{:<18} {n:>8} steps, of the law: ahead {ahead:.2}",
            row.name
        );
        assert!((0.46..=1.64).contains(&ahead), "{ahead}");
        assert!(state <= 1e-6 * median(&finest.found[count].state));
    }
}
