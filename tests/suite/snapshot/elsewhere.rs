//! The scenes of the drift example, saved in the middle.

#[path = "../../../examples/drift/scene.rs"]
#[allow(dead_code)] // the example asks for more
mod scene;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Anchor, Force, Gravity, LinearDrag, Pairs, Point, Ratio, Scalar, Spring, Step, Stored, Vec2,
    Verlet, World,
};
use scene::{ALL, Law, STARTS, Scene, Start};

type Pair<S> = World<Point<S>, 2>;

/// Steps before a cut and after it.
const TICKS: usize = 300;

fn real(value: f64) -> Ratio {
    Ratio::from_f64(value).unwrap()
}

fn vector<S: Scalar>(v: Vec2<f64>) -> Vec2<S> {
    fixstep::vec2(real(v.x), real(v.y)).unwrap()
}

fn world<S: Scalar>(starts: &[Start]) -> Pair<S> {
    let mut world = World::new();
    for start in starts {
        let (position, velocity) = (vector(start.position), vector(start.velocity));
        let point = Point::new(position, velocity, real(start.mass)).unwrap();
        world.add(point).unwrap();
    }
    world
}

/// Runs to the cut, saves, reads, and runs both on with forces made anew: equal after each step.
fn cut<S, F>(mut world: Pair<S>, forces: impl Fn(&Pair<S>) -> F, tick: usize) -> u64
where
    S: Scalar<InvMass: Stored> + Stored,
    F: Force<Point<S>>,
{
    let step = Step::<S>::hz(60).unwrap();
    let mut of_world = forces(&world);
    (0..tick).for_each(|_| world.step(&mut Verlet, &mut of_world, &step));
    let mut bytes = vec![0; Pair::<S>::SNAPSHOT];
    let length = world.save(&mut bytes).unwrap();
    let mut again = Pair::<S>::load(&bytes[..length]).unwrap();
    let mut of_again = forces(&again);
    for _ in tick..TICKS {
        assert_eq!(again.state_hash(), world.state_hash());
        world.step(&mut Verlet, &mut of_world, &step);
        again.step(&mut Verlet, &mut of_again, &step);
    }
    assert_eq!(again.bodies(), world.bodies());
    again.state_hash()
}

fn scene_of<S>(scene: &Scene, index: usize, tick: usize) -> u64
where
    S: Scalar<InvMass: Stored> + Stored,
{
    let start = || world::<S>(&scene.bodies(index, 50.0));
    let gravity = |g: f64| Gravity::new(vector::<S>(Vec2::new(0.0, -g)));
    let drag = |k| LinearDrag::<S>::new(real(k)).unwrap();
    match scene.law {
        Law::Free => cut(start(), |_| (), tick),
        Law::Gravity { g } => cut(start(), |_| gravity(g), tick),
        Law::Drag { k } => cut(start(), |_| drag(k), tick),
        Law::GravityAndDrag { g, k } => cut(start(), |_| (gravity(g), drag(k)), tick),
        Law::Anchor { k } => {
            let anchor = |world: &Pair<S>| Anchor::new(world.ids()[0], Vec2::ZERO, real(k), 0);
            cut(start(), |world| anchor(world).unwrap(), tick)
        }
        Law::Spring { k, rest } => {
            let spring = || Spring::new(real(rest), real(k), 0).unwrap();
            let pair = |world: &Pair<S>| [[world.ids()[0], world.ids()[1]]];
            cut(start(), |world| Pairs::new(spring(), pair(world)), tick)
        }
    }
}

fn every_scene<S>()
where
    S: Scalar<InvMass: Stored> + Stored,
{
    for scene in &ALL {
        let ends: Vec<u64> = (0..STARTS)
            .map(|i| scene_of::<S>(scene, i, 1 + i * 18))
            .collect();
        // Another start ends elsewhere: the hash has seen the state.
        assert!(ends.windows(2).all(|pair| pair[0] != pair[1]));
    }
}

#[test]
fn every_scene_of_drift_goes_on_from_its_middle() {
    every_scene::<f32>();
    every_scene::<I16F16>();
    every_scene::<I8F24>();
}
