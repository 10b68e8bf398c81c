//! A scene that names every verb of bodies that turn and of their shapes, for an image in which the linker
//! looks for panics and for hashes that must agree.

use core::hint::black_box;

use fixstep::fixed::types::I16F16;
use fixstep::mass::{capsule, convex_polygon, disc, polygon, rectangle, ring};
use fixstep::rigid::torque::{Attached, SpinDrag, Torque, Wrench};
use fixstep::rigid::{Centre, SavedRotor};
use fixstep::scalar::Rational;
use fixstep::world::snapshot::{HEADER, Saved};
use fixstep::{
    AllPairs, Anchor, Angle, Ballistic, Between, Carried, Decay, Error, ExactPair, ExactSpring,
    MassProperties, Pairs, PerBody, Point, PointMass, Pull, RangeChecked, Ratio, Rigid, Rotating,
    Scalar, SemiImplicitEuler, Spring, Step, Time, Vec2, Verlet, World, dec, vec2,
};

/// Of both centres, in fixed point and in floats. Inlined, as all here that is of one type: no other image has it then.
#[inline]
pub fn hash() -> Result<u64, Error> {
    let sums = [
        of::<Point<I16F16>>()?,
        of::<Carried<I16F16>>()?,
        of::<Point<f32>>()?,
        back()?,
    ];
    Ok(sums.iter().fold(0, |sum, hash| sum.rotate_left(7) ^ hash))
}

/// A hammer with a hole, and point masses.
fn properties<S: Rational>() -> Result<MassProperties<S>, Error> {
    let corner = |x, y| vec2(black_box(x), y);
    let corners = [corner(0, 0)?, corner(2, 0)?, corner(2, 1)?, corner(0, 1)?];
    let head = convex_polygon(&corners)?.with_density(black_box(dec!(1.5)))?;
    let bore = disc(dec!(0.25))?
        .with_density(dec!(1.5))?
        .at(vec2(1, dec!(0.5))?)?;
    let handle = rectangle(dec!(0.2), black_box(3))?.with_mass(2)?;
    let grip = capsule(black_box(1), dec!(0.2))?.with_mass(dec!(0.3))?;
    let rim = ring(dec!(0.5), black_box(dec!(0.4)))?.with_mass(1)?;
    let arrow =
        polygon(&[corner(0, 0)?, corner(3, 1)?, corner(1, 1)?, corner(1, 3)?])?.with_mass(1)?;
    let points = [1, 2].map(|mass| PointMass {
        position: Vec2::ZERO,
        velocity: Vec2::ZERO,
        mass: Ratio::from(mass),
    });
    let parts = [
        head.without(&bore)?,
        handle.at(vec2(1, -2)?)?,
        grip.at(vec2(1, -3)?)?,
        rim,
        arrow,
        MassProperties::from_points(&points)?,
    ];
    MassProperties::from_parts(&parts)
}

fn of<C>() -> Result<u64, Error>
where
    C: Centre<S: Decay + Rational, Rotor: SavedRotor> + Saved,
{
    let mut world = World::<Rigid<C>, 4>::new();
    let whole = properties::<C::S>()?;
    let about = whole.inertia_about(Vec2::ZERO)?.num() as u64;
    let body = Rigid::<C>::from_properties(&whole, vec2(black_box(1), 0)?)?;
    let turned = body
        .with_angle(Angle::degrees(black_box(30)))
        .with_spin(black_box(2))?;
    let held = Rigid::locked(C::from(Point::new(vec2(4, 0)?, vec2(0, 1)?, 2)?));
    let (Ok(a), Ok(b), Ok(c)) = (
        world.add(turned),
        world.add(held),
        world.add(Rigid::kinematic(vec2(0, 5)?, vec2(1, 0)?)?.with_spin(1)?),
    ) else {
        return Ok(0);
    };
    let _ = world.add(Rigid::static_at(vec2(-4, 0)?)?);
    let step = Step::hz(60)?;
    let torque = C::S::ratio(dec!(0.3)).unwrap_or(C::S::ZERO);
    let wrench = PerBody(move |_: Time, body: &Rigid<C>| {
        Wrench::at(
            body.rotation().rotate(Vec2::new(torque, torque)),
            Vec2::new(torque, C::S::ZERO),
        )
    });
    let (spring, at) = (Spring::new(1, 10, dec!(0.2))?, [vec2(1, 0)?, Vec2::ZERO]);
    let attached = Attached { spring, at };
    let mut forces = (
        (
            Anchor::new(c, Vec2::ZERO, 20, 0)?,
            ExactSpring::new(b, Vec2::ZERO, 1, dec!(0.1))?,
        ),
        ExactPair::new([a, c], vec2(1, 0)?, dec!(0.5), 0)?,
        Pairs::new(Spring::new(2, 40, 0)?, [[a, b]]),
        (
            AllPairs(Pull::new(1, 1)?),
            wrench,
            Torque { body: a, torque },
        ),
        (
            Ballistic::new(vec2(0, -5)?, dec!(0.1))?,
            SpinDrag::new(black_box(dec!(0.1)))?,
        ),
        Pairs::new(attached, [[a, b]]),
    );
    let before = world.clone();
    let mut world = saved(&world);
    for _ in 0..100 {
        world.step(&mut SemiImplicitEuler, &mut forces, &step);
    }
    touched(&mut world, a)?;
    let part = Between::new(black_box(dec!(0.3)), &step)?;
    let (was, is) = (before.get(a), world.get(a));
    let drawn = was.and_then(|was| is.map(|is| was.angle().between(is.angle(), &part)));
    let kinds = world
        .bodies()
        .iter()
        .fold(0, |sum, body| sum * 3 + body.kind() as u64);
    let bits = drawn.map_or(0, |angle| angle.rotation().cos().bits());
    Ok(world.state_hash() ^ about ^ kinds ^ bits)
}

/// Written and read.
fn saved<B: Saved>(world: &World<B, 4>) -> World<B, 4> {
    let mut bytes = [0; HEADER + 64 * 4];
    let back = world.save(black_box(&mut bytes));
    back.and_then(|length| World::load(bytes.get(..length).unwrap_or_default()))
        .unwrap_or_default()
}

/// What a game does to a body between steps.
fn touched<C: Centre>(world: &mut World<Rigid<C>, 4>, id: fixstep::BodyId) -> Result<(), Error> {
    let body = world.get_mut(id)?;
    let point = body.to_world(vec2(1, 1)?);
    let own = body.to_own(point);
    body.push_at(point, vec2(dec!(0.5), 0)?);
    body.push_angular(own.x);
    let speed = body.velocity_at(point);
    body.set_velocity(speed)?;
    body.set_spin(body.spin().plus(speed.y))?;
    body.set_angle(body.angle() - Angle::turns(black_box(dec!(0.1))));
    body.teleport(vec2(1, 2)?)
}

/// Out and back.
#[inline]
fn back() -> Result<u64, Error> {
    let mut world = World::<RangeChecked<Rigid<Point<I16F16>>>, 1>::new();
    let whole = properties()?;
    let id = world.add(RangeChecked::new(Rigid::from_properties(
        &whole,
        vec2(0, 3)?,
    )?))?;
    let mut forces = Torque {
        body: id,
        torque: I16F16::ONE,
    };
    let step = Step::hz(60)?;
    for _ in 0..60 {
        world.step(&mut Verlet, &mut forces, &step);
    }
    let far = world.state_hash();
    while world.step_back(&mut Verlet, &mut forces, &step).is_ok() {}
    Ok(far ^ world.state_hash())
}
