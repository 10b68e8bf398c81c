//! A scene that names every verb of the crate, for images in which the linker looks for panics and
//! for hashes that must agree.

use core::hint::black_box;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::integrate::{drift, drift_half, kick};
use fixstep::time::Now;
use fixstep::world::snapshot::HEADER;
use fixstep::{
    Accumulator, AllBodies, AllPairs, Anchor, Between, Body, BodyId, CentreOfMass,
    ConstantAcceleration, DyadicStep, Error, Euler, Force, Gravity, GravityY, LinearDrag, Method,
    Pairs, PerBody, Point, PointMass, PositionOnly, Pull, Push, QuadraticDrag, RangeChecked,
    Rewinds, Scalar, SemiImplicitEuler, Spring, Step, Stored, Time, TimeStep, Vec2, Verlet, Window,
    World, dec, heapless, vec2,
};
const N: usize = 4;

type Ball = RangeChecked<Point<I16F16>>;

/// Every force at once.
fn forces<S: Scalar>([a, b, c]: [BodyId; 3]) -> Result<impl Force<Point<S>>, Error> {
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
    let pull = Pull::new(black_box(dec!(0.7)), dec!(0.5))?;
    let mut list = heapless::Vec::<[BodyId; 2], 2>::new();
    let _ = list.push([b, c]);
    Ok((
        (
            Gravity::new(vec2(dec!(0.1), -5)?),
            GravityY::new(-1)?,
            LinearDrag::new(dec!(0.2))?,
            QuadraticDrag::new(black_box(dec!(0.03)))?,
        ),
        [
            Anchor::new(a, vec2(1, 1)?, 20, 1)?,
            Anchor::new(c, vec2(0, 1)?, 30, 0)?,
        ],
        Pairs::new(Spring::new(2, black_box(dec!(9.5)), dec!(0.5))?, [[a, b]]),
        (PerBody(wind), AllBodies::<_, S, N>::new(swarm)),
        (Pairs::new(pull, list), Some(AllPairs(pull))),
        Window::new(black_box(20)..50, Push::new(b, vec2(3, 2)?)),
    ))
}

fn scene<S: Scalar<InvMass: Stored> + Stored>(
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
    let mut forces = forces([a, b, c])?;
    for _ in 0..100 {
        world.step(method, &mut forces, step);
    }
    let mut sum = beside(&mut world, method, &mut forces, step)?;
    if let Ok(body) = world.get_mut(b) {
        body.push(vec2(1, 2)?);
        body.teleport(vec2(2, 2)?)?;
        body.set_velocity(vec2(0, 0)?)?;
    }
    if let (Ok(gone), Err(stale)) = (world.remove(c), world.remove(c)) {
        sum ^= gone.position().y.bits() ^ stale.0.serial() as u64;
    }
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
    while let Ok(id) = world.add(at(1, 1)?) {
        sum ^= id.serial() as u64;
    }
    let full = world.add(at(0, 0)?).err();
    Ok(hash ^ sum ^ full.map_or(0, |full| full.capacity as u64))
}

/// What is done beside the steps: frames, pictures, snapshots, bodies of many points.
fn beside<S: Scalar<InvMass: Stored> + Stored>(
    world: &mut World<Point<S>, N>,
    method: &mut impl Method<Point<S>, N>,
    forces: &mut impl Force<Point<S>>,
    step: &impl TimeStep<S>,
) -> Result<u64, Error> {
    let mut clock = Accumulator::new(black_box(32_768), step.seconds(), 3)?;
    let due = clock.advance(black_box(700));
    let part = Between::new(clock.fraction(), step)?;
    let before = world.clone();
    for _ in 0..due.steps {
        world.step(method, forces, step);
    }
    let drawn = world.between(&before, method, &part);
    let mut sum = drawn.fold(due.dropped, |sum, (_, at)| sum ^ at.x.bits() ^ at.y.bits());
    sum ^= clock.advance(black_box(u64::MAX)).dropped; // needs 128 bits
    clock.reset();
    sum ^= world.time(step).half_ticks() ^ world.time(step).seconds::<S>().bits();

    let mut bytes = [0; HEADER + 24 * N];
    let saved = world
        .save(&mut bytes)
        .ok()
        .and_then(|length| bytes.get(..length));
    match World::load(black_box(saved.unwrap_or_default())) {
        Ok(again) => *world = again,
        Err(_) => sum = !sum,
    }
    if World::<Point<S>, 1>::load(&bytes).is_err() && world.save(&mut []).is_err() {
        sum ^= u32::from_le_bytes([bytes[36], bytes[37], bytes[38], bytes[39]]) as u64;
    }
    let [ball, other] = [dec!(1), black_box(dec!(2.5))].map(|mass| PointMass {
        position: Vec2::new(S::MAX, S::ZERO),
        velocity: Vec2::ZERO,
        mass,
    });
    let whole = CentreOfMass::new(black_box(&[ball, other]))?.point()?;
    Ok(sum ^ whole.position().x.bits() ^ whole.inv_mass().store())
}

fn scalar<S: Scalar<InvMass: Stored> + Stored>() -> Result<u64, Error> {
    let (step, dyadic) = (Step::<S>::hz(60)?, DyadicStep::<S, 4389, 18>::new()?);
    Ok(scene(&mut Euler::new(), &step)?
        ^ scene(&mut ConstantAcceleration::new(), &dyadic)?
        ^ scene(&mut SemiImplicitEuler, &DyadicStep::<S, 1, 6>::new()?)?
        ^ scene(&mut Verlet, &step)?)
}

/// Out and back by every force that can; zero if the world returns.
fn returned(method: &mut impl Rewinds<Ball, N>) -> Result<u64, Error> {
    let mut world = World::<Ball, N>::new();
    let at =
        |x, y| Point::new(vec2(black_box(x), y)?, vec2(0, 1)?, dec!(1.5)).map(RangeChecked::new);
    let (a, b) = (world.add(at(0, 0)?)?, world.add(at(3, 4)?)?);
    let tide = |time: Time, _: &Ball| {
        vec2(1, 0).map_or(Vec2::ZERO, |v| v.scaled(time.seconds::<I16F16>().coef()))
    };
    let swarm =
        |_: Time, all: &[Ball], i: usize| all.get(i).map_or(Vec2::ZERO, |body| -body.position());
    let mut list = heapless::Vec::<_, 2>::new();
    let _ = list.push(Pairs::new(
        Spring::new(2, black_box(dec!(9.5)), 0)?,
        [[a, b]],
    ));
    let mut forces = (
        (Gravity::new(vec2(dec!(0.1), -5)?), GravityY::new(-1)?),
        [Anchor::new(a, vec2(1, 1)?, 20, 0)?],
        (
            list,
            Some(AllPairs(Pull::new(black_box(dec!(0.7)), dec!(0.5))?)),
        ),
        PositionOnly(PerBody(tide)),
        PositionOnly(AllBodies::<_, I16F16, N>::new(swarm)),
        Window::new(black_box(20)..50, Push::new(b, vec2(3, 2)?)),
    );
    let (start, step) = (world.state_hash(), Step::hz(60)?);
    (0..100).for_each(|_| world.step(method, &mut forces, &step));
    while world.step_back(method, &mut &mut forces, &step).is_ok() {}
    let (hash, tick) = (world.state_hash(), world.tick());
    for (_, ball) in world.iter_mut() {
        ball.change(|point| point.teleport(Vec2::new(I16F16::MAX, I16F16::ZERO)))?;
        ball.forget();
    }
    let kept = world.bodies().iter().all(RangeChecked::was_outside);
    Ok(hash ^ start ^ tick ^ u64::from(!kept))
}

/// The hash over every method in two number types, and over one method in a third.
pub fn hash() -> Result<u64, Error> {
    let third = scene(&mut Verlet, &Step::<I8F24>::hz(60)?)?;
    let third = third ^ returned(&mut SemiImplicitEuler)? ^ returned(&mut Verlet)?.rotate_left(1);
    Ok(scalar::<I16F16>()? ^ third ^ scalar::<f32>()?)
}
