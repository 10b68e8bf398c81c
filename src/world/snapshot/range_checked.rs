//! The saved state of a body that remembers whether it was at an end of the range.

use super::Saved;
use crate::body::RangeChecked;

/// The state of the body, and one byte for the mark, so that the loaded body keeps it.
impl<B: Saved> Saved for RangeChecked<B> {
    const KIND: u16 = B::KIND | 0x4000;
    const BYTES: usize = B::BYTES + 1;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        self.body().save(write);
        write(self.was_outside().into(), 1);
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        let body = B::load(read)?;
        let outside = match read(1) {
            mark @ 0..=1 => mark == 1,
            _ => return None,
        };
        Some(RangeChecked::marked(body, outside))
    }
}
