//! The hash of a state: equal for equal states, another for any bit.

use fixstep::fixed::types::I16F16;
use fixstep::{Body, Point, SemiImplicitEuler, Step, TimeStep, Vec2, World, vec2};

/// Takes any bits, NaN too.
#[derive(Clone, Copy)]
struct Loose([f32; 4]);

impl Body for Loose {
    type S = f32;
    type Spin = fixstep::body::NoSpin;

    fn position(&self) -> Vec2<f32> {
        Vec2::new(self.0[0], self.0[1])
    }

    fn velocity(&self) -> Vec2<f32> {
        Vec2::new(self.0[2], self.0[3])
    }

    fn inv_mass(&self) -> f32 {
        1.0
    }

    fn kick(&mut self, _: Vec2<f32>) {}

    fn push(&mut self, _: Vec2<f32>) {}

    fn shift(&mut self, _: Vec2<f32>) {}

    fn drift(&mut self, _: &impl TimeStep<f32>) {}

    fn drift_half(&mut self, _: &impl TimeStep<f32>) {}
}

fn loose(state: [f32; 4]) -> u64 {
    let mut world = World::<Loose, 1>::new();
    let _ = world.add(Loose(state));
    world.state_hash()
}

fn fixed(state: [i32; 4]) -> u64 {
    let [x, y, u, v] = state.map(I16F16::from_bits);
    let mut world = World::<_, 2>::new();
    world
        .add(Point::new(Vec2::new(x, y), Vec2::new(u, v), 1).unwrap())
        .unwrap();
    world.state_hash()
}

#[test]
fn every_bit_of_a_state_counts() {
    let state = [0x1234_5678, -0x1234_5678, 1, 0];
    let mut seen = vec![fixed(state)];
    for place in 0..4 {
        for bit in 0..32 {
            let mut other = state;
            other[place] ^= 1 << bit;
            seen.push(fixed(other));
        }
    }
    seen.push(fixed([state[1], state[0], state[2], state[3]]));
    seen.push(fixed([state[2], state[3], state[0], state[1]]));
    let count = seen.len();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), count);
}

#[test]
fn equal_states_hash_alike() {
    assert_eq!(loose([0.0, 1.0, -0.0, 2.0]), loose([-0.0, 1.0, 0.0, 2.0]));
    let [quiet, payload, minus] = [0x7FC0_0000, 0x7FC1_2345, 0xFFC0_0000].map(f32::from_bits);
    assert_eq!(
        loose([quiet, 0.0, 0.0, 0.0]),
        loose([payload, 0.0, 0.0, 0.0])
    );
    assert_eq!(loose([0.0, 0.0, 0.0, quiet]), loose([0.0, 0.0, 0.0, minus]));
    assert_ne!(loose([quiet, 0.0, 0.0, 0.0]), loose([0.0; 4]));
    assert_ne!(loose([f32::MIN_POSITIVE, 0.0, 0.0, 0.0]), loose([0.0; 4]));
}

#[test]
fn ids_and_ticks_count() {
    let rest = Point::<f32>::new(vec2(0, 0).unwrap(), vec2(0, 0).unwrap(), 1).unwrap();
    let mut world = World::<_, 2>::new();
    let first = world.add(rest).unwrap();
    let before = world.state_hash();

    let mut renamed = world.clone();
    renamed.remove(first).unwrap();
    renamed.add(rest).unwrap();
    assert_eq!(renamed.bodies(), world.bodies());
    assert_ne!(renamed.state_hash(), before);

    world.step(&mut SemiImplicitEuler, &mut (), &Step::hz(60).unwrap());
    assert_eq!(renamed.bodies(), world.bodies());
    assert_ne!(world.state_hash(), before);
}

// Eight bytes of the tick, then four of the serial number and four zero bytes, then the bits.
#[test]
fn is_fnv_1a() {
    let words = [
        0_u64,
        0,
        u64::from(1.5_f32.to_bits()),
        0,
        0,
        u64::from((-2.0_f32).to_bits()),
    ];
    let bytes = words.into_iter().flat_map(u64::to_le_bytes);
    let hash = bytes.fold(0xCBF2_9CE4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3)
    });
    assert_eq!(loose([1.5, 0.0, 0.0, -2.0]), hash);
}
