//! A world that was saved, read again and given fresh forces and a fresh method goes on with the
//! bits of the one that was never stopped: random cuts through every scene, method, step and scalar.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::{
    Carried, Decay, DyadicStep, Force, Point, RangeChecked, Rigid, Rotating, Step, TimeStep, World,
};

use super::bytes::Random;
use super::cast::Cast;
use super::scenes::{FIRST, ROOM, Scene, events, flight, stars, start, tied};
use super::turning::turning;
use crate::support::{Chosen, Format, LAB, SCHEMES};

const CUTS: usize = 12;
/// Ticks before a cut, and behind it, are fewer.
const STRETCH: usize = 40;

/// What the cuts met, so that none of it is empty talk.
#[derive(Default)]
struct Met {
    /// Starts of each scene.
    starts: usize,
    cuts: usize,
    /// With every body away from the ends of the range.
    inside: usize,
    /// With bodies that were not there at the start.
    changed: usize,
    full: usize,
    ticks: usize,
}

/// Every word of every body, and what no snapshot can leave out unseen: the bodies as they print.
fn bits<B: Cast>(world: &Scene<B>) -> (Vec<u64>, String) {
    let mut words = Vec::new();
    for body in world.bodies() {
        body.save(&mut |word, _| words.push(word));
    }
    (words, format!("{:?}", world.bodies()))
}

fn run<B: Cast>(
    world: &mut Scene<B>,
    method: &mut Chosen<B, ROOM>,
    forces: &mut impl Force<B>,
    step: &impl TimeStep<B::S>,
    ticks: usize,
) {
    for _ in 0..ticks {
        events(world);
        world.step(method, forces, step);
    }
}

fn restarted<B: Cast>(world: &Scene<B>) -> Scene<B> {
    let mut bytes = vec![0; Scene::<B>::SNAPSHOT];
    let length = world.save(&mut bytes).unwrap();
    World::load(&bytes[..length]).unwrap()
}

fn assert_same<B: Cast>(going: &Scene<B>, restarted: &Scene<B>, what: &str) {
    assert_eq!(going.state_hash(), restarted.state_hash(), "{what}");
    assert_eq!(going.tick(), restarted.tick(), "{what}");
    assert_eq!(going.ids(), restarted.ids(), "{what}");
    assert_eq!(bits(going), bits(restarted), "{what}");
    let another = start::<B>(0).bodies()[0];
    let ids = [going, restarted].map(|world| world.clone().add(another).ok());
    assert_eq!(ids[0], ids[1], "{what}");
}

fn cut<B: Cast, F: Force<B>>(
    build: fn(&Scene<B>) -> F,
    step: &impl TimeStep<B::S>,
    what: &str,
    met: &mut Met,
) {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for (scheme, seed) in SCHEMES
        .into_iter()
        .flat_map(|s| (0..met.starts).map(move |i| (s, i)))
    {
        let mut going = start::<B>(seed);
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

fn every_scene<B: Cast>(step: &impl TimeStep<B::S>, what: &str, met: &mut Met) {
    cut(flight::<B>, step, &format!("{what}, flight"), met);
    cut(tied::<B>, step, &format!("{what}, tied"), met);
    cut(stars::<B>, step, &format!("{what}, stars"), met);
}

fn at_60_hz<B: Cast>(met: &mut Met) {
    let name = B::S::name();
    every_scene::<B>(&Step::hz(60).unwrap(), &format!("{name} 1/60"), met);
}

fn dyadic<B: Cast>(met: &mut Met) {
    let (name, step) = (B::S::name(), DyadicStep::<B::S, 1, 6>::new().unwrap());
    every_scene::<B>(&step, &format!("{name} 1/64"), met);
}

fn met(starts: usize) -> Met {
    Met {
        starts,
        ..Met::default()
    }
}

/// How often a scene is cut: less often where there is no time.
const fn rounds(all: usize) -> usize {
    if LAB { all } else { 1 }
}

fn check(met: &Met, least: usize) {
    let Met {
        cuts,
        inside,
        changed,
        full,
        ticks,
        ..
    } = *met;
    println!("{cuts} cuts, {ticks} ticks; {inside} inside, {changed} with newcomers, {full} full");
    assert!(cuts >= least && inside * 10 >= cuts * 9);
    assert!(changed * 2 >= cuts && full * 100 >= cuts);
}

#[test]
fn cuts_go_on_with_the_same_bits() {
    let mut met = met(rounds(9));
    at_60_hz::<Point<f32>>(&mut met);
    dyadic::<Point<f64>>(&mut met);
    at_60_hz::<Point<I16F16>>(&mut met);
    dyadic::<Point<I16F16>>(&mut met);
    dyadic::<Point<I12F20>>(&mut met);
    at_60_hz::<Point<I8F24>>(&mut met);
    dyadic::<Point<I20F12>>(&mut met);
    at_60_hz::<Point<I32F32>>(&mut met);
    check(&met, 1100 * rounds(9));
}

#[test]
fn cuts_of_bodies_that_carry_go_on_with_the_same_bits() {
    let mut met = met(rounds(6));
    at_60_hz::<Carried<f32>>(&mut met);
    dyadic::<Carried<f64>>(&mut met);
    at_60_hz::<Carried<I16F16>>(&mut met);
    dyadic::<Carried<I8F24>>(&mut met);
    check(&met, 500 * rounds(6));
}

fn turned<B: Cast + Rotating<S: Decay>>(step: &impl TimeStep<B::S>, what: &str, met: &mut Met) {
    let what = format!("{what} {}, turning", B::S::name());
    cut(turning::<B>, step, &what, met);
}

#[test]
fn cuts_of_bodies_that_turn_go_on_with_the_same_bits() {
    let mut met = met(rounds(6));
    turned::<Rigid<Point<f32>>>(&Step::hz(60).unwrap(), "1/60", &mut met);
    let dyadic = DyadicStep::<I16F16, 1, 6>::new().unwrap();
    turned::<Rigid<Point<I16F16>>>(&dyadic, "1/64", &mut met);
    turned::<RangeChecked<Rigid<Point<I8F24>>>>(&Step::hz(60).unwrap(), "1/60 watched", &mut met);
    turned::<Rigid<Carried<I16F16>>>(&Step::hz(60).unwrap(), "1/60 carried", &mut met);
    let dyadic = DyadicStep::<f32, 1, 6>::new().unwrap();
    turned::<Rigid<Carried<f32>>>(&dyadic, "1/64 carried", &mut met);
    check(&met, 230 * rounds(6));
}
