//! Terminal velocity: every method and scalar against the exact value, within derived bounds.
//!
//! A field force reads the velocity as it was at the start of the step, with every method, so
//!
//! ```text
//! v' = v + g h - q v (v/v_t)^(p-1)        q = g h/v_t        p: power of v in the drag
//! ```
//!
//! for all four: they agree in every bit, and the exact terminal speed is their fixed point. From
//! rest under linear drag `v(n) = v_t (1 - (1 - q)^n)`. What is left is rounding:
//!
//! ```text
//! fixed point, unit u     |v - v_t| <= u + u/(2 p q)          kick rounded once, gravity spread
//! floats                  |v - v_t| <= ulp(v + g h)/(p q)     two sums a step
//! ```
//!
//! and the coefficients'. The derivation stands with the formula, in `examples/terminal/bound.rs`.
//! Inside of its dead zone fixed point is where a kick of `g h` rounded down becomes one rounded up.

use fixstep_lab::support;

#[path = "../examples/terminal/bound.rs"]
mod bound;
#[path = "../examples/terminal/csv.rs"]
mod csv;
#[path = "terminal/edges.rs"]
mod edges;
#[path = "../examples/terminal/fall.rs"]
mod fall;
#[path = "../examples/terminal/scene.rs"]
mod scene;
#[allow(dead_code)] // the chart asks for more
#[path = "../examples/terminal/series.rs"]
mod series;
#[path = "../examples/terminal/table.rs"]
mod table;

use std::sync::OnceLock;

use bound::{bound, coefficients};
use fall::{descend, outcome, ticks};
use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use scene::{Fall, Law, SPEEDS};
use series::{Series, coinciding, measure};
use support::*;

const CSV: &str = include_str!("../examples/terminal/terminal.csv");

/// All that the example measures, once.
fn measured() -> &'static [Series] {
    static ALL: OnceLock<Vec<Series>> = OnceLock::new();
    ALL.get_or_init(measure)
}

#[test]
fn the_committed_file_is_what_the_example_makes() {
    assert!(csv::lines(measured()) == CSV, "terminal.csv is another one");
}

#[test]
fn a_page_shows_the_table() {
    assert!(
        support::pages::pages().contains(table::HEAD),
        "no table of terminal speeds"
    );
    for row in table::rows(measured()) {
        assert!(
            support::pages::pages().contains(&row),
            "no page says: {row}"
        );
    }
}

// No force reads a position, and every method hands the old velocity to the forces.
#[test]
fn all_methods_make_the_same_bits() {
    let all = measured();
    assert_eq!(all.len(), 20);
    let groups = coinciding(all);
    assert!(groups.iter().all(|group| group.is_of_all()));
    assert_eq!(groups.len(), 5);
}

// The bounds themselves rest on their being small.
#[test]
fn falls_from_rest_end_within_the_bounds() {
    for series in measured() {
        for law in Law::BOTH {
            let name = format!("{} {:?} {law:?}", series.scalar, series.scheme);
            let all = || series.all(law);
            let bounds: Vec<f64> = all().map(|(_, bound)| bound.worst).collect();
            within(0.01, &format!("{name}, bounds"), &bounds);
            let worst: Vec<f64> = all().map(|(o, bound)| o.worst / bound.worst).collect();
            within(1.0, &format!("{name}, worst tick in bounds"), &worst);
            let mean: Vec<f64> = all().map(|(o, bound)| o.mean / bound.mean).collect();
            within(1.0, &format!("{name}, mean in bounds"), &mean);
        }
    }
}

/// Sixteen falls over all speeds, none of which the example makes.
fn falls(law: Law) -> impl Iterator<Item = Fall> {
    (0..16).map(move |i| Fall::spread(law, SPEEDS[i + 5], 1000 + i))
}

/// From faster than the terminal speed, and from rest again for a scalar that the example lacks.
fn check_ends<S: Format>(from: f64) {
    for law in Law::BOTH {
        for scheme in SCHEMES {
            let share = |fall: Fall| {
                let (outcome, bound) = (outcome::<S>(scheme, &fall, from), bound::<S>(&fall));
                assert!(bound.worst <= 0.01);
                maximum(&[outcome.worst / bound.worst, outcome.mean / bound.mean])
            };
            let shares: Vec<f64> = falls(law).map(share).collect();
            let what = format!("{} {scheme:?} {law:?} from {from}, in bounds", S::name());
            within(1.0, &what, &shares);
        }
    }
}

#[test]
fn falls_from_above_end_within_the_bounds() {
    check_ends::<f32>(1.5);
    check_ends::<f64>(1.5);
    check_ends::<I16F16>(1.5);
    check_ends::<I12F20>(1.5);
    check_ends::<I8F24>(1.5);
    check_ends::<I20F12>(1.5);
    check_ends::<I20F12>(0.0);
}

/// The bound holds on the way too, with `v_t (1 - (1 - q)^n)` in place of v_t: the difference obeys
/// the same recursion from zero. An error of q by a part of it moves the power by no more than
/// the same part of v_t, since `n q (1 - q)^(n-1) < 1`: the coefficients count twice.
fn check_way<S: Format>() {
    for scheme in SCHEMES {
        let share = |fall: Fall| {
            let (speed, mut worst) = (fall.speed(), 0.0_f64);
            let bound = speed * (bound::<S>(&fall).worst + coefficients::<S>(&fall));
            descend::<S>(scheme, &fall, 0.0, ticks(&fall)[0], |n, v| {
                let exact = -speed * (f64::from(n) * (-fall.share()).ln_1p()).exp_m1();
                worst = maximum(&[worst, (v - exact).abs() / bound]);
            });
            worst
        };
        let shares: Vec<f64> = falls(Law::Linear).map(share).collect();
        let what = format!("{} {scheme:?} on its way, in bounds", S::name());
        within(1.0, &what, &shares);
    }
}

#[test]
fn linear_drag_follows_its_recursion() {
    check_way::<f32>();
    check_way::<f64>();
    check_way::<I16F16>();
    check_way::<I12F20>();
    check_way::<I8F24>();
    check_way::<I20F12>();
}

/// With `g h` between the units a and a + 1, the kick is a below `v_t ((a + 1/2) u / g h)^(1/p)` and
/// a + 1 above. Below v does not fall and above it does not rise, by a unit at most: v stays
/// within one unit of that speed, but for its coefficients. It climbs there by the share of ticks
/// which get a + 1, so falls are taken for which neither kind is rare.
fn check_hovering<S: Format>(scheme: Scheme, law: Law) {
    let unit = S::unit(0.0);
    let part = |fall: &Fall| (fall.gain() / unit).fract();
    let all = (0..).map(|i| Fall::spread(law, SPEEDS[i % SPEEDS.len()], 2000 + i));
    let mixed = all.filter(|fall| (0.1..0.9).contains(&part(fall)));
    let off = |fall: Fall| {
        let change = (fall.gain() / unit).floor() + 0.5;
        let ratio = change * unit / fall.gain();
        let edge = fall.speed() * ratio.powf(1.0 / law.power());
        let bound = unit + edge * coefficients::<S>(&fall);
        let ([settle, watch], mut worst) = (ticks(&fall), 0.0_f64);
        descend::<S>(scheme, &fall, 0.0, settle + watch, |n, v| {
            if n > settle {
                worst = maximum(&[worst, (v - edge).abs() / bound]);
            }
        });
        worst
    };
    let shares: Vec<f64> = mixed.take(16).map(off).collect();
    let what = format!("{} {scheme:?} {law:?} from the kick's edge", S::name());
    within(1.0, &what, &shares);
}

#[test]
fn fixed_point_hovers_where_the_kick_changes() {
    for law in Law::BOTH {
        for scheme in SCHEMES {
            check_hovering::<I16F16>(scheme, law);
            check_hovering::<I12F20>(scheme, law);
            check_hovering::<I8F24>(scheme, law);
            check_hovering::<I20F12>(scheme, law);
        }
    }
}
