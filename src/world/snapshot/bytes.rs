//! Little-endian words at the front of a slice.

/// Writes little-endian words to the front of a slice whose length was checked before.
pub(super) struct Writer<'a>(pub(super) &'a mut [u8]);

impl Writer<'_> {
    pub(super) fn put(&mut self, word: u64, count: usize) {
        if let Some((front, tail)) = core::mem::take(&mut self.0).split_at_mut_checked(count) {
            let bytes = word.to_le_bytes();
            front
                .iter_mut()
                .zip(bytes)
                .for_each(|(to, byte)| *to = byte);
            self.0 = tail;
        }
    }
}

/// Reads little-endian words from the front of a slice.
pub(super) struct Reader<'a>(pub(super) &'a [u8]);

impl Reader<'_> {
    pub(super) fn take(&mut self, count: usize) -> u64 {
        let (front, tail) = self.0.split_at_checked(count).unwrap_or_default();
        self.0 = tail;
        let word = front.iter().rev();
        word.fold(0, |word, &byte| word << 8 | byte as u64)
    }
}
