//! Bodies of one's own in a snapshot: told from points by their kind, with a state of their own that
//! they check themselves.

use fixstep::fixed::types::I16F16;
use fixstep::{Body, Point, Saved, SnapshotError, TimeStep, Vec2, Verlet, World};

use super::bytes::{self, HEADER, ID, get, with};
use super::samples;

/// A point with a count of its drifts and whether it burns: 25 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Rocket {
    point: Point<I16F16>,
    drifts: u32,
    burns: bool,
}

impl Body for Rocket {
    type S = I16F16;
    type Spin = fixstep::body::NoSpin;

    fn position(&self) -> Vec2<I16F16> {
        self.point.position()
    }

    fn velocity(&self) -> Vec2<I16F16> {
        self.point.velocity()
    }

    fn inv_mass(&self) -> <I16F16 as fixstep::Scalar>::InvMass {
        self.point.inv_mass()
    }

    fn kick(&mut self, dv: Vec2<I16F16>) {
        self.point.kick(dv);
    }

    fn push(&mut self, impulse: Vec2<I16F16>) {
        self.point.push(impulse);
    }

    fn shift(&mut self, dx: Vec2<I16F16>) {
        self.point.shift(dx);
    }

    fn drift(&mut self, step: &impl TimeStep<I16F16>) {
        self.point.drift(step);
        self.drifts += 1;
    }

    fn drift_half(&mut self, step: &impl TimeStep<I16F16>) {
        self.point.drift_half(step);
        self.drifts += 1;
    }
}

impl Saved for Rocket {
    const KIND: u16 = 0x8001;
    const BYTES: usize = <Point<I16F16> as Saved>::BYTES + 5;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        self.point.save(write);
        write(self.drifts.into(), 4);
        write(self.burns.into(), 1);
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        Some(Rocket {
            point: Point::load(read)?,
            drifts: u32::try_from(read(4)).ok()?,
            burns: match read(1) {
                0 => false,
                1 => true,
                _ => return None,
            },
        })
    }
}

type Rockets = World<Rocket, 8>;

fn three() -> Rockets {
    let mut world = World::new();
    let points = samples::world::<I16F16>(3);
    for (i, &point) in (0..).zip(points.bodies()) {
        let (drifts, burns) = (0x0102_0304 << i, i == 1);
        world
            .add(Rocket {
                point,
                drifts,
                burns,
            })
            .unwrap();
    }
    world
}

fn saved() -> Vec<u8> {
    let mut bytes = vec![0; Rockets::SNAPSHOT];
    let length = three().save(&mut bytes).unwrap();
    bytes.truncate(length);
    bytes
}

#[test]
fn a_state_of_any_size_comes_back() {
    let bytes = saved();
    assert_eq!(bytes.len(), 40 + 3 * (4 + 25));
    assert_eq!(Rockets::SNAPSHOT, 40 + 8 * (4 + 25));
    let (mut world, mut again) = (three(), Rockets::load(&bytes).unwrap());
    assert_eq!(again.bodies(), world.bodies());
    let step = fixstep::Step::hz(60).unwrap();
    for world in [&mut world, &mut again] {
        world.step(&mut Verlet, &mut (), &step);
    }
    assert_eq!(again.bodies(), world.bodies());
    assert_eq!(again.bodies()[0].drifts, 0x0102_0304 + 2);
}

#[test]
fn its_parts_stand_behind_those_of_the_point() {
    let bytes = saved();
    let points = samples::saved(&samples::world::<I16F16>(3));
    for i in 0..3 {
        let (own, point) = (HEADER + 29 * i, HEADER + 24 * i);
        assert_eq!(get(&bytes, (own, ID)), i as u64);
        assert_eq!(bytes[own + ID..][..20], points[point + ID..][..20]);
        assert_eq!(get(&bytes, (own + 24, 4)), 0x0102_0304 << i);
        assert_eq!(get(&bytes, (own + 28, 1)), u64::from(i == 1));
    }
}

#[test]
fn kinds_are_not_mistaken_for_one_another() {
    let (own, points) = (saved(), samples::saved(&samples::world::<I16F16>(3)));
    let as_points = samples::Small::<I16F16>::load(&own);
    assert_eq!(as_points.map(drop), Err(SnapshotError::Kind(0x8001)));
    let as_rockets = Rockets::load(&points);
    assert_eq!(as_rockets.map(drop), Err(SnapshotError::Kind(1)));
}

#[test]
fn what_a_body_refuses_is_no_state() {
    for (value, expected) in [(0, Ok(())), (1, Ok(())), (2, Err(SnapshotError::State))] {
        let bytes = with(&saved(), (HEADER + 28, 1), value);
        assert_eq!(Rockets::load(&bytes).map(drop), expected);
    }
    let mass = (HEADER + ID + 16, 4);
    let bytes = with(&saved(), mass, 0);
    assert_eq!(Rockets::load(&bytes).map(drop), Err(SnapshotError::State));
}

// The same kind with a state that grew, as after an update of a program.
#[test]
fn an_older_body_of_the_same_kind_is_refused() {
    let bytes = with(&saved(), bytes::SIZE, 24);
    let found = Rockets::load(&bytes).map(drop);
    assert_eq!(found, Err(SnapshotError::Kind(0x8001)));
}
