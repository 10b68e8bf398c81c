//! The bodies as forces see them, for methods in which all forces act from the same instant.

use crate::body::Body;

/// A copy of the bodies, filled only where a force couples them.
#[derive(Clone, Debug)]
pub(super) struct Seen<B, const N: usize>(heapless::Vec<B, N>);

impl<B, const N: usize> Seen<B, N> {
    pub(super) const fn new() -> Self {
        Seen(heapless::Vec::new())
    }

    pub(super) fn bodies(&self) -> &[B] {
        &self.0
    }
}

impl<B: Body, const N: usize> Seen<B, N> {
    #[inline]
    pub(super) fn copy(&mut self, bodies: &[B]) {
        super::copy(bodies, &mut self.0);
    }
}

/// `new` and `Default` of a method that holds such a copy and nothing else.
macro_rules! holds_a_copy {
    ($method:ident) => {
        impl<B, const N: usize> $method<B, N> {
            /// With room for the copy.
            #[must_use]
            pub const fn new() -> Self {
                $method { seen: Seen::new() }
            }
        }

        impl<B, const N: usize> Default for $method<B, N> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}

pub(super) use holds_a_copy;
