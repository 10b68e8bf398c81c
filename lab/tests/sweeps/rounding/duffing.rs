//! An oscillator whose frequency depends on its energy, `a = -x - x³`, 1 kg: 32 of them on the two
//! axes of 16 bodies, beside the same map in `f64`.

use std::fmt::Debug;

use fixstep::scalar::Factor;
use fixstep::{Body, PerBody, Point, Ratio, Scalar, Step, Time, Vec2, World};

use crate::support::*;

pub const STARTS: usize = 32;

/// Half a decade apart.
pub const COUNTS: [u32; 7] = [1_000, 3_162, 10_000, 31_623, 100_000, 316_228, 1_000_000];

/// A method, and steps a second: periods last 2.6 to 5.7 s, none a whole number of steps.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    pub scheme: Scheme,
    pub rate: (i64, u64),
}

/// Position and velocity.
pub type State = [f64; 2];

impl Setup {
    fn rate(&self) -> Ratio {
        Ratio::new(self.rate.0, self.rate.1).unwrap()
    }

    pub fn seconds(&self) -> f64 {
        1.0 / self.rate().to_f64()
    }
}

/// In the scalar: two products and a sum, so that x³ is off by up to `(|x| + 1) / 2` units. The kick
/// rounds h times that once. At 60 Hz a force of 30 units modulo 60 is a tie, which goes one way: half
/// a unit of force on the mean, and 5e-9 of the phase of an `I8F24`, far below what is judged.
pub fn force<S: Scalar>(x: S) -> S {
    x.times(x).times(x).plus(x).negated()
}

pub fn acceleration(x: f64) -> f64 {
    -(x + x * x * x)
}

pub fn energy([x, v]: State) -> f64 {
    0.5 * (v * v + x * x) + 0.25 * x * x * x * x
}

/// Start `i`: amplitudes from 0.5 to 2 m, everywhere on their orbits.
pub fn start(i: usize) -> State {
    let amplitude = 0.5 + 1.5 * i as f64 / (STARTS - 1) as f64;
    let (sin, cos) = angle(i).sin_cos();
    let x = amplitude * cos;
    let rest = energy([amplitude, 0.0]) - energy([x, 0.0]);
    [x, (2.0 * rest).sqrt().copysign(sin)]
}

/// The lengths of time that a scalar holds: of a kick, and of a drift in even and in odd ticks.
#[derive(Clone, Copy, Debug)]
pub struct Lengths {
    kick: f64,
    drifts: [f64; 2],
}

impl Lengths {
    /// A point drifts by two spans in turn.
    pub fn point<S: Scalar>(setup: &Setup) -> Lengths {
        let (num, den) = setup.rate;
        let parts = setup.scheme.drifts() as i64;
        let length = |parts| Ratio::new(den as i64, num as u64 * parts).unwrap();
        let kick = S::Coef::new(length(1)).unwrap().to_f64();
        let drifts = S::spans(length(parts as u64)).unwrap().map(Factor::to_f64);
        Lengths { kick, drifts }
    }

    /// A body that keeps remainders drifts by a coefficient.
    pub fn carried<S: Scalar>(setup: &Setup) -> Lengths {
        let kick = Lengths::point::<S>(setup).kick;
        let drift = kick / setup.scheme.drifts();
        Lengths {
            kick,
            drifts: [drift; 2],
        }
    }

    /// The step of the scheme that these lengths make, written out once more.
    fn advance(&self, scheme: Scheme, tick: u32, [mut x, mut v]: State) -> State {
        let drift = self.drifts[(tick & 1) as usize];
        if scheme == Scheme::Verlet {
            x += drift * v;
        }
        v += self.kick * acceleration(x);
        [x + drift * v, v]
    }

    /// The states of all starts before each of `steps` steps of the first orbits.
    pub fn orbit(&self, scheme: Scheme, i: usize, steps: u32) -> impl Iterator<Item = State> {
        let next = move |tick: u32, state| self.advance(scheme, tick, state);
        let states = (0..steps).scan(start(i), move |state, tick| {
            let seen = *state;
            *state = next(tick, seen);
            Some(seen)
        });
        states.collect::<Vec<_>>().into_iter()
    }
}

/// What the method keeps but for `h³` and more, by the formula of Baker, Campbell and Hausdorff.
/// The energy itself swings with h along an orbit, and would show a phase error as one of energy.
pub fn kept(setup: &Setup, [x, v]: State) -> f64 {
    let (h, slope) = (setup.seconds(), 1.0 + 3.0 * x * x);
    let (a, bend) = (acceleration(x), slope * v * v);
    energy([x, v])
        + match setup.scheme {
            Scheme::Verlet => h * h * (a * a / 12.0 - bend / 24.0),
            _ => h * a * v / 2.0 + h * h * (a * a + bend) / 12.0,
        }
}

/// The angular frequency of an amplitude: the arithmetic-geometric mean of `sqrt(1 + A²)` and
/// `sqrt(1 + A²/2)`, which is `π / 2` over the complete elliptic integral of the quarter period.
pub fn frequency(energy: f64) -> f64 {
    let square = (1.0 + 4.0 * energy).sqrt() - 1.0;
    let (mut a, mut b) = ((1.0 + square).sqrt(), (1.0 + square / 2.0).sqrt());
    for _ in 0..6 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    a
}

/// How far from the reference, of each start.
#[derive(Clone, Debug)]
pub struct Errors {
    /// Length of the difference in x (m) and v (m/s).
    pub state: [f64; STARTS],
    /// The part of it along the orbit: time by which it runs ahead, s.
    pub ahead: [f64; STARTS],
    /// Of what the method keeps, J.
    pub energy: [f64; STARTS],
}

fn errors(setup: &Setup, states: &[State; STARTS], exact: &[State; STARTS]) -> Errors {
    let off = |i: usize| [0, 1].map(|k| states[i][k] - exact[i][k]);
    let ahead = |i: usize| {
        let ([x, v], [dx, dv]) = (exact[i], off(i));
        let a = acceleration(x);
        (dx * v + dv * a) / (v * v + a * a)
    };
    Errors {
        state: std::array::from_fn(|i| off(i)[0].hypot(off(i)[1])),
        ahead: std::array::from_fn(ahead),
        energy: std::array::from_fn(|i| kept(setup, states[i]) - kept(setup, exact[i])),
    }
}

fn states<B: Body>(world: &World<B, 16>) -> [State; STARTS] {
    std::array::from_fn(|i| {
        let body = &world.bodies()[i / 2];
        [body.position(), body.velocity()].map(|pair| pair.to_f64().array()[i % 2])
    })
}

/// Runs all starts as bodies `B` up to the last of `counts`, and from the states that these hold in
/// `f64` with `lengths`.
pub fn run<B>(setup: &Setup, lengths: &Lengths, counts: &[u32]) -> Vec<Errors>
where
    B: Body + From<Point<B::S>> + Debug,
{
    let body = |i: usize| {
        let ([x, vx], [y, vy]) = (start(2 * i), start(2 * i + 1));
        B::from(point::<B::S>([x, y], [vx, vy], 1.0))
    };
    let mut world: World<B, 16> = world(std::array::from_fn(body));
    let mut exact = states(&world);
    let mut forces = PerBody(|_: Time, body: &B| -> Vec2<B::S> { body.position().map(force) });
    let (mut method, step) = (setup.scheme.method(), Step::hz(setup.rate()).unwrap());
    let mut found = vec![];
    for tick in 0..counts.last().copied().unwrap_or(0) {
        world.step(&mut method, &mut forces, &step);
        exact = exact.map(|state| lengths.advance(setup.scheme, tick, state));
        if counts.contains(&(tick + 1)) {
            found.push(errors(setup, &states(&world), &exact));
        }
    }
    found
}
