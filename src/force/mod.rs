//! Forces say *what* they do to a body; the method decides *when* and to which copy of the state.
//!
//! | force | acts on | cost |
//! |---|---|---|
//! | [`Gravity`] | every body, from itself | one addition an axis |
//! | [`GravityY`] | every body, from itself | one addition |
//! | [`LinearDrag`] | every body, from itself | a product and one more an axis |
//! | [`PerBody`] | every body, from itself | your function, a product and one more an axis |
//! | [`Anchor`] | one body | two products and two more an axis |
//! | [`Spring`] | two bodies | a square root, two or three divisions |
//! | [`AllBodies`] | every body, from all | your function, 8 bytes a body in the force |
//!
//! A tuple of forces is a force, and so is an array, a `heapless::Vec` or an `Option` of one. What is
//! not named is not linked.
//!
//! A force on one body multiplies by `h / m` at once and rounds the change of velocity. The impulse
//! between two bodies is a scalar itself, in kg m/s: with masses far from 1 kg its unit is coarse for
//! the light body and its range short for the heavy one.
//!
//! [`field`](Force::field) forces need only the body itself: they run inside the loop that moves
//! it. [`couple`](Force::couple) forces see all bodies and run before that loop. Under the splitting
//! methods a force reads velocities that coupled forces before it have changed: drag brakes what a
//! spring has just pushed, so a body that hangs in both rests about `k_drag h / m` of its sag lower.

mod all_bodies;
mod anchor;
mod drag;
mod gravity;
mod per_body;
mod spring;

use crate::body::Body;
use crate::error::Error;
use crate::id::{self, BodyId};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::{Now, TimeStep};

pub use all_bodies::AllBodies;
pub use anchor::Anchor;
pub use drag::LinearDrag;
pub use gravity::{Gravity, GravityY};
pub use per_body::PerBody;
pub use spring::Spring;

/// Bodies to read and the same bodies to push, in the order of their ids.
///
/// The two are one array where a method lets a force see what the forces before it did, and two
/// where all forces act from one instant.
#[derive(Debug)]
pub struct Frame<'a, B> {
    ids: &'a [BodyId],
    seen: Option<&'a [B]>,
    live: &'a mut [B],
}

impl<'a, B: Body> Frame<'a, B> {
    /// Forces read and push the same bodies.
    pub fn new(ids: &'a [BodyId], bodies: &'a mut [B]) -> Self {
        Frame {
            ids,
            seen: None,
            live: bodies,
        }
    }

    /// Forces read `seen` and push `live`: two copies of the same bodies.
    pub fn split(ids: &'a [BodyId], seen: &'a [B], live: &'a mut [B]) -> Self {
        Frame {
            ids,
            seen: Some(seen),
            live,
        }
    }

    /// The bodies as forces are to see them.
    #[inline]
    pub fn bodies(&self) -> &[B] {
        self.seen.unwrap_or(self.live)
    }

    /// The body of that name as forces are to see it, and where it stands.
    #[inline]
    pub fn find(&self, id: BodyId) -> Option<(usize, B)> {
        let index = id::position(self.ids, id)?;
        Some((index, *self.bodies().get(index)?))
    }

    /// The bodies to push, in the same order.
    #[inline]
    pub fn live(&mut self) -> &mut [B] {
        self.live
    }

    /// The body to push at that place.
    #[inline]
    pub fn live_at(&mut self, index: usize) -> Option<&mut B> {
        self.live.get_mut(index)
    }
}

/// Something that changes velocities. A force implements the verbs it needs.
pub trait Force<B: Body> {
    /// Whether [`couple`](Force::couple) does anything: methods skip it otherwise.
    const COUPLES: bool;

    /// Work that is the same for every body; called once before the others, for each evaluation.
    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let _ = now;
    }

    /// Acts on bodies that it finds in `frame`.
    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        let _ = (now, frame);
    }

    /// Acts on one body, `live`, from its state `seen`.
    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
        let _ = (now, seen, live);
    }

    /// Potential energy of `bodies` in this force, J; zero for a force that has none.
    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let _ = (ids, bodies);
        0.0
    }
}

impl<B: Body, F: Force<B>> Force<B> for [F] {
    const COUPLES: bool = F::COUPLES;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        self.iter_mut().for_each(|force| force.prepare(now));
    }

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        self.iter_mut().for_each(|force| force.couple(now, frame));
    }

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
        self.iter_mut()
            .for_each(|force| force.field(now, seen, live));
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        self.iter().map(|force| force.potential(ids, bodies)).sum()
    }
}

/// Hands every verb to `self` seen as `$target`.
macro_rules! forward {
    ($self:ident => $target:ty, $deref:expr, $deref_mut:expr) => {
        const COUPLES: bool = <$target>::COUPLES;

        #[inline]
        fn prepare<H: TimeStep<B::S>>(&mut $self, now: &Now<H>) {
            $deref_mut.prepare(now);
        }

        #[inline]
        fn couple<H: TimeStep<B::S>>(&mut $self, now: &Now<H>, frame: &mut Frame<B>) {
            $deref_mut.couple(now, frame);
        }

        #[inline]
        fn field<H: TimeStep<B::S>>(&mut $self, now: &Now<H>, seen: &B, live: &mut B) {
            $deref_mut.field(now, seen, live);
        }

        fn potential(&$self, ids: &[BodyId], bodies: &[B]) -> f64 {
            $deref.potential(ids, bodies)
        }
    };
}

impl<B: Body, F: Force<B>, const M: usize> Force<B> for [F; M] {
    forward!(self => [F], self.as_slice(), self.as_mut_slice());
}

impl<B: Body, F: Force<B>, const M: usize> Force<B> for heapless::Vec<F, M> {
    forward!(self => [F], self.as_slice(), self.as_mut_slice());
}

/// A force that can be switched off: `None` does nothing.
impl<B: Body, F: Force<B>> Force<B> for Option<F> {
    forward!(self => [F], self.as_slice(), self.as_mut_slice());
}

impl<B: Body, F: Force<B> + ?Sized> Force<B> for &mut F {
    forward!(self => F, (**self), (**self));
}

macro_rules! tuple {
    ($($name:ident)*) => {
        #[allow(non_snake_case, unused_variables)]
        impl<B: Body, $($name: Force<B>),*> Force<B> for ($($name,)*) {
            const COUPLES: bool = false $(|| $name::COUPLES)*;

            #[inline]
            fn prepare<Z: TimeStep<B::S>>(&mut self, now: &Now<Z>) {
                let ($($name,)*) = self;
                $($name.prepare(now);)*
            }

            #[inline]
            fn couple<Z: TimeStep<B::S>>(&mut self, now: &Now<Z>, frame: &mut Frame<B>) {
                let ($($name,)*) = self;
                $($name.couple(now, frame);)*
            }

            #[inline]
            fn field<Z: TimeStep<B::S>>(&mut self, now: &Now<Z>, seen: &B, live: &mut B) {
                let ($($name,)*) = self;
                $($name.field(now, seen, live);)*
            }

            fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
                let ($($name,)*) = self;
                0.0 $(+ $name.potential(ids, bodies))*
            }
        }
    };
}

tuple!();
tuple!(F1);
tuple!(F1 F2);
tuple!(F1 F2 F3);
tuple!(F1 F2 F3 F4);
tuple!(F1 F2 F3 F4 F5);
tuple!(F1 F2 F3 F4 F5 F6);

/// The coefficient of a force: neither negative, nor out of range, nor lost to rounding.
///
/// For forces of your own; `field` names the argument in the error.
#[inline(always)]
pub fn coefficient<S: Scalar>(field: &'static str, value: Ratio) -> Result<S::Coef, Error> {
    if value.num() < 0 {
        return Err(Error::Negative { field, value });
    }
    S::Coef::new(value).ok_or(match value.num() as u64 > value.den() {
        true => Error::OutOfRange { field, value },
        false => Error::RoundsToZero { field, value },
    })
}

/// Coefficients multiplied with `h`: made anew when the step changes, not in every step.
///
/// For forces of your own: keep one, and ask it in `prepare` or `couple`.
#[derive(Clone, Copy, Debug)]
pub struct PerStep<S: Scalar, T>(Option<(S::Coef, T)>);

impl<S: Scalar, T: Copy> Default for PerStep<S, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, T: Copy> PerStep<S, T> {
    /// Nothing made yet.
    pub const fn new() -> Self {
        PerStep(None)
    }

    /// What `make` makes of `h`, remembered for as long as `h` is the same.
    #[inline]
    pub fn get(&mut self, step: &impl TimeStep<S>, make: impl FnOnce(S::Coef) -> T) -> T {
        let h = step.coef();
        match self.0 {
            Some((made_for, value)) if made_for == h => value,
            _ => self.renew(h, make),
        }
    }

    #[cold]
    #[inline(never)]
    fn renew(&mut self, h: S::Coef, make: impl FnOnce(S::Coef) -> T) -> T {
        let value = make(h);
        self.0 = Some((h, value));
        value
    }
}
