//! `Body` for a rigid body: the functions of its centre, and the same for its rotor.
//!
//! A kinematic or static body has an inverse mass and an inverse inertia of zero. Kicks are the same for every mass, so they
//! test for it. Pushes and torques test too, since infinity times zero is NaN.

use super::rotor::Rotor;
use super::{Centre, Rigid};
use crate::body::{Body, Point, Reverse};
use crate::scalar::{Angular, Exact, Factor, Scalar};
use crate::time::{Revolve, TimeStep};
use crate::vec2::Vec2;

type Coef<B> = <<B as Body>::S as Scalar>::Coef;

impl<C: Centre> Body for Rigid<C> {
    type S = C::S;
    type Spin = C::S;

    #[inline]
    fn position(&self) -> Vec2<C::S> {
        self.centre.position()
    }

    #[inline]
    fn velocity(&self) -> Vec2<C::S> {
        self.centre.velocity()
    }

    #[inline]
    fn inv_mass(&self) -> <C::S as Scalar>::InvMass {
        self.centre.inv_mass()
    }

    #[inline]
    fn kick(&mut self, dv: Vec2<C::S>) {
        if !self.has_infinite_mass() {
            self.centre.kick(dv);
        }
    }

    #[inline]
    fn kick_y(&mut self, dv: C::S) {
        if !self.has_infinite_mass() {
            self.centre.kick_y(dv);
        }
    }

    #[inline]
    fn kick_by(&mut self, value: Vec2<C::S>, factor: Coef<C>) {
        if !self.has_infinite_mass() {
            self.centre.kick_by(value, factor);
        }
    }

    #[inline]
    fn brake_by(&mut self, value: Vec2<C::S>, factor: Coef<C>) {
        if !self.has_infinite_mass() {
            self.centre.brake_by(value, factor);
        }
    }

    #[inline]
    fn push(&mut self, impulse: Vec2<C::S>) {
        if !self.has_infinite_mass() {
            self.centre.push(impulse);
        }
    }

    #[inline]
    fn damp(&mut self, loss: Coef<C>) {
        if !self.has_infinite_mass() {
            self.centre.damp(loss);
        }
    }

    #[inline]
    fn kick_from(&mut self, from: Vec2<C::S>, factor: Coef<C>) {
        if !self.has_infinite_mass() {
            self.centre.kick_from(from, factor);
        }
    }

    #[inline]
    fn halt(&mut self) {
        self.centre.halt();
        self.rotor.set_spin(C::S::ZERO);
    }

    #[inline]
    fn shift(&mut self, dx: Vec2<C::S>) {
        self.centre.shift(dx);
    }

    #[inline]
    fn move_by(&mut self, value: Vec2<C::S>, factor: Coef<C>) {
        self.centre.move_by(value, factor);
    }

    #[inline(always)]
    fn drift(&mut self, step: &impl TimeStep<C::S>) {
        self.centre.drift(step);
        self.drift_angle(step);
    }

    #[inline(always)]
    fn drift_half(&mut self, step: &impl TimeStep<C::S>) {
        self.centre.drift_half(step);
        self.drift_angle_half(step);
    }

    #[inline]
    fn drift_by(&mut self, factor: Coef<C>) {
        self.centre.drift_by(factor);
    }

    #[inline]
    fn swing(&mut self, from: Vec2<C::S>, by: [Coef<C>; 4]) {
        self.centre.swing(from, by);
    }

    #[inline]
    fn mirror(&mut self, about: Vec2<C::S>) {
        self.centre.mirror(about);
    }

    #[inline]
    fn spin(&self) -> C::S {
        self.rotor.spin()
    }

    #[inline]
    fn twist(&mut self, change: C::S) {
        self.rotor.twist(change);
    }

    #[inline]
    fn twist_part(&mut self, spin: C::S, factor: Coef<C>) {
        self.rotor.twist_by(spin, factor);
    }

    #[inline(always)]
    fn drift_angle(&mut self, step: &impl TimeStep<C::S>) {
        self.rotor = step.revolve(self.rotor);
    }

    #[inline(always)]
    fn drift_angle_half(&mut self, step: &impl TimeStep<C::S>) {
        self.rotor = step.revolve_half(self.rotor);
    }

    #[inline]
    fn drift_angle_by(&mut self, factor: Coef<C>) {
        self.rotor = self.rotor.revolved(factor, 0);
    }

    #[inline]
    fn rotate_by(&mut self, spin: C::S, factor: Coef<C>) {
        self.rotor.rotate_by(spin, factor);
    }

    #[inline]
    fn has_infinite_mass(&self) -> bool {
        self.inv_mass() == C::S::INFINITE_MASS
    }

    // With s = ω / 2π and the inverse i = 1 / 2πI: I ω²/2 = π s² / i and I ω = s / i.
    fn spin_energy(&self) -> f64 {
        core::f64::consts::PI * self.spin().to_f64() * self.spin_momentum()
    }

    fn spin_momentum(&self) -> f64 {
        let inv_inertia = self.rotor.inv_inertia().to_f64();
        if inv_inertia == 0.0 {
            return 0.0;
        }
        self.rotor.spin_to_f64() / inv_inertia
    }

    fn write_state(&self, write: &mut impl FnMut(u64)) {
        self.centre.write_state(write);
        write(crate::scalar::Turns::bits(self.angle().count()));
        write(self.spin().bits());
        self.rotor.write_left_over(write);
    }

    #[inline]
    fn is_inside(&self) -> bool {
        self.centre.is_inside() && self.spin().is_inside()
    }
}

impl<S: Angular + Exact> Reverse for Rigid<Point<S>> {
    #[inline]
    fn reverse(&mut self) {
        self.centre.reverse();
        self.rotor.reverse();
    }
}
