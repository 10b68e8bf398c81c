//! One run: a body through [`World::step`] with one method, for either equation.
//!
//! ```text
//! dy/dx = 2x        velocity (1, 2x), acceleration (0, 2): the position is the point (x, y)
//! dv/dt = -k/m v    drag k on mass m: the velocity is the solution
//! ```
//!
//! In `f64`, so that what is seen is the error of the method and not of the numbers.

use fixstep::{
    ConstantAcceleration, Error, Euler, Force, GravityY, LinearDrag, Method, Point, Ratio,
    SemiImplicitEuler, TimeStep, Vec2, Verlet, World,
};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MethodName {
    Euler,
    ConstantAcceleration,
    SemiImplicitEuler,
    Verlet,
}

impl MethodName {
    pub const ALL: [MethodName; 4] = [
        MethodName::Euler,
        MethodName::ConstantAcceleration,
        MethodName::SemiImplicitEuler,
        MethodName::Verlet,
    ];
}

/// A method's values at the start and after each step.
#[derive(Clone, Debug)]
pub struct Run {
    pub method: MethodName,
    /// Length of a step: of x, or of t in s.
    pub step: f64,
    pub samples: Vec<Sample>,
}

/// One point of a run beside the curve that it should follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// x, or t in s.
    pub at: f64,
    /// y, or v in m/s.
    pub value: f64,
    pub exact: f64,
}

impl Sample {
    pub fn error(&self) -> f64 {
        self.value - self.exact
    }
}

/// dy/dx = 2x from (`x0`, `y0`). The body keeps its velocity along x at 1, so that x is the time.
pub fn parabola<H: TimeStep<f64>>(
    method: MethodName,
    step: &H,
    ticks: u32,
    [x0, y0]: [f64; 2],
) -> Result<Run, Error> {
    let start = Point::new(Vec2::new(x0, y0), Vec2::new(1.0, 2.0 * x0), 1)?;
    let bodies = fly(method, start, &mut GravityY::new(2)?, step, ticks);
    let sample = |body: &Point<f64>| {
        let Vec2 { x, y } = body.position();
        let exact = y0 + (x - x0) * (x + x0);
        Sample {
            at: x,
            value: y,
            exact,
        }
    };
    Ok(Run {
        method,
        step: step.seconds().to_f64(),
        samples: bodies.iter().map(sample).collect(),
    })
}

/// dv/dt = -k/m v from `v0` for a drag of k = 1 kg/s on m = 1 kg.
pub fn friction<H: TimeStep<f64>>(
    method: MethodName,
    step: &H,
    ticks: u32,
    v0: f64,
) -> Result<Run, Error> {
    let one = Ratio::from(1);
    let start = Point::new(Vec2::ZERO, Vec2::new(v0, 0.0), one)?;
    let bodies = fly(method, start, &mut LinearDrag::new(one)?, step, ticks);
    let step = step.seconds().to_f64();
    let sample = |(tick, body): (u32, &Point<f64>)| {
        let at = f64::from(tick) * step;
        Sample {
            at,
            value: body.velocity().x,
            exact: v0 * (-at).exp(),
        }
    };
    Ok(Run {
        method,
        step,
        samples: (0..).zip(&bodies).map(sample).collect(),
    })
}

/// The body at the start and after each step.
fn fly<F: Force<Point<f64>>, H: TimeStep<f64>>(
    method: MethodName,
    start: Point<f64>,
    forces: &mut F,
    step: &H,
    ticks: u32,
) -> Vec<Point<f64>> {
    match method {
        MethodName::Euler => fly_with(Euler::new(), start, forces, step, ticks),
        MethodName::ConstantAcceleration => {
            fly_with(ConstantAcceleration::new(), start, forces, step, ticks)
        }
        MethodName::SemiImplicitEuler => fly_with(SemiImplicitEuler, start, forces, step, ticks),
        MethodName::Verlet => fly_with(Verlet, start, forces, step, ticks),
    }
}

fn fly_with<F: Force<Point<f64>>, H: TimeStep<f64>>(
    mut method: impl Method<Point<f64>, 1>,
    start: Point<f64>,
    forces: &mut F,
    step: &H,
    ticks: u32,
) -> Vec<Point<f64>> {
    let mut world = World::<Point<f64>, 1>::new();
    // A world of one has room for the first.
    let _ = world.add(start);
    let mut seen = world.bodies().to_vec();
    for _ in 0..ticks {
        world.step(&mut method, forces, step);
        seen.extend(world.bodies());
    }
    seen
}
