//! The map of drag alone: linear and quadratic, as a force and as a factor, and both sides of each limit.

use crate::stability::drag_cell::{KINDS, row};
use crate::stability::law::{LAWS, Law};
use crate::stability::scene::*;

/// All of one law: the grid, and a five-hundredth on both sides of where it explodes.
fn check_law<S: Number>(law: &Law) {
    let what = format!("{:<8}{:?}", S::name(), law.scheme);
    for kind in KINDS {
        let cells = row(kind.columns().map(|rate| kind.course::<S>(law, rate)));
        let limit = kind.limit(law);
        println!("{what:<32}{:<18}{cells:<34}limit {limit:.4}", kind.name());
        if limit.is_finite() {
            for side in [0.998, 1.002] {
                kind.course::<S>(law, side * limit);
            }
        }
    }
}

pub fn check<S: Number>() {
    LAWS.iter().for_each(check_law::<S>);
}

/// The limit of a measured step is the closed one but for what the slack of the search moves it, 9e-13:
/// `|v'/v|` rises by more than 0.1 for a unit of rate.
pub fn check_limits() {
    for (law, kind) in LAWS.iter().flat_map(|law| KINDS.map(|kind| (law, kind))) {
        let (limit, measured) = (kind.limit(law), kind.measured_limit(law));
        let same = measured == limit || (measured - limit).abs() <= 1e-11;
        assert!(same, "{:?} {kind:?}: {measured} and {limit}", law.scheme);
    }
}
