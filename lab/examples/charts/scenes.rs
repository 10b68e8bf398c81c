//! What the charts compare: six scenes, each with every method and every way to state its forces. The
//! firmware prices the same file, so that no cost is of another scene than its error.

use fixstep::{
    AllPairs, Anchor, Ballistic, Body, BodyId, ConstantAcceleration, Decay, Error, Euler,
    ExactDrag, ExactPair, ExactQuadraticDrag, ExactSpring, Force, GravityY, LinearDrag, Method,
    Pairs, Pefrl, Point, Pull, QuadraticDrag, Ratio, Rk4, SemiImplicitEuler, Spring, Verlet, World,
    dec, vec2,
};

/// Most bodies of a scene.
pub const ROOM: usize = 8;
pub type Room<B> = World<B, ROOM>;

/// m/s².
pub const GRAVITY: Ratio = dec!(-9.81);
/// Of the springs to a fixed point, N/m and Hz for a mass of 1 kg: in no simple ratio to a rate.
pub const STIFFNESS: Ratio = dec!(38.427_484_757_225_69);
pub const HERTZ: Ratio = dec!(0.9866);
/// Of air, kg/s and kg/m for a mass of 1 kg.
pub const DRAG: Ratio = dec!(0.7);
pub const QUADRATIC: Ratio = dec!(0.05);
/// Of the pair on a spring, kg, N/m, m and Hz.
pub const MASSES: [Ratio; 2] = [dec!(1.25), dec!(3)];
pub const PAIR_STIFFNESS: Ratio = dec!(30);
pub const PAIR_REST: Ratio = dec!(2);
pub const PAIR_HERTZ: Ratio = dec!(0.928_024_816_995_683);
/// Of stars, each of 1 kg. Two of them circle with a = 1 m relative to each other in 2π s.
pub const PULL: Ratio = dec!(0.5);
pub const SOFTENING: Ratio = dec!(0.015625);
/// Of the cluster, m.
pub const CLUSTER_SOFTENING: Ratio = dec!(0.25);

/// Hears of every run that a scene has.
pub trait Visitor<B: Body> {
    /// A method by name, forces by name, and how to make both anew for a world.
    fn run<M, F>(
        &mut self,
        method: &'static str,
        forces: &'static str,
        new: fn() -> M,
        build: fn(&Room<B>) -> Result<F, Error>,
    ) -> Result<(), Error>
    where
        M: Method<B, ROOM>,
        F: Force<B>;
}

/// A scene: its runs for one kind of body.
pub trait Scene {
    const NAME: &'static str;
    const BODIES: usize;

    fn show<B, V>(visitor: &mut V) -> Result<(), Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
        V: Visitor<B>;
}

/// All six methods with one way to state the forces.
fn methods<B, F, V>(
    visitor: &mut V,
    forces: &'static str,
    build: fn(&Room<B>) -> Result<F, Error>,
) -> Result<(), Error>
where
    B: Body,
    F: Force<B>,
    V: Visitor<B>,
{
    visitor.run("Euler", forces, Euler::new, build)?;
    visitor.run(
        "ConstantAcceleration",
        forces,
        ConstantAcceleration::new,
        build,
    )?;
    visitor.run("SemiImplicitEuler", forces, || SemiImplicitEuler, build)?;
    visitor.run("Verlet", forces, || Verlet, build)?;
    visitor.run("Rk4", forces, Rk4::new, build)?;
    visitor.run("Pefrl", forces, Pefrl::new, build)
}

/// The ids of a scene's bodies; none where it has another number of them.
fn ids<B: Body, const N: usize>(world: &Room<B>) -> Result<[BodyId; N], Error> {
    world
        .ids()
        .try_into()
        .map_err(|_| Error::Empty { field: "bodies" })
}

/// One of a thing for each of four bodies.
fn each<T>(
    [a, b, c, d]: [BodyId; 4],
    make: impl Fn(BodyId) -> Result<T, Error>,
) -> Result<[T; 4], Error> {
    Ok([make(a)?, make(b)?, make(c)?, make(d)?])
}

/// Four bodies of 1 kg, each on its own spring to the origin.
pub struct Springs;

impl Scene for Springs {
    const NAME: &'static str = "spring";
    const BODIES: usize = 4;

    fn show<B, V>(visitor: &mut V) -> Result<(), Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
        V: Visitor<B>,
    {
        methods(visitor, "Anchor", |world| {
            let origin = vec2(0, 0)?;
            each(ids(world)?, |id| Anchor::new(id, origin, STIFFNESS, 0))
        })?;
        let exact = |world: &Room<B>| {
            let origin = vec2(0, 0)?;
            each(ids(world)?, |id| ExactSpring::new(id, origin, HERTZ, 0))
        };
        visitor.run(
            "SemiImplicitEuler",
            "ExactSpring",
            || SemiImplicitEuler,
            exact,
        )
    }
}

/// Four bodies of 1 kg thrown into air whose drag is linear.
pub struct Projectile;

impl Scene for Projectile {
    const NAME: &'static str = "projectile";
    const BODIES: usize = 4;

    fn show<B, V>(visitor: &mut V) -> Result<(), Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
        V: Visitor<B>,
    {
        methods(visitor, "LinearDrag", |_| {
            Ok((GravityY::new(GRAVITY)?, LinearDrag::new(DRAG)?))
        })?;
        let exact = |_: &Room<B>| Ok((GravityY::new(GRAVITY)?, ExactDrag::new(DRAG)?));
        visitor.run(
            "SemiImplicitEuler",
            "ExactDrag",
            || SemiImplicitEuler,
            exact,
        )?;
        visitor.run("Verlet", "ExactDrag", || Verlet, exact)?;
        let both = |_: &Room<B>| Ballistic::new(vec2(0, GRAVITY)?, DRAG);
        visitor.run("SemiImplicitEuler", "Ballistic", || SemiImplicitEuler, both)
    }
}

/// The same with drag that goes with the square of the speed.
pub struct QuadraticProjectile;

impl Scene for QuadraticProjectile {
    const NAME: &'static str = "quadratic";
    const BODIES: usize = 4;

    fn show<B, V>(visitor: &mut V) -> Result<(), Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
        V: Visitor<B>,
    {
        methods(visitor, "QuadraticDrag", |_| {
            Ok((GravityY::new(GRAVITY)?, QuadraticDrag::new(QUADRATIC)?))
        })?;
        let exact = |_: &Room<B>| {
            let drag = ExactQuadraticDrag::new(QUADRATIC)?;
            Ok((GravityY::new(GRAVITY)?, drag))
        };
        visitor.run(
            "SemiImplicitEuler",
            "ExactQuadraticDrag",
            || SemiImplicitEuler,
            exact,
        )?;
        visitor.run("Verlet", "ExactQuadraticDrag", || Verlet, exact)
    }
}

/// Two stars that circle each other.
pub struct Kepler;

impl Scene for Kepler {
    const NAME: &'static str = "kepler";
    const BODIES: usize = 2;

    fn show<B, V>(visitor: &mut V) -> Result<(), Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
        V: Visitor<B>,
    {
        methods(visitor, "Pull", |world| {
            Ok(Pairs::new(Pull::new(PULL, SOFTENING)?, [ids(world)?]))
        })
    }
}

/// Five stars that pull each other.
pub struct Cluster;

impl Scene for Cluster {
    const NAME: &'static str = "cluster";
    const BODIES: usize = 5;

    fn show<B, V>(visitor: &mut V) -> Result<(), Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
        V: Visitor<B>,
    {
        methods(visitor, "Pull", |_| {
            Ok(AllPairs(Pull::new(PULL, CLUSTER_SOFTENING)?))
        })
    }
}

/// Two bodies on a spring, along x.
pub struct Pair;

impl Scene for Pair {
    const NAME: &'static str = "pair";
    const BODIES: usize = 2;

    fn show<B, V>(visitor: &mut V) -> Result<(), Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
        V: Visitor<B>,
    {
        methods(visitor, "Spring", |world| {
            let spring = Spring::new(PAIR_REST, PAIR_STIFFNESS, 0)?;
            Ok(Pairs::new(spring, [ids(world)?]))
        })?;
        visitor.run(
            "SemiImplicitEuler",
            "ExactPair",
            || SemiImplicitEuler,
            |world| ExactPair::new(ids(world)?, vec2(PAIR_REST, 0)?, PAIR_HERTZ, 0),
        )
    }
}
