//! Snapshots that are whole, but of something else. Each has its checksum made good, so that the
//! check it is meant for is reached, and each has an error of its own.

use fixstep::fixed::types::{I16F16, I32F32};
use fixstep::{Point, SnapshotError, World};

use super::bytes::{self, length, with};
use super::samples::{Small, every_scalar, saved, world};

type Load = Result<Small<I16F16>, SnapshotError>;

fn load(bytes: &[u8]) -> Load {
    Small::load(bytes)
}

fn three() -> Vec<u8> {
    saved(&world::<I16F16>(3))
}

#[track_caller]
fn refused(found: Load, error: SnapshotError) {
    assert_eq!(found.map(drop), Err(error));
}

#[test]
fn another_version() {
    for version in [0, 2, 3, 0x0100, 0x0101, 0xFFFF] {
        let bytes = with(&three(), bytes::VERSION, version.into());
        refused(load(&bytes), SnapshotError::Version(version));
    }
}

#[test]
fn no_snapshot_at_all() {
    for place in 0..4 {
        let mut bytes = three();
        bytes[place] ^= 0x20;
        bytes::seal(&mut bytes);
        refused(load(&bytes), SnapshotError::NotASnapshot);
    }
    refused(load(&[0; 40]), SnapshotError::NotASnapshot);
}

#[test]
fn every_scalar_refuses_every_other() {
    for count in [0, 1, 8] {
        let samples = every_scalar(count);
        for reader in &samples {
            for written in &samples {
                let error = SnapshotError::Scalar(written.format);
                let same = reader.format == written.format;
                let expected = if same { Ok(()) } else { Err(error) };
                let found = (reader.load)(&written.bytes);
                assert_eq!(found, expected, "{} from {}", reader.name, written.name);
            }
        }
    }
}

#[test]
fn another_kind() {
    for kind in [0, 2, 0x8000, 0x8001, 0xFFFF] {
        let bytes = with(&three(), bytes::KIND, kind);
        refused(load(&bytes), SnapshotError::Kind(kind as u16));
    }
}

// The kind says what is in a body, so a body of another size is of another kind, even if none is
// there.
#[test]
fn bodies_of_another_size() {
    for bytes in [three(), saved(&world::<I16F16>(0))] {
        for size in [0, 19, 21, 40, 0xFFFF_FFFF] {
            let bytes = with(&bytes, bytes::SIZE, size);
            refused(load(&bytes), SnapshotError::Kind(1));
        }
    }
}

#[test]
fn more_or_fewer_bodies_than_there_are() {
    let given = length::<I16F16>(3);
    for count in [0, 1, 2, 4, 9, u32::MAX] {
        let bytes = with(&three(), bytes::COUNT, count.into());
        let needed = length::<I16F16>(count as usize);
        refused(load(&bytes), SnapshotError::Length { needed, given });
    }
}

fn room<const N: usize>(bytes: &[u8]) -> Result<(), SnapshotError> {
    World::<Point<I32F32>, N>::load(bytes).map(drop)
}

#[test]
fn a_world_with_too_little_room() {
    let bytes = saved(&world::<I32F32>(5));
    let full = |capacity| {
        Err(SnapshotError::Full {
            bodies: 5,
            capacity,
        })
    };
    assert_eq!(room::<0>(&bytes), full(0));
    assert_eq!(room::<1>(&bytes), full(1));
    assert_eq!(room::<4>(&bytes), full(4));
    assert_eq!(room::<5>(&bytes), Ok(()));
    assert_eq!(room::<60>(&bytes), Ok(()));
}

// Two faults at once: what would make all that follows meaningless comes first.
#[test]
fn the_first_fault_is_named() {
    let faults = [
        (bytes::VERSION, 2, SnapshotError::Version(2)),
        (bytes::KIND, 9, SnapshotError::Kind(9)),
        (bytes::FORMAT, 7, SnapshotError::Scalar(7)),
        (bytes::SIZE, 24, SnapshotError::Kind(1)),
    ];
    let mut bytes = with(&three(), bytes::NEXT, 0);
    refused(load(&bytes), SnapshotError::State);
    for (field, value, error) in faults.into_iter().rev() {
        bytes = with(&bytes, field, value);
        refused(load(&bytes), error);
    }
}

#[test]
fn messages_differ_and_take_one_line() {
    let errors = [
        SnapshotError::Length {
            needed: 64,
            given: 63,
        },
        SnapshotError::NotASnapshot,
        SnapshotError::Version(7),
        SnapshotError::Checksum,
        SnapshotError::Kind(0x8001),
        SnapshotError::Scalar(0x0200_0020),
        SnapshotError::Full {
            bodies: 9,
            capacity: 8,
        },
        SnapshotError::State,
    ];
    let texts = errors.map(|error| error.to_string());
    for (i, text) in texts.iter().enumerate() {
        assert!(!texts[..i].contains(text) && !text.contains('\n'), "{text}");
        assert!(text.len() < 80, "{text}");
    }
    for (text, parts) in [
        (&texts[0], ["64", "63"]),
        (&texts[2], ["7", "1"]),
        (&texts[5], ["0x02000020", ""]),
        (&texts[6], ["9", "8"]),
    ] {
        assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    }
}
