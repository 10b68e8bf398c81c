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
    paint(deepest, words);
    work();
    let untouched = (0..words)
        .take_while(|&i| read(deepest, i) == PAINT)
        .count();
    // Where all is gone, it may have gone deeper.
    (untouched > 0).then(|| (words - untouched) * size_of::<usize>())
}

// As far as the compiler knows it pushes: so the frame of the caller is made before, and stands above.
#[inline(always)]
fn stack_pointer() -> usize {
    let pointer: usize;
    #[cfg(target_arch = "arm")]
    unsafe {
        core::arch::asm!("mov {}, sp", out(reg) pointer)
    };
    #[cfg(target_arch = "riscv32")]
    unsafe {
        core::arch::asm!("mv {}, sp", out(reg) pointer)
    };
    #[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
    {
        pointer = 0;
    }
    pointer
}

#[inline(always)]
fn paint(start: usize, words: usize) {
    for i in 0..words {
        unsafe {
            (start as *mut usize)
                .add(i)
                .write_volatile(black_box(PAINT))
        };
    }
}

#[inline(always)]
fn read(start: usize, word: usize) -> usize {
    unsafe { (start as *const usize).add(word).read_volatile() }
}
