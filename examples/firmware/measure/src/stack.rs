//! How deep the stack goes: paint what lies below, work, look for the deepest mark that is gone.

use core::hint::black_box;

use crate::board::Board;

/// Words that are painted; no step needs as much.
const WORDS: usize = 1024;
const PAINT: usize = 0x5a5a_a5a5;

/// Bytes that `work` takes. Painting is inlined, so that nothing stands below the stack pointer.
#[inline(never)]
pub fn used(board: &impl Board, work: impl FnOnce()) -> Option<usize> {
    let here = stack_pointer();
    let room = board
        .stack_bottom()
        .map_or(0, |bottom| here.saturating_sub(bottom));
    let words = (room / size_of::<usize>()).min(WORDS);
    let deepest = here - words * size_of::<usize>();
    // SAFETY: from the bottom of the stack to the stack pointer, by the promise of `Board`.
    unsafe { paint(deepest, words) };
    work();
    // SAFETY: the same words.
    let kept = |&i: &usize| unsafe { read(deepest, i) } == PAINT;
    let untouched = (0..words).take_while(kept).count();
    // Where all is gone, it may have gone deeper.
    (untouched > 0).then(|| (words - untouched) * size_of::<usize>())
}

// As far as the compiler knows it pushes: so the frame of the caller is made before, and stands above.
#[inline(always)]
fn stack_pointer() -> usize {
    let pointer: usize;
    #[cfg(target_arch = "arm")]
    // SAFETY: it reads a register.
    unsafe {
        core::arch::asm!("mov {}, sp", out(reg) pointer)
    };
    #[cfg(target_arch = "riscv32")]
    // SAFETY: it reads a register.
    unsafe {
        core::arch::asm!("mv {}, sp", out(reg) pointer)
    };
    #[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
    {
        pointer = 0;
    }
    pointer
}

/// # Safety
///
/// So many words from there on are nobody's.
#[inline(always)]
unsafe fn paint(start: usize, words: usize) {
    for i in 0..words {
        // SAFETY: one of them.
        unsafe {
            (start as *mut usize)
                .add(i)
                .write_volatile(black_box(PAINT))
        };
    }
}

/// # Safety
///
/// That word is in memory.
#[inline(always)]
unsafe fn read(start: usize, word: usize) -> usize {
    // SAFETY: it is.
    unsafe { (start as *const usize).add(word).read_volatile() }
}
