//! Any bytes at all: nothing panics, and what is accepted is a world that can be stepped. Random
//! strings stop at the first four bytes, so others have their checksum made good.

use fixstep::fixed::types::{I16F16, I32F32};
use fixstep::{Body, Factor, Force, Point, Saved, SnapshotError, Step, Stored};

use super::bytes::{self, HEADER, ID, Kept, Random, body, length, put, seal};
use super::samples::saved;
use super::scenes::{ROOM, Scene, flight, stars, start, tied};
use crate::support::SCHEMES;

const SPELLS: usize = 340_000;
const MUTANTS: usize = 100_000;
const FORGERIES: usize = 100_000;
/// Of so many accepted worlds one is stepped.
const EVERY: usize = 5;

#[derive(Default)]
struct Tally {
    accepted: usize,
    stepped: usize,
    /// Refusals, one for each kind of error.
    refused: [usize; 8],
}

impl Tally {
    fn refuse(&mut self, error: SnapshotError) {
        use SnapshotError::*;
        let kind = match error {
            Length { .. } => 0,
            NotASnapshot => 1,
            Version(_) => 2,
            Checksum => 3,
            Kind(_) => 4,
            Scalar(_) => 5,
            Full { .. } => 6,
            State => 7,
            _ => unreachable!(),
        };
        self.refused[kind] += 1;
    }

    fn print(&self, what: &str) {
        let Tally {
            accepted,
            stepped,
            refused,
        } = self;
        println!("{what}: {accepted} accepted, {stepped} of them stepped, refused {refused:?}");
    }
}

/// Loads, and looks at what came of it.
fn attempt<S: Kept>(bytes: &[u8], tally: &mut Tally) {
    let world = match Scene::<Point<S>>::load(bytes) {
        Ok(world) => world,
        Err(error) => return tally.refuse(error),
    };
    assert!(world.len() <= ROOM && world.bodies().len() == world.ids().len());
    assert!(world.ids().windows(2).all(|pair| pair[0] < pair[1]));
    for body in world.bodies() {
        let inverse = body.inv_mass().to_f64();
        assert!(0.0 < inverse && inverse < f64::INFINITY, "{inverse}");
    }
    assert_eq!(saved(&world), bytes);
    let twin = world.bodies().first().copied();
    if let Some(Ok(id)) = twin.map(|twin| world.clone().add(twin)) {
        assert!(world.ids().iter().all(|&other| other < id));
    }
    tally.accepted += 1;
    if tally.accepted.is_multiple_of(EVERY) {
        match tally.accepted / EVERY % 3 {
            0 => go_on(world, flight::<Point<S>>, tally),
            1 => go_on(world, tied::<Point<S>>, tally),
            _ => go_on(world, stars::<Point<S>>, tally),
        }
    }
}

/// Two steps by each method: the arithmetic is total for every state there is.
fn go_on<S: Kept, F: Force<Point<S>>>(
    world: Scene<Point<S>>,
    build: fn(&Scene<Point<S>>) -> F,
    tally: &mut Tally,
) {
    let step = Step::hz(60).unwrap();
    for scheme in SCHEMES {
        let (mut world, mut method) = (world.clone(), scheme.method());
        let mut forces = build(&world);
        for _ in 0..2 {
            world.step(&mut method, &mut forces, &step);
        }
    }
    tally.stepped += 1;
}

fn every_scalar(seed: u64, what: &str, test: [fn(&mut Random, &mut Tally); 3]) -> Tally {
    let (mut random, mut tally) = (Random(seed), Tally::default());
    for test in test {
        test(&mut random, &mut tally);
    }
    tally.print(what);
    tally
}

fn spells<S: Kept>(random: &mut Random, tally: &mut Tally) {
    for _ in 0..SPELLS {
        let count = random.below(Scene::<Point<S>>::SNAPSHOT + 9);
        attempt::<S>(&random.bytes(count), tally);
    }
}

#[test]
fn a_million_random_strings() {
    let scalars = [spells::<f32>, spells::<I16F16>, spells::<I32F32>];
    let tally = every_scalar(0x5EED, "random strings", scalars);
    assert_eq!(
        tally.accepted + tally.refused.iter().sum::<usize>(),
        3 * SPELLS
    );
}

/// A valid snapshot with some of its bytes replaced: one, two, or up to all.
fn mutants<S: Kept>(random: &mut Random, tally: &mut Tally) {
    let valid: Vec<_> = (0..8).map(|seed| saved(&start::<Point<S>>(seed))).collect();
    for i in 0..MUTANTS {
        let mut bytes = valid[i % valid.len()].clone();
        let front = [0, bytes::TICK.0, HEADER][random.below(3)];
        let most = [1, 2, 8, bytes.len()][random.below(4)];
        for _ in 0..=random.below(most) {
            let place = front + random.below(bytes.len() - front);
            bytes[place] = random.next() as u8;
        }
        seal(&mut bytes);
        attempt::<S>(&bytes, tally);
    }
}

#[test]
fn mutants_with_a_good_checksum() {
    let scalars = [mutants::<f32>, mutants::<I16F16>, mutants::<I32F32>];
    let tally = every_scalar(0x3117, "mutants", scalars);
    assert!(tally.accepted >= 20_000 && tally.stepped >= 4_000);
    assert!(tally.refused[7] >= 20_000, "states: {:?}", tally.refused);
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
        attempt::<S>(&bytes, tally);
    }
}

#[test]
fn forgeries_reach_every_check() {
    let scalars = [forgeries::<f32>, forgeries::<I16F16>, forgeries::<I32F32>];
    let tally = every_scalar(0xF06E, "forgeries", scalars);
    assert!(tally.accepted >= 20_000 && tally.stepped >= 4_000);
    // Magic, version and checksum are right by design.
    let [length, _, _, _, kind, scalar, full, state] = tally.refused;
    assert!(
        [length, kind, scalar, full, state]
            .iter()
            .all(|&count| count >= 1_000)
    );
}
