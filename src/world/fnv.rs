//! The FNV-1a hashes of Fowler, Noll and Vo: xor first, then multiply.
//!
//! Source: Fowler, Noll, Vo, Eastlake, Hansen, "The FNV Non-Cryptographic Hash Algorithm" (IETF
//! draft-eastlake-fnv): offset bases and primes of 32 and 64 bits.

/// The 64-bit hash of words, eight bytes each.
pub(crate) struct Fnv64(pub(crate) u64);

impl Fnv64 {
    pub(crate) fn new() -> Fnv64 {
        Fnv64(0xcbf2_9ce4_8422_2325)
    }

    pub(crate) fn write(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ byte as u64).wrapping_mul(0x100_0000_01b3);
        }
    }
}

/// The 32-bit hash of bytes: one multiplication per byte on the smallest core.
pub(crate) struct Fnv32(pub(crate) u32);

impl Fnv32 {
    pub(crate) fn new() -> Fnv32 {
        Fnv32(0x811c_9dc5)
    }

    pub(crate) fn write(&mut self, byte: u8) {
        self.0 = (self.0 ^ byte as u32).wrapping_mul(0x0100_0193);
    }
}
