//! A snapshot seen from outside: where its fields stand, its checksum, a source of random bytes.
//! Nothing here calls the code under test.

use fixstep::{Scalar, Stored};

use crate::support::Format;

/// A number type whose points can be saved.
pub trait Kept: Format + Stored + Scalar<InvMass: Stored> {}

impl<S: Format + Stored + Scalar<InvMass: Stored>> Kept for S {}

/// Bytes before the first body, and of an id before each body.
pub const HEADER: usize = 40;
pub const ID: usize = 4;

/// Where each field of the header stands, by the table in the documentation.
pub const VERSION: (usize, usize) = (4, 2);
pub const KIND: (usize, usize) = (6, 2);
pub const FORMAT: (usize, usize) = (8, 4);
pub const SIZE: (usize, usize) = (12, 4);
pub const COUNT: (usize, usize) = (16, 4);
pub const TICK: (usize, usize) = (20, 8);
pub const NEXT: (usize, usize) = (28, 8);
pub const SUM: (usize, usize) = (36, 4);

/// Bytes of a snapshot of `count` points of `S`: position, velocity and inverse mass are five
/// numbers of one size in every scalar of the crate.
pub fn length<S>(count: usize) -> usize {
    HEADER + count * (ID + 5 * size_of::<S>())
}

/// Where the state of body `i` starts: behind its id.
pub fn body<S>(i: usize) -> usize {
    length::<S>(i) + ID
}

/// FNV-1a of 32 bits: the base and the prime of its authors.
pub fn fnv1a(bytes: impl IntoIterator<Item = u8>) -> u32 {
    bytes.into_iter().fold(2_166_136_261, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(16_777_619)
    })
}

/// `bytes` with `value` in a field.
pub fn put(bytes: &mut [u8], (at, size): (usize, usize), value: u64) {
    bytes[at..at + size].copy_from_slice(&value.to_le_bytes()[..size]);
}

/// What stands in a field.
pub fn get(bytes: &[u8], (at, size): (usize, usize)) -> u64 {
    let mut word = [0; 8];
    word[..size].copy_from_slice(&bytes[at..at + size]);
    u64::from_le_bytes(word)
}

/// Sets the checksum to that of the bytes as they are.
pub fn seal(bytes: &mut [u8]) {
    let others = bytes[..SUM.0].iter().chain(&bytes[HEADER..]);
    let sum = fnv1a(others.copied());
    put(bytes, SUM, sum.into());
}

/// `bytes` with another value in a field, and the checksum that goes with it.
pub fn with(bytes: &[u8], field: (usize, usize), value: u64) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    put(&mut bytes, field, value);
    seal(&mut bytes);
    bytes
}

/// Marsaglia's xorshift of 64 bits with the shifts 13, 7, 17. A seed of zero would stay zero.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// From 0 to below `end`; the remainder's bias does not matter here.
    pub fn below(&mut self, end: usize) -> usize {
        (self.next() >> 11) as usize % end
    }

    pub fn bytes(&mut self, count: usize) -> Vec<u8> {
        let words = (0..count.div_ceil(8)).map(|_| self.next().to_le_bytes());
        let mut bytes: Vec<u8> = words.flatten().collect();
        bytes.truncate(count);
        bytes
    }
}
