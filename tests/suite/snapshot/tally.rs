//! What became of many strings of bytes: worlds, or which of the errors.

use fixstep::SnapshotError;

#[derive(Default)]
pub struct Tally {
    pub accepted: usize,
    pub stepped: usize,
    /// Refusals, one for each kind of error.
    pub refused: [usize; 8],
}

impl Tally {
    pub fn refuse(&mut self, error: SnapshotError) {
        use SnapshotError::*;
        let kind = match error {
            Length { .. } => 0,
            NotASnapshot => 1,
            Version(_) => 2,
            Checksum => 3,
            Kind(_) => 4,
            Scalar(_) => 5,
            Full { .. } => 6,
            State => 7,
            _ => unreachable!(),
        };
        self.refused[kind] += 1;
    }

    pub fn print(&self, what: &str) {
        let Tally {
            accepted,
            stepped,
            refused,
        } = self;
        println!("{what}: {accepted} accepted, {stepped} of them stepped, refused {refused:?}");
    }
}
