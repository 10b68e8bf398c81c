//! How many bytes there are, and what each of them is, by the table in the documentation.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::{Point, SnapshotError, World, vec2};

use super::bytes::{self, HEADER, Kept, get, length};
use super::samples::{ROOM, Small, all, saved, world};

fn sizes<S: Kept>(per_point: usize) {
    for count in 0..=ROOM {
        let expected = 40 + per_point * count;
        assert_eq!(saved(&world::<S>(count)).len(), expected, "{}", S::name());
        assert_eq!(length::<S>(count), expected);
    }
    assert_eq!(Small::<S>::SNAPSHOT, 40 + per_point * ROOM);
    assert_eq!(World::<Point<S>, 0>::SNAPSHOT, 40);
}

#[test]
fn a_point_takes_24_bytes_in_32_bits_and_44_in_64() {
    sizes::<f32>(24);
    sizes::<I16F16>(24);
    sizes::<I12F20>(24);
    sizes::<I8F24>(24);
    sizes::<I20F12>(24);
    sizes::<f64>(44);
    sizes::<I32F32>(44);
}

#[test]
fn the_header_says_what_follows() {
    for sample in all() {
        let field = |field| get(&sample.bytes, field);
        let point = if sample.format & 0x40 != 0 || sample.format & 0x4000 != 0 {
            40
        } else {
            20
        };
        assert_eq!(sample.bytes[..4], *b"fixs");
        assert_eq!((field(bytes::VERSION), field(bytes::KIND)), (1, 1));
        assert_eq!(field(bytes::FORMAT), u64::from(sample.format));
        assert_eq!(field(bytes::SIZE), point, "{}", sample.name);
        let count = (sample.bytes.len() - HEADER) as u64 / (point + 4);
        // A body of every third is added after one that is taken out again.
        let next = count + (count + 1) / 3;
        assert_eq!((field(bytes::COUNT), field(bytes::TICK)), (count, 7));
        assert_eq!(field(bytes::NEXT), next, "{}", sample.name);
        let mut sealed = sample.bytes.clone();
        bytes::seal(&mut sealed);
        assert_eq!(sealed, sample.bytes, "{}", sample.name);
    }
}

/// Fails where version 1 becomes another format.
fn golden<S: Kept>(format: u32, state: [u32; 5]) {
    let mut world = World::<Point<S>, 2>::new();
    let body = Point::new(vec2(0, 2).unwrap(), vec2(3, -1).unwrap(), 1).unwrap();
    let gone = world.add(body).unwrap();
    world.add(body).unwrap();
    world.remove(gone).unwrap();
    let mut expected = Vec::from(*b"fixs\x01\0\x01\0");
    // Number type, bytes a body, number of bodies, tick, next id.
    let words = [format, 20, 1, 0, 0, 2, 0];
    words
        .iter()
        .for_each(|word| expected.extend(word.to_le_bytes()));
    let id = 1_u32;
    let behind: Vec<u8> = [id]
        .iter()
        .chain(&state)
        .flat_map(|word| word.to_le_bytes())
        .collect();
    let sum = bytes::fnv1a(expected.iter().chain(&behind).copied());
    expected.extend(sum.to_le_bytes());
    expected.extend(behind);
    assert_eq!(saved(&world), expected, "{}", S::name());
}

// 2, 3 and -1 in units of 2^-16 and as floats. One kilogram: a mantissa of 2^30, so that the five
// bits of its exponent, above 2^-20, are ten.
#[test]
fn every_byte_of_a_small_world() {
    let kilogram = 1 << 30 | 10;
    golden::<I16F16>(
        0x0100_2010,
        [0, 2 << 16, 3 << 16, -(1_i32 << 16) as u32, kilogram],
    );
    golden::<I8F24>(
        0x0100_2018,
        [0, 2 << 24, 3 << 24, -(1_i32 << 24) as u32, kilogram],
    );
    golden::<f32>(
        0x0200_0020,
        [0, 0x4000_0000, 0x4040_0000, 0xBF80_0000, 0x3F80_0000],
    );
}

#[test]
fn a_short_slice_stays_as_it_was() {
    let world = world::<I16F16>(3);
    let needed = length::<I16F16>(3);
    for given in 0..needed {
        let mut bytes = vec![0xA5; given];
        let error = SnapshotError::Length { needed, given };
        assert_eq!(world.save(&mut bytes), Err(error));
        assert!(bytes.iter().all(|&byte| byte == 0xA5), "{given}");
    }
}

#[test]
fn of_a_long_slice_the_front_is_written() {
    let world = world::<f32>(3);
    let needed = length::<f32>(3);
    for more in [0, 1, 3, 24, 1000] {
        let mut bytes = vec![0xA5; needed + more];
        assert_eq!(world.save(&mut bytes), Ok(needed));
        assert_eq!(bytes[..needed], saved(&world));
        assert!(bytes[needed..].iter().all(|&byte| byte == 0xA5), "{more}");
    }
}

// The values that the authors of the hash publish.
#[test]
fn the_checksum_of_these_tests_is_fnv_1a() {
    for (text, sum) in [
        ("", 0x811C_9DC5),
        ("a", 0xE40C_292C),
        ("foobar", 0xBF9C_F968),
    ] {
        assert_eq!(bytes::fnv1a(text.bytes()), sum);
    }
}
