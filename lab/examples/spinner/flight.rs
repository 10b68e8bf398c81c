//! One body through `World::step`: a push between steps, then a thruster and a drag as forces.

use fixstep::rigid::Centre;
use fixstep::rigid::torque::{SpinDrag, Wrench};
use fixstep::{
    Decay, Error, PerBody, Point, Rigid, Rotating, Step, Time, Vec2, Verlet, Window, World, vec2,
};

use crate::exact::Motion;
use crate::lane::{BURN, Lane, NOZZLE, RATE, SPIN_DRAG, THRUST, TICKS};
use crate::table::{looks, motion};

/// The body as it was just pushed, and after each step.
pub fn fly<C>(lane: Lane) -> Result<Vec<Rigid<C>>, Error>
where
    C: Centre<S: Decay> + From<Point<C::S>>,
{
    let mut world = World::<Rigid<C>, 1>::new();
    let id = world.add(lane.start()?)?;
    lane.push(world.get_mut(id)?)?;

    let (nozzle, thrust) = (vec2(0, NOZZLE)?, vec2(THRUST, 0)?);
    let thruster = PerBody(|_: Time, gear: &Rigid<C>| {
        let axes = gear.rotation();
        Wrench::at(axes.rotate(nozzle), axes.rotate(thrust))
    });
    let burn = (lane == Lane::Gear).then(|| Window::new(0..BURN.into(), thruster));
    let air = (lane == Lane::Braked).then(|| SpinDrag::new(SPIN_DRAG));
    let (mut forces, step) = ((burn, air.transpose()?), Step::hz(RATE as i32)?);

    let mut seen = world.bodies().to_vec();
    for _ in 0..TICKS {
        world.step(&mut Verlet, &mut forces, &step);
        seen.extend(world.bodies());
    }
    Ok(seen)
}

/// What the body does at both looks of the table.
pub fn found<C>(lane: Lane) -> Result<[Motion; 2], Error>
where
    C: Centre<S: Decay> + From<Point<C::S>>,
{
    let seen = fly::<C>(lane)?;
    Ok(looks(lane).map(|tick| motion(&seen[tick as usize])))
}

/// Where points of a body, in its own axes, are in the world; for drawing.
pub fn placed<C: Centre>(body: &Rigid<C>, own: &[Vec2<f64>]) -> Vec<Vec2<f64>> {
    let at = body.position().to_f64();
    let (sin, cos) = (body.angle().to_f64() * std::f64::consts::TAU).sin_cos();
    let turned = |p: &Vec2<f64>| Vec2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
    own.iter().map(|point| at + turned(point)).collect()
}
