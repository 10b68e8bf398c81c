//! A scene that names every verb of exact drags, exact springs, bodies that carry and methods of order
//! 4; beside `every_verb.rs`, since all in one image would not fit the smaller board.

use core::hint::black_box;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::integrate::damp;
use fixstep::time::Now;
use fixstep::world::snapshot::HEADER;
use fixstep::{
    AllPairs, Anchor, Ballistic, Body, Carried, Carry, ConstantAcceleration, Decay, DyadicStep,
    Error, Euler, ExactDrag, ExactPair, ExactQuadraticDrag, ExactSpring, Force, GravityY,
    LinearDrag, Method, Pairs, Part, Pefrl, Point, Pull, Push, QuadraticDrag, Rk4, Scalar,
    SemiImplicitEuler, Spring, Step, Stored, TimeStep, Vec2, Verlet, Window, World, dec, vec2,
};

const N: usize = 4;

/// Four bodies of three masses.
fn world<B: Body + From<Point<B::S>>>() -> Result<World<B, N>, Error> {
    let mut world = World::new();
    for (x, mass) in [(0, dec!(1)), (2, dec!(1.37)), (5, dec!(2.91)), (8, dec!(1))] {
        let point = Point::new(vec2(black_box(x), 1)?, vec2(1, 2)?, mass)?;
        let _ = world.add(point.into());
    }
    Ok(world)
}

fn steps<B: Body>(
    world: &mut World<B, N>,
    method: &mut impl Method<B, N>,
    forces: &mut impl Force<B>,
    step: &impl TimeStep<B::S>,
) -> u64 {
    (0..100).for_each(|_| world.step(method, forces, step));
    world.state_hash().rotate_left(world.tick() as u32 & 31)
}

/// Springs that flow, beside kicks; and a flight that flows.
fn flows<B>(method: &mut impl Method<B, N>, step: &impl TimeStep<B::S>) -> Result<u64, Error>
where
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let mut scene = world::<B>()?;
    let Ok([a, b, c, d]) = <[_; N]>::try_from(scene.ids()) else {
        return Ok(0);
    };
    let tied = ExactSpring::new(a, vec2(1, 1)?, black_box(dec!(0.7)), dec!(0.2))?;
    let free = ExactSpring::new(d, vec2(8, 0)?, dec!(25.7), 0)?;
    let mut forces = (
        GravityY::new(-5)?,
        [tied.with_gravity(vec2(0, -5)?)?, free],
        ExactPair::new([b, c], vec2(2, 0)?, black_box(dec!(1.1)), dec!(0.1))?,
        Window::new(20..60, Push::new(b, vec2(1, 3)?)),
        (
            ExactDrag::new(dec!(0.1))?,
            ExactQuadraticDrag::new(black_box(dec!(0.02)))?,
        ),
    );
    let sum = steps(&mut scene, method, &mut forces, step);
    let mut flight = Ballistic::new(vec2(dec!(0.5), -5)?, black_box(dec!(0.3)))?;
    Ok(sum ^ steps(&mut scene, method, &mut flight, step))
}

/// What kicks and damps, for methods that no flow goes with.
fn kicks<B>(method: &mut impl Method<B, N>, step: &impl TimeStep<B::S>) -> Result<u64, Error>
where
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let mut scene = world::<B>()?;
    let Ok([a, b, c, d]) = <[_; N]>::try_from(scene.ids()) else {
        return Ok(0);
    };
    let mut forces = (
        GravityY::new(-5)?,
        Anchor::new(a, vec2(1, 1)?, black_box(9), dec!(0.2))?,
        Pairs::new(
            Spring::new(2, black_box(dec!(9.5)), dec!(0.5))?,
            [[b, c], [c, d]],
        ),
        AllPairs(Pull::new(black_box(dec!(0.7)), dec!(0.5))?),
        (LinearDrag::new(dec!(0.2))?, QuadraticDrag::new(dec!(0.03))?),
        [Some(ExactDrag::new(black_box(dec!(0.1)))?)],
    );
    Ok(steps(&mut scene, method, &mut forces, step))
}

/// A body that carries, by its verbs, and saved and read again.
fn carried<S>() -> Result<u64, Error>
where
    S: Carry + Decay + Scalar<InvMass: Stored> + Stored,
{
    let step = Step::<S>::hz(60)?;
    let mut sum = flows::<Carried<S>>(&mut SemiImplicitEuler, &step)?
        ^ flows::<Carried<S>>(&mut Verlet, &DyadicStep::<S, 4389, 18>::new()?)?
        ^ kicks::<Carried<S>>(&mut SemiImplicitEuler, &DyadicStep::<S, 1, 6>::new()?)?;
    let mut scene = world::<Carried<S>>()?;
    for (_, body) in scene.iter_mut() {
        body.push(vec2(black_box(3), -1)?);
        body.teleport(vec2(2, 2)?)?;
        body.shift(vec2(0, dec!(0.5))?);
        body.set_velocity(vec2(0, 3)?)?;
        body.kick(vec2(1, 0)?);
        sum ^= body.position().x.bits() ^ body.velocity().y.bits();
    }
    let now = Now::end(&step, scene.tick());
    let mut bodies = [Carried::<S>::new(Vec2::ZERO, vec2(4, 0)?, 2)?];
    let mut drag = ExactDrag::new(1)?;
    Force::<Carried<S>>::prepare(&mut drag, &now);
    damp(&mut bodies, &mut drag, &now, Part::Whole);
    let mut bytes = [0; HEADER + 36 * N];
    let saved = scene.save(&mut bytes).ok();
    let saved = saved.and_then(|length| bytes.get(..length));
    let again = World::<Carried<S>, N>::load(black_box(saved.unwrap_or_default()));
    let hash = again.map_or(0, |again| again.state_hash());
    Ok(sum ^ hash ^ bodies.first().map_or(0, |body| body.velocity().x.bits()))
}

/// The hash over two number types, with and without remainders.
pub fn hash() -> Result<u64, Error> {
    let step = Step::<I16F16>::hz(60)?;
    let fixed = flows::<Point<I16F16>>(&mut SemiImplicitEuler, &step)?
        ^ flows::<Point<I16F16>>(&mut Verlet, &step)?.rotate_left(1)
        ^ kicks::<Point<I16F16>>(&mut Euler::new(), &step)?.rotate_left(2)
        ^ kicks::<Point<I16F16>>(&mut ConstantAcceleration::new(), &step)?.rotate_left(3)
        ^ kicks::<Point<I16F16>>(&mut Rk4::new(), &step)?.rotate_left(4)
        ^ kicks::<Point<I16F16>>(&mut Pefrl::new(), &step)?.rotate_left(5);
    let step = Step::<f32>::hz(60)?;
    let float = flows::<Point<f32>>(&mut Verlet, &step)?
        ^ kicks::<Point<f32>>(&mut Rk4::new(), &step)?.rotate_left(1)
        ^ kicks::<Point<f32>>(&mut Pefrl::new(), &step)?.rotate_left(2);
    Ok(fixed ^ float ^ carried::<I8F24>()? ^ carried::<f32>()?.rotate_left(1))
}
