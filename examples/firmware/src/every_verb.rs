//! A scene that names every verb of the crate, for images in which the linker looks for panics and
//! for hashes that must agree. The host tests run the same file.

use core::hint::black_box;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::integrate::{drift, drift_half, kick};
use fixstep::time::Now;
use fixstep::{
    AllBodies, Anchor, Body, ConstantAcceleration, DyadicStep, Error, Euler, Gravity, GravityY,
    LinearDrag, Method, Pairs, PerBody, Point, Scalar, SemiImplicitEuler, Spring, Step, Time,
    TimeStep, Vec2, Verlet, World, dec, vec2,
};
const N: usize = 4;

fn scene<S: Scalar>(
    method: &mut impl Method<Point<S>, N>,
    step: &impl TimeStep<S>,
) -> Result<u64, Error> {
    let mut world = World::<Point<S>, N>::new();
    let at = |x, y| Point::<S>::new(vec2(black_box(x), y)?, vec2(0, 1)?, dec!(1.5));
    let (Ok(a), Ok(b), Ok(c)) = (
        world.add(at(0, 0)?),
        world.add(at(3, 4)?),
        world.add(at(-3, 1)?),
    ) else {
        return Ok(0);
    };
    let wind = |time: Time, body: &Point<S>| {
        Vec2::new(time.seconds::<S>().times(body.position().x), S::ZERO)
    };
    let swarm = |_: Time, all: &[Point<S>], i: usize| {
        all.iter()
            .zip(all.get(i))
            .fold(Vec2::ZERO, |sum, (other, body)| {
                sum + (other.position() - body.position())
            })
    };
    let mut forces = (
        Gravity::new(vec2(dec!(0.1), -5)?),
        GravityY::new(-1)?,
        LinearDrag::new(dec!(0.2))?,
        [
            Anchor::new(a, vec2(1, 1)?, 20, 1)?,
            Anchor::new(c, vec2(0, 1)?, 30, 0)?,
        ],
        Pairs::new(Spring::new(2, black_box(dec!(9.5)), dec!(0.5))?, [[a, b]]),
        (PerBody(wind), AllBodies::<_, S, N>::new(swarm)),
    );
    for _ in 0..100 {
        world.step(method, &mut forces, step);
    }
    if let Ok(body) = world.get_mut(b) {
        body.push(vec2(1, 2)?);
        body.teleport(vec2(2, 2)?)?;
        body.set_velocity(vec2(0, 0)?)?;
    }
    let _ = world.remove(c);
    world.retain(|id, body| id != a || body.is_inside());
    for (_, body) in world.iter_mut() {
        body.kick(vec2(0, 1)?);
    }
    let (ids, mut bodies) = (world.ids(), [at(1, 1)?, at(2, 2)?]);
    let now = Now::start(step, world.tick());
    kick(ids, &mut bodies, &mut forces, &now);
    drift(&mut bodies, &now);
    drift_half(&mut bodies, &now);
    black_box((bodies, world.out_of_range().count(), world.iter().len()));
    let hash = world.state_hash();
    world.clear();
    Ok(hash)
}

fn scalar<S: Scalar>() -> Result<u64, Error> {
    let (step, dyadic) = (Step::<S>::hz(60)?, DyadicStep::<S, 4389, 18>::new()?);
    Ok(scene(&mut Euler::new(), &step)?
        ^ scene(&mut ConstantAcceleration::new(), &dyadic)?
        ^ scene(&mut SemiImplicitEuler, &DyadicStep::<S, 1, 6>::new()?)?
        ^ scene(&mut Verlet, &step)?)
}

/// The hash over every method and three number types.
pub fn hash() -> Result<u64, Error> {
    Ok(scalar::<I16F16>()? ^ scalar::<I8F24>()? ^ scalar::<f32>()?)
}
