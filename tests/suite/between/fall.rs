//! A falling body between two steps: on the parabola where the method has one, else on the straight
//! path that the method itself takes, `g h²/8` off in the middle.
//!
//! ```text
//! x(α h) = x0 + v0 α h + g (α h)²/2            Verlet, ConstantAcceleration
//!          x0 + v0 α h                         Euler
//!          x0 + v1 α h                         SemiImplicitEuler
//! chord less parabola, same ends = α (1 - α)/2 g h²
//! ```
//!
//! The reference is `f64`: 1e-14 m, which no 32-bit type sees.

use fixstep::Gravity;

use super::*;

/// Frames of a display, and steps so long that the bow is seen in any type.
const RATES: [i32; 2] = [60, 10];

fn gravity<S: Format>() -> S {
    scalar(-9.81)
}

/// One body at one part of one step, y only.
struct Sample {
    part: f64,
    h: f64,
    x: [f64; 2],
    v: [f64; 2],
    drawn: f64,
}

impl Sample {
    fn chord(&self) -> f64 {
        self.x[0] + self.part * (self.x[1] - self.x[0])
    }

    /// What h, the part and the bow may be off by, in units: a COEFFICIENT of the way each, and
    /// two of the way for the step's own halves. The way is h v at most.
    fn slack<S: Format>(&self) -> f64 {
        let speed = self.v[0].abs().max(self.v[1].abs());
        5.0 * S::COEFFICIENT * self.h * speed / self.unit::<S>()
    }

    fn unit<S: Format>(&self) -> f64 {
        S::unit(self.x[0].abs().max(self.x[1].abs()))
    }
}

/// Eight steps of sixteen bodies thrown from 20 to 80 m, at every part of each step.
fn samples<S: Format>(scheme: Scheme, rate: i32) -> Vec<Sample> {
    let start = |i| {
        let (y, v) = (20.0 + 60.0 * spread(i), 12.0 * spread(i + 16) - 6.0);
        point::<S>([0.0, y], [0.0, v], 1.0)
    };
    let mut world = world::<_, 16>(std::array::from_fn(start));
    let mut forces = Gravity::new(Vec2::new(S::ZERO, gravity()));
    let (step, mut method) = (Step::hz(rate).unwrap(), scheme.method());
    let mut all = Vec::new();
    for _ in 0..8 {
        let before = world.clone();
        world.step(&mut method, &mut forces, &step);
        for part in parts() {
            let between = Between::new(part, &step).unwrap();
            for (id, at) in picture(scheme, [&before, &world], &between) {
                let states = [&before, &world].map(|world| world.get(id).unwrap());
                all.push(Sample {
                    part: part.to_f64(),
                    h: 1.0 / f64::from(rate),
                    x: states.map(|body| body.position().y.to_f64()),
                    v: states.map(|body| body.velocity().y.to_f64()),
                    drawn: at.y.to_f64(),
                });
            }
        }
    }
    all
}

/// Errors against `path` as parts of the `bound`, in units.
fn follows<S: Format>(
    scheme: Scheme,
    path: impl Fn(&Sample) -> f64,
    bound: impl Fn(&Sample) -> f64,
) {
    for rate in RATES {
        let samples = samples::<S>(scheme, rate);
        let units = |s: &Sample| (s.drawn - path(s)).abs() / s.unit::<S>();
        let errors: Vec<f64> = samples.iter().map(units).collect();
        let allowed = |s: &Sample| bound(s) + s.slack::<S>();
        let ratios = samples.iter().zip(&errors).map(|(s, e)| e / allowed(s));
        let (worst, least) = (maximum(&errors), samples.iter().map(allowed));
        let least = least.fold(f64::MAX, f64::min);
        println!("{rate} Hz: {worst:.2} units, bounds from {least:.2}");
        let what = format!("{} {scheme:?} {rate} Hz, of the bound", S::name());
        within(1.0, &what, &ratios.collect::<Vec<_>>());
    }
}

// The chord and the bow round by half a unit each, the step's two drifts by half a unit each, of
// which a part is seen. What a tick adds to v is g h to within a unit, which moves x1 by h/2 units and
// the bow by h/8.
fn is_on_the_parabola<S: Format>() {
    let g = gravity::<S>().to_f64();
    for scheme in [Scheme::Verlet, Scheme::ConstantAcceleration] {
        let path = |s: &Sample| {
            let t = s.part * s.h;
            s.x[0] + s.v[0] * t + 0.5 * g * t * t
        };
        follows::<S>(scheme, path, |s| 1.0 + s.part + s.h);
    }
}

#[test]
fn methods_for_constant_acceleration_are_drawn_on_the_parabola() {
    is_on_the_parabola::<f32>();
    is_on_the_parabola::<I16F16>();
    is_on_the_parabola::<I12F20>();
    is_on_the_parabola::<I8F24>();
    is_on_the_parabola::<I20F12>();
}

// One drift, of which a part is seen, and one chord: half a unit each.
fn is_on_its_own_path<S: Format>() {
    for (scheme, end) in [(Scheme::Euler, 0), (Scheme::SemiImplicitEuler, 1)] {
        let path = |s: &Sample| s.x[0] + s.v[end] * s.part * s.h;
        follows::<S>(scheme, path, |s| 0.5 + 0.5 * s.part);
    }
}

#[test]
fn methods_of_one_velocity_are_drawn_on_their_own_path() {
    is_on_its_own_path::<f32>();
    is_on_its_own_path::<I16F16>();
    is_on_its_own_path::<I12F20>();
    is_on_its_own_path::<I8F24>();
    is_on_its_own_path::<I20F12>();
}

/// How far `scheme` is drawn above (+) or below its `line`, in units of g h² at each part: the
/// roundings that both sides may differ by are in the same units.
fn bow<S: Format>(scheme: Scheme, line: impl Fn(&Sample) -> f64, expected: impl Fn(f64) -> f64) {
    let (mut errors, mut middle) = (Vec::new(), Vec::new());
    for sample in samples::<S>(scheme, 10) {
        let bow = gravity::<S>().to_f64() * sample.h * sample.h;
        let off = (sample.drawn - line(&sample)) / bow;
        // Two sums, half a unit each; the bow's velocities are g h to within a unit.
        let rounding = (1.0 + sample.h + sample.slack::<S>()) * sample.unit::<S>() / bow.abs();
        errors.push((off - expected(sample.part)).abs() / rounding);
        if sample.part == 0.5 {
            middle.push(off.abs());
            assert!(rounding < 0.011, "too coarse to see an eighth: {rounding}");
        }
    }
    let what = format!("{} {scheme:?} against the other path", S::name());
    within(1.0, &what, &errors);
    let (least, most) = (middle.iter().copied().fold(1.0, f64::min), maximum(&middle));
    println!("in the middle {least:.4} to {most:.4} g h²");
    assert!(least > 0.114 && most < 0.136, "an eighth, both sides");
}

// The parabola through the same ends, for the methods that take the chord; and the chord for those
// that take the parabola.
fn is_an_eighth<S: Format>() {
    let g = gravity::<S>().to_f64();
    let eighth = |part: f64| part * (1.0 - part) / 2.0;
    let parabola = |s: &Sample| s.chord() - eighth(s.part) * g * s.h * s.h;
    for scheme in [Scheme::Euler, Scheme::SemiImplicitEuler] {
        bow::<S>(scheme, parabola, eighth);
    }
    for scheme in [Scheme::Verlet, Scheme::ConstantAcceleration] {
        bow::<S>(scheme, Sample::chord, |part| -eighth(part));
    }
}

#[test]
fn chord_and_parabola_differ_by_an_eighth_of_g_h_squared() {
    is_an_eighth::<f32>();
    is_an_eighth::<I16F16>();
    is_an_eighth::<I12F20>();
    is_an_eighth::<I8F24>();
    is_an_eighth::<I20F12>();
}
