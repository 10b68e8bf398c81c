//! Rows of the table: `scene scalar method hash insn cycles worst ram stack`, tab-separated. What the
//! linker knows (flash, symbols) `run` adds.

use core::hint::black_box;

use fixstep::{Body, Error, Force, Method, TimeStep};

use crate::board::{Board, Counts};
use crate::print::Printer;
use crate::scenes::{Meter, Name, Start};
use crate::stack;

/// Steps that are counted together, after as many that are not. Those behind are counted each.
const STEPS: u32 = 60;

/// Prices scenes on a board, and prints a row of each.
pub struct Priced<'a, B> {
    board: &'a B,
    /// What reading the counter counts.
    reading: u32,
    /// What the steps take without a force, and what no work takes.
    without: u32,
}

/// What is known of a scene.
#[derive(Default)]
struct Figures {
    /// Tenths for a body and step.
    each: Option<u64>,
    worst: Option<u32>,
    ram: Option<usize>,
    stack: Option<usize>,
}

impl<'a, B: Board> Priced<'a, B> {
    /// Prints what a loop of known length counts, for `run` to check.
    pub fn new(board: &'a B) -> Priced<'a, B> {
        let mut priced = Priced {
            board,
            reading: 0,
            without: 0,
        };
        priced.reading = priced.counted(|| ());
        let out = Printer(board);
        for rounds in [0, 1_000, 100_000] {
            let counted = priced.spun(rounds);
            out.text("calibration");
            for figure in [rounds, counted, B::ROUND] {
                out.text("\t");
                out.number(figure as u64, 10);
            }
            out.text("\n");
        }
        priced
    }

    #[inline(always)]
    fn counted(&self, work: impl FnOnce()) -> u32 {
        let start = self.board.ticks();
        work();
        let ticks = self.board.ticks().wrapping_sub(start);
        self.board.counts(ticks).saturating_sub(self.reading)
    }

    // Not inlined: nothing of the caller's may come between the two readings.
    #[inline(never)]
    fn spun(&self, rounds: u32) -> u32 {
        self.counted(|| self.board.spin(rounds))
    }

    /// Tenths of a count for each unit, less what is there without a force.
    fn each(&mut self, name: Name, counted: u32, units: u32) -> u64 {
        if let [_, "no force" | "nothing", _] = name.scene {
            self.without = counted;
        }
        let priced_alone = matches!(name.scene, ["force" | "beside", _, _]);
        let without = if priced_alone { self.without } else { 0 };
        counted.saturating_sub(without) as u64 * 10 / units.max(1) as u64
    }

    fn begin(&self, name: Name) -> Printer<'a, B> {
        let out = Printer(self.board);
        let [first, rest @ ..] = name.scene;
        out.text(first);
        for word in rest.into_iter().filter(|word| !word.is_empty()) {
            out.text(" ");
            out.text(word);
        }
        for word in [name.scalar, name.method] {
            out.text("\t");
            out.text(word);
        }
        out.text("\t");
        out
    }

    fn end(&self, figures: Figures) {
        let Figures {
            each,
            worst,
            ram,
            stack,
        } = figures;
        let out = Printer(self.board);
        for counts in [Counts::Instructions, Counts::Cycles] {
            match each {
                Some(tenths) if B::COUNTS == counts => {
                    out.text("\t");
                    out.tenths(tenths);
                }
                _ => out.text("\t-"),
            }
        }
        let worst = worst.filter(|_| B::COUNTS != Counts::Nothing);
        for figure in [worst.map(|worst| worst as usize), ram, stack] {
            out.text("\t");
            match figure {
                Some(figure) => out.number(figure as u64, 10),
                None => out.text("-"),
            }
        }
        out.text("\n");
    }
}

impl<T: Board> Meter for Priced<'_, T> {
    fn run<B, M, H, F, const N: usize>(
        &mut self,
        name: Name,
        units: u32,
        start: Start<'_, B, M, H, F, N>,
    ) where
        B: Body,
        M: Method<B, N>,
        H: TimeStep<B::S>,
        F: Force<B>,
    {
        let ram = size_of_val(start.world)
            + size_of_val(start.method)
            + size_of_val(start.step)
            + size_of_val(start.forces);
        let mut start = Start {
            step: black_box(start.step),
            world: black_box(start.world),
            ..start
        };
        let out = self.begin(name);
        let mut each = None;
        let mut worst = 0;
        // The first step is the deepest: it makes what is kept from then on.
        let deepest = stack::used(self.board, || worst = self.counted(|| start.run(1)));
        for (i, &ticks) in name.ticks.iter().enumerate() {
            if i == 2 {
                let counted = self.counted(|| start.run(STEPS));
                each = Some(self.each(name, counted, units * STEPS));
                for _ in 2 * STEPS..ticks {
                    worst = worst.max(self.counted(|| start.run(1)));
                }
            }
            let done = start.world.tick() as u32;
            start.run(ticks.saturating_sub(done));
            out.text(if i == 0 { "" } else { " " });
            out.number(ticks as u64, 10);
            out.text(":");
            out.number(start.world.state_hash(), 16);
        }
        self.end(Figures {
            each,
            worst: Some(worst),
            ram: Some(ram),
            stack: deepest,
        });
    }

    fn work<R>(
        &mut self,
        name: Name,
        units: u32,
        work: impl FnOnce() -> R,
        hash: impl FnOnce(R) -> u64,
    ) {
        let mut made = None;
        let counted = self.counted(|| made = Some(black_box(work())));
        self.begin(name).number(made.map_or(0, hash), 16);
        let each = Some(self.each(name, counted, units));
        self.end(Figures {
            each,
            ..Figures::default()
        });
    }

    fn whole(&mut self, scene: &'static str, hash: Result<u64, Error>) {
        let name = Name {
            scene: [scene, "", ""],
            scalar: "all",
            method: "all",
            ticks: &[],
        };
        let out = self.begin(name);
        match hash {
            Ok(hash) => out.number(hash, 16),
            Err(_) => out.text("refused"),
        }
        self.end(Figures::default());
    }
}
