//! Forces together are a force: tuples, arrays, lists, an option, a reference, a promise.

use crate::body::Body;
use crate::body::id::BodyId;
use crate::force::{Force, Frame, Part, PositionOnly};
use crate::time::{Now, TimeStep};

impl<B: Body, F: Force<B>> Force<B> for [F] {
    const COUPLES: bool = F::COUPLES;
    const FLOWS: bool = F::FLOWS;

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

    // Backwards in the second half, so that a step is the mirror image of itself.
    #[inline]
    fn damp<H: TimeStep<B::S>>(&mut self, now: &Now<H>, part: Part, live: &mut B) {
        match part {
            Part::SecondHalf => self
                .iter_mut()
                .rev()
                .for_each(|force| force.damp(now, part, live)),
            _ => self
                .iter_mut()
                .for_each(|force| force.damp(now, part, live)),
        }
    }

    #[inline]
    fn flow<H: TimeStep<B::S>>(
        &mut self,
        now: &Now<H>,
        part: Part,
        frame: &mut Frame<B>,
        moved: &mut [bool],
    ) {
        self.iter_mut()
            .for_each(|force| force.flow(now, part, frame, moved));
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        self.iter().map(|force| force.potential(ids, bodies)).sum()
    }
}

/// Forwards every function to `self` as `$target`.
macro_rules! forward {
    ($self:ident => $target:ty, $deref:expr, $deref_mut:expr) => {
        const COUPLES: bool = <$target>::COUPLES;
        const FLOWS: bool = <$target>::FLOWS;

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

        #[inline]
        fn damp<H: TimeStep<B::S>>(&mut $self, now: &Now<H>, part: Part, live: &mut B) {
            $deref_mut.damp(now, part, live);
        }

        #[inline]
        fn flow<H: TimeStep<B::S>>(
            &mut $self,
            now: &Now<H>,
            part: Part,
            frame: &mut Frame<B>,
            moved: &mut [bool],
        ) {
            $deref_mut.flow(now, part, frame, moved);
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

impl<B: Body, F: Force<B>> Force<B> for PositionOnly<F> {
    forward!(self => F, self.0, self.0);
}

macro_rules! tuple {
    ($($name:ident)*; $($back:ident)*) => {
        #[allow(non_snake_case, unused_variables)]
        impl<B: Body, $($name: Force<B>),*> Force<B> for ($($name,)*) {
            const COUPLES: bool = false $(|| $name::COUPLES)*;
            const FLOWS: bool = false $(|| $name::FLOWS)*;

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

            #[inline]
            fn damp<Z: TimeStep<B::S>>(&mut self, now: &Now<Z>, part: Part, live: &mut B) {
                let ($($name,)*) = self;
                match part {
                    Part::SecondHalf => { $($back.damp(now, part, live);)* }
                    _ => { $($name.damp(now, part, live);)* }
                }
            }

            #[inline]
            fn flow<Z: TimeStep<B::S>>(
                &mut self,
                now: &Now<Z>,
                part: Part,
                frame: &mut Frame<B>,
                moved: &mut [bool],
            ) {
                let ($($name,)*) = self;
                $($name.flow(now, part, frame, moved);)*
            }

            fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
                let ($($name,)*) = self;
                0.0 $(+ $name.potential(ids, bodies))*
            }
        }
    };
}

tuple!(;);
tuple!(F1; F1);
tuple!(F1 F2; F2 F1);
tuple!(F1 F2 F3; F3 F2 F1);
tuple!(F1 F2 F3 F4; F4 F3 F2 F1);
tuple!(F1 F2 F3 F4 F5; F5 F4 F3 F2 F1);
tuple!(F1 F2 F3 F4 F5 F6; F6 F5 F4 F3 F2 F1);
