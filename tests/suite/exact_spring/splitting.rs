//! The two methods that take flows, chosen at run time: the others do not compile with one.

use fixstep::{Body, BodyId, Force, Method, SemiImplicitEuler, TimeStep, Verlet};

/// A splitting method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Splitting {
    SemiImplicitEuler,
    Verlet,
}

pub const SPLITTINGS: [Splitting; 2] = [Splitting::SemiImplicitEuler, Splitting::Verlet];

impl Splitting {
    /// Flows in a step.
    pub fn flows(self) -> f64 {
        match self {
            Splitting::SemiImplicitEuler => 1.0,
            Splitting::Verlet => 2.0,
        }
    }
}

impl<B: Body, const N: usize> Method<B, N> for Splitting {
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        match self {
            Splitting::SemiImplicitEuler => {
                Method::<B, N>::step(&mut SemiImplicitEuler, ids, bodies, forces, step, tick)
            }
            Splitting::Verlet => {
                Method::<B, N>::step(&mut Verlet, ids, bodies, forces, step, tick);
            }
        }
    }
}
