//! What a force has made for one key, and keeps until it is asked for another.

/// A value and the key it was made for, such as the length of a step or the mass of a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Memo<K, T>(Option<(K, T)>);

impl<K: Copy + PartialEq, T: Copy> Memo<K, T> {
    /// Nothing made yet.
    pub(crate) const fn new() -> Self {
        Memo(None)
    }

    /// What `make` makes of `key`, made anew only where the key before was another.
    #[inline]
    pub(crate) fn get(&mut self, key: K, make: impl FnOnce(K) -> T) -> T {
        match self.0 {
            Some((known, value)) if known == key => value,
            _ => *self.renew(key, make),
        }
    }

    /// Has the next call make its value anew: what it depends on beside the key has changed.
    pub(crate) fn forget(&mut self) {
        self.0 = None;
    }

    #[cold]
    #[inline(never)]
    fn renew(&mut self, key: K, make: impl FnOnce(K) -> T) -> &T {
        &self.0.insert((key, make(key))).1
    }
}
