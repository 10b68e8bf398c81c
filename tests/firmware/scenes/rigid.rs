//! Bodies that turn: what a step of one costs, what the forces that turn it cost, and what is made of an
//! angle.

use core::hint::black_box;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::rigid::Centre;
use fixstep::rigid::torque::{Attached, SpinDrag, Torque, Wrench};
use fixstep::{
    Angle, Angular, Body, BodyId, Carried, ConstantAcceleration, Decay, DyadicStep, Error, Euler,
    Force, GravityY, Method, Pairs, Pefrl, PerBody, Point, Rigid, Rk4, Scalar, SemiImplicitEuler,
    Spring, Step, Time, TimeStep, Vec2, Verlet, World, dec, vec2,
};

use super::{Meter, Name, Start, TICKS};

/// Bodies under gravity, and under a force.
const MANY: usize = 32;
const EIGHT: usize = 8;

/// Shows all of it in four kinds of bodies.
pub fn show(meter: &mut impl Meter) -> Result<(), Error> {
    kind::<Point<I16F16>>(meter, "I16F16 rigid")?;
    kind::<Point<I8F24>>(meter, "I8F24 rigid")?;
    kind::<Point<f32>>(meter, "f32 rigid")?;
    kind::<Carried<I16F16>>(meter, "I16F16 carried rigid")?;
    angles::<I16F16>(meter, "I16F16 rigid")?;
    angles::<f32>(meter, "f32 rigid")?;
    direction(meter);
    Ok(())
}

fn kind<C>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    C: Centre<S: Decay> + From<Point<C::S>>,
{
    let (step, dyadic) = (Step::hz(60)?, DyadicStep::<_, 1, 6>::new()?);
    let mut meter = Shown { meter, scalar };
    meter.gravity::<C, _>("1/60", "SemiImplicitEuler", SemiImplicitEuler, &step)?;
    meter.gravity::<C, _>("1/64", "SemiImplicitEuler", SemiImplicitEuler, &dyadic)?;
    meter.gravity::<C, _>("1/60", "Verlet", Verlet, &step)?;
    forces::<C>(&mut meter)?;
    meter.bar::<C>("Euler", Euler::new())?;
    meter.bar::<C>("ConstantAcceleration", ConstantAcceleration::new())?;
    meter.bar::<C>("SemiImplicitEuler", SemiImplicitEuler)?;
    meter.bar::<C>("Verlet", Verlet)?;
    meter.bar::<C>("Rk4", Rk4::new())?;
    meter.bar::<C>("Pefrl", Pefrl::new())
}

/// Bodies of 1.5 kg and 0.4 kg m², each with another velocity and spin.
fn build<C, const N: usize>(world: &mut World<Rigid<C>, N>, bodies: usize) -> Result<(), Error>
where
    C: Centre + From<Point<C::S>>,
{
    for i in 0..bodies as i32 {
        let position = vec2(3 * (i & 7) - 11, 5 * (i & 1) - (i >> 2))?;
        let point = Point::new(position, vec2((i & 7) - 3, 4 - (i >> 2))?, dec!(1.5))?;
        let spin = C::S::ratio(dec!(0.37)).unwrap_or(C::S::ZERO);
        let mut body = Rigid::new(C::from(point), dec!(0.4))?.with_spin(i & 3)?;
        body.twist(spin);
        let _ = world.add(body.with_angle(Angle::turns(dec!(0.15))));
    }
    Ok(())
}

/// Shows scenes of one kind of bodies to a meter.
struct Shown<'a, M> {
    meter: &'a mut M,
    scalar: &'static str,
}

impl<M: Meter> Shown<'_, M> {
    fn name(&self, scene: [&'static str; 2], method: &'static str) -> Name {
        let [group, what] = scene;
        Name {
            scene: [group, what, ""],
            scalar: self.scalar,
            method,
            ticks: TICKS,
        }
    }

    fn gravity<C, H>(
        &mut self,
        length: &'static str,
        name: &'static str,
        mut method: impl Method<Rigid<C>, MANY>,
        step: &H,
    ) -> Result<(), Error>
    where
        C: Centre + From<Point<C::S>>,
        H: TimeStep<C::S>,
    {
        let mut world = World::<Rigid<C>, MANY>::new();
        build(&mut world, MANY)?;
        let start = Start {
            world: &mut world,
            method: &mut method,
            step,
            forces: &mut GravityY::new(dec!(-9.81))?,
        };
        let name = self.name(["gravity", length], name);
        self.meter.run(name, MANY as u32, start);
        Ok(())
    }

    fn force<C, F>(&mut self, force: &'static str, units: u32, mut forces: F) -> Result<(), Error>
    where
        C: Centre + From<Point<C::S>>,
        F: Force<Rigid<C>>,
    {
        let mut world = World::<Rigid<C>, EIGHT>::new();
        build(&mut world, EIGHT)?;
        let start = Start {
            world: &mut world,
            method: &mut SemiImplicitEuler,
            step: &Step::hz(60)?,
            forces: &mut forces,
        };
        let name = self.name(["force", force], "SemiImplicitEuler");
        self.meter.run(name, units, start);
        Ok(())
    }

    /// Two bodies on a spring off their centres, one with a motor, and a third that is driven.
    fn bar<C>(
        &mut self,
        name: &'static str,
        mut method: impl Method<Rigid<C>, 3>,
    ) -> Result<(), Error>
    where
        C: Centre<S: Decay> + From<Point<C::S>>,
    {
        let mut world = World::<Rigid<C>, 3>::new();
        build(&mut world, 2)?;
        let &[a, b] = world.ids() else {
            return Ok(());
        };
        let _ = world.add(Rigid::kinematic(vec2(0, 4)?, vec2(0, 1)?)?.with_spin(1)?);
        let mut forces = (
            GravityY::new(dec!(-9.81))?,
            Pairs::new(attached()?, [[a, b]]),
            SpinDrag::new(dec!(0.2))?,
            torque::<C::S>(a),
        );
        let start = Start {
            world: &mut world,
            method: &mut method,
            step: &Step::hz(60)?,
            forces: &mut forces,
        };
        let name = self.name(["bar", ""], name);
        self.meter.run(name, 3, start);
        Ok(())
    }
}

fn attached<S: Scalar>() -> Result<Attached<S>, Error> {
    Ok(Attached {
        spring: Spring::new(2, 40, dec!(0.5))?,
        at: [vec2(dec!(0.5), 0)?, vec2(0, dec!(0.25))?],
    })
}

fn torque<S: Scalar>(body: BodyId) -> Torque<S> {
    let torque = S::ratio(dec!(0.3)).unwrap_or(S::ZERO);
    Torque { body, torque }
}

/// What the forces that turn cost more than none.
fn forces<C>(meter: &mut Shown<'_, impl Meter>) -> Result<(), Error>
where
    C: Centre<S: Decay> + From<Point<C::S>>,
{
    let mut world = World::<Rigid<C>, EIGHT>::new();
    build(&mut world, EIGHT)?;
    let Ok(ids) = <[BodyId; EIGHT]>::try_from(world.ids()) else {
        return Ok(());
    };
    let [a, b, c, d, e, f, g, h] = ids;
    let chain = [[a, b], [b, c], [c, d], [d, e], [e, f], [f, g], [g, h]];
    let mild = C::S::ratio(dec!(0.25)).unwrap_or(C::S::ZERO);
    let wrench = PerBody(move |_: Time, _: &Rigid<C>| Wrench {
        force: Vec2::new(mild, C::S::ZERO),
        torque: mild,
    });
    meter.force::<C, _>("no force", 1, ())?;
    meter.force::<C, _>("Torque", 8, ids.map(torque))?;
    meter.force::<C, _>("SpinDrag", 8, SpinDrag::new(dec!(0.2))?)?;
    meter.force::<C, _>("PerBody<Wrench>", 8, wrench)?;
    meter.force::<C, _>("Pairs<Attached>", 7, Pairs::new(attached()?, chain))
}

/// How often a thing is done that is priced alone.
const TIMES: u32 = 100;

/// What is made of an angle, and the other way to keep one; a root for comparison.
fn angles<S: Angular>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error> {
    let name = |what| Name {
        scene: ["beside", what, ""],
        scalar,
        method: "SemiImplicitEuler",
        ticks: &[],
    };
    let far = S::ratio(dec!(17.3)).unwrap_or(S::ZERO);
    let turn = Angle::<S>::turns(black_box(dec!(0.0137)));
    let all = |each: fn(Angle<S>, S) -> S| {
        let mut angle = Angle::ZERO;
        (0..TIMES).fold(S::ZERO, |sum, _| {
            angle = angle + turn;
            sum.plus(each(black_box(angle), far))
        })
    };
    meter.work(name("nothing"), 1, || all(|_, far| far), S::bits);
    let sines = || {
        all(|angle, far| {
            black_box(angle.rotation());
            far
        })
    };
    meter.work(name("Angle::rotation"), TIMES, sines, S::bits);
    let vectors = || {
        all(|angle, far| {
            let v = angle.rotation().rotate(Vec2::new(far, far));
            v.x.plus(v.y)
        })
    };
    meter.work(name("Rotation::rotate"), TIMES, vectors, S::bits);
    let lengths = || all(|_, far| Vec2::new(black_box(far), far).length());
    meter.work(name("Vec2::length"), TIMES, lengths, S::bits);
    Ok(())
}

/// The other way to know where a body points: its cosine and sine, in units of 2^-30, turned in each step and
/// made a unit long again by a step of Newton's method.
fn direction(meter: &mut impl Meter) {
    const ONE: i64 = 1 << 30;
    fn product(a: i32, b: i32) -> i32 {
        ((a as i64 * b as i64 + ONE / 2) >> 30) as i32
    }
    fn turned([cos, sin]: [i32; 2], [c, s]: [i32; 2]) -> [i32; 2] {
        let x = product(cos, c).wrapping_sub(product(sin, s));
        let y = product(cos, s).wrapping_add(product(sin, c));
        let square = product(x, x).wrapping_add(product(y, y));
        let inverse = ((3 * ONE - square as i64) / 2) as i32;
        [product(x, inverse), product(y, inverse)]
    }
    let by = black_box([1_069_766_225, 92_313_207]); // 0.0137 turns
    let kept = || (0..TIMES).fold([ONE as i32, 0], |kept, _| black_box(turned(kept, by)));
    let name = Name {
        scene: ["beside", "a kept direction", ""],
        scalar: "I16F16 rigid",
        method: "SemiImplicitEuler",
        ticks: &[],
    };
    meter.work(name, TIMES, kept, |[x, y]| {
        (x as u32 as u64) << 32 | y as u32 as u64
    });
}
