//! Eight points and one force at a time: what a force costs is the difference to the same scene
//! without it.

use core::hint::black_box;
use core::marker::PhantomData;

use fixstep::fixed::types::I16F16;
use fixstep::world::snapshot::HEADER;
use fixstep::{
    Accumulator, AllPairs, Anchor, Ballistic, Between, Body, BodyId, Carried, Decay, Error,
    ExactDrag, ExactPair, ExactQuadraticDrag, ExactSpring, Force, LinearDrag, Pairs, PerBody,
    Point, Pull, Push, QuadraticDrag, Scalar, SemiImplicitEuler, Spring, Step, Stored, Time, Vec2,
    World, dec, vec2,
};

use super::{Meter, Name, Start, TICKS};

/// Points in the scene.
pub const POINTS: usize = 8;

/// The world of the scene.
pub type Eight<B> = World<B, POINTS>;

/// Points of 1.5 kg on two rows, each with another velocity.
pub fn build<B: Body + From<Point<B::S>>>(world: &mut Eight<B>) -> Result<(), Error> {
    world.clear();
    for i in 0..POINTS as i32 {
        let position = vec2(3 * i - 11, 5 * (i & 1) - i)?;
        let point = Point::new(position, vec2(i - 3, 4 - i)?, dec!(1.5))?;
        let _ = world.add(point.into());
    }
    Ok(())
}

/// Shows forces to a meter, by name.
struct Shown<'a, M, B: Body> {
    meter: &'a mut M,
    scalar: &'static str,
    body: PhantomData<B>,
}

impl<M: Meter, B: Body + From<Point<B::S>>> Shown<'_, M, B> {
    fn force<F: Force<B>>(
        &mut self,
        force: &'static str,
        units: u32,
        mut forces: F,
    ) -> Result<(), Error> {
        let mut world = Eight::<B>::new();
        build(&mut world)?;
        let start = Start {
            world: &mut world,
            method: &mut SemiImplicitEuler,
            step: &Step::hz(60)?,
            forces: &mut forces,
        };
        let name = name("force", force, self.scalar);
        self.meter.run(name, units, start);
        Ok(())
    }
}

fn name(group: &'static str, what: &'static str, scalar: &'static str) -> Name {
    Name {
        scene: [group, what, ""],
        scalar,
        method: "SemiImplicitEuler",
        ticks: TICKS,
    }
}

/// Shows every force, and what is done beside the steps, in three kinds of bodies.
pub fn show(meter: &mut impl Meter) -> Result<(), Error> {
    scalar::<I16F16>(meter, "I16F16")?;
    scalar::<f32>(meter, "f32")?;
    forces::<_, Carried<I16F16>>(meter, "I16F16 carried")
}

fn scalar<S>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    S: Decay<InvMass: Stored> + Stored,
{
    forces::<_, Point<S>>(meter, scalar)?;
    beside::<S>(meter, scalar)
}

/// Every force; none at all comes first.
fn forces<M, B>(meter: &mut M, scalar: &'static str) -> Result<(), Error>
where
    M: Meter,
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let mut meter = Shown {
        meter,
        scalar,
        body: PhantomData,
    };
    let mut world = Eight::<B>::new();
    build(&mut world)?;
    let Ok(ids) = <[BodyId; POINTS]>::try_from(world.ids()) else {
        return Ok(());
    };
    let [a, b, c, d, e, f, g, h] = ids;
    let chain = [[a, b], [b, c], [c, d], [d, e], [e, f], [f, g], [g, h]];
    let (thrust, origin) = (vec2(2, -1)?, vec2(1, 2)?);
    let mild = B::S::ratio(dec!(0.25)).unwrap_or(B::S::ZERO);
    let wind = PerBody(move |_: Time, _: &B| Vec2::new(mild, B::S::ZERO));
    let pull = Pull::new(black_box(10), dec!(0.5))?;
    let anchor = Anchor::new(a, origin, 20, dec!(0.5))?;
    let [_, rest @ ..] = ids;
    let mut anchors = [anchor; POINTS];
    for (place, id) in anchors.iter_mut().skip(1).zip(rest) {
        *place = Anchor::new(id, origin, 20, dec!(0.5))?;
    }
    meter.force("no force", 1, ())?;
    meter.force("LinearDrag", 8, LinearDrag::new(dec!(0.1))?)?;
    meter.force("QuadraticDrag", 8, QuadraticDrag::new(dec!(0.05))?)?;
    meter.force("PerBody", 8, wind)?;
    meter.force("Push", 8, ids.map(|id| Push::new(id, thrust)))?;
    meter.force("Anchor", 8, anchors)?;
    meter.force(
        "Pairs<Spring>",
        7,
        Pairs::new(Spring::new(2, 40, dec!(0.5))?, chain),
    )?;
    meter.force("Pairs<Pull>", 7, Pairs::new(pull, chain))?;
    meter.force("AllPairs<Pull>", 28, AllPairs(pull))?;
    exact::<M, B>(&mut meter, ids)
}

/// Drags and springs that are solved exactly; those that flow take the place of the drift.
fn exact<M, B>(meter: &mut Shown<'_, M, B>, ids: [BodyId; POINTS]) -> Result<(), Error>
where
    M: Meter,
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let [a, b, c, d, e, f, g, h] = ids;
    let origin = vec2(1, 2)?;
    meter.force("ExactDrag", 8, ExactDrag::new(dec!(0.1))?)?;
    let quadratic = ExactQuadraticDrag::new(dec!(0.05))?;
    meter.force("ExactQuadraticDrag", 8, quadratic)?;
    let flight = Ballistic::new(vec2(0, -5)?, dec!(0.1))?;
    meter.force("Ballistic", 8, flight)?;
    let tied = |damping_ratio| {
        let mut springs = [ExactSpring::new(a, origin, dec!(0.6), damping_ratio)?; POINTS];
        for (spring, id) in springs.iter_mut().zip(ids) {
            *spring = ExactSpring::new(id, origin, dec!(0.6), damping_ratio)?;
        }
        Ok::<_, Error>(springs)
    };
    meter.force("ExactSpring", 8, tied(dec!(0.1))?)?;
    meter.force("ExactSpring, undamped", 8, tied(dec!(0))?)?;
    let pair = |i, j| ExactPair::new([i, j], vec2(2, 0)?, dec!(0.6), dec!(0.1));
    let pairs = [pair(a, b)?, pair(c, d)?, pair(e, f)?, pair(g, h)?];
    meter.force("ExactPair", 4, pairs)
}

/// Shows what is done beside the steps: nothing at all, then frames, pictures, snapshots.
fn beside<S>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    S: Scalar<InvMass: Stored> + Stored,
{
    let step = Step::<S>::hz(60)?;
    let mut before = Eight::<Point<S>>::new();
    build(&mut before)?;
    let mut after = before.clone();
    black_box(&mut after).step(&mut SemiImplicitEuler, &mut (), &step);
    let part = Between::new(black_box(dec!(0.3)), &step)?;
    let mut clock = Accumulator::new(1_000_000, step.seconds(), black_box(4))?;
    meter.work(name("beside", "nothing", scalar), 1, || 0, |_| 0);
    let mut frame = || clock.advance(black_box(16_000)).steps;
    let frames = || (0..100).fold(0, |sum, _| sum + frame());
    meter.work(
        name("beside", "Accumulator::advance", scalar),
        100,
        frames,
        u32::into,
    );
    let prepared = || Between::new(black_box(dec!(0.3)), black_box(&step));
    meter.work(
        name("beside", "Between::new", scalar),
        1,
        prepared,
        |part| {
            let at = |part: Between<S>| part.chord(Vec2::ZERO, Vec2::new(S::MAX, S::ZERO)).x.bits();
            part.map_or(0, at)
        },
    );
    let picture = || {
        let mut drawn = [Vec2::<S>::ZERO; POINTS];
        let places = black_box(&after).between(&before, &SemiImplicitEuler, &part);
        for (to, (_, at)) in drawn.iter_mut().zip(places) {
            *to = at;
        }
        drawn
    };
    meter.work(
        name("beside", "World::between", scalar),
        8,
        picture,
        |drawn| {
            let bits = drawn.iter().flat_map(|at| at.array()).map(S::bits);
            bits.fold(0_u64, |sum, bits| sum.wrapping_mul(31) ^ bits)
        },
    );
    let snapshot = || {
        let mut bytes = [0; HEADER + 24 * POINTS];
        black_box(&after).save(black_box(&mut bytes)).map(|_| bytes)
    };
    meter.work(
        name("beside", "World::save", scalar),
        8,
        snapshot,
        |bytes| {
            let bytes = bytes.into_iter().flatten();
            bytes.fold(0_u64, |sum, byte| sum.wrapping_mul(31) ^ byte as u64)
        },
    );
    Ok(())
}
