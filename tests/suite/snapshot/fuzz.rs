//! Any bytes at all: nothing panics, and what is accepted is a world that can be stepped. Random
//! strings stop at the first four bytes, so others have their checksum made good.

use fixstep::fixed::types::{I16F16, I32F32};
use fixstep::{Body, Carried, Force, Point, RangeChecked, Rigid, Saved, Step, Stored};

use super::bytes::{self, HEADER, ID, Kept, Random, body, length, put, seal};
use super::cast::Cast;
use super::samples::saved;
use super::scenes::{ROOM, Scene, flight, stars, start, tied};
use super::tally::Tally;
use super::turning::turning;
use crate::support::{SCHEMES, long};

const SPELLS: usize = long(340_000) as usize;
const MUTANTS: usize = long(100_000) as usize;
const TURNING_MUTANTS: usize = long(40_000) as usize;
const FORGERIES: usize = long(100_000) as usize;
/// Of so many accepted worlds one is stepped.
const EVERY: usize = 5;

/// A body whose worlds are stepped, by one of three scenes.
trait Stepped: Cast {
    fn go_on(world: Scene<Self>, scene: usize);
}

impl<S: Kept> Stepped for Point<S> {
    fn go_on(world: Scene<Self>, scene: usize) {
        match scene {
            0 => go_on(world, flight::<Self>),
            1 => go_on(world, tied::<Self>),
            _ => go_on(world, stars::<Self>),
        }
    }
}

macro_rules! turning {
    ($($body:ty),*) => {
        $(
            impl Stepped for $body {
                fn go_on(world: Scene<Self>, _: usize) {
                    go_on(world, turning::<Self>);
                }
            }
        )*
    };
}

turning!(
    Rigid<Point<I16F16>>,
    Rigid<Carried<I16F16>>,
    Rigid<Carried<f32>>,
    RangeChecked<Rigid<Point<f32>>>
);

/// Loads, and looks at what came of it.
fn attempt<B: Stepped>(bytes: &[u8], tally: &mut Tally) {
    let world = match Scene::<B>::load(bytes) {
        Ok(world) => world,
        Err(error) => return tally.refuse(error),
    };
    assert!(world.len() <= ROOM && world.bodies().len() == world.ids().len());
    assert!(world.ids().windows(2).all(|pair| pair[0] < pair[1]));
    world.bodies().iter().for_each(Cast::assert_sound);
    let again = saved(&world);
    assert_eq!(saved(&Scene::<B>::load(&again).unwrap()), again);
    assert!(again == bytes || !B::EXACT);
    let twin = world.bodies().first().copied();
    if let Some(Ok(id)) = twin.map(|twin| world.clone().add(twin)) {
        assert!(world.ids().iter().all(|&other| other < id));
    }
    tally.accepted += 1;
    if tally.accepted.is_multiple_of(EVERY) {
        B::go_on(world, tally.accepted / EVERY % 3);
        tally.stepped += 1;
    }
}

/// Two steps by each method: the arithmetic is total for every state there is.
fn go_on<B: Cast, F: Force<B>>(world: Scene<B>, build: fn(&Scene<B>) -> F) {
    let step = Step::hz(60).unwrap();
    for scheme in SCHEMES {
        let (mut world, mut method) = (world.clone(), scheme.method());
        let mut forces = build(&world);
        for _ in 0..2 {
            world.step(&mut method, &mut forces, &step);
        }
    }
}

fn every_body<const N: usize>(
    seed: u64,
    what: &str,
    test: [fn(&mut Random, &mut Tally); N],
) -> Tally {
    let (mut random, mut tally) = (Random(seed), Tally::default());
    for test in test {
        test(&mut random, &mut tally);
    }
    tally.print(what);
    tally
}

fn spells<B: Stepped>(random: &mut Random, tally: &mut Tally) {
    for _ in 0..SPELLS {
        let count = random.below(Scene::<B>::SNAPSHOT + 9);
        attempt::<B>(&random.bytes(count), tally);
    }
}

#[test]
fn random_strings() {
    let points = [
        spells::<Point<f32>>,
        spells::<Point<I16F16>>,
        spells::<Point<I32F32>>,
    ];
    let tally = every_body(0x5EED, "random strings", points);
    assert_eq!(
        tally.accepted + tally.refused.iter().sum::<usize>(),
        3 * SPELLS
    );
}

/// A valid snapshot with some of its bytes replaced: one, two, or up to all.
fn mutants<B: Stepped, const COUNT: usize>(random: &mut Random, tally: &mut Tally) {
    let valid: Vec<_> = (0..8).map(|seed| saved(&start::<B>(seed))).collect();
    for i in 0..COUNT {
        let mut bytes = valid[i % valid.len()].clone();
        let front = [0, bytes::TICK.0, HEADER][random.below(3)];
        let most = [1, 2, 8, bytes.len()][random.below(4)];
        for _ in 0..=random.below(most) {
            let place = front + random.below(bytes.len() - front);
            bytes[place] = random.next() as u8;
        }
        seal(&mut bytes);
        attempt::<B>(&bytes, tally);
    }
}

#[test]
fn mutants_with_a_good_checksum() {
    let points = [
        mutants::<Point<f32>, MUTANTS>,
        mutants::<Point<I16F16>, MUTANTS>,
        mutants::<Point<I32F32>, MUTANTS>,
    ];
    let tally = every_body(0x3117, "mutants", points);
    assert!(tally.accepted >= long(20_000) as usize && tally.stepped >= long(4_000) as usize);
    assert!(
        tally.refused[7] >= long(20_000) as usize,
        "states: {:?}",
        tally.refused
    );
}

// Their strings stop where those of points do, so there are fewer of them.
#[test]
fn mutants_and_strings_of_bodies_that_turn() {
    let bodies = [
        mutants::<Rigid<Point<I16F16>>, TURNING_MUTANTS>,
        mutants::<Rigid<Carried<I16F16>>, TURNING_MUTANTS>,
        mutants::<Rigid<Carried<f32>>, TURNING_MUTANTS>,
        mutants::<RangeChecked<Rigid<Point<f32>>>, TURNING_MUTANTS>,
        spells::<Rigid<Point<I16F16>>>,
    ];
    let tally = every_body(0x7417, "bodies that turn", bodies);
    assert!(tally.accepted >= long(20_000) as usize && tally.stepped >= long(4_000) as usize);
    assert!(
        tally.refused[7] >= long(20_000) as usize,
        "states: {:?}",
        tally.refused
    );
}

/// One of `likely`, or any word.
fn pick(random: &mut Random, likely: &[u64]) -> u64 {
    let word = random.next() >> random.below(64);
    likely
        .get(random.below(likely.len() + 1))
        .copied()
        .unwrap_or(word)
}

/// Random bytes under a header that is right but for a field now and then.
fn forgeries<S: Kept>(random: &mut Random, tally: &mut Tally) {
    let (size, format) = (<Point<S> as Saved>::BYTES as u64, S::FORMAT.into());
    let mass = start::<Point<S>>(0).bodies()[0].inv_mass().store();
    for _ in 0..FORGERIES {
        let count = random.below(ROOM + 3);
        let mut bytes = random.bytes(length::<S>(count));
        bytes[..4].copy_from_slice(b"fixs");
        put(&mut bytes, bytes::VERSION, 1);
        put(&mut bytes, bytes::KIND, pick(random, &[1; 15]));
        put(&mut bytes, bytes::FORMAT, pick(random, &[format; 15]));
        put(&mut bytes, bytes::SIZE, pick(random, &[size; 15]));
        put(&mut bytes, bytes::COUNT, pick(random, &[count as u64; 15]));
        put(
            &mut bytes,
            bytes::TICK,
            pick(random, &[0, 1, 1 << 32, u64::MAX]),
        );
        let next = pick(
            random,
            &[9, 1 << 31, u32::MAX.into(), 1 << 32, (1 << 32) + 1],
        );
        put(&mut bytes, bytes::NEXT, next);
        for i in 0..count {
            let (at, mass_at) = (body::<S>(i), body::<S>(i) + 4 * size_of::<S>());
            put(&mut bytes, (at - ID, ID), pick(random, &[i as u64; 15]));
            put(
                &mut bytes,
                (mass_at, size_of::<S>()),
                pick(random, &[mass; 15]),
            );
        }
        seal(&mut bytes);
        attempt::<Point<S>>(&bytes, tally);
    }
}

#[test]
fn forgeries_reach_every_check() {
    let scalars = [forgeries::<f32>, forgeries::<I16F16>, forgeries::<I32F32>];
    let tally = every_body(0xF06E, "forgeries", scalars);
    assert!(tally.accepted >= long(20_000) as usize && tally.stepped >= long(4_000) as usize);
    // Magic, version and checksum are right by design.
    let [length, _, _, _, kind, scalar, full, state] = tally.refused;
    assert!(
        [length, kind, scalar, full, state]
            .iter()
            .all(|&count| count >= long(1_000) as usize)
    );
}
