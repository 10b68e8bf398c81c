//! A spring of 1 m at sixteen frequencies for a million steps, beside the same map in exact
//! arithmetic: with the coefficients as the type holds them, so that only the roundings of the state
//! are left, and with the ideal ones.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Anchor, Body, Carried, Factor, Point, Ratio, Scalar, Step, World};

use crate::support::*;

const STEPS: u32 = 1_000_000;
const RATE: f64 = 60.0;

/// Sixteen frequencies from 0.5 to 2.6 Hz, as rad/s.
fn omega(i: usize) -> f64 {
    std::f64::consts::TAU * (0.5 + 2.1 * i as f64 / 15.0)
}

/// The map `v -= κ x, x += h v` (Verlet: with half a drift before), whose trace is `2 - κ h`.
#[derive(Clone, Copy)]
struct Map {
    scheme: Scheme,
    kick: f64,
    h: f64,
}

impl Map {
    /// Position after `n` steps, q² = κ h, cos θ = 1 - q²/2:
    ///
    /// ```text
    /// SemiImplicitEuler   x cos(nθ) + (v h - x q²/2) sin(nθ) / sin θ
    /// Verlet              x cos(nθ) + v h (1 - q²/4) sin(nθ) / sin θ
    /// ```
    ///
    /// nθ is below 3e5 and good to `2^-52` of itself: 1e-10 m.
    fn position(self, [x, v]: [f64; 2], n: u32) -> f64 {
        let square = self.kick * self.h;
        let theta = 2.0 * (square.sqrt() / 2.0).asin();
        let side = match self.scheme {
            Scheme::SemiImplicitEuler => v * self.h - x * square / 2.0,
            _ => v * self.h * (1.0 - square / 4.0),
        };
        let (sin, cos) = (n as f64 * theta).sin_cos();
        x * cos + side * sin / theta.sin()
    }
}

/// The `h` that a kind of body drifts by, on the mean of two ticks.
trait Drifts: Body<S: Format> + From<Point<Self::S>> + std::fmt::Debug {
    const KIND: &str;

    fn h(scheme: Scheme) -> f64;
}

fn spans<S: Scalar>(seconds: Ratio) -> f64 {
    let [below, above] = S::spans(seconds).unwrap();
    (below.to_f64() + above.to_f64()) / 2.0
}

impl<S: Format> Drifts for Point<S> {
    const KIND: &str = "Point";

    fn h(scheme: Scheme) -> f64 {
        match scheme {
            Scheme::Verlet => 2.0 * spans::<S>(Ratio::new(1, 120).unwrap()),
            _ => spans::<S>(Ratio::new(1, 60).unwrap()),
        }
    }
}

impl<S: Format + fixstep::Carry> Drifts for Carried<S> {
    const KIND: &str = "carried";

    fn h(_: Scheme) -> f64 {
        S::Coef::new(Ratio::new(1, 60).unwrap()).unwrap().to_f64()
    }
}

/// The largest errors of each body over the last two periods of the slowest: beside its own
/// coefficients, and beside the ideal ones.
fn swing<B: Drifts>(scheme: Scheme) -> [[f64; 16]; 2] {
    let start = |i: usize| {
        let part = |k: usize| [angle(k).cos(), omega(i) * angle(k).sin()];
        let (x, y) = (part(2 * i), part(2 * i + 1));
        point::<B::S>([x[0], y[0]], [x[1], y[1]], 1.0).into()
    };
    let mut world: World<B, 16> = world(std::array::from_fn(start));
    let starts = world.clone();
    let stiffness: [f64; 16] = std::array::from_fn(|i| omega(i) * omega(i));
    let mut forces: [Anchor<B::S>; 16] = anchors(&world, stiffness);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let maps = stiffness.map(|k| {
        let [k, h] = [ratio(k), Ratio::new(1, 60).unwrap()].map(<B::S as Scalar>::Coef::new);
        let kick = B::S::product(k.unwrap(), h.unwrap()).to_f64();
        let h = B::h(scheme);
        Map { scheme, kick, h }
    });
    let ideal = stiffness.map(|k| Map {
        scheme,
        kick: k / RATE,
        h: 1.0 / RATE,
    });
    let mut worst = [[0.0; 16]; 2];
    for n in 1..=STEPS {
        world.step(&mut method, &mut forces, &step);
        if n + 240 < STEPS {
            continue;
        }
        for (worst, maps) in worst.iter_mut().zip([maps, ideal]) {
            for (i, worst) in worst.iter_mut().enumerate() {
                let (now, then) = (&world.bodies()[i], &starts.bodies()[i]);
                let [at, from, speed] =
                    [now.position(), then.position(), then.velocity()].map(|v| v.to_f64().array());
                for axis in 0..2 {
                    let exact = maps[i].position([from[axis], speed[axis]], n);
                    *worst = maximum(&[*worst, (at[axis] - exact).abs()]);
                }
            }
        }
    }
    worst
}

/// What may come together in N steps of a body that carries, six standard deviations of it, at 2.6 Hz
/// where ω h is 0.272 and ω 16.3 rad/s:
///
/// * x seen for the force is off by 1/12 of a unit² on the mean; κ of it is a velocity, κ/ω = ω h in m.
/// * the position as it is seen: half a unit.
/// * products of floats are rounded before they are added: of kicks up to 4.5 m/s, of drifts up to ω h.
///
/// A point rounds each drift and both products of a kick, and ties of `h v` and the roundings of x and v
/// go together: only half a unit each, all one way, is sure.
fn roundings<B: Drifts>(scheme: Scheme) -> f64 {
    let (n, x) = (STEPS as f64, B::S::unit(1.0));
    if B::KIND == "Point" {
        return 0.5 * n * (scheme.drifts() * x + 2.0 * B::S::unit(16.3) / 3.1);
    }
    let (seen, float) = (0.272 * x, B::S::unit(4.5) != B::S::unit(0.272));
    let products = match float {
        true => [B::S::unit(4.5) / 16.3, B::S::unit(0.272)],
        false => [0.0; 2],
    };
    let squares =
        seen * seen + products[0] * products[0] + scheme.drifts() * products[1] * products[1];
    6.0 * (n / 12.0 * squares).sqrt() + 0.5 * x
}

/// Coefficients are off by `COEFFICIENT` of themselves, h by as much: times the angle turned.
fn coefficients<S: Format>() -> f64 {
    S::COEFFICIENT * 16.4 * STEPS as f64 / RATE
}

fn row<B: Drifts>(scheme: Scheme) -> [f64; 16] {
    let [own, ideal] = swing::<B>(scheme);
    let what = format!("{} {} {scheme:?}", B::S::name(), B::KIND);
    within(roundings::<B>(scheme), &format!("{what} 1 m, m"), &own);
    let bound = roundings::<B>(scheme) + coefficients::<B::S>();
    within(bound, &format!("{what} beside ideal k h, m"), &ideal);
    if scheme == Scheme::SemiImplicitEuler {
        let kind = if B::KIND == "Point" {
            "Point"
        } else {
            "Carried"
        };
        crate::carry::told(&format!("{kind}<{}>", B::S::name()), 4, &own);
    }
    own
}

/// What was asked for, beside what a float does in the same bytes.
fn check_fine(scheme: Scheme) {
    let errors = row::<Carried<I8F24>>(scheme);
    within(5e-5, &format!("I8F24 carried {scheme:?}, asked"), &errors);
    assert!(median(&errors) <= 2e-5, "{:e}", median(&errors));
}

#[test]
fn a_spring_is_within_20_um_of_its_map_in_i8f24_by_semi_implicit_euler() {
    check_fine(Scheme::SemiImplicitEuler);
}

#[test]
fn a_spring_is_within_20_um_of_its_map_in_i8f24_by_verlet() {
    check_fine(Scheme::Verlet);
}

#[test]
fn a_spring_of_others_by_semi_implicit_euler() {
    let scheme = Scheme::SemiImplicitEuler;
    row::<Point<I8F24>>(scheme);
    row::<Point<I16F16>>(scheme);
    row::<Carried<I16F16>>(scheme);
}

#[test]
fn a_spring_of_floats() {
    row::<Point<f32>>(Scheme::SemiImplicitEuler);
    row::<Carried<f32>>(Scheme::SemiImplicitEuler);
}
