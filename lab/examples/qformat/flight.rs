//! One run of a scene, in whatever number type its bodies have.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use clap::ValueEnum;
use fixstep::{
    Body, Error, Force, Method, Ratio, Scalar, SemiImplicitEuler, Step, TimeStep, Vec2, Verlet,
    World,
};

use crate::recorded::Recorded;

/// The methods that a scene can be asked about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Scheme {
    /// Verlet, drift-kick-drift
    Verlet,
    /// Semi-implicit Euler
    SemiImplicitEuler,
}

/// How a scene is flown.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// What makes the steps.
    pub method: Scheme,
    /// Steps per second.
    pub rate: Ratio,
    /// Simulated time.
    pub seconds: f64,
    /// Keeps x on a circle of this many metres: a long cruise needs no long road.
    pub circle: Option<u32>,
}

/// Where a body is: m, and turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    at: Vec2<f64>,
    angle: f64,
}

/// The places of all bodies after each step of the last second: one instant would be luck, since two
/// motions that swing apart meet again twice a period.
pub type Track = Vec<Place>;

/// A body whose flight is looked at.
pub trait Seen: Body {
    /// Its angle, turns; none if it is a point.
    fn turns(&self) -> f64 {
        0.0
    }
}

/// An angle that is wrong counts as the arc at an arm of 1 m.
pub const ARM: f64 = 1.0;

impl Plan {
    pub fn steps(&self) -> u64 {
        (self.seconds * self.rate.to_f64()).round() as u64
    }

    /// Flies a world under its forces.
    pub fn fly<B: Seen, F: Force<B>, const N: usize>(
        &self,
        world: &mut World<B, N>,
        forces: &mut F,
        step: &impl TimeStep<B::S>,
    ) -> Result<Track, Error> {
        match self.method {
            Scheme::Verlet => self.fly_by(&mut Verlet, world, forces, step),
            Scheme::SemiImplicitEuler => self.fly_by(&mut SemiImplicitEuler, world, forces, step),
        }
    }

    fn fly_by<B: Seen, F: Force<B>, const N: usize>(
        &self,
        method: &mut impl Method<B, N>,
        world: &mut World<B, N>,
        forces: &mut F,
        step: &impl TimeStep<B::S>,
    ) -> Result<Track, Error> {
        let steps = self.steps();
        let last = steps.saturating_sub(self.rate.to_f64().ceil() as u64);
        let around = match self.circle {
            Some(metres) => Some(fixstep::vec2(Ratio::new(metres.into(), 1)?, 0)?),
            None => None,
        };
        let mut track = Track::new();
        while world.tick() < steps {
            world.step(method, forces, step);
            if let Some(around) = around {
                wrap(world, around);
            }
            if world.tick() > last {
                track.extend(world.bodies().iter().map(|body| Place {
                    at: body.position().to_f64(),
                    angle: body.turns(),
                }));
            }
        }
        Ok(track)
    }

    /// The largest distance between the bodies of two runs, or arc between their angles; infinite where one
    /// is no number.
    pub fn apart(&self, a: &Track, b: &Track) -> f64 {
        let circle = self.circle.map(f64::from);
        let distance = |(a, b): (&Place, &Place)| {
            let (turned, d) = (a.angle - b.angle, a.at - b.at);
            let around = circle.map_or(0.0, |c| c * (d.x / c).round());
            let arc = TAU * ARM * (turned - turned.round()).abs();
            [(d.x - around).hypot(d.y), arc]
        };
        let all = a.iter().zip(b).flat_map(distance);
        all.fold(0.0, |most, d| match d.partial_cmp(&most) {
            Some(Ordering::Greater) => d,
            Some(_) => most,
            None => f64::INFINITY,
        })
    }
}

/// Where x has passed half of the circle it goes to the other side; both are sums, which lose nothing.
fn wrap<B: Body, const N: usize>(world: &mut World<B, N>, around: Vec2<B::S>) {
    let half = 0.5 * around.to_f64().x;
    for (_, body) in world.iter_mut() {
        let x = body.position().to_f64().x;
        if x >= half {
            body.shift(-around);
        } else if x < -half {
            body.shift(around);
        }
    }
}

/// A step of `1 / 2^shift` seconds whose shift is known at run time only, for numbers that take notes.
#[derive(Clone, Copy, Debug)]
pub struct Dyadic {
    shift: u32,
    of_a_second: Step<Recorded>,
}

impl Dyadic {
    pub fn new(shift: u32) -> Result<Dyadic, Error> {
        let of_a_second = Step::from_seconds(Ratio::new(1, 1 << shift)?)?;
        Ok(Dyadic { shift, of_a_second })
    }
}

impl TimeStep<Recorded> for Dyadic {
    fn coef(&self) -> <Recorded as Scalar>::Coef {
        TimeStep::coef(&self.of_a_second)
    }

    fn times(&self, rate: Recorded) -> Recorded {
        rate.dyadic(1, self.shift)
    }

    fn half_times(&self, rate: Recorded) -> Recorded {
        rate.dyadic(1, self.shift + 1)
    }

    fn seconds(&self) -> Ratio {
        self.of_a_second.seconds()
    }
}
