//! The bodies, their forces and the edges of the room, in any number type.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Anchor, BodyId, Decay, Error, ExactDrag, GravityY, Pairs, Point, Spring, TimeStep, Vec2,
    Verlet, World, dec, heapless, vec2,
};

/// Bodies: four of a chain, two of a dumbbell, three balls.
pub const BODIES: usize = 9;

/// Who hangs on whom.
pub const LINKS: [[usize; 2]; 4] = [[0, 1], [1, 2], [2, 3], [4, 5]];

/// Pixels of a metre, as a power of two.
const ZOOM: u32 = 4;
/// Where the floor is on the screen.
const FLOOR: i32 = 131;

/// A place on the screen.
#[derive(Clone, Copy)]
pub struct Place {
    pub x: i32,
    pub y: i32,
}

/// A number type of the showcase.
pub trait Shown: Decay {
    /// The number in units of 2^-16, towards nothing.
    fn shown(self) -> i32;
}

impl Shown for I16F16 {
    fn shown(self) -> i32 {
        self.to_bits()
    }
}

impl Shown for I8F24 {
    fn shown(self) -> i32 {
        self.to_bits() >> 8
    }
}

impl Shown for f32 {
    fn shown(self) -> i32 {
        (self * 65_536.0) as i32
    }
}

type Forces<S> = (
    Pairs<Spring<S>, heapless::Vec<[BodyId; 2], { LINKS.len() }>>,
    Anchor<S>,
    GravityY<S>,
    ExactDrag<S>,
);

/// A world, what acts in it and the room it is in.
pub struct Scene<S: Shown> {
    world: World<Point<S>, BODIES>,
    forces: Forces<S>,
    low: Vec2<S>,
    high: Vec2<S>,
    jump: S,
}

impl<S: Shown> Scene<S> {
    /// The scene at its start.
    pub fn new() -> Result<Scene<S>, Error> {
        let mut world = World::new();
        let start = [
            (vec2(dec!(7.5), 7)?, vec2(0, 0)?),
            (vec2(dec!(8.6), dec!(7.1))?, vec2(0, 0)?),
            (vec2(dec!(9.7), dec!(7.2))?, vec2(0, 0)?),
            (vec2(dec!(10.8), dec!(7.3))?, vec2(0, 1)?),
            (vec2(2, 6)?, vec2(3, 1)?),
            (vec2(3, dec!(6.6))?, vec2(3, -3)?),
            (vec2(1, 3)?, vec2(dec!(3.3), 2)?),
            (vec2(13, 5)?, vec2(dec!(-2.2), 0)?),
            (vec2(14, 2)?, vec2(-5, 3)?),
        ];
        for (position, velocity) in start {
            let _ = world.add(Point::new(position, velocity, 1)?);
        }
        let mut links = heapless::Vec::new();
        for link in LINKS {
            if let [Some(&from), Some(&to)] = link.map(|i| world.ids().get(i)) {
                let _ = links.push([from, to]);
            }
        }
        let &[hook, ..] = world.ids() else {
            return Err(Error::Empty { field: "bodies" });
        };
        let forces = (
            Pairs::new(Spring::new(dec!(1.1), 90, 0)?, links),
            Anchor::new(hook, vec2(dec!(7.5), 7)?, 300, 0)?,
            GravityY::new(dec!(-9.81))?,
            ExactDrag::new(dec!(0.01))?,
        );
        Ok(Scene {
            world,
            forces,
            low: vec2(0, 0)?,
            high: vec2(15, dec!(7.5))?,
            jump: S::ratio(dec!(9)).unwrap_or(S::MAX),
        })
    }

    /// A step of the library, then the edges.
    #[inline(always)]
    pub fn step<H: TimeStep<S>>(&mut self, step: &H) {
        self.world.step(&mut Verlet, &mut self.forces, step);
        let (low, high, jump) = (self.low, self.high, self.jump);
        for (_, body) in self.world.iter_mut() {
            let (mut at, mut v) = (body.position(), body.velocity());
            if at.x < low.x || at.x > high.x || at.y < low.y || at.y > high.y {
                reflect(&mut at.x, &mut v.x, low.x, high.x);
                if reflect(&mut at.y, &mut v.y, low.y, high.y) && v.y < jump {
                    v.y = jump;
                }
                let _ = body.teleport(at);
                let _ = body.set_velocity(v);
            }
        }
    }

    /// Where the bodies are, m.
    pub fn positions(&self) -> Positions {
        let mut all = [Vec2::ZERO; BODIES];
        for (at, body) in all.iter_mut().zip(self.world.bodies()) {
            *at = body.position().map(|x| I16F16::from_bits(x.shown()));
        }
        all
    }
}

/// Positions of all bodies in a type that all types can be shown in.
pub type Positions = [Vec2<I16F16>; BODIES];

/// Where that is on the screen.
pub fn place(at: Vec2<I16F16>) -> Place {
    Place {
        x: at.x.to_bits() >> (16 - ZOOM),
        y: FLOOR - (at.y.to_bits() >> (16 - ZOOM)),
    }
}

/// Mirrors a coordinate at the edge it is behind; whether that was the lower one, which throws a body
/// back with no less than `jump`: a trampoline, or drag would end the show.
#[inline(always)]
fn reflect<S: Shown>(at: &mut S, v: &mut S, low: S, high: S) -> bool {
    let below = *at < low;
    if below || *at > high {
        let edge = if below { low } else { high };
        *at = edge.plus(edge.minus(*at));
        if (*v < S::ZERO) == below {
            *v = v.negated();
        }
    }
    below
}
