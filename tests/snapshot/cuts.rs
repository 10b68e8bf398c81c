//! A world that was saved, read again and given fresh forces and a fresh method goes on with the
//! bits of the one that was never stopped: random cuts through every scene, method, step and scalar.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::{Body, DyadicStep, Force, Point, Step, Stored, TimeStep, World};

use super::bytes::{Kept, Random};
use super::scenes::{FIRST, ROOM, Scene, events, flight, stars, start, tied};
use crate::support::{Chosen, SCHEMES};

const STARTS: usize = 5;
const CUTS: usize = 12;
/// Ticks before a cut, and behind it, are fewer.
const STRETCH: usize = 40;

/// What the cuts met, so that none of it is empty talk.
#[derive(Default)]
struct Met {
    cuts: usize,
    /// With every body away from the ends of the range.
    inside: usize,
    /// With bodies that were not there at the start.
    changed: usize,
    full: usize,
    ticks: usize,
}

/// Every bit that a point has.
fn bits<S: Kept>(world: &Scene<S>) -> Vec<[u64; 5]> {
    let of = |body: &Point<S>| {
        let ([x, y], [u, v]) = (body.position().array(), body.velocity().array());
        let mass = body.inv_mass().store();
        [x.store(), y.store(), u.store(), v.store(), mass]
    };
    world.bodies().iter().map(of).collect()
}

fn run<S: Kept>(
    world: &mut Scene<S>,
    method: &mut Chosen<Point<S>, ROOM>,
    forces: &mut impl Force<Point<S>>,
    step: &impl TimeStep<S>,
    ticks: usize,
) {
    for _ in 0..ticks {
        events(world);
        world.step(method, forces, step);
    }
}

fn restarted<S: Kept>(world: &Scene<S>) -> Scene<S> {
    let mut bytes = vec![0; Scene::<S>::SNAPSHOT];
    let length = world.save(&mut bytes).unwrap();
    World::load(&bytes[..length]).unwrap()
}

fn assert_same<S: Kept>(going: &Scene<S>, restarted: &Scene<S>, what: &str) {
    assert_eq!(going.state_hash(), restarted.state_hash(), "{what}");
    assert_eq!(going.tick(), restarted.tick(), "{what}");
    assert_eq!(going.ids(), restarted.ids(), "{what}");
    assert_eq!(bits(going), bits(restarted), "{what}");
    let another = start(0).bodies()[0];
    let ids = [going, restarted].map(|world| world.clone().add(another).ok());
    assert_eq!(ids[0], ids[1], "{what}");
}

fn cut<S: Kept, F: Force<Point<S>>>(
    build: fn(&Scene<S>) -> F,
    step: &impl TimeStep<S>,
    what: &str,
    met: &mut Met,
) {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for (scheme, seed) in SCHEMES
        .into_iter()
        .flat_map(|s| (0..STARTS).map(move |i| (s, i)))
    {
        let mut going = start(seed);
        let (mut method, mut forces) = (scheme.method(), build(&going));
        for _ in 0..CUTS {
            let [before, after] = [0, 1].map(|least| least + random.below(STRETCH));
            run(&mut going, &mut method, &mut forces, step, before);
            let mut again = restarted(&going);
            let what = format!("{what}, {scheme:?}, cut at {}", going.tick());
            assert_same(&going, &again, &what);
            let (mut fresh, mut fresh_forces) = (scheme.method(), build(&again));
            run(&mut again, &mut fresh, &mut fresh_forces, step, after);
            run(&mut going, &mut method, &mut forces, step, after);
            assert_same(&going, &again, &what);
            met.cuts += 1;
            met.inside += usize::from(going.out_of_range().next().is_none());
            met.changed += usize::from(going.ids().iter().any(|id| id.serial() >= FIRST as u32));
            met.full += usize::from(going.len() == ROOM);
            met.ticks += before + 2 * after;
        }
    }
}

fn every_scene<S: Kept>(step: &impl TimeStep<S>, what: &str, met: &mut Met) {
    cut(flight::<S>, step, &format!("{what}, flight"), met);
    cut(tied::<S>, step, &format!("{what}, tied"), met);
    cut(stars::<S>, step, &format!("{what}, stars"), met);
}

fn every_step<S: Kept>(met: &mut Met) {
    let name = S::name();
    every_scene::<S>(&Step::hz(60).unwrap(), &format!("{name} 1/60"), met);
    let dyadic = DyadicStep::<S, 1, 6>::new().unwrap();
    every_scene(&dyadic, &format!("{name} 1/64"), met);
}

#[test]
fn ten_thousand_cuts_go_on_with_the_same_bits() {
    let mut met = Met::default();
    every_step::<f32>(&mut met);
    every_step::<f64>(&mut met);
    every_step::<I16F16>(&mut met);
    every_step::<I12F20>(&mut met);
    every_step::<I8F24>(&mut met);
    every_step::<I20F12>(&mut met);
    every_step::<I32F32>(&mut met);
    let Met {
        cuts,
        inside,
        changed,
        full,
        ticks,
    } = met;
    println!("{cuts} cuts, {ticks} ticks; {inside} inside, {changed} with newcomers, {full} full");
    assert!(cuts >= 10_000 && inside * 10 >= cuts * 9);
    assert!(changed * 2 >= cuts && full >= 100);
}
