//! Time is counted, and a step is as long as it says.

#[path = "time/day.rs"]
mod day;

use std::cell::RefCell;

use fixstep::fixed::types::{I8F24, I16F16, I20F12, I32F32};
use fixstep::scalar::Factor;
use fixstep::time::Now;
use fixstep::{
    ConstantAcceleration, DyadicStep, Euler, Gravity, Method, PerBody, Point, Ratio, Scalar,
    SemiImplicitEuler, Step, Time, TimeStep, Vec2, Verlet, World, dec, vec2,
};

fn start(step: &Step<I16F16>, tick: u64) -> Time {
    Now::start(step, tick).time::<I16F16>()
}

fn middle(step: &Step<I16F16>, tick: u64) -> Time {
    Now::middle(step, tick).time::<I16F16>()
}

fn bits(time: Time) -> i32 {
    time.seconds::<I16F16>().to_bits()
}

/// `num / den`, nearest, ties away.
fn rounded(num: i128, den: i128) -> i128 {
    (2 * num.abs() + den) / (2 * den) * num.signum()
}

#[test]
fn seconds_are_rounded_once_at_every_tick() {
    let step = Step::hz(60).unwrap();
    for tick in (0..100).chain([3_599, 36_000, 1_000_001, 1_966_019]) {
        let t = i128::from(tick);
        assert_eq!(i128::from(bits(start(&step, tick))), rounded(t << 16, 60));
        assert_eq!(
            i128::from(bits(middle(&step, tick))),
            rounded((2 * t + 1) << 16, 120)
        );
    }
}

#[test]
fn seconds_saturate_at_the_end_of_the_range() {
    let step = Step::hz(60).unwrap();
    assert!(start(&step, 32_767 * 60).seconds::<I16F16>() == 32_767);
    assert_eq!(start(&step, 32_768 * 60).seconds::<I16F16>(), I16F16::MAX);
    assert_eq!(start(&step, 1 << 50).seconds::<I16F16>(), I16F16::MAX);
    assert_eq!(start(&step, 128 * 60).seconds::<I8F24>(), I8F24::MAX);
    assert_eq!(start(&step, 60 << 20).seconds::<f64>(), (1 << 20) as f64);
}

#[test]
fn the_last_ticks_stand_still_without_panic() {
    let step = Step::hz(60).unwrap();
    for tick in [u64::MAX, u64::MAX - 1, u64::MAX / 2 + 1] {
        for time in [start(&step, tick), middle(&step, tick)] {
            assert_eq!((time.half_ticks(), time.elapsed()), (u64::MAX, None));
            assert_eq!(time.seconds::<I16F16>(), I16F16::MAX);
        }
    }
    assert_eq!(start(&step, u64::MAX / 2).half_ticks(), u64::MAX - 1);
    assert_eq!(middle(&step, u64::MAX / 2).half_ticks(), u64::MAX);
}

fn steps_at_the_end_of_time<M: Method<Point<I16F16>, 1>>(mut method: M) {
    let mut world = World::<_, 1>::new();
    let rest = Point::new(vec2(0, 0).unwrap(), vec2(0, 0).unwrap(), 1).unwrap();
    let id = world.add(rest).unwrap();
    let mut forces = (
        Gravity::new(vec2(0, -64).unwrap()),
        PerBody(|time: Time, _: &_| Vec2::new(time.seconds(), I16F16::ZERO)),
    );
    let mut bodies = [rest];
    for tick in [u64::MAX - 1, u64::MAX, u64::MAX] {
        method.step(
            &[id],
            &mut bodies,
            &mut forces,
            &Step::hz(64).unwrap(),
            tick,
        );
    }
    let velocity = fixstep::Body::velocity(&bodies[0]);
    assert!(velocity.y == -3 && velocity.x > 1535, "{velocity:?}");
}

#[test]
fn every_method_steps_at_the_end_of_time() {
    steps_at_the_end_of_time(Verlet);
    steps_at_the_end_of_time(SemiImplicitEuler);
    steps_at_the_end_of_time(Euler::<_, 1>::new());
    steps_at_the_end_of_time(ConstantAcceleration::<_, 1>::new());
}

#[test]
fn elapsed_is_exact() {
    let step = Step::hz(dec!(59.7275)).unwrap();
    for tick in [0, 1, 12_345, 1 << 30] {
        let elapsed = start(&step, tick).elapsed().unwrap();
        let (num, den) = (i128::from(elapsed.num()), i128::from(elapsed.den()));
        assert_eq!(num * 597_275, i128::from(tick) * 10_000 * den);
    }
}

// 1/60 has 53 bits in an `f64` and 17 digits as a decimal; 100 s are no long time.
#[test]
fn a_length_with_many_digits_keeps_time_too() {
    for seconds in [
        Ratio::from_f64(1.0 / 60.0).unwrap(),
        dec!(0.01666666666666667),
    ] {
        let step = Step::<I16F16>::from_seconds(seconds).unwrap();
        for tick in [60, 600, 6_000, 600_000] {
            let seconds = start(&step, tick).seconds::<I16F16>().to_num::<f64>();
            assert!(
                (seconds - tick as f64 / 60.0).abs() < 1e-4,
                "{seconds} s after {tick} ticks"
            );
        }
    }
}

/// `h v` of the largest v, and of the smaller ones, is off by half a unit and 9.4e-10 of itself.
fn step_is_as_long_as_it_says<S: Scalar>(unit: f64) {
    for rate in [
        dec!(4.1),
        dec!(10),
        dec!(50),
        dec!(59.7275),
        dec!(60),
        dec!(1000),
        dec!(44100),
    ] {
        let step = Step::<S>::hz(rate).unwrap();
        for value in [S::MAX, S::MAX.negated(), S::ratio(dec!(1.2345)).unwrap()] {
            let exact = value.to_f64() / rate.to_f64();
            let allowed = |exact: f64| 0.5 * unit + exact.abs() * 9.4e-10;
            assert!((step.times(value).to_f64() - exact).abs() <= allowed(exact));
            let half = exact / 2.0;
            assert!((step.half_times(value).to_f64() - half).abs() <= allowed(half));
        }
        let coef = step.coef().to_f64() * rate.to_f64();
        assert!((coef - 1.0).abs() < 2.0_f64.powi(-31) + 1e-15);
        assert_eq!(
            step.seconds(),
            Ratio::new(rate.den() as i64, rate.num() as u64).unwrap()
        );
    }
}

#[test]
fn steps_are_as_long_as_they_say() {
    step_is_as_long_as_it_says::<I8F24>(2.0_f64.powi(-24));
    step_is_as_long_as_it_says::<I16F16>(2.0_f64.powi(-16));
    step_is_as_long_as_it_says::<I20F12>(2.0_f64.powi(-12));
    step_is_as_long_as_it_says::<I32F32>(2.0_f64.powi(-32));
}

// Odd mantissas from 2^30 lie two units apart, so their middle is within one of any h between.
#[test]
fn two_spans_are_within_2_to_the_minus_30_on_the_mean() {
    for hz in (5..5000).chain([7_919, 59_727, 1_000_003]) {
        let seconds = Ratio::new(1, hz).unwrap();
        let spans = I16F16::spans(seconds).unwrap();
        let [below, above] = spans.map(Factor::<I16F16>::to_f64);
        let h = seconds.to_f64();
        assert!(below <= h && h <= above, "{hz} Hz: {below}, {above}");
        assert!(
            ((below + above) / (2.0 * h) - 1.0).abs() <= 2.0_f64.powi(-30),
            "{hz} Hz"
        );
    }
}

fn dyadic_is_exact<const NUM: u32, const SHIFT: u32>() {
    let step = DyadicStep::<I16F16, NUM, SHIFT>::new().unwrap();
    let limited = |raw: i128| raw.clamp(-i128::from(i32::MAX), i32::MAX.into());
    for raw in [
        0,
        1,
        -1,
        31,
        32,
        33,
        -32,
        65_536,
        123_456_789,
        -i32::MAX,
        i32::MAX,
        i32::MAX - 1,
    ] {
        let (value, product) = (I16F16::from_bits(raw), i128::from(raw) * i128::from(NUM));
        let (whole, half) = (
            step.times(value).to_bits(),
            step.half_times(value).to_bits(),
        );
        assert_eq!(i128::from(whole), limited(rounded(product, 1 << SHIFT)));
        assert_eq!(i128::from(half), limited(rounded(product, 2 << SHIFT)));
    }
    let coef_seconds = Factor::<I16F16>::to_f64(step.coef());
    let seconds = f64::from(NUM) / 2.0_f64.powi(SHIFT as i32);
    assert_eq!((coef_seconds, step.seconds().to_f64()), (seconds, seconds));
}

#[test]
fn dyadic_steps_are_exact() {
    dyadic_is_exact::<1, 1>();
    dyadic_is_exact::<1, 6>();
    dyadic_is_exact::<1, 29>();
    dyadic_is_exact::<3, 8>();
    dyadic_is_exact::<4389, 18>();
    dyadic_is_exact::<{ 1 << 24 }, 29>();
    dyadic_is_exact::<5, 1>();
}

/// The half ticks at which a force is asked in three steps.
fn instants(mut method: impl Method<Point<f32>, 1>) -> Vec<u64> {
    let seen = RefCell::new(Vec::new());
    let mut force = PerBody(|time: Time, _: &Point<f32>| {
        seen.borrow_mut().push(time.half_ticks());
        Vec2::ZERO
    });
    let mut world = World::<_, 1>::new();
    world
        .add(Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap())
        .unwrap();
    (0..3).for_each(|_| world.step(&mut method, &mut force, &Step::hz(60).unwrap()));
    assert_eq!(world.tick(), 3);
    seen.take()
}

#[test]
fn forces_are_taken_at_the_start_or_in_the_middle() {
    assert_eq!(instants(Verlet), [1, 3, 5]);
    assert_eq!(instants(SemiImplicitEuler), [0, 2, 4]);
    assert_eq!(instants(Euler::<_, 1>::new()), [0, 2, 4]);
    assert_eq!(instants(ConstantAcceleration::<_, 1>::new()), [0, 2, 4]);
}
