//! Two balls fall through syrup, at 60 steps a second whatever the loop takes.
#![no_std]
#![no_main]

use core::convert::Infallible;

use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};
use cortex_m_rt::entry;
use fixstep::fixed::types::I16F16;
use fixstep::{Accumulator, Error, GravityY, LinearDrag, Point, Step, Verlet, World, dec, vec2};
use panic_halt as _; // no code of fixstep panics: this one is for your own

/// Clock of the core, here an STM32F0 after reset. Yours, once you have set it up.
const CLOCK_HZ: u32 = 8_000_000;
/// SysTick counts down 24 bits: a turn of the loop may take 2 s at 8 MHz.
const SYSTICK: u32 = 0x00ff_ffff;

#[entry]
fn main() -> ! {
    if let Some(peripherals) = Peripherals::take() {
        let Err(_refused) = run(peripherals.SYST); // a constant above is out of range: log it
    }
    loop {
        cortex_m::asm::wfi();
    }
}

fn run(mut systick: SYST) -> Result<Infallible, Error> {
    systick.set_clock_source(SystClkSource::Core);
    systick.set_reload(SYSTICK);
    systick.clear_current();
    systick.enable_counter();

    let mut world = World::<Point<I16F16>, 8>::new();
    let light = world.add(Point::new(vec2(0, 10)?, vec2(2, 0)?, dec!(0.2))?)?;
    world.add(Point::new(vec2(0, 10)?, vec2(1, 0)?, 1)?)?;
    let mut forces = (GravityY::new(dec!(-9.81))?, LinearDrag::new(dec!(0.5))?);
    let step = Step::hz(60)?;
    // Counts of the clock itself: no rounding to microseconds, so that no clock drifts.
    let mut clock = Accumulator::new(CLOCK_HZ, step.seconds(), 4)?;

    let mut before = SYST::get_current();
    loop {
        let now = SYST::get_current();
        let due = clock.advance((before.wrapping_sub(now) & SYSTICK).into());
        before = now;
        for _ in 0..due.steps {
            world.step(&mut Verlet, &mut forces, &step);
        }
        show(world.get(light)?);
    }
}

/// Yours: a display, a motor, a wire. The board sees raw bits, 1/65536 m each.
fn show(ball: &Point<I16F16>) {
    core::hint::black_box(ball.position().y.to_bits());
}
