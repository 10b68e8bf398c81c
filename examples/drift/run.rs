//! One run: a scene through [`World::step`] with one method and one scalar.

use fixstep::{
    Anchor, Body, ConstantAcceleration, Error, Euler, Force, Gravity, LinearDrag, Method, Pairs,
    Point, Ratio, Scalar, SemiImplicitEuler, Spring, Step, Vec2, Verlet, World,
};

use crate::cli::MethodName;
use crate::represent::{point, real, vector};
use crate::scene::{Compare, Law, Start};

/// No scene has more bodies.
const ROOM: usize = 2;

type Bodies<S> = World<Point<S>, ROOM>;

/// What to fly, and when to look.
#[derive(Clone, Copy)]
pub struct Plan<'a> {
    pub law: Law,
    pub compare: Compare,
    pub method: MethodName,
    pub rate: Ratio,
    /// Rising.
    pub ticks: &'a [u64],
}

/// The state at one tick, relative to the start.
pub struct Sample {
    /// Of each body, m.
    pub displacements: Vec<Vec2<f64>>,
    /// Change of the total energy over its first value.
    pub energy: f64,
    /// Change of the total momentum, kg m/s.
    pub momentum: f64,
}

/// A sample for each tick of the plan; `None` from the step on after which a body had reached an
/// end of the range, infinity or NaN.
pub type Flight = Vec<Option<Sample>>;

/// Flies `bodies`. Refuses a scene that the scalar cannot hold.
pub fn fly<S: Scalar>(plan: &Plan, bodies: &[Start]) -> Result<Flight, Error> {
    match plan.method {
        MethodName::Euler => with_method::<S, _>(plan, bodies, Euler::<Point<S>, ROOM>::new()),
        MethodName::ConstantAcceleration => {
            with_method::<S, _>(plan, bodies, ConstantAcceleration::<Point<S>, ROOM>::new())
        }
        MethodName::SemiImplicitEuler => with_method::<S, _>(plan, bodies, SemiImplicitEuler),
        MethodName::Verlet => with_method::<S, _>(plan, bodies, Verlet),
    }
}

fn with_method<S: Scalar, M: Method<Point<S>, ROOM>>(
    plan: &Plan,
    bodies: &[Start],
    method: M,
) -> Result<Flight, Error> {
    let mut world = Bodies::<S>::new();
    for start in bodies {
        // A full world would show as a flight of fewer bodies; no scene has more than ROOM.
        let _ = world.add(point(start)?);
    }
    let gravity = |g: f64| Ok::<_, Error>(Gravity::new(vector(Vec2::new(0.0, -g))?));
    match plan.law {
        Law::Free => with_forces(plan, world, method, ()),
        Law::Gravity { g } => with_forces(plan, world, method, gravity(g)?),
        Law::Drag { k } => with_forces(plan, world, method, LinearDrag::new(real(k)?)?),
        Law::GravityAndDrag { g, k } => {
            let forces = (gravity(g)?, LinearDrag::new(real(k)?)?);
            with_forces(plan, world, method, forces)
        }
        Law::Anchor { k } => {
            let anchor = Anchor::new(world.ids()[0], Vec2::ZERO, real(k)?, 0)?;
            with_forces(plan, world, method, anchor)
        }
        Law::Spring { k, rest } => {
            let ends = [world.ids()[0], world.ids()[1]];
            let spring = Pairs::new(Spring::new(real(rest)?, real(k)?, 0)?, [ends]);
            with_forces(plan, world, method, spring)
        }
    }
}

fn with_forces<S: Scalar, M: Method<Point<S>, ROOM>, F: Force<Point<S>>>(
    plan: &Plan,
    mut world: Bodies<S>,
    mut method: M,
    mut forces: F,
) -> Result<Flight, Error> {
    let step = Step::<S>::hz(plan.rate)?;
    let circle = Circle::new(plan.compare)?;
    let first = Totals::of(&world, &forces);
    let mut flight = Flight::new();
    for &tick in plan.ticks {
        while world.tick() < tick {
            world.step(&mut method, &mut forces, &step);
            if let Some(circle) = &circle {
                circle.wrap(&mut world)?;
            }
            if !world.bodies().iter().all(Body::is_inside) {
                flight.resize_with(plan.ticks.len(), || None);
                return Ok(flight);
            }
        }
        flight.push(Some(first.sample(&world, &forces)));
    }
    Ok(flight)
}

/// Keeps x between `-half` and `half` by teleports between the steps.
struct Circle<S> {
    half: S,
    around: Vec2<S>,
}

impl<S: Scalar> Circle<S> {
    fn new(compare: Compare) -> Result<Option<Self>, Error> {
        let Compare::OnCircle(metres) = compare else {
            return Ok(None);
        };
        let around = vector(Vec2::new(f64::from(metres), 0.0))?;
        let half = vector(Vec2::new(0.5 * f64::from(metres), 0.0))?.x;
        Ok(Some(Circle { half, around }))
    }

    fn wrap(&self, world: &mut Bodies<S>) -> Result<(), Error> {
        for (_, body) in world.iter_mut() {
            let position = body.position();
            if position.x >= self.half {
                body.teleport(position - self.around)?;
            } else if position.x < self.half.negated() {
                body.teleport(position + self.around)?;
            }
        }
        Ok(())
    }
}

/// Positions and invariants, by the crate's own read-outs.
struct Totals {
    positions: Vec<Vec2<f64>>,
    energy: f64,
    momentum: Vec2<f64>,
}

impl Totals {
    fn of<S: Scalar>(world: &Bodies<S>, forces: &impl Force<Point<S>>) -> Self {
        Totals {
            positions: world
                .bodies()
                .iter()
                .map(|body| body.position().to_f64())
                .collect(),
            energy: world.kinetic_energy() + world.potential_energy(forces),
            momentum: world.momentum(),
        }
    }

    /// The world seen from these totals of its start.
    fn sample<S: Scalar>(&self, world: &Bodies<S>, forces: &impl Force<Point<S>>) -> Sample {
        let now = Totals::of(world, forces);
        let moved = now.positions.iter().zip(&self.positions);
        Sample {
            displacements: moved.map(|(&now, &start)| now - start).collect(),
            energy: (now.energy / self.energy - 1.0).abs(),
            momentum: (now.momentum - self.momentum).length(),
        }
    }
}
