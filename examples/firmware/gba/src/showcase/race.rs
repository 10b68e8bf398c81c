//! The two worlds, what the buttons choose, and what a frame costs.

use board::{Long, This};
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Accumulator, Error, Ratio, Step, TimeStep};
use measure::Board;

use crate::scene::{Positions, Scene, Shown};

/// Cycles of a second and of a picture.
const SECOND: u32 = 1 << 24;
const PICTURE: u32 = 280_896;
/// Pictures over which costs are taken together, as a power of two.
const WINDOW: u32 = 5;

/// Steps that a picture may make: one that comes late must not make the next one late.
const MOST: u32 = 2;

/// Steps as the screen says them and in units of 2^-31 s, as exact as the console's multiply takes them.
const RATES: [(&str, u32); 4] = [
    ("1/30 s", (1 << 31) / 30),
    ("1/60 s", (1 << 31) / 60),
    ("4389/2^18 s", Long::<f32>::PICTURE),
    ("4389/2^19 s", Long::<f32>::PICTURE / 2),
];

/// Cycles of a window of pictures.
#[derive(Clone, Copy, Default)]
pub struct Cost {
    now: u32,
    last: u32,
}

impl Cost {
    /// Of the mean picture.
    pub fn cycles(self) -> u32 {
        self.last >> WINDOW
    }

    /// Of the time that a picture has.
    pub fn tenths_of_percent(self) -> u32 {
        self.cycles() * 1000 / PICTURE
    }
}

/// A world with its step.
struct Side<S: Shown, H> {
    scene: Scene<S>,
    step: H,
}

/// The world in fixed point, in the type that was chosen.
enum Fixed {
    I16F16(Side<I16F16, Long<I16F16>>),
    I8F24(Side<I8F24, Long<I8F24>>),
}

/// Both worlds.
pub struct Race {
    fixed: Fixed,
    float: Side<f32, Step<f32>>,
    /// Where the bodies are.
    pub fixed_at: Positions,
    pub float_at: Positions,
    clock: Accumulator,
    rate: usize,
    pub cost_of_fixed: Cost,
    pub cost_of_float: Cost,
    /// Pictures drawn in this window, pictures that the screen has shown meanwhile, and the same of
    /// the window before.
    drawn: u32,
    passed: u32,
    last_passed: u32,
}

/// As ARM code in fast RAM, with all that is inlined; floats have the functions that they call there too.
#[inline(never)]
#[instruction_set(arm::a32)]
#[unsafe(link_section = ".iwram.fast")]
fn fast<S: Shown, H: TimeStep<S>>(scene: &mut Scene<S>, step: &H) {
    scene.step(step);
}

fn halves(rate: usize) -> u32 {
    RATES
        .get(rate)
        .map_or(Long::<f32>::PICTURE, |&(_, halves)| halves)
}

impl<S: Shown> Side<S, Long<S>> {
    fn new(rate: usize) -> Result<Self, Error> {
        let (scene, step) = (Scene::new()?, Long::new(halves(rate))?);
        Ok(Side { scene, step })
    }
}

impl Side<f32, Step<f32>> {
    fn new(rate: usize) -> Result<Self, Error> {
        let (scene, step) = (Scene::new()?, step(rate)?);
        Ok(Side { scene, step })
    }
}

/// The same length for floats.
fn step(rate: usize) -> Result<Step<f32>, Error> {
    Step::from_seconds(Ratio::new(halves(rate) as i64, 1 << 31)?)
}

impl Race {
    /// At its start, in the first type, at the rate of the screen.
    pub fn new() -> Result<Race, Error> {
        let rate = 2;
        let float = Side::<f32, Step<_>>::new(rate)?;
        let at = float.scene.positions();
        Ok(Race {
            fixed_at: at,
            float_at: at,
            fixed: Fixed::I16F16(Side::<_, Long<_>>::new(rate)?),
            clock: Accumulator::new(SECOND, float.step.seconds(), MOST)?,
            float,
            rate,
            cost_of_fixed: Cost::default(),
            cost_of_float: Cost::default(),
            drawn: 0,
            passed: 0,
            last_passed: 1 << WINDOW,
        })
    }

    /// Another type, which starts anew, as `again` does; another rate, with which the race goes on.
    /// Whether it starts anew.
    pub fn choose(&mut self, other_type: bool, faster: i32, again: bool) -> Result<bool, Error> {
        if faster != 0 {
            let rate = self.rate as i32 + faster;
            self.rate = rate.rem_euclid(RATES.len() as i32) as usize;
            self.float.step = step(self.rate)?;
            match &mut self.fixed {
                Fixed::I16F16(side) => side.step = Long::new(halves(self.rate))?,
                Fixed::I8F24(side) => side.step = Long::new(halves(self.rate))?,
            }
            self.clock = Accumulator::new(SECOND, self.float.step.seconds(), MOST)?;
        }
        if other_type || again {
            self.float = Side::<f32, Step<_>>::new(self.rate)?;
            self.fixed = match (&self.fixed, other_type) {
                (Fixed::I16F16(_), false) | (Fixed::I8F24(_), true) => {
                    Fixed::I16F16(Side::<_, Long<_>>::new(self.rate)?)
                }
                _ => Fixed::I8F24(Side::<_, Long<_>>::new(self.rate)?),
            };
            self.clock.reset();
        }
        Ok(other_type || again)
    }

    /// Makes the steps that are due after so many pictures of the screen.
    pub fn advance(&mut self, pictures: u32) {
        let due = self.clock.advance(pictures as u64 * PICTURE as u64);
        let start = This.ticks();
        for _ in 0..due.steps {
            match &mut self.fixed {
                Fixed::I16F16(side) => fast(&mut side.scene, &side.step),
                Fixed::I8F24(side) => fast(&mut side.scene, &side.step),
            }
        }
        let middle = This.ticks();
        for _ in 0..due.steps {
            fast(&mut self.float.scene, &self.float.step);
        }
        let end = This.ticks();
        self.look();
        self.cost_of_fixed.now += middle.wrapping_sub(start);
        self.cost_of_float.now += end.wrapping_sub(middle);
        self.passed += pictures;
        self.drawn += 1;
        if self.drawn == 1 << WINDOW {
            for cost in [&mut self.cost_of_fixed, &mut self.cost_of_float] {
                *cost = Cost {
                    now: 0,
                    last: cost.now,
                };
            }
            (self.last_passed, self.passed, self.drawn) = (self.passed, 0, 0);
        }
    }

    fn look(&mut self) {
        self.float_at = self.float.scene.positions();
        self.fixed_at = match &self.fixed {
            Fixed::I16F16(side) => side.scene.positions(),
            Fixed::I8F24(side) => side.scene.positions(),
        };
    }

    /// How far two bodies of one name have parted, at most, in units of 2^-16 m.
    pub fn apart(&self) -> u32 {
        let pairs = self.fixed_at.iter().zip(&self.float_at);
        pairs
            .map(|(&a, &b)| (a - b).length().to_bits() as u32)
            .fold(0, u32::max)
    }

    pub fn scalar(&self) -> &'static str {
        match &self.fixed {
            Fixed::I16F16(_) => "I16F16",
            Fixed::I8F24(_) => "I8F24",
        }
    }

    pub fn rate(&self) -> &'static str {
        RATES.get(self.rate).map_or("", |&(name, _)| name)
    }

    /// In hundredths: 59.73 where none is missed.
    pub fn pictures_per_second(&self) -> u32 {
        let shown = PICTURE as u64 * self.last_passed.max(1) as u64;
        ((((SECOND as u64 * 100) << WINDOW) + shown / 2) / shown) as u32
    }
}
