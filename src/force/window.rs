//! A force that acts for a time: from one tick to another.

use core::ops::Range;

use crate::body::Body;
use crate::body::id::BodyId;
use crate::force::{Force, Frame, Part, Reversible};
use crate::time::{Now, TimeStep};

/// Any force, in the steps whose number lies in `ticks` and in no other.
///
/// Ticks are whole numbers, so a window opens and closes on the same step on every target. An empty
/// range never opens.
///
/// ```
/// use fixstep::{Window, prelude::*};
/// let mut world = World::<Point<f32>, 1>::new();
/// let id = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let mut lift = Window::new(10..12, GravityY::new(8)?);
/// for _ in 0..64 {
///     world.step(&mut SemiImplicitEuler, &mut lift, &Step::hz(64)?);
/// }
/// assert_eq!(world.get(id)?.velocity().y, 0.25); // two steps of 8/64 m/s
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Window<F> {
    /// First step that feels the force, and the first that no longer does.
    pub ticks: Range<u64>,
    /// What acts.
    pub force: F,
    open: bool,
}

impl<F> Window<F> {
    /// `force` in the steps numbered `ticks`; a world counts its own from 0.
    ///
    /// ```
    /// use fixstep::{dec, GravityY, Window};
    /// let lift = Window::new(600..660, GravityY::<f32>::new(dec!(9.81))?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    #[inline]
    #[must_use]
    pub const fn new(ticks: Range<u64>, force: F) -> Window<F> {
        Window {
            ticks,
            force,
            open: false,
        }
    }
}

impl<B: Body, F: Force<B>> Force<B> for Window<F> {
    const COUPLES: bool = F::COUPLES;
    const FLOWS: bool = F::FLOWS;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        self.open = self.ticks.contains(&now.tick());
        if self.open {
            self.force.prepare(now);
        }
    }

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        if self.open {
            self.force.couple(now, frame);
        }
    }

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
        if self.open {
            self.force.field(now, seen, live);
        }
    }

    #[inline]
    fn damp<H: TimeStep<B::S>>(&mut self, now: &Now<H>, part: Part, live: &mut B) {
        if self.open {
            self.force.damp(now, part, live);
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
        if self.open {
            self.force.flow(now, part, frame, moved);
        }
    }

    /// That of the force if the last step felt it, else zero.
    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        if self.open {
            self.force.potential(ids, bodies)
        } else {
            0.0
        }
    }
}

// What is closed reads nothing.
impl<B: Body, F: Reversible<B>> Reversible<B> for Window<F> {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        let open = self.ticks.contains(&tick);
        open.then(|| self.force.damper(tick)).flatten()
    }
}
