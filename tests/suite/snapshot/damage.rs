//! Damaged bytes are refused: each bit and each byte in turn, every loss and every addition.

use fixstep::fixed::types::I16F16;
use fixstep::{Carried, Point, RangeChecked, Rigid, SnapshotError, Stored};

use super::bytes::{HEADER, Random, VERSION, get, seal};
use super::cast::Cast;
use super::samples::{self, Sample, saved};
use super::scenes::{Scene, start};
use crate::support::Format;

/// Five bodies, of which one is driven and one locked where they turn.
fn sample<B: Cast>(name: &str) -> Sample {
    Sample {
        name: format!("{name} of {}", B::S::name()),
        bytes: saved(&start::<B>(3)),
        format: B::S::FORMAT,
        load: |bytes| Scene::<B>::load(bytes).map(drop),
    }
}

fn all() -> impl Iterator<Item = Sample> {
    samples::all().chain([
        sample::<Rigid<Point<f32>>>("rigid points"),
        sample::<Rigid<Carried<I16F16>>>("rigid bodies that carry"),
        sample::<RangeChecked<Rigid<Point<I16F16>>>>("watched rigid points"),
    ])
}

/// What a byte that was changed must lead to. Magic and version are looked at before the checksum,
/// so that another version may have another checksum.
fn expected(damaged: &[u8], place: usize) -> SnapshotError {
    match place {
        0..4 => SnapshotError::NotASnapshot,
        4..6 => SnapshotError::Version(get(damaged, VERSION) as u16),
        _ => SnapshotError::Checksum,
    }
}

/// Every byte in turn, changed in each of the ways in `masks`; returns how many were refused.
fn flip(sample: &Sample, masks: impl Iterator<Item = u8> + Clone) -> usize {
    let mut damaged = sample.bytes.clone();
    let mut refused = 0;
    for place in 0..damaged.len() {
        for mask in masks.clone() {
            damaged[place] ^= mask;
            let expected = expected(&damaged, place);
            let found = (sample.load)(&damaged);
            assert_eq!(
                found,
                Err(expected),
                "{} byte {place} ^ {mask:#x}",
                sample.name
            );
            damaged[place] ^= mask;
            refused += 1;
        }
    }
    assert_eq!((sample.load)(&damaged), Ok(()));
    refused
}

#[test]
fn every_flipped_bit_is_refused() {
    let bits = all().map(|sample| flip(&sample, (0..8).map(|bit| 1 << bit)));
    println!("{} bits flipped", bits.sum::<usize>());
}

// Not by luck: from two inputs that differ in one byte, FNV-1a goes on with two sums, and each step
// after that can be undone.
#[test]
fn every_other_byte_in_every_place_is_refused() {
    let small = all().filter(|sample| sample.bytes.len() <= HEADER + 2 * 44);
    let bytes = small.map(|sample| flip(&sample, 1..=255));
    println!("{} bytes replaced", bytes.sum::<usize>());
}

/// As it is, and with the checksum made good: then only the length can tell.
fn assert_refused(sample: &Sample, mut bytes: Vec<u8>) {
    let given = bytes.len();
    assert_ne!((sample.load)(&bytes), Ok(()), "{} as {given}", sample.name);
    let mut needed = HEADER;
    if given >= HEADER {
        seal(&mut bytes);
        needed = sample.bytes.len();
    }
    let error = SnapshotError::Length { needed, given };
    assert_eq!(
        (sample.load)(&bytes),
        Err(error),
        "{} as {given}",
        sample.name
    );
}

#[test]
fn every_truncation_is_refused() {
    let mut count = 0;
    for sample in all() {
        for given in 0..sample.bytes.len() {
            assert_refused(&sample, sample.bytes[..given].to_vec());
            count += 1;
        }
    }
    println!("{count} truncations");
}

#[test]
fn every_extension_is_refused() {
    let mut random = Random(0xE7);
    let mut count = 0;
    for sample in all() {
        for more in 1..=100 {
            for tail in [vec![0; more], random.bytes(more)] {
                assert_refused(&sample, [sample.bytes.as_slice(), &tail].concat());
                count += 1;
            }
        }
    }
    println!("{count} extensions");
}
