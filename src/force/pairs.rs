//! Who a force between two bodies acts on: a list of pairs, or all there are.
//!
//! *What* acts is a [`PairForce`], of which one serves any number of pairs; the list belongs to the
//! scene and takes 8 bytes a pair.

use crate::body::Body;
use crate::body::id::{self, BodyId};
use crate::force::{Force, Frame, Reversible, ReversiblePair};
use crate::time::{Now, TimeStep};

/// Something that acts between two bodies.
///
/// ```
/// use fixstep::time::{Now, TimeStep};
/// use fixstep::{AllPairs, PairForce, prelude::*};
///
/// /// Pushes two bodies apart along x with 1 N.
/// struct Repel;
///
/// impl<B: Body<S = f32>> PairForce<B> for Repel {
///     fn act<H: TimeStep<f32>>(&mut self, now: &Now<H>, _: [&B; 2], [a, b]: [&mut B; 2]) {
///         let impulse = Vec2::new(1.0, 0.0).scaled(now.step.coef());
///         a.push(-impulse); // what one loses the other gains
///         b.push(impulse);
///     }
/// }
///
/// let mut world = World::<Point<f32>, 2>::new();
/// for mass in [1, 2] {
///     world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, mass)?)?;
/// }
/// world.step(&mut SemiImplicitEuler, &mut AllPairs(Repel), &Step::hz(10)?);
/// assert!(world.momentum().x.abs() < 1e-7);
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait PairForce<B: Body> {
    /// Work that is the same for every pair; called once before the others, for each evaluation.
    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let _ = now;
    }

    /// Acts on two bodies, `live`, from their states `seen`. What one of them gains in momentum
    /// the other is to lose.
    fn act<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: [&B; 2], live: [&mut B; 2]);

    /// Potential energy of two bodies, J; zero for a force that has none.
    #[must_use]
    fn potential(&self, bodies: [&B; 2]) -> f64 {
        let _ = bodies;
        0.0
    }
}

/// A force between the bodies of each pair in a list: an array, or a `heapless::Vec` to which the
/// scene adds. A pair does nothing if one body is gone, or if both ids are the same.
///
/// ```
/// use fixstep::{heapless, prelude::*};
/// let mut world = World::<Point<f32>, 8>::new();
/// let mut chain = Pairs::new(Spring::<f32>::new(1, 40, 2)?, heapless::Vec::<[BodyId; 2], 7>::new());
/// let mut last = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// for x in 1..8 {
///     let next = world.add(Point::new(vec2(x, 0)?, vec2(0, 0)?, 1)?)?;
///     chain.pairs.push([last, next]).unwrap(); // a full list returns the pair in the error
///     last = next;
/// }
/// world.step(&mut SemiImplicitEuler, &mut chain, &Step::hz(60)?);
/// assert_eq!(world.get(last)?.position(), vec2(7, 0)?); // no spring is stretched
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pairs<L, P> {
    /// What acts.
    pub law: L,
    /// The pairs of bodies that it acts on.
    pub pairs: P,
}

impl<L, P> Pairs<L, P> {
    /// The same `law` for all `pairs`, in their order.
    #[inline]
    #[must_use]
    pub const fn new(law: L, pairs: P) -> Pairs<L, P> {
        Pairs { law, pairs }
    }
}

impl<B: Body, L: PairForce<B>, P: AsRef<[[BodyId; 2]]>> Force<B> for Pairs<L, P> {
    const COUPLES: bool = true;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        self.law.prepare(now);
    }

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        for pair in self.pairs.as_ref() {
            let (Some(i), Some(j)) = (frame.index_of(pair[0]), frame.index_of(pair[1])) else {
                continue;
            };
            if let Some((seen, live)) = frame.pair(i, j) {
                self.law.act(now, [&seen[0], &seen[1]], live);
            }
        }
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let find = |id| id::position(ids, id).and_then(|i| bodies.get(i));
        let of = |pair: &[BodyId; 2]| match pair.map(find) {
            [Some(first), Some(second)] if pair[0] != pair[1] => {
                self.law.potential([first, second])
            }
            _ => 0.0,
        };
        self.pairs.as_ref().iter().map(of).sum()
    }
}

/// A force between every two bodies of the world: `n (n - 1) / 2` pairs, in the order of ids.
///
/// ```
/// use fixstep::{AllPairs, Pull, prelude::*};
/// let mut world = World::<Point<f64>, 3>::new();
/// for x in [0, 1, 2] {
///     world.add(Point::new(vec2(x, 0)?, vec2(0, 0)?, 1)?)?;
/// }
/// let mut gravitation = AllPairs(Pull::new(1, dec!(0.05))?);
/// world.step(&mut SemiImplicitEuler, &mut gravitation, &Step::hz(60)?);
/// assert!(world.momentum().x.abs() < 1e-15); // the body between the others is pulled both ways
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct AllPairs<L>(
    /// What acts.
    pub L,
);

impl<B: Body, L: PairForce<B>> Force<B> for AllPairs<L> {
    const COUPLES: bool = true;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        self.0.prepare(now);
    }

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        for j in 1..frame.bodies().len() {
            for i in 0..j {
                if let Some((seen, live)) = frame.pair(i, j) {
                    self.0.act(now, [&seen[0], &seen[1]], live);
                }
            }
        }
    }

    fn potential(&self, _ids: &[BodyId], bodies: &[B]) -> f64 {
        let with_others = |(i, first): (usize, &B)| -> f64 {
            let others = bodies.iter().skip(i + 1);
            others.map(|second| self.0.potential([first, second])).sum()
        };
        bodies.iter().enumerate().map(with_others).sum()
    }
}

impl<B: Body, L: ReversiblePair<B>, P: AsRef<[[BodyId; 2]]>> Reversible<B> for Pairs<L, P> {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        self.law.damper(tick)
    }
}

impl<B: Body, L: ReversiblePair<B>> Reversible<B> for AllPairs<L> {
    fn damper(&self, tick: u64) -> Option<&'static str> {
        self.0.damper(tick)
    }
}
