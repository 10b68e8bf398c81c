//! fixstep in `f32` and in fixed point, by `Verlet` or `SemiImplicitEuler`: once with the forces that its guide
//! names, and where these are solved exactly a second time with the explicit ones.
//!
//! | problem | as the guide says | explicit |
//! |---|---|---|
//! | fall | `GravityY` | |
//! | drag | `ExactDrag` | `LinearDrag` |
//! | projectile | `Ballistic` | `GravityY` and `LinearDrag` |
//! | spring as user force | `PerBody` | |
//! | own spring | `ExactSpring` | `Anchor` |
//!
//! `Ballistic` and `ExactSpring` are the exact solutions of these problems, but for rounding, and `ExactDrag` is in
//! the velocity: what the explicit rows show is what a method does with a force that nobody has solved.

use std::f64::consts::TAU;
use std::marker::PhantomData;

use ::fixstep::fixed::types::{I8F24, I16F16};
use ::fixstep::{
    Anchor, Ballistic, BodyId, Decay, Error, ExactDrag, ExactSpring, Force, GravityY, LinearDrag,
    Method, PerBody, Point, Ratio, SemiImplicitEuler, Step, Time, Vec2, Verlet, World,
};

use crate::engine::{Engine, Scene, Setting, setting};
use crate::problem::{HERTZ, Kind, STARTS, State};

type Bodies<S> = World<Point<S>, STARTS>;
type Springs<T> = [T; STARTS];

const VERLET: usize = 0;

const SETTINGS: [Setting; 2] = [
    setting("Verlet", [VERLET, 0]),
    setting("SemiImplicitEuler", [1, 0]),
];

struct Ours<S> {
    name: &'static str,
    exact: bool,
    scalar: PhantomData<S>,
}

/// Two engines, as the header says.
fn ours<S: Decay>([name, explicit]: [&'static str; 2]) -> [Box<dyn Engine>; 2] {
    [(name, true), (explicit, false)].map(|(name, exact)| {
        let scalar = PhantomData::<S>;
        Box::new(Ours {
            name,
            exact,
            scalar,
        }) as Box<dyn Engine>
    })
}

/// Each number type.
pub fn all() -> Vec<Box<dyn Engine>> {
    let engines = [
        ours::<f32>(["fixstep f32", "fixstep f32 explicit"]),
        ours::<I16F16>(["fixstep I16F16", "fixstep I16F16 explicit"]),
        ours::<I8F24>(["fixstep I8F24", "fixstep I8F24 explicit"]),
    ];
    engines.into_iter().flatten().collect()
}

impl<S: Decay> Engine for Ours<S> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn settings(&self, kind: Kind) -> &'static [Setting] {
        match kind {
            Kind::Fall | Kind::UserSpring if !self.exact => &[],
            _ => &SETTINGS,
        }
    }

    fn build(&self, kind: Kind, setting: &Setting, rate: u32) -> Box<dyn Scene> {
        scene::<S>(kind, self.exact, setting.counts[0], rate)
            .expect("every problem fits every number type")
    }
}

fn real(value: f64) -> Result<Ratio, Error> {
    Ok(Ratio::from_f64(value)?)
}

fn vector<S: Decay>([x, y]: [f64; 2]) -> Result<Vec2<S>, Error> {
    ::fixstep::vec2(real(x)?, real(y)?)
}

fn scene<S: Decay>(
    kind: Kind,
    exact: bool,
    method: usize,
    rate: u32,
) -> Result<Box<dyn Scene>, Error> {
    let step = Step::hz(rate as i32)?;
    let mut world = Bodies::<S>::new();
    for start in kind.starts() {
        world.add(Point::new(vector(start.at)?, vector(start.speed)?, 1)?)?;
    }
    let down = vector([0.0, -kind.gravity()])?;
    let (drag, rest) = (real(kind.drag())?, vector(kind.rest())?);
    let omega = TAU * HERTZ;
    let stiffness = real(omega * omega)?;
    let damping = real(2.0 * kind.damping_ratio() * omega)?;
    let gravity = GravityY::new(real(-kind.gravity())?)?;
    Ok(match kind {
        Kind::Fall => run(world, step, method, gravity),
        Kind::Drag if exact => run(world, step, method, ExactDrag::new(drag)?),
        Kind::Projectile if exact => run(world, step, method, Ballistic::new(down, drag)?),
        Kind::Drag => run(world, step, method, LinearDrag::new(drag)?),
        Kind::Projectile => run(world, step, method, (gravity, LinearDrag::new(drag)?)),
        Kind::UserSpring => {
            let stiffness = <S::Coef as ::fixstep::Factor<S>>::new(stiffness)
                .expect("a stiffness that a coefficient holds");
            let force = move |_: Time, body: &Point<S>| -body.position().scaled(stiffness);
            run(world, step, method, PerBody(force))
        }
        _ if exact => {
            let ratio = real(kind.damping_ratio())?;
            let springs = each(&world, |id| ExactSpring::new(id, rest, real(HERTZ)?, ratio))?;
            run(world, step, method, springs)
        }
        _ => {
            let springs = each(&world, |id| Anchor::new(id, rest, stiffness, damping))?;
            run(world, step, method, springs)
        }
    })
}

/// One spring a body.
fn each<S: Decay, T: std::fmt::Debug>(
    world: &Bodies<S>,
    spring: impl FnMut(BodyId) -> Result<T, Error>,
) -> Result<Springs<T>, Error> {
    let springs: Result<Vec<T>, Error> = world.ids().iter().copied().map(spring).collect();
    Ok(springs?.try_into().expect("as many bodies as starts"))
}

struct Run<S: Decay, M, F> {
    world: Bodies<S>,
    step: Step<S>,
    method: M,
    forces: F,
}

fn run<S: Decay, F: Force<Point<S>> + 'static>(
    world: Bodies<S>,
    step: Step<S>,
    method: usize,
    forces: F,
) -> Box<dyn Scene> {
    if method == VERLET {
        let method = Verlet;
        Box::new(Run {
            world,
            step,
            method,
            forces,
        })
    } else {
        let method = SemiImplicitEuler;
        Box::new(Run {
            world,
            step,
            method,
            forces,
        })
    }
}

impl<S: Decay, M: Method<Point<S>, STARTS>, F: Force<Point<S>>> Scene for Run<S, M, F> {
    fn advance(&mut self, steps: u32) {
        for _ in 0..steps {
            self.world
                .step(&mut self.method, &mut self.forces, &self.step);
        }
    }

    fn states(&self) -> Vec<State> {
        let array = |v: Vec2<f64>| [v.x, v.y];
        self.world
            .bodies()
            .iter()
            .map(|body| State {
                at: array(body.position().to_f64()),
                speed: array(body.velocity().to_f64()),
            })
            .collect()
    }
}
