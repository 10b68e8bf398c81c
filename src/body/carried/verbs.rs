//! `Body` for a carried point: every method keeps its remainders.

use super::Carried;
use crate::body::{Body, NoSpin};
use crate::scalar::Carry;
use crate::time::TimeStep;
use crate::vec2::Vec2;

impl<S: Carry> Body for Carried<S> {
    type S = S;
    type Spin = NoSpin;

    #[inline]
    fn position(&self) -> Vec2<S> {
        self.position()
    }

    #[inline]
    fn velocity(&self) -> Vec2<S> {
        self.velocity
    }

    #[inline]
    fn inv_mass(&self) -> S::InvMass {
        self.inv_mass
    }

    #[inline]
    fn kick(&mut self, dv: Vec2<S>) {
        self.velocity += dv;
    }

    #[inline]
    fn kick_y(&mut self, dv: S) {
        self.velocity.y = self.velocity.y.plus(dv);
    }

    #[inline]
    fn kick_by(&mut self, value: Vec2<S>, factor: S::Coef) {
        let [x, y] = self.kept();
        self.set([S::kicked(x, value.x, factor), S::kicked(y, value.y, factor)]);
    }

    #[inline]
    fn brake_by(&mut self, value: Vec2<S>, factor: S::Coef) {
        self.kick_by(-value, factor);
    }

    #[inline]
    fn kick_from(&mut self, from: Vec2<S>, factor: S::Coef) {
        let ([x, y], [zx, zy]) = (self.kept(), self.beyond(from));
        self.set([S::kicked_as(x, zx, factor), S::kicked_as(y, zy, factor)]);
    }

    #[inline]
    fn push(&mut self, impulse: Vec2<S>) {
        self.set(S::pushed(self.kept(), impulse.array(), self.inv_mass));
    }

    #[inline]
    fn damp(&mut self, loss: S::Coef) {
        self.set(self.kept().map(|kept| S::damped(kept, loss)));
    }

    #[inline]
    fn halt(&mut self) {
        self.set([(S::ZERO, S::NO_REMAINDER); 2]);
    }

    #[inline]
    fn shift(&mut self, dx: Vec2<S>) {
        let [x, y] = self.position;
        self.position = [
            S::moved_dyadic(x, dx.x, 1, 0),
            S::moved_dyadic(y, dx.y, 1, 0),
        ];
    }

    #[inline]
    fn move_by(&mut self, value: Vec2<S>, factor: S::Coef) {
        let [x, y] = self.position;
        self.position = [
            S::moved(x, value.x, factor, 0),
            S::moved(y, value.y, factor, 0),
        ];
    }

    #[inline]
    fn drift(&mut self, step: &impl TimeStep<S>) {
        let ([x, y], [u, v]) = (self.position, self.kept());
        self.position = [step.carry(x, u), step.carry(y, v)];
    }

    #[inline]
    fn drift_half(&mut self, step: &impl TimeStep<S>) {
        let ([x, y], [u, v]) = (self.position, self.kept());
        self.position = [step.carry_half(x, u), step.carry_half(y, v)];
    }

    #[inline]
    fn drift_by(&mut self, factor: S::Coef) {
        let ([x, y], [u, v]) = (self.position, self.kept());
        self.position = [S::drifted(x, u, factor, 0), S::drifted(y, v, factor, 0)];
    }

    #[inline]
    fn swing(&mut self, from: Vec2<S>, by: [S::Coef; 4]) {
        let ([x, y], [u, v], [zx, zy]) = (self.position, self.kept(), self.beyond(from));
        let ((x, u), (y, v)) = (swung(x, u, zx, by), swung(y, v, zy, by));
        self.position = [x, y];
        self.set([u, v]);
    }

    #[inline]
    fn mirror(&mut self, about: Vec2<S>) {
        let ([x, y], kept) = (self.position, self.kept());
        self.position = [S::mirrored(x, about.x), S::mirrored(y, about.y)];
        self.set(kept.map(S::reversed));
    }

    fn write_state(&self, write: &mut impl FnMut(u64)) {
        let (position, velocity) = (self.position().array(), self.velocity.array());
        position
            .into_iter()
            .chain(velocity)
            .for_each(|scalar| write(scalar.bits()));
        self.position
            .into_iter()
            .for_each(|position| write(S::left_over(position)));
        self.remainder
            .into_iter()
            .for_each(|remainder| write(S::remainder_left_over(remainder)));
    }
}

/// One axis of [`Body::swing`].
#[inline]
fn swung<S: Carry>(
    position: S::FinePosition,
    kept: (S, S::Remainder),
    z: (S, S::Remainder),
    [a, b, c, d]: [S::Coef; 4],
) -> (S::FinePosition, (S, S::Remainder)) {
    let position = S::drifted(S::drifted(position, z, a, 0), kept, b, 0);
    let gained = S::kicked_as(kept, z, c);
    (position, S::kicked_as(gained, kept, d))
}
