//! A million random calls against a plain list of everything that was ever added.

use crate::support::long;
use fixstep::{BodyId, Point, Stale, World, vec2};

const ROOM: usize = 32;

/// What every id ever given stands for; its place is its serial number.
#[derive(Default)]
struct Model {
    given: Vec<(BodyId, i32)>,
    live: Vec<usize>,
}

struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as usize % end
    }
}

fn body(name: i32) -> Point<f64> {
    Point::new(vec2(name, 0).unwrap(), vec2(0, 0).unwrap(), 1).unwrap()
}

impl Model {
    fn add(&mut self, world: &mut World<Point<f64>, ROOM>) {
        let name = self.given.len() as i32;
        let added = world.add(body(name));
        assert_eq!(added.is_ok(), self.live.len() < ROOM);
        if let Ok(id) = added {
            self.live.push(self.given.len());
            self.given.push((id, name));
        }
    }

    fn remove(&mut self, world: &mut World<Point<f64>, ROOM>, serial: usize) {
        let (id, name) = self.given[serial];
        let place = self.live.iter().position(|&live| live == serial);
        assert_eq!(world.remove(id), place.map(|_| body(name)).ok_or(Stale(id)));
        place.map(|place| self.live.remove(place));
    }

    fn look(&self, world: &mut World<Point<f64>, ROOM>, serial: usize) {
        let (id, name) = self.given[serial];
        let live = self.live.contains(&serial);
        let expected = live.then(|| body(name)).ok_or(Stale(id));
        assert_eq!(world.get(id).copied(), expected);
        assert_eq!(world.get_mut(id).copied(), expected);
    }

    fn compare(&self, world: &World<Point<f64>, ROOM>) {
        let names = world.iter().map(|(id, body)| (id, body.position().x));
        let expected = self.live.iter().map(|&serial| {
            let (id, name) = self.given[serial];
            (id, f64::from(name))
        });
        assert!(names.eq(expected));
    }
}

/// Live, or stale: one in three of the last hundred, so that both are met often.
fn some_serial(random: &mut Random, model: &Model) -> usize {
    match random.below(3) {
        0 if !model.live.is_empty() => model.live[random.below(model.live.len())],
        1 => model.given.len() - 1 - random.below(model.given.len().min(100)),
        _ => random.below(model.given.len()),
    }
}

#[test]
fn a_stale_id_finds_nothing() {
    let (mut world, mut model) = (World::new(), Model::default());
    let mut random = Random(1);
    model.add(&mut world);
    for call in 0..long(1_000_000) {
        let serial = some_serial(&mut random, &model);
        match random.below(2) {
            0 => model.add(&mut world),
            _ => model.remove(&mut world, serial),
        }
        let serial = some_serial(&mut random, &model);
        model.look(&mut world, serial);
        if call % 500 == 0 {
            model.compare(&world);
        }
    }
    assert!(model.given.len() as u64 > long(100_000));
}
