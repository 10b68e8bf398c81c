//! The bodies that play in the scenes of these tests: made of a point, saved, and looked at when read.

use std::fmt::Debug;

use fixstep::rigid::{Centre, SavedRotor};
use fixstep::{
    Angle, Body, Carried, Carry, Factor, Point, RangeChecked, Rigid, Rotating, Saved, Scalar, Vec2,
};

use super::bytes::Kept;
use crate::support::{ratio, spread};

/// A body that can be made of a point and saved.
pub trait Cast: Saved<S: Kept> + Debug {
    /// Whether no two states of it are read as the same.
    const EXACT: bool = true;

    /// Of a point; whatever else it has comes from `seed`.
    fn of(point: Point<Self::S>, seed: usize) -> Self;

    /// What holds for every body that was read.
    fn assert_sound(&self) {
        let inverse = self.inv_mass().to_f64();
        assert!(0.0 < inverse && inverse < f64::INFINITY, "{inverse}");
    }
}

impl<S: Kept> Cast for Point<S> {
    fn of(point: Point<S>, _: usize) -> Self {
        point
    }
}

impl<S: Kept + Carry> Cast for Carried<S> {
    fn of(point: Point<S>, _: usize) -> Self {
        point.into()
    }
}

/// Of five, one is locked and one kinematic.
impl<C: Cast + Centre<Rotor: SavedRotor>> Cast for Rigid<C> {
    fn of(point: Point<C::S>, seed: usize) -> Self {
        let part = |k: usize| ratio(2.0 * spread(3 * seed + k) - 1.0);
        let body = match seed % 5 {
            2 => Rigid::locked(C::of(point, seed)),
            3 => Rigid::kinematic(point.position(), point.velocity()).unwrap(),
            _ => Rigid::new(C::of(point, seed), ratio(0.4 + spread(seed))).unwrap(),
        };
        let body = body.with_angle(Angle::turns(part(0)));
        body.with_spin(part(1)).unwrap()
    }

    fn assert_sound(&self) {
        let [mass, inertia] = [
            self.inv_mass().to_f64(),
            Rotating::inv_inertia(self).to_f64(),
        ];
        if self.has_infinite_mass() {
            assert_eq!([mass, inertia], [0.0; 2]);
        } else {
            assert!(0.0 < mass && mass < f64::INFINITY, "{mass}");
            assert!((0.0..f64::INFINITY).contains(&inertia), "{inertia}");
        }
    }
}

/// Every other has been outside.
impl<B: Cast> Cast for RangeChecked<B> {
    // One that stands outside is marked when it is read.
    const EXACT: bool = false;

    fn of(point: Point<B::S>, seed: usize) -> Self {
        let body = B::of(point, seed);
        let mut watched = RangeChecked::new(body);
        if seed.is_multiple_of(2) {
            watched.shift(Vec2::new(B::S::MAX, B::S::MAX));
            watched.shift(Vec2::new(B::S::MAX, B::S::MAX));
            watched.change(|moved| *moved = body);
        }
        watched
    }

    fn assert_sound(&self) {
        self.body().assert_sound();
    }
}
