//! Damped springs in a world: starts in the phase plane, forces, and the matrix of a step.

use fixstep::scalar::Decay;
use fixstep::{Anchor, ExactDrag, Point, Step, Vec2, World};

use super::law::Drag;
use crate::support::*;

/// Steps a second, so that ω = 8 q: positions and velocities have numbers of the same size.
pub const RATE: f64 = 8.0;

/// A number type in which both drags can be solved.
pub trait Number: Format + Decay {}

impl<S: Format + Decay> Number for S {}

/// A spring of one kilogram, by its place in the map.
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    pub drag: Drag,
    pub q: f64,
    pub zeta: f64,
}

/// A spring with its damper, and the exact drag of all bodies if that is what damps.
pub type Forces<S, const N: usize> = ([Anchor<S>; N], Option<ExactDrag<S>>);

impl Swing {
    pub fn omega(self) -> f64 {
        self.q * RATE
    }

    /// Bodies whose x and y axes start at (x, u) of the phase plane.
    pub fn world<S: Number, const N: usize>(
        self,
        starts: [[[f64; 2]; 2]; N],
    ) -> World<Point<S>, N> {
        let omega = self.omega();
        world(starts.map(|[x, y]| point([x[0], y[0]], [x[1] * omega, y[1] * omega], 1.0)))
    }

    pub fn forces<S: Number, const N: usize>(self, world: &World<Point<S>, N>) -> Forces<S, N> {
        let rate = 2.0 * self.zeta * self.omega();
        let (damping, drag) = match self.drag {
            Drag::Explicit => (rate, None),
            Drag::Exact => (0.0, Some(ExactDrag::new(ratio(rate)).unwrap())),
        };
        let stiffness = ratio(self.omega().powi(2));
        let anchor = |i: usize| Anchor::new(world.ids()[i], Vec2::ZERO, stiffness, ratio(damping));
        (std::array::from_fn(|i| anchor(i).unwrap()), drag)
    }

    /// The step in (x, u) as it is: its columns are what becomes of the unit starts.
    pub fn matrix(self, scheme: Scheme) -> [[f64; 2]; 2] {
        let mut world = self.world([[[1.0, 0.0], [0.0, 1.0]]]);
        let mut forces = self.forces::<f64, 1>(&world);
        world.step(&mut scheme.method(), &mut forces, &step());
        let ([x0, x1], [v0, v1]) = state(&world.bodies()[0]);
        [[x0, x1], [v0 / self.omega(), v1 / self.omega()]]
    }
}

/// Phases all round, in (x, u), none within a tenth of a direction to `avoid`.
pub fn starts(size: f64, avoid: Option<f64>) -> [[[f64; 2]; 2]; 8] {
    let at = |i: usize| {
        let near = avoid.is_some_and(|avoid| (angle(i) - avoid).sin().abs() < 0.1);
        let (sin, cos) = (angle(i) + if near { 0.25 } else { 0.0 }).sin_cos();
        [size * cos, size * sin]
    };
    std::array::from_fn(|i| [at(2 * i), at(2 * i + 1)])
}

pub fn step<S: Number>() -> Step<S> {
    Step::hz(ratio(RATE)).unwrap()
}

/// Positions and velocities of both axes.
pub fn state<S: Number>(body: &Point<S>) -> ([f64; 2], [f64; 2]) {
    let (position, velocity) = (body.position().to_f64(), body.velocity().to_f64());
    (position.array(), velocity.array())
}

/// Trace and determinant.
pub fn measured([[a, b], [c, d]]: [[f64; 2]; 2]) -> [f64; 2] {
    [a + d, a * d - b * c]
}

/// How far a scene may reach: the end of the range, for floats 2^20.
pub fn reach<S: Number>() -> f64 {
    S::MAX.to_f64().min(1_048_576.0)
}

/// Whether the type is a float, whose range has no end that a run would come to.
pub fn is_float<S: Number>() -> bool {
    S::unit(1.0) != S::unit(4.0)
}
