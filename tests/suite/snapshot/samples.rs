//! Worlds to be saved, damaged and mistaken for one another: every scalar, empty to full.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::{GravityY, Point, Saved, SnapshotError, Step, Verlet, World, dec};

use super::bytes::Kept;
use crate::support::{point, spread};

pub const ROOM: usize = 8;

pub type Small<S> = World<Point<S>, ROOM>;

/// A snapshot, and who reads it.
pub struct Sample {
    pub name: String,
    pub bytes: Vec<u8>,
    /// The number type, by the table of formats.
    pub format: u32,
    pub load: fn(&[u8]) -> Result<(), SnapshotError>,
}

/// `count` points that have moved for seven ticks, with ids that have gaps.
pub fn world<S: Kept>(count: usize) -> Small<S> {
    let mut world = World::new();
    for i in 0..count {
        let part = |k: usize| 4.0 * spread(5 * i + k) - 2.0;
        let body = point([part(0), part(1)], [part(2), part(3)], 0.5 + spread(i));
        if i % 3 == 1 {
            let gone = world.add(body).unwrap();
            world.remove(gone).unwrap();
        }
        world.add(body).unwrap();
    }
    let mut gravity = GravityY::new(dec!(-1.3)).unwrap();
    for _ in 0..7 {
        world.step(&mut Verlet, &mut gravity, &Step::hz(60).unwrap());
    }
    world
}

pub fn saved<B: Saved, const N: usize>(world: &World<B, N>) -> Vec<u8> {
    let mut bytes = vec![0; World::<B, N>::SNAPSHOT];
    let length = world.save(&mut bytes).unwrap();
    bytes.truncate(length);
    bytes
}

fn sample<S: Kept>(format: u32, count: usize) -> Sample {
    Sample {
        name: format!("{count} points of {}", S::name()),
        bytes: saved(&world::<S>(count)),
        format,
        load: |bytes| Small::<S>::load(bytes).map(drop),
    }
}

/// One snapshot of `count` points in each scalar. A format has a family, then bits of storage, then
/// of the fraction.
pub fn every_scalar(count: usize) -> [Sample; 7] {
    [
        sample::<f32>(0x0200_0020, count),
        sample::<f64>(0x0200_0040, count),
        sample::<I16F16>(0x0100_2010, count),
        sample::<I12F20>(0x0100_2014, count),
        sample::<I8F24>(0x0100_2018, count),
        sample::<I20F12>(0x0100_200C, count),
        sample::<I32F32>(0x0100_4020, count),
    ]
}

/// Every scalar with every number of points.
pub fn all() -> impl Iterator<Item = Sample> {
    (0..=ROOM).flat_map(every_scalar)
}
