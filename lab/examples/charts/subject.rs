//! What a course asks of a kind of body: how it starts, and how far it is from where it should be.

use fixstep::rigid::Centre;
use fixstep::{Body, Error, Point, Ratio, Rigid};

use crate::rotor::Rotor;
use crate::starts::Dot;
use crate::support::point;

/// Both, for a kind of body.
pub struct Subject<B> {
    pub start: fn(&Dot) -> Result<B, Error>,
    /// The square of the distance, m², or of the angle between, turns².
    pub square: fn(&B, &[f64; 2]) -> f64,
}

impl<B: Body + From<Point<B::S>>> Subject<B> {
    /// A body that moves.
    pub fn moving() -> Subject<B> {
        Subject {
            start: |dot| Ok(point::<B::S>(dot.x, dot.v, dot.mass).into()),
            square: |body, at| {
                let is = body.position().to_f64();
                (is.x - at[0]).powi(2) + (is.y - at[1]).powi(2)
            },
        }
    }
}

impl<C: Centre + From<Point<C::S>>> Subject<Rigid<C>> {
    /// One that turns in its place: what would be x of a place is an angle. Whole turns are left out, as the
    /// body leaves them out: no run is half a turn behind.
    pub fn turning() -> Subject<Rigid<C>> {
        Subject {
            start: |dot| Rotor::body(Ratio::from_f64(dot.x[0])?, Ratio::from_f64(dot.v[0])?),
            square: |body, at| {
                let apart = body.angle().to_f64() - at[0];
                (apart - apart.round()).powi(2)
            },
        }
    }
}
