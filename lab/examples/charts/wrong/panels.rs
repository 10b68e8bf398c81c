//! What the eight panels show: title, axes, lines.

use plotters::style::RGBColor;

use super::{points, springs};
use crate::axes::{self, Axis, GREY, SKY, VERMILION};
use crate::table::Table;

const BAD: RGBColor = VERMILION;
const GOOD: [RGBColor; 2] = [axes::BLUE, axes::GREEN];

pub struct Spec {
    pub name: &'static str,
    pub title: String,
    pub axes: [Axis; 2],
    /// Name in the head, names of its lines, colour.
    pub lines: Vec<(&'static str, &'static [&'static str], RGBColor)>,
}

pub fn all(table: &Table) -> [Spec; 8] {
    [
        euler(),
        held(),
        drag(),
        middle(),
        cruise(),
        fall(),
        clock(table),
        range(),
    ]
}

fn ticks<const N: usize>(ticks: [i32; N]) -> [f64; N] {
    ticks.map(f64::from)
}

fn euler() -> Spec {
    let steps = springs::doubling(springs::euler_growth(springs::Q));
    Spec {
        name: "euler",
        title: format!(
            "Explicit Euler: a spring of 1 Hz has twice the energy after {steps:.0} steps"
        ),
        axes: [
            Axis::linear(
                "seconds, 1 Hz at 60 steps a second",
                [0.0, 10.0],
                &ticks([0, 2, 4, 6, 8, 10]),
            ),
            Axis::log("energy", [0.5, 1000.0], &ticks([1, 10, 100, 1000])),
        ],
        lines: vec![
            ("Euler", &["Euler"], BAD),
            ("SemiImplicitEuler", &["SemiImplicitEuler"], GOOD[1]),
            ("Verlet", &["Verlet"], GOOD[0]),
        ],
    }
}

fn held() -> Spec {
    let steps = springs::doubling(springs::held_growth(springs::Q, 4));
    Spec {
        name: "held",
        title: format!("A spring held over 4 substeps: twice the energy after {steps:.0} steps"),
        axes: [
            Axis::linear(
                "seconds, 1 Hz at 60 steps a second",
                [0.0, 10.0],
                &ticks([0, 2, 4, 6, 8, 10]),
            ),
            Axis::linear("energy", [0.0, 12.0], &ticks([0, 2, 4, 6, 8, 10, 12])),
        ],
        lines: vec![
            ("held over 4", &["held over 4 substeps"], BAD),
            ("over 2", &["held over 2"], axes::ORANGE),
            ("SemiImplicitEuler", &["SemiImplicitEuler"], GOOD[1]),
            ("Verlet", &["Verlet"], GOOD[0]),
        ],
    }
}

fn drag() -> Spec {
    Spec {
        name: "drag",
        title: "Truncated drag leaves a creep of 120 units, on one side only".into(),
        axes: [
            Axis::linear(
                "seconds, k = 0.5 kg/s",
                [0.0, 20.0],
                &ticks([0, 5, 10, 15, 20]),
            ),
            Axis::linear(
                "speed, units of 15 µm/s",
                [-400.0, 400.0],
                &ticks([-400, -200, 0, 200, 400]),
            ),
        ],
        lines: vec![
            (
                "v -= c * v of fixed",
                &["v -= c * v of fixed", "v -= c * v of fixed from below"],
                BAD,
            ),
            ("LinearDrag", &["LinearDrag"], GOOD[1]),
            ("ExactDrag", &["ExactDrag"], GOOD[0]),
            ("exact", &["exact"], GREY),
        ],
    }
}

fn middle() -> Spec {
    Spec {
        name: "middle",
        title: "Truncated products pull a mirrored pair to one side".into(),
        axes: [
            Axis::linear(
                "seconds, \u{00b1}1.2345 m/s",
                [0.0, 60.0],
                &ticks([0, 20, 40, 60]),
            ),
            Axis::linear(
                "middle of the pair, mm",
                [-30.0, 5.0],
                &ticks([-30, -20, -10, 0]),
            ),
        ],
        lines: vec![
            ("x += h * v of fixed", &["x += h * v of fixed"], BAD),
            ("this crate, I16F16", &["this crate"], GOOD[0]),
        ],
    }
}

fn cruise() -> Spec {
    Spec {
        name: "cruise",
        title: "f32 at 100 km: 0.2 m/s stands still, 0.3 m/s is half as fast again".into(),
        axes: [
            Axis::linear("seconds at 60 Hz", [0.0, 10.0], &ticks([0, 2, 4, 6, 8, 10])),
            Axis::linear("metres flown", [0.0, 5.0], &ticks([0, 1, 2, 3, 4, 5])),
        ],
        lines: vec![
            (
                "f32 at 100 km",
                &["f32 at 100 km at 0.2 m/s", "f32 at 100 km at 0.3 m/s"],
                BAD,
            ),
            (
                "I16F16 at 30 km",
                &["I16F16 at 30 km at 0.2 m/s", "I16F16 at 30 km at 0.3 m/s"],
                SKY,
            ),
            (
                "f32 at the origin",
                &[
                    "f32 at the origin at 0.2 m/s",
                    "f32 at the origin at 0.3 m/s",
                ],
                GREY,
            ),
        ],
    }
}

fn fall() -> Spec {
    Spec {
        name: "fall",
        title: "f32 at 100 km: what is let go hangs for a quarter second".into(),
        axes: [
            Axis::linear(
                "seconds at 600 Hz",
                [0.0, 0.5],
                &[0.0, 0.1, 0.2, 0.3, 0.4, 0.5],
            ),
            Axis::linear("metres fallen", [-1.6, 0.1], &[-1.5, -1.0, -0.5, 0.0]),
        ],
        lines: vec![
            ("f32 at 100 km", &["f32 at 100 km"], BAD),
            ("I16F16 at 30 km", &["I16F16 at 30 km"], SKY),
            ("f32 at the origin", &["f32 at the origin"], axes::GREEN),
            ("exact", &["exact"], GREY),
        ],
    }
}

fn clock(table: &Table) -> Spec {
    let day = points(table, "clock", "t += 1/60 in f32");
    let slow = day.last().map_or(f64::NAN, |[_, off]| -off / 60.0);
    Spec {
        name: "clock",
        title: format!("Seconds added up in f32 are {slow:.0} minutes behind after a day"),
        axes: [
            Axis::linear(
                "hours at 60 Hz",
                [0.0, 24.0],
                &ticks([0, 4, 8, 12, 16, 20, 24]),
            ),
            Axis::linear(
                "seconds off",
                [-3000.0, 2000.0],
                &ticks([-3000, -2000, -1000, 0, 1000, 2000]),
            ),
        ],
        lines: vec![
            ("t += 1/60 in f32", &["t += 1/60 in f32"], BAD),
            ("ticks of this crate", &["ticks of this crate"], GOOD[0]),
        ],
    }
}

fn range() -> Spec {
    Spec {
        name: "range",
        title: "Past the end of the range: wrapped to the other side, or held".into(),
        axes: [
            Axis::linear("seconds at 1000 m/s", [0.0, 60.0], &ticks([0, 20, 40, 60])),
            Axis::linear("position, km", [-40.0, 40.0], &ticks([-40, -20, 0, 20, 40])),
        ],
        lines: vec![
            ("+ of fixed, release build", &["x += h * v of fixed"], BAD),
            ("this crate, I16F16", &["this crate"], GOOD[0]),
        ],
    }
}
