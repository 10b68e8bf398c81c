//! A value that a force computes for one key, and keeps until the key changes.

/// A value and the key it was made for, such as the length of a step or the mass of a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Memo<K, T>(Option<(K, T)>);

impl<K: Copy + PartialEq, T: Copy> Memo<K, T> {
    /// Nothing made yet.
    pub(crate) const fn new() -> Self {
        Memo(None)
    }

    /// The value of `make` for `key`. It is computed again only where the key has changed.
    #[inline]
    pub(crate) fn get(&mut self, key: K, make: impl FnOnce(K) -> T) -> T {
        match self.0 {
            Some((known, value)) if known == key => value,
            _ => *self.renew(key, make),
        }
    }

    /// Makes the next call compute its value again, since something other than the key has changed.
    pub(crate) fn forget(&mut self) {
        self.0 = None;
    }

    #[cold]
    #[inline(never)]
    fn renew(&mut self, key: K, make: impl FnOnce(K) -> T) -> &T {
        &self.0.insert((key, make(key))).1
    }
}
