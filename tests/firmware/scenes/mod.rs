//! The scenes of the firmware: one tree of files for every image and for the host's tests, so that what
//! is compared is the same.

pub mod chart;
pub mod every_exact;
pub mod every_turning;
pub mod every_verb;
pub mod force;
pub mod gravity;
pub mod long;
pub mod rigid;

use fixstep::{Body, Error, Force, Method, TimeStep, World};

/// Names a row of the table.
#[derive(Clone, Copy)]
pub struct Name {
    /// Words of the scene, empty ones left out.
    pub scene: [&'static str; 3],
    pub scalar: &'static str,
    pub method: &'static str,
    /// After how many steps the bits are compared, rising.
    pub ticks: &'static [u32],
}

/// When the bits are compared.
pub const TICKS: &[u32] = &[1, 60, 600];

/// The same of scenes that are small enough to go on.
pub const LONG_TICKS: &[u32] = &[1, 60, 600, 36_000];

/// A scene as it starts.
pub struct Start<'a, B: Body, M, H, F, const N: usize> {
    pub world: &'a mut World<B, N>,
    pub method: &'a mut M,
    pub step: &'a H,
    pub forces: &'a mut F,
}

impl<B, M, H, F, const N: usize> Start<'_, B, M, H, F, N>
where
    B: Body,
    M: Method<B, N>,
    H: TimeStep<B::S>,
    F: Force<B>,
{
    /// Makes `steps` steps.
    #[inline]
    pub fn run(&mut self, steps: u32) {
        run(self.world, self.method, self.step, self.forces, steps);
    }
}

/// Not inlined, so that it can be looked at.
#[inline(never)]
fn run<B, M, H, F, const N: usize>(
    world: &mut World<B, N>,
    method: &mut M,
    step: &H,
    forces: &mut F,
    steps: u32,
) where
    B: Body,
    M: Method<B, N>,
    H: TimeStep<B::S>,
    F: Force<B>,
{
    for _ in 0..steps {
        world.step(method, forces, step);
    }
}

/// Looks at scenes: prices them, or compares their bits.
pub trait Meter {
    /// A scene of so many bodies or pairs.
    fn run<B, M, H, F, const N: usize>(
        &mut self,
        name: Name,
        units: u32,
        start: Start<'_, B, M, H, F, N>,
    ) where
        B: Body,
        M: Method<B, N>,
        H: TimeStep<B::S>,
        F: Force<B>;

    /// Work of so many units beside the steps; `hash` looks at what it made.
    fn work<T>(
        &mut self,
        name: Name,
        units: u32,
        work: impl FnOnce() -> T,
        hash: impl FnOnce(T) -> u64,
    );

    /// A scene that says nothing but a hash.
    fn whole(&mut self, scene: &'static str, hash: Result<u64, Error>);
}
