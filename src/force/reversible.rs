//! Forces whose steps can be undone: their kicks depend on positions and time alone.
//!
//! Then the same kick can be made from both sides of it, and `(v + a) - a` is v. A force that reads
//! velocities (a drag, a damper) would read others on the way back.

use crate::body::Body;
use crate::force::{AllBodies, Force, PairForce, PerBody};
use crate::scalar::Scalar;

/// A force whose kick depends on positions and time alone, and that neither damps nor flows.
///
/// Implement it for a force of your own that keeps this law.
///
/// ```
/// use fixstep::{LinearDrag, Reversible, prelude::*};
/// let mut world = World::<Point<f32>, 1>::new();
/// let id = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let damper = |damping| Ok::<_, Error>(Anchor::new(id, vec2(0, 0)?, 5, damping)?.damper_name());
/// trait DamperName {
///     fn damper_name(&self) -> Option<&'static str>;
/// }
/// impl<F: Reversible<Point<f32>>> DamperName for F {
///     fn damper_name(&self) -> Option<&'static str> {
///         self.damper(0)
///     }
/// }
/// assert_eq!(damper(0)?, None);
/// assert_eq!(damper(1)?, Some("Anchor")); // it reads velocities
/// # Ok::<(), fixstep::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "the steps of `{Self}` cannot be undone",
    note = "a kick must depend on positions and time alone; drags read velocities",
    note = "a function may: `PositionOnly(PerBody(f))` promises that it does not"
)]
pub trait Reversible<B: Body>: Force<B> {
    /// The name of a force in it that reads velocities in step `tick`. A spring with damping is one.
    #[must_use]
    fn damper(&self, tick: u64) -> Option<&'static str> {
        let _ = tick;
        None
    }
}

/// The same as [`Reversible`], for a force between two bodies.
///
/// ```
/// use fixstep::{ReversiblePair, prelude::*};
/// fn damper(spring: Spring<f32>) -> Option<&'static str> {
///     ReversiblePair::<Point<f32>>::damper(&spring, 0)
/// }
/// assert_eq!(damper(Spring::new(1, 40, 0)?), None);
/// assert_eq!(damper(Spring::new(1, 40, 2)?), Some("Spring"));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[diagnostic::on_unimplemented(message = "the steps of `{Self}` between bodies cannot be undone")]
pub trait ReversiblePair<B: Body>: PairForce<B> {
    /// The name of the force, if it reads velocities in step `tick`.
    #[must_use]
    fn damper(&self, tick: u64) -> Option<&'static str> {
        let _ = tick;
        None
    }
}

/// Your promise that the function in a [`PerBody`] or [`AllBodies`] reads no velocity and no spin. For the same
/// time and positions it must always return the same force.
///
/// ```
/// use fixstep::{PositionOnly, RangeChecked, Time, fixed::types::I16F16, prelude::*};
/// // A tide that changes its direction every 600 ticks.
/// let mut tide = PositionOnly(PerBody(|time: Time, _: &RangeChecked<Point<I16F16>>| {
///     let ebb = time.half_ticks() / 1200 % 2 == 0;
///     Vec2::new(if ebb { I16F16::ONE } else { -I16F16::ONE }, I16F16::ZERO)
/// }));
/// let mut world = World::<_, 1>::new();
/// world.add(RangeChecked::new(Point::new(vec2(0, 0)?, vec2(1, 0)?, 1)?))?;
/// let (before, step) = (world.state_hash(), Step::hz(60)?);
/// world.step(&mut Verlet, &mut tide, &step);
/// world.step_back(&mut Verlet, &mut tide, &step).unwrap();
/// assert_eq!(world.state_hash(), before);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PositionOnly<F>(
    /// The force.
    pub F,
);

impl<B: Body, F> Reversible<B> for PositionOnly<PerBody<F>> where PerBody<F>: Force<B> {}

impl<B: Body, F, S: Scalar, const N: usize> Reversible<B> for PositionOnly<AllBodies<F, S, N>> where
    AllBodies<F, S, N>: Force<B>
{
}

impl<B: Body, F: Reversible<B>> Reversible<B> for [F] {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        self.iter().find_map(|force| force.damper(tick))
    }
}

impl<B: Body, F: Reversible<B>, const M: usize> Reversible<B> for [F; M] {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        self.as_slice().damper(tick)
    }
}

impl<B: Body, F: Reversible<B>, const M: usize> Reversible<B> for heapless::Vec<F, M> {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        self.as_slice().damper(tick)
    }
}

impl<B: Body, F: Reversible<B>> Reversible<B> for Option<F> {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        self.as_slice().damper(tick)
    }
}

impl<B: Body, F: Reversible<B> + ?Sized> Reversible<B> for &mut F {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        (**self).damper(tick)
    }
}

macro_rules! tuple {
    ($($name:ident)*) => {
        #[allow(non_snake_case, unused_variables)]
        impl<B: Body, $($name: Reversible<B>),*> Reversible<B> for ($($name,)*) {
            fn damper(&self, tick: u64) -> Option<&'static str> {
                let ($($name,)*) = self;
                None$(.or_else(|| $name.damper(tick)))*
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
