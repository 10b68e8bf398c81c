//! What rounding may do in a flow, and how much of it is left after many.

use crate::exact_spring::flow::Matrix;
use crate::support::*;

/// Whether the unit is the same everywhere.
pub fn is_fixed<S: Format>() -> bool {
    S::unit(1.0) == S::unit(2.0)
}

/// One rounding of a coefficient, of itself.
pub fn coefficient<S: Format>() -> f64 {
    S::COEFFICIENT / 3.0
}

/// The most that one flow of a spring is off by, as a length in (x, v/ω), for a body that swings by
/// `amplitude` about a point up to `reach` from the origin.
///
/// Damped, x and v take two products each, half a unit both: one unit in x, one in v. A turn rounds x,
/// v and x again; a shear lengthens by at most `(1 + sqrt 5)/2 = 1.62`, so the first comes out at most
/// 2.62 times as long, the second 1.62 times: 1.81 units of x and 0.81 of v. Floats round the sums as
/// well, and the difference z: damped 3 and 2.5; a turn 2 for the half turn before it, 2 * 1.81, 1.62
/// times half of one for z: 6.5 units of x, and 1.62 of v. Units are those of the largest partial
/// sum: three amplitudes. Gains of up to 2 and exchanges of up to 1, or the terms of
/// `2 α + α² β`, are each off by one rounding of a coefficient: less than ten of them.
pub fn of_flow<S: Format>(omega: f64, amplitude: f64, reach: f64) -> f64 {
    let x = S::unit(reach + 3.0 * amplitude);
    let v = S::unit(3.0 * omega * amplitude) / omega;
    let rounded = if is_fixed::<S>() {
        2.0 * x + v
    } else {
        6.5 * x + 2.5 * v
    };
    rounded + 10.0 * coefficient::<S>() * amplitude
}

/// Errors of one step each add up as the flow carries them on: `sum(|P^j|)` over the steps so far,
/// where |P| <= 1.
pub struct Carried {
    flow: Matrix,
    power: Matrix,
    pub sum: f64,
}

impl Carried {
    pub fn new(flow: Matrix) -> Carried {
        Carried {
            flow,
            power: Matrix::identity(),
            sum: 0.0,
        }
    }

    /// One step more.
    pub fn step(&mut self) {
        let entries = self.power.to_f64();
        let square: f64 = entries
            .as_flattened()
            .iter()
            .map(|entry| entry * entry)
            .sum();
        self.sum += square.sqrt().min(1.0);
        self.power = self.power.times(&self.flow);
    }
}
