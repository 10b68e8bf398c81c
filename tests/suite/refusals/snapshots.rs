//! Snapshots that are refused.

use fixstep::world::snapshot::HEADER;
use fixstep::{TimeStep, Vec2};

use super::*;

type Scene = World<Point<I16F16>, 3>;

fn saved() -> Vec<u8> {
    let mut world = Scene::new();
    for mass in 1..=3 {
        world.add(point(mass).unwrap()).unwrap();
    }
    let mut bytes = vec![0; Scene::SNAPSHOT];
    let length = world.save(&mut bytes).unwrap();
    assert_eq!(length, bytes.len());
    assert!(Scene::load(&bytes).is_ok());
    bytes
}

/// The bytes with that at `place` changed and the sum made right again.
fn forged(place: usize, change: impl Fn(&mut u8)) -> Vec<u8> {
    let mut bytes = saved();
    change(&mut bytes[place]);
    summed(bytes)
}

fn summed(mut bytes: Vec<u8>) -> Vec<u8> {
    let counted = (0..bytes.len()).filter(|place| !(36..40).contains(place));
    let sum = counted.fold(0x811C_9DC5_u32, |sum, place| {
        (sum ^ u32::from(bytes[place])).wrapping_mul(0x0100_0193)
    });
    bytes[36..40].copy_from_slice(&sum.to_le_bytes());
    bytes
}

fn load(bytes: &[u8]) -> String {
    refused(Scene::load(bytes))
}

/// What a world says that has room but has given its last id.
pub fn no_id_left() -> String {
    let mut bytes = saved();
    bytes[28..36].copy_from_slice(&(1_u64 << 32).to_le_bytes());
    let mut world = World::<Point<I16F16>, 4>::load(&summed(bytes)).unwrap();
    assert_eq!(world.len(), 3);
    let error = world.add(point(7).unwrap()).unwrap_err();
    assert_eq!((error.body, world.len()), (point(7).unwrap(), 3));
    name(error)
}

pub fn short_slice() -> Errors {
    let mut short = vec![7; HEADER + 23];
    let mut world = Scene::new();
    world.add(point(1).unwrap()).unwrap();
    let error = refused(world.save(&mut short));
    assert!(short.iter().all(|&byte| byte == 7));
    vec![error]
}

pub fn other_length() -> Errors {
    // A forged count, since a cut alone shows in the sum already.
    vec![
        load(&[]),
        load(&saved()[..HEADER - 1]),
        load(&forged(16, |count| *count = 2)),
    ]
}

pub fn other_bytes() -> Errors {
    vec![load(&[0; 100]), load(&forged(3, |byte| *byte = b'S'))]
}

pub fn other_version() -> Errors {
    vec![load(&forged(4, |version| *version += 1))]
}

pub fn changed_bit() -> Errors {
    let bytes = saved();
    let flipped = |bit: usize| {
        let mut bytes = bytes.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        load(&bytes)
    };
    // Behind the version, which is looked at first.
    let mut errors: Errors = (8 * 6..8 * bytes.len()).map(flipped).collect();
    errors.extend((HEADER..bytes.len()).map(|end| load(&bytes[..end])));
    errors
}

/// A point that says it is something else.
#[derive(Clone, Copy, Debug)]
struct Other(Point<I16F16>);

impl Body for Other {
    type S = I16F16;
    type Spin = fixstep::body::NoSpin;

    fn position(&self) -> Vec2<I16F16> {
        self.0.position()
    }

    fn velocity(&self) -> Vec2<I16F16> {
        self.0.velocity()
    }

    fn inv_mass(&self) -> <I16F16 as fixstep::Scalar>::InvMass {
        self.0.inv_mass()
    }

    fn kick(&mut self, dv: Vec2<I16F16>) {
        self.0.kick(dv);
    }

    fn push(&mut self, impulse: Vec2<I16F16>) {
        self.0.push(impulse);
    }

    fn shift(&mut self, dx: Vec2<I16F16>) {
        self.0.shift(dx);
    }

    fn drift(&mut self, step: &impl TimeStep<I16F16>) {
        self.0.drift(step);
    }

    fn drift_half(&mut self, step: &impl TimeStep<I16F16>) {
        self.0.drift_half(step);
    }
}

impl fixstep::Saved for Other {
    const KIND: u16 = 0x8000;
    const BYTES: usize = Point::<I16F16>::BYTES;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        self.0.save(write);
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        Point::load(read).map(Other)
    }
}

pub fn other_kind() -> Errors {
    vec![refused(World::<Other, 3>::load(&saved()))]
}

pub fn other_scalar() -> Errors {
    vec![
        refused(World::<Point<I8F24>, 3>::load(&saved())),
        refused(World::<Point<f32>, 3>::load(&saved())),
    ]
}

pub fn other_room() -> Errors {
    vec![refused(World::<Point<I16F16>, 2>::load(&saved()))]
}

pub fn other_state() -> Errors {
    let second = HEADER + 24;
    vec![
        load(&forged(second, |id| *id = 0)),
        load(&forged(28, |next| *next = 2)),
        load(&forged(HEADER + 23, |mass| *mass = 0)),
    ]
}
