//! A scene as data, built in any number type with any body; and the scenes of the drift example as such.

use fixstep::heapless;
use fixstep::{
    AllPairs, Anchor, Body, BodyId, Error, Gravity, LinearDrag, Pairs, Point, Pull, QuadraticDrag,
    Ratio, Scalar, Spring, Vec2, World,
};

use crate::scene::{self, Law, Start};

/// No scene has more bodies, anchors or springs.
pub const ROOM: usize = 3;

/// A spring between two bodies, or one and a point: stiffness and damping.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    pub stiffness: f64,
    pub damping: f64,
}

/// Bodies and the forces between them.
#[derive(Clone, Debug, Default)]
pub struct Described {
    pub bodies: Vec<Start>,
    /// m/s²
    pub gravity: Option<Vec2<f64>>,
    /// kg/s
    pub linear: Option<f64>,
    /// kg/m
    pub quadratic: Option<f64>,
    /// Body, point, spring.
    pub anchors: Vec<(usize, Vec2<f64>, Held)>,
    /// Both bodies, rest length, spring.
    pub springs: Vec<([usize; 2], f64, Held)>,
    /// Constant and softening of a pull between all bodies.
    pub pull: Option<[f64; 2]>,
}

/// All forces that a described scene may have.
pub type Forces<S> = (
    Option<Gravity<S>>,
    Option<LinearDrag<S>>,
    Option<QuadraticDrag<S>>,
    heapless::Vec<Anchor<S>, ROOM>,
    heapless::Vec<Pairs<Spring<S>, [[BodyId; 2]; 1]>, ROOM>,
    Option<AllPairs<Pull<S>>>,
);

fn real(value: f64) -> Result<Ratio, Error> {
    Ok(Ratio::from_f64(value)?)
}

fn vector<S: Scalar>(v: Vec2<f64>) -> Result<Vec2<S>, Error> {
    fixstep::vec2(real(v.x)?, real(v.y)?)
}

impl Described {
    /// Puts the bodies into `world`, each as `body` makes it of a point. What does not fit into [`ROOM`] is
    /// left out.
    pub fn build<B: Body, const N: usize>(
        &self,
        world: &mut World<B, N>,
        body: impl Fn(Point<B::S>) -> B,
    ) -> Result<Forces<B::S>, Error> {
        for start in &self.bodies {
            let (position, velocity) = (vector(start.position)?, vector(start.velocity)?);
            world.add(body(Point::new(position, velocity, real(start.mass)?)?))?;
        }
        let ids = world.ids();
        let mut anchors = heapless::Vec::new();
        for &(of, point, Held { stiffness, damping }) in &self.anchors {
            let _ = anchors.push(Anchor::new(
                ids[of],
                vector(point)?,
                real(stiffness)?,
                real(damping)?,
            )?);
        }
        let mut springs = heapless::Vec::new();
        for &(ends, rest, Held { stiffness, damping }) in &self.springs {
            let spring = Spring::new(real(rest)?, real(stiffness)?, real(damping)?)?;
            let _ = springs.push(Pairs::new(spring, [ends.map(|end| ids[end])]));
        }
        let gravity = self.gravity.map(|g| vector(g).map(Gravity::new));
        let linear = self.linear.map(|k| LinearDrag::new(real(k)?));
        let quadratic = self.quadratic.map(|k| QuadraticDrag::new(real(k)?));
        let pull = self.pull.map(|[g, e]| Pull::new(real(g)?, real(e)?));
        Ok((
            gravity.transpose()?,
            linear.transpose()?,
            quadratic.transpose()?,
            anchors,
            springs,
            pull.transpose()?.map(AllPairs),
        ))
    }

    /// Start `index` of a scene of the drift example, with its second body, if far, at `distance`.
    pub fn of_drift(scene: &scene::Scene, index: usize, distance: f64) -> Described {
        let mut described = Described {
            bodies: scene.bodies(index, distance),
            ..Described::default()
        };
        let down = |g: f64| Some(Vec2::new(0.0, -g));
        let held = |stiffness| Held {
            stiffness,
            damping: 0.0,
        };
        match scene.law {
            Law::Free => {}
            Law::Gravity { g } => described.gravity = down(g),
            Law::Drag { k } => described.linear = Some(k),
            Law::GravityAndDrag { g, k } => {
                (described.gravity, described.linear) = (down(g), Some(k));
            }
            Law::Anchor { k } => described.anchors.push((0, Vec2::new(0.0, 0.0), held(k))),
            Law::Spring { k, rest } => described.springs.push(([0, 1], rest, held(k))),
        }
        described
    }
}
