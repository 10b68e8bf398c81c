//! What an image asks of a board.

use fixstep::Error;

/// What a board's counter counts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Counts {
    Instructions,
    Cycles,
    /// There is no counter, and no stack to look at.
    Nothing,
}

/// A counter, a line to the host and a stack.
///
/// # Safety
///
/// Nothing but the stack uses the memory from [`Board::stack_bottom`] to the stack pointer, and no interrupt
/// runs: it is painted.
pub unsafe trait Board {
    const COUNTS: Counts;
    /// What one round of `spin` takes, in what is counted.
    const ROUND: u32;

    /// Starts the counter.
    fn start(&self);

    /// Ticks of the counter, which wraps; reading takes a few counts.
    fn ticks(&self) -> u32;

    /// What so many ticks count.
    fn counts(&self, ticks: u32) -> u32 {
        ticks
    }

    /// A loop of known length.
    fn spin(&self, rounds: u32);

    /// Prints to the host.
    fn print(&self, text: &str);

    /// Ends the emulation.
    fn exit(&self, ok: bool) -> !;

    /// The lowest address that the stack may use, where it grows down to.
    fn stack_bottom(&self) -> Option<usize>;
}

/// Runs an image to its end.
pub fn finish<B: Board>(board: &B, image: impl FnOnce(&B) -> Result<(), Error>) -> ! {
    board.start();
    let made = image(board);
    if made.is_err() {
        board.print("a constructor refused a value\n");
    }
    board.exit(made.is_ok())
}
