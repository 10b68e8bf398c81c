//! Three scenes that name every force between them, with bodies that come and go. What happens at a
//! tick depends on nothing but the world and the tick, as in a program that can be restarted.

use fixstep::{
    AllBodies, AllPairs, Anchor, BodyId, Force, Gravity, GravityY, LinearDrag, Pairs, PerBody,
    Pull, Push, QuadraticDrag, Scalar, Spring, Time, Vec2, Window, World, dec, heapless, vec2,
};

use super::cast::Cast;
use crate::support::{point, spread};

pub const ROOM: usize = 7;
/// Bodies at the start; forces name these.
pub const FIRST: usize = 5;

pub type Scene<B> = World<B, ROOM>;

/// Start values and masses from the golden ratio, within what an `I8F24` holds.
fn newcomer<B: Cast>(seed: usize) -> B {
    let part = |k: usize| 2.0 * spread(8 * seed + k) - 1.0;
    let position = [6.0 * part(0), 6.0 * part(1)];
    let velocity = [2.0 * part(2), 2.0 * part(3)];
    B::of(point(position, velocity, 1.5 + part(4)), seed)
}

pub fn start<B: Cast>(seed: usize) -> Scene<B> {
    let mut world = World::new();
    for i in 0..FIRST {
        world.add(newcomer(FIRST * seed + i)).unwrap();
    }
    world
}

/// What the program does before each step: takes bodies out, adds some, pushes one.
pub fn events<B: Cast>(world: &mut Scene<B>) {
    let tick = world.tick() as usize;
    let bodies = world.len();
    match tick % 101 {
        17 | 40 => {
            let _ = world.add(newcomer(tick));
        }
        29 if bodies > 1 => {
            let id = world.ids()[tick % bodies];
            world.remove(id).unwrap();
        }
        53 => world.retain(|_, body| body.position().x < B::S::MAX),
        71 => {
            for (_, body) in world.iter_mut().take(1) {
                body.push(vec2(1, dec!(-0.5)).unwrap());
            }
        }
        97 if tick > 300 => world.retain(|id, _| id.serial() % 3 != 0),
        _ => {}
    }
}

/// The body with that number, if it is still there: all that a program knows after a restart.
pub fn named<B: Cast>(world: &Scene<B>, serial: u32) -> Option<BodyId> {
    let mut ids = world.ids().iter().copied();
    ids.find(|id| id.serial() == serial)
}

/// Forces that need but the body itself: the methods make no copy of the bodies.
pub fn flight<B: Cast>(_: &Scene<B>) -> impl Force<B> + use<B> {
    let wind = |time: Time, body: &B| {
        let gust = time
            .seconds::<B::S>()
            .times(B::S::ratio(dec!(0.02)).unwrap());
        let blows = time.half_ticks() % 64 < 32;
        Vec2::new(
            if blows {
                gust.times(body.position().y)
            } else {
                B::S::ZERO
            },
            B::S::ZERO,
        )
    };
    (
        Gravity::new(vec2(dec!(0.03), dec!(-0.11)).unwrap()),
        GravityY::new(dec!(-0.07)).unwrap(),
        LinearDrag::new(dec!(0.021)).unwrap(),
        QuadraticDrag::new(dec!(0.013)).unwrap(),
        PerBody(wind),
        Window::new(60..240, GravityY::new(dec!(0.31)).unwrap()),
    )
}

/// Forces that name bodies, and one that computes all from all.
pub fn tied<B: Cast>(world: &Scene<B>) -> impl Force<B> + use<B> {
    let anchor = |serial, x, k| {
        let at = vec2(x, 1).unwrap();
        named(world, serial).map(|id| Anchor::new(id, at, k, dec!(0.2)).unwrap())
    };
    let mut chain = heapless::Vec::<[BodyId; 2], FIRST>::new();
    for serial in 1..FIRST as u32 {
        let pair = [serial - 1, serial].map(|serial| named(world, serial));
        if let [Some(one), Some(other)] = pair {
            chain.push([one, other]).unwrap();
        }
    }
    let swarm = |_: Time, all: &[B], i: usize| {
        let next = all[(i + 1) % all.len()].position();
        (next - all[i].position()).scaled(B::S::ratio(dec!(0.03)).unwrap().coef())
    };
    let thrust = named(world, 1).map(|id| Push::new(id, vec2(dec!(0.3), dec!(0.7)).unwrap()));
    (
        [anchor(0, 1, dec!(3.1)), anchor(2, -2, dec!(1.7))],
        Pairs::new(Spring::new(2, dec!(2.3), dec!(0.4)).unwrap(), chain),
        AllBodies::<_, B::S, ROOM>::new(swarm),
        Window::new(33..400, thrust),
    )
}

/// Gravitation, with drag behind it in the order of forces.
pub fn stars<B: Cast>(world: &Scene<B>) -> impl Force<B> + use<B> {
    let push = named(world, 3).map(|id| Push::new(id, vec2(dec!(-0.2), 0).unwrap()));
    (
        AllPairs(Pull::new(dec!(0.9), dec!(0.6)).unwrap()),
        LinearDrag::new(dec!(0.017)).unwrap(),
        push,
    )
}
