//! Spin without a torque: how far an angle is, after ten million steps, from where the spin that the body
//! holds would lead it. The reference is exact: whole numbers, modulo turns.
//!
//! ```text
//! s n a/b  modulo 1        s = num / den turns/s as it is held, a step of a/b s
//! ```
//!
//! `spin/methods.rs` has the remainder of a spin under each method, `spin/pair.rs` the same for a cosine and a
//! sine that are turned by a small angle in each step.

#[path = "spin/methods.rs"]
mod methods;
#[path = "spin/pair.rs"]
mod pair;
use crate::support;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::rigid::Centre;
use fixstep::{
    Angular, Body, Carried, DyadicStep, Point, Ratio, Rigid, Scalar, Step, TimeStep, Vec2,
};
use support::*;

const STEPS: u64 = long(10_000_000);

/// Turns a second, one of them backwards.
const SPINS: [f64; 3] = [0.1, -1.0, 10.0];

/// Half a unit of an angle of 32 bits.
const HALF: f64 = 0.5 / 4_294_967_296.0;

const TURN: f64 = 18_446_744_073_709_551_616.0;

/// How far a point on the circle of an angle is from the circle, `cos² + sin² - 1` in units of 2^-30.
trait OnCircle: Angular {
    fn off_circle(angle: Self::Turns) -> f64;

    /// The square of the length is off by `2 (cos, sin) · e` for errors e: where none is above 1.4 units, and the
    /// unit tests of `circle.rs` ask for less, by `2 sqrt(2) 1.4 = 4`. As an `f32` each is rounded, by 2^-25 = 32
    /// units more: `2 sqrt(2) (32 + 1.4) = 95`.
    const BOUND: f64;
}

macro_rules! on_circle {
    ($($scalar:ty, $one:expr, $bound:expr;)*) => {
        $(impl OnCircle for $scalar {
            fn off_circle(angle: u32) -> f64 {
                let [cos, sin] = Self::circle(angle).map(|unit| unit as f64 / $one);
                // Squares of 30 bits have 60: as f64 they are off by 2^-53, a 2^-23 of a unit.
                (cos * cos + sin * sin - 1.0).abs() * 1_073_741_824.0
            }

            const BOUND: f64 = $bound;
        })*
    };
}

on_circle! {
    I16F16, 1_073_741_824.0, 4.0;
    I8F24, 1_073_741_824.0, 4.0;
    f32, 1.0, 95.0;
}

/// A body of 1 kg and 1 kg m² that turns about the origin.
fn spinning<C: Centre + From<Point<C::S>>>(spin: f64) -> Rigid<C> {
    let centre = Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap();
    let body = Rigid::new(C::from(centre), 1).unwrap();
    body.with_spin(ratio(spin)).unwrap()
}

/// All bits of the angle of a 32-bit body, in units of 2^-64 turns: what a body that carries holds beyond what
/// is seen stands before the last word of its state, in two halves.
fn all_bits<C: Centre>(body: &Rigid<C>) -> u64 {
    let mut words = Vec::new();
    body.write_state(&mut |word| words.push(word));
    match words[..] {
        [_, _, _, _, seen, _] => seen << 32,
        [.., high, low, _] => high << 32 | low,
        _ => unreachable!(),
    }
}

/// The exact angle after `steps`, in units of 2^-64 turns, rounded down.
fn flow(spin: f64, seconds: Ratio, steps: u64) -> u64 {
    let spin = ratio(spin);
    let whole = spin.den() as i128 * seconds.den() as i128;
    let part = spin.num() as i128 * seconds.num() as i128 % whole * steps as i128;
    // In two halves, as `whole` may have 80 bits.
    let rest = part.rem_euclid(whole) << 32;
    ((rest / whole) as u64) << 32 | (((rest % whole) << 32) / whole) as u64
}

/// Turns from `exact` to `angle`, -1/2 to 1/2.
fn apart(angle: u64, exact: u64) -> f64 {
    angle.wrapping_sub(exact) as i64 as f64 / TURN
}

/// What a run may be off by: in each step, and by a part of the turns that were made.
#[derive(Clone, Copy)]
struct Allowed {
    a_step: f64,
    a_turn: f64,
}

/// Ten million steps at each spin. Every thousandth: the angle within what is allowed, and its
/// cosine and sine on the circle.
fn check<C: Centre<S: OnCircle + Format> + From<Point<C::S>>>(
    name: &str,
    step: &impl TimeStep<C::S>,
    allowed: impl Fn(f64) -> Allowed,
) {
    let mut off_circle = 0.0;
    for given in SPINS {
        let mut body = spinning::<C>(given);
        let spin = body.spin().to_f64();
        let Allowed { a_step, a_turn } = allowed(spin);
        let (mut error, mut bound, mut turns) = (0.0, 0.0, 0.0);
        for thousand in 1..=STEPS / 1000 {
            // A drift, but for what it does to a centre at rest.
            (0..1000).for_each(|_| body.drift_angle(step));
            let steps = 1000 * thousand;
            turns = (steps as f64 * spin * step.seconds().to_f64()).abs();
            error = apart(all_bits(&body), flow(spin, step.seconds(), steps));
            // The reference is rounded down: one unit of its own.
            bound = a_step * steps as f64 + a_turn * turns + 1.0 / TURN;
            assert!(error.abs() <= bound, "{name}: {error:e} after {steps}");
            let off = C::S::off_circle(body.angle().count());
            off_circle = maximum(&[off_circle, off]);
        }
        println!(
            "{:<7} {name:<15} {given:>5} turns/s {turns:>9.0} turns, off by {error:9.2e}, \
             {:8.1e} of them (bound {bound:8.2e})",
            C::S::name(),
            error.abs() / turns,
        );
    }
    assert!(off_circle <= C::S::BOUND, "{name}: {off_circle}");
    println!(
        "{:<23} off the circle by {off_circle:.2} units of 2^-30 at most",
        ""
    );
}

/// Nothing is lost.
fn exact(_: f64) -> Allowed {
    Allowed {
        a_step: 0.0,
        a_turn: 0.0,
    }
}

/// `1/60 = m / 2^36` with `m = 1145324612.27`, rounded: 0.27 of a unit, 2.33e-10 of it.
const SIXTIETH: f64 = 2.4e-10;

/// A body that carries has all bits of the product: what is left is that of `h`.
fn carried(_: f64) -> Allowed {
    Allowed {
        a_step: 0.0,
        a_turn: SIXTIETH,
    }
}

/// Half a unit of the angle in each step, and a fraction that is made odd, 2^-32 of a unit for each unit of spin.
fn plain<S: Format>(spin: f64) -> Allowed {
    Allowed {
        a_step: HALF * (1.0 + 2.0 * spin.abs() / S::unit(0.0) / 4_294_967_296.0),
        a_turn: SIXTIETH,
    }
}

#[test]
fn at_dyadic_rates_a_carried_angle_is_exact() {
    let (fast, frame) = (
        DyadicStep::<_, 1, 6>::new(),
        DyadicStep::<_, 4389, 18>::new(),
    );
    check::<Carried<I16F16>>("Carried 1/64", &fast.unwrap(), exact);
    check::<Carried<I16F16>>("Carried GBA", &frame.unwrap(), exact);
    let (fast, frame) = (
        DyadicStep::<_, 1, 6>::new(),
        DyadicStep::<_, 4389, 18>::new(),
    );
    check::<Carried<I8F24>>("Carried 1/64", &fast.unwrap(), exact);
    check::<Carried<I8F24>>("Carried GBA", &frame.unwrap(), exact);
}

#[test]
fn at_60_hz_a_carried_angle_is_off_by_what_h_is() {
    check::<Carried<I16F16>>("Carried 60 Hz", &Step::hz(60).unwrap(), carried);
    check::<Carried<I8F24>>("Carried 60 Hz", &Step::hz(60).unwrap(), carried);
}

/// An angle of 32 bits holds `2^-16 / 64` of a turn, and rounds the rest.
#[test]
fn a_plain_angle_is_off_by_half_a_unit_a_step() {
    let step = DyadicStep::new().unwrap();
    check::<Point<I16F16>>("Point 1/64", &step as &DyadicStep<_, 1, 6>, exact);
    check::<Point<I16F16>>("Point 60 Hz", &Step::hz(60).unwrap(), plain::<I16F16>);
    check::<Point<I8F24>>("Point 60 Hz", &Step::hz(60).unwrap(), plain::<I8F24>);
}

/// A product of floats has 24 bits: `h` is rounded by at most 2^-24 of itself, and so is `h s`. Of 1/60 it is
/// 2^-25.4: `2^29 / 60 = 8947848.53`, rounded up by 0.47, 5.3e-8 of it. The angle holds all of the product that
/// is above its own half unit.
#[test]
fn f32_is_off_by_a_part_of_the_turns() {
    let product = 0.5 * f32::EPSILON as f64;
    let allowed = |a_step| {
        move |_: f64| Allowed {
            a_step,
            a_turn: product + 5.3e-8,
        }
    };
    check::<Point<f32>>("Point 60 Hz", &Step::hz(60).unwrap(), allowed(HALF));
    check::<Carried<f32>>("Carried 60 Hz", &Step::hz(60).unwrap(), allowed(0.0));
    let step = DyadicStep::new().unwrap();
    check::<Carried<f32>>("Carried 1/64", &step as &DyadicStep<_, 1, 6>, exact);
}
