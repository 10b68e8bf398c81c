//! The figures: what each body does at the end, and its angular momentum before that, when the push is over.

use fixstep::rigid::Centre;
use fixstep::{Body, Rigid, Scalar};

use crate::exact::Motion;
use crate::lane::{BURN, Lane, TICKS};

pub const HEAD: &str = "\
| body | numbers | speed, m/s | error | spin, turns/s | error | angular momentum, pushed | error | at the end | error |
|---|---|---|---|---|---|---|---|---|---|
";

/// The ticks at which a body is looked at: when the push is over, and the last.
pub fn looks(lane: Lane) -> [u32; 2] {
    match lane {
        Lane::Gear => [BURN, TICKS],
        _ => [0, TICKS],
    }
}

/// A row, from what is found and what is exact at both [`looks`].
pub fn row(lane: Lane, numbers: &str, found: [Motion; 2], exact: [Motion; 2]) -> String {
    let cell = |part: fn(&Motion) -> f64, i: usize| {
        let (found, exact) = (part(&found[i]), part(&exact[i]));
        format!("{found:.6} | {}", figure(found - exact))
    };
    let momentum = |motion: &Motion| motion.momentum;
    format!(
        "| {} | {numbers} | {} | {} | {} | {} |\n",
        lane.name(),
        cell(|motion| motion.speed, 1),
        cell(|motion| motion.spin, 1),
        cell(momentum, 0),
        cell(momentum, 1),
    )
}

/// As it is held.
pub fn motion<C: Centre>(body: &Rigid<C>) -> Motion {
    Motion {
        speed: body.velocity().to_f64().length(),
        spin: body.spin().to_f64(),
        momentum: body.spin_momentum(),
    }
}

fn figure(value: f64) -> String {
    match value {
        0.0 => "0".into(),
        _ => format!("{value:+.1e}").replace('-', "\u{2212}"),
    }
}
