//! A clock, a world and a picture together: a steady body at irregular frames lies on its line, one
//! step behind.
//!
//! ```text
//! k steps made, a part α left:  t = (k + α) h,  drawn at (k - 1 + α) h = t - h
//! ```

use fixstep::{Accumulator, DyadicStep, TimeStep};

use super::*;

const MICROSECONDS: u32 = 1_000_000;

/// Frames of 3 to 32 ms, without a pattern that a step could follow.
fn frame(i: usize) -> u64 {
    3_000 + (29_000.0 * spread(7 * i)) as u64
}

/// Two seconds of frames; `see` gets the time in microseconds and steps, and the pictures.
fn show<S: Format, H: TimeStep<S>>(
    scheme: Scheme,
    step: &H,
    start: Scene<S>,
    mut see: impl FnMut(u64, u64, Vec<(BodyId, Vec2<S>)>),
) {
    let mut clock = Accumulator::new(MICROSECONDS, step.seconds(), 4).unwrap();
    let (mut before, mut world, mut method) = (start.clone(), start, scheme.method());
    let (mut elapsed, mut frames) = (0, 0);
    while elapsed < 2_000_000 {
        elapsed += frame(frames);
        frames += 1;
        let due = clock.advance(frame(frames - 1));
        assert_eq!(due.dropped, 0);
        for _ in 0..due.steps {
            before = world.clone();
            world.step(&mut method, &mut (), step);
        }
        if world.tick() > 0 {
            let between = Between::new(clock.fraction(), step).unwrap();
            let picture = picture(scheme, [&before, &world], &between);
            see(elapsed, world.tick(), picture);
        }
    }
    assert!(frames > 100);
}

/// Errors of every frame and axis against `x0 + v (t - h)`, as parts of `bound`, in units, of a
/// body and the number of steps.
fn one_step_behind<S: Format, H: TimeStep<S>>(
    scheme: Scheme,
    step: &H,
    start: Scene<S>,
    bound: impl Fn(f64, f64, u64) -> f64,
) -> (Vec<f64>, f64) {
    let (mut ratios, mut worst) = (Vec::new(), 0.0);
    let h = step.seconds();
    // t - h = (elapsed den - 10^6 num) / (10^6 den)
    let (num, den) = (i128::from(h.num()), i128::from(h.den()));
    let whole = i128::from(MICROSECONDS) * den;
    let bodies = start.clone();
    show(scheme, step, start, |elapsed, tick, picture| {
        let late = i128::from(elapsed) * den - i128::from(MICROSECONDS) * num;
        for (body, (id, at)) in bodies.bodies().iter().zip(picture) {
            assert_eq!(bodies.get(id), Ok(body));
            let (x0, v) = (body.position().array(), body.velocity().array());
            for ((x0, v), at) in x0.into_iter().zip(v).zip(at.array()) {
                let (x0, v) = (x0.to_f64(), v.to_f64());
                let exact = scaled(x0) * whole + late * scaled(v);
                // Positions grow by 24 m at most.
                let reach = x0.abs() + 2.0 * v.abs();
                let error = off(at, exact, whole, reach);
                ratios.push(error / bound(v.abs(), reach, tick));
                worst = maximum(&[worst, error]);
            }
        }
    });
    (ratios, worst)
}

/// Speeds in sixteenths of a metre per second: h v and its half at 1/64 s are whole units of every
/// type, and so are all positions.
fn on_the_grid<S: Format>() -> Scene<S> {
    let grid = |value: f64| (16.0 * value).round() / 16.0;
    let pair = |f: &dyn Fn(usize) -> f64, i| [grid(f(i)), grid(f(i + 16))];
    let place = |i: usize| 40.0 + 50.0 * spread(i);
    let speed = |i: usize| 24.0 * spread(i + 48) - 12.0;
    world(std::array::from_fn(|i| {
        point(pair(&place, i), pair(&speed, i), 1.0)
    }))
}

// Only the picture rounds: half a unit, and the part's COEFFICIENT of the way of a step.
fn exact_steps_round_once<S: Format>() {
    let step = DyadicStep::<S, 1, 6>::new().unwrap();
    for scheme in SCHEMES {
        let bound = |v, reach, _| 0.5 + S::COEFFICIENT * v / 64.0 / S::unit(reach);
        let (ratios, worst) = one_step_behind(scheme, &step, on_the_grid::<S>(), bound);
        let what = format!("{} {scheme:?} 1/64 s, of the bound", S::name());
        within(1.0, &what, &ratios);
        println!("{worst:.3} units at most");
    }
}

#[test]
fn with_exact_steps_a_picture_is_half_a_unit_off_for_ever() {
    exact_steps_round_once::<f32>();
    exact_steps_round_once::<I16F16>();
    exact_steps_round_once::<I12F20>();
    exact_steps_round_once::<I8F24>();
    exact_steps_round_once::<I20F12>();
}

// Every drift may be half a unit off the same way, as the velocity is the same. h is off by a
// COEFFICIENT of the whole way, or 4/3 of one, the part by one of a step.
fn any_step_rounds_once_a_drift<S: Format>() {
    let step = Step::<S>::hz(RATE).unwrap();
    for scheme in SCHEMES {
        let bound = |v: f64, reach: f64, tick: u64| {
            let slack = S::COEFFICIENT * v * (2.0 * 4.0 / 3.0 + 1.0 / 60.0) / S::unit(reach);
            0.5 + 0.5 * scheme.drifts() * tick as f64 + slack
        };
        let (ratios, worst) = one_step_behind(scheme, &step, steady::<S>(), bound);
        let what = format!("{} {scheme:?} 60 Hz, of the bound", S::name());
        within(1.0, &what, &ratios);
        println!("{worst:.1} units at most");
    }
}

#[test]
fn at_60_hz_a_picture_is_on_the_line_to_what_the_steps_round() {
    any_step_rounds_once_a_drift::<f32>();
    any_step_rounds_once_a_drift::<I16F16>();
    any_step_rounds_once_a_drift::<I12F20>();
    any_step_rounds_once_a_drift::<I8F24>();
    any_step_rounds_once_a_drift::<I20F12>();
}
