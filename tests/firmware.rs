//! The committed figures of the firmware: the host makes the same bits, and the README the same
//! numbers. The figures themselves come from `examples/firmware/run`.

#[path = "../examples/firmware/src/carry.rs"]
mod carry;
#[path = "../examples/firmware/src/every_verb.rs"]
mod every_verb;
#[path = "../examples/firmware/src/scene.rs"]
mod scene;

use carry::{Carried, Compensated};
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Body, DyadicStep, Method, Point, SemiImplicitEuler, Step, TimeStep, Verlet, World};
use scene::POINTS;

const RESULTS: &str = include_str!("../examples/firmware/results.tsv");
const ARCHITECTURE: &str = include_str!("../ARCHITECTURE.md");
const README: &str = include_str!("../README.md");

/// Steps that the image makes before it hashes.
const STEPS: u32 = 600;

fn rows() -> impl Iterator<Item = [&'static str; 6]> {
    RESULTS.lines().skip(1).map(|line| {
        let mut fields = line.split('\t');
        std::array::from_fn(|_| fields.next().unwrap_or(""))
    })
}

fn hash<B, M, H>(mut method: M, step: H) -> u64
where
    B: Body + From<Point<B::S>>,
    M: Method<B, POINTS>,
    H: TimeStep<B::S>,
{
    let mut world = World::new();
    scene::build(&mut world).unwrap();
    scene::run(
        &mut world,
        &mut method,
        &step,
        &mut scene::gravity().unwrap(),
        STEPS,
    );
    world.state_hash()
}

fn by_step<B>(step: &str, method: &str) -> u64
where
    B: Body + From<Point<B::S>>,
{
    match (step, method) {
        ("1/60", "SemiImplicitEuler") => hash::<B, _, _>(SemiImplicitEuler, Step::hz(60).unwrap()),
        ("1/60", "Verlet") => hash::<B, _, _>(Verlet, Step::hz(60).unwrap()),
        ("1/64", "SemiImplicitEuler") => {
            hash::<B, _, _>(SemiImplicitEuler, DyadicStep::<_, 1, 6>::new().unwrap())
        }
        ("1/64", "Verlet") => hash::<B, _, _>(Verlet, DyadicStep::<_, 1, 6>::new().unwrap()),
        ("4389/2^18", "SemiImplicitEuler") => {
            hash::<B, _, _>(SemiImplicitEuler, DyadicStep::<_, 4389, 18>::new().unwrap())
        }
        other => panic!("no such row: {other:?}"),
    }
}

#[test]
fn the_host_makes_the_bits_of_the_targets() {
    let mut compared = 0;
    for [target, body, step, method, _, expected] in rows() {
        let hash = match body {
            "flash of the scene" => continue,
            "every verb" => every_verb::hash().unwrap(),
            "I16F16" => by_step::<Point<I16F16>>(step, method),
            "I8F24" => by_step::<Point<I8F24>>(step, method),
            "f32" => by_step::<Point<f32>>(step, method),
            "I16F16 carried" => by_step::<Carried>(step, method),
            "f32 compensated" => by_step::<Compensated>(step, method),
            other => panic!("no such body: {other}"),
        };
        assert_eq!(
            format!("{hash:x}"),
            expected,
            "{target} {body} {step} {method}"
        );
        compared += 1;
    }
    assert_eq!(compared, 2 * 11);
}

/// A row of the README's table: `| body | step | method | M0+ | M4F |`.
#[test]
fn the_readme_says_what_was_measured() {
    let mut told = 0;
    for [target, body, step, method, figure, _] in rows() {
        if body == "every verb" {
            continue;
        }
        if body == "flash of the scene" {
            let (bytes, level) = figure.split_once(" bytes at opt-level ").unwrap();
            let sentence = match level {
                "3" => format!("takes {bytes} bytes of flash"),
                _ => format!("{bytes} at `{level}`"),
            };
            assert!(
                README.contains(&sentence),
                "the README does not say: {sentence}"
            );
            continue;
        }
        let start = format!("| {body} | {step} | {method} |");
        let row = README.lines().find(|line| line.starts_with(&start));
        let row = row.unwrap_or_else(|| panic!("the README lacks {start}"));
        let column = if target.starts_with("thumbv6m") { 4 } else { 5 };
        assert_eq!(
            row.split('|').nth(column).unwrap().trim(),
            figure,
            "{target}: {row}"
        );
        told += 1;
    }
    assert_eq!(told, 2 * 10);
}

/// The rounded figures of the bodies that carry, in ARCHITECTURE.md: `| body | bytes | M0+ | M4F |`.
#[test]
fn the_architecture_says_what_was_measured() {
    let names = [
        ("I16F16", "`Point<I16F16>`"),
        ("I16F16 carried", "the same, 64-bit position"),
        ("f32", "`Point<f32>`"),
        ("f32 compensated", "the same, compensated"),
    ];
    let sizes = [
        size_of::<Point<I16F16>>(),
        size_of::<Carried>(),
        size_of::<Point<f32>>(),
        size_of::<Compensated>(),
    ];
    for ((name, title), size) in names.into_iter().zip(sizes) {
        let mut figures = rows()
            .filter(|row| row[1] == name && row[2] == "1/60" && row[3] == "SemiImplicitEuler");
        let mut next = || figures.next().unwrap()[4].parse::<f64>().unwrap().round();
        let (m0, m4) = (next(), next());
        let row = ARCHITECTURE
            .lines()
            .find(|line| line.starts_with(&format!("| {title} |")));
        let row = row.unwrap_or_else(|| panic!("ARCHITECTURE.md lacks {title}"));
        assert!(
            row.ends_with(&format!("| {size} | {m0} | {m4} |")),
            "{row}: {m0}, {m4}"
        );
    }
}
