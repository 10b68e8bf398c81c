//! The examples that a newcomer reads first: short, and right by references of their own.
#![allow(clippy::duplicate_mod)] // Each example has its copy of `picture`, as when it is run.

#[allow(dead_code)]
#[path = "../../examples/cannon.rs"]
mod cannon;
#[allow(dead_code)]
#[path = "../../examples/chain.rs"]
mod chain;
#[path = "examples/flight.rs"]
mod flight;
#[allow(dead_code)]
#[path = "../../examples/lander.rs"]
mod lander;
#[allow(dead_code)]
#[path = "../../examples/orbit.rs"]
mod orbit;
#[allow(dead_code)]
#[path = "../../examples/tags.rs"]
mod tags;

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use fixstep::fixed::types::I16F16;
use fixstep::{Point, Ratio, Stale, Vec2};

use flight::G;

const NAMES: [&str; 5] = ["cannon", "chain", "lander", "orbit", "tags"];

fn near(what: &str, found: f64, wanted: f64, bound: f64) {
    let error = (found - wanted).abs();
    println!("{what:<28} {found:12.6} {wanted:12.6}  error {error:8.1e}  bound {bound:8.1e}");
    assert!(error <= bound, "{what}: {found}, not {wanted}");
}

#[test]
fn none_is_longer_than_sixty_lines_and_each_says_how_to_run_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in NAMES {
        let text = fs::read_to_string(root.join(format!("examples/{name}.rs"))).unwrap();
        assert!(text.lines().count() <= 60, "{name} is too long");
        let mut header = text.lines().take_while(|line| line.starts_with("//! "));
        let command = format!("`cargo run --example {name}`");
        assert!(
            header.any(|line| line.contains(&command)),
            "{name}: no {command}"
        );
    }
}

/// What rounding and the last piece of a path add to a height. In 20 s 1200 steps round a velocity
/// of I16F16 once and a position twice, by half a unit of 1.5e-5 m: 1200 (20 s / 2 + 2) half units,
/// 0.11 m, if all went one way. For f32, with units of 6e-5 m and 8e-6 m/s, it is 0.12 m. The chord
/// cuts g h²/8 = 0.3 mm off. At 15 degrees, 1 m of height is 3.8 m of range, and 1 m of its own.
const ROUNDING: f64 = 0.13 * 4.8;

#[test]
fn the_cannon_carries_as_far_as_an_integration_of_order_4() {
    let k = cannon::AIR.to_f64() / 5.4;
    for degrees in [15, 25, 35, 42, 55, 65, 75] {
        let air = flight::flight(degrees, k);
        let vacuum =
            cannon::SPEED * cannon::SPEED * (f64::from(2 * degrees)).to_radians().sin() / G;
        let ranges = |drag: Ratio| {
            [
                cannon::range::<f32>(degrees, drag).unwrap(),
                cannon::range::<I16F16>(degrees, drag).unwrap(),
            ]
        };
        for (name, [wanted, bound], found) in [
            ("in air", [air.range, air.bound], ranges(cannon::AIR)),
            ("in vacuum", [vacuum, 0.0], ranges(cannon::VACUUM)),
        ] {
            near(
                &format!("{degrees}° {name}, f32"),
                found[0],
                wanted,
                bound + ROUNDING,
            );
            near(
                &format!("{degrees}° {name}, I16F16"),
                found[1],
                wanted,
                bound + ROUNDING,
            );
        }
    }
}

#[test]
fn forty_two_degrees_carry_farthest() {
    let ranges = |degrees| flight::flight(degrees, cannon::AIR.to_f64() / 5.4).range;
    let best = (1..90)
        .max_by(|&a, &b| ranges(a).total_cmp(&ranges(b)))
        .unwrap();
    let found = (1..90).max_by(|&a, &b| {
        let range = |degrees| cannon::range::<I16F16>(degrees, cannon::AIR).unwrap();
        range(a).total_cmp(&range(b))
    });
    assert_eq!(found, Some(best));
}

/// While it brakes, a step keeps v² <= 4 y but for what the lander gains before the engine answers:
/// it looks in the middle of a step, so at touchdown the last look was at most 1.5 v h above the
/// ground, and one step of free fall adds g h: v <= sqrt(6 v h) + g h, so v <= 0.15 m/s.
#[test]
fn the_lander_is_gentle_and_no_step_is_lost_from_the_books() {
    let (speed, [made, dropped], seen) = lander::land().unwrap();
    println!("touchdown at {speed} m/s");
    assert!((0.0..=0.15).contains(&speed));
    let frames = seen[0].len() + seen[1].len();
    let lengths = (1..=frames).map(|i| match i {
        300 => 400_000,
        _ => lander::FRAMES[i % 5],
    });
    let elapsed: u64 = lengths.sum();
    // The last frame has up to three steps and makes none after touchdown.
    let left = elapsed * 60 / 1_000_000 - (made + dropped);
    assert!(left <= 2, "{left} steps are missing");
    // The stall is 24 steps and has a part of one before it; a frame of 33 ms is 2 or 3 at most.
    assert!((20..=21).contains(&dropped));
    // Free fall from 5 m/s meets v² = 4 y when 575 / 7.24 m down, at 17 m/s. The frame that shows it
    // may be 33 ms late and shows up to a step before; the engine answers within another.
    let (lit, late) = (seen[1][0].y, 0.0333 + 2.0 / 60.0);
    near("engine on at, m", lit, 150.0 - 575.0 / 7.24, 17.0 * late);
}

/// The closed form is T = 2 pi sqrt(a³ / (G M)) with a from the start: 1/a = 2/r - v²/(G M).
/// Moons are 1e-5 of the planet: it starts at rest and is soon moved by the inner moon at 6e-5 m/s,
/// 3e-5 of the outer moon's start, times 3 v² a / (G M) = 1.3 for the period; their mass adds 1e-5.
/// Half a unit of position (14 m: 5e-7 m) twice and of velocity once a step walk at random: 24,000
/// steps change the energy of the outer moon by 7e-5 J/kg of 5 (one sigma), its period by 2e-5.
/// Verlet adds (h omega)² / 24 = 3e-6. All in all 4e-5 + 1e-5 + 4 * 2e-5.
#[test]
fn moons_turn_in_the_time_that_kepler_gives() {
    let (paths, change) = orbit::orbit().unwrap();
    for (path, v) in paths.iter().zip([5.7735, 2.0702]) {
        let r: f64 = path[0].x;
        let axis = 1.0 / (2.0 / r - v * v / 100.0);
        let wanted = TAU * (axis * axis * axis / 100.0).sqrt();
        near("period, s", orbit::period(path), wanted, 1.3e-4 * wanted);
    }
    // Inner: 2 m/s * 7e-7 m s^-2 m a step, the same walk: 2e-4 J/kg of 22, and 4 sigma.
    near("energy", change, 0.0, 4e-5);
}

/// A link carries the weight below it. Gravity comes after the springs and drag after both, which
/// brakes what springs have just pushed: the springs give g / (1 - h c/m). The swing is down by
/// exp(-c t / 2m) = e^-12, to 5e-5 of 8 m, and stretches by the square of that. Where h c/m v is less
/// than half a unit, v = 3.6e-5 m/s, drag rounds to nothing and a mode of the chain rings on, with
/// v / sqrt(k/m) = 6e-7 m in a link. There are 16 modes.
#[test]
fn a_hanging_link_stretches_by_the_weight_below_it() {
    let shapes = chain::swing().unwrap();
    let rest = shapes.last().unwrap();
    let g = G / (1.0 - 0.1 / 0.5 / 240.0);
    for (link, ends) in (1..chain::BEADS).zip(rest.windows(2)) {
        let stretch = ends[1] - ends[0];
        let wanted = (chain::BEADS - link) as f64 * 0.5 * g / 2000.0;
        near("stretch, m", stretch.x.hypot(stretch.y) - 0.5, wanted, 1e-5);
    }
    near(
        "the hook, m",
        -rest[0].y,
        chain::BEADS as f64 * 0.5 * g / 2000.0,
        1e-6,
    );
}

/// Against a map from ids to tags.
#[test]
fn tags_stay_with_their_bodies() {
    let mut scene = tags::Tagged::<u32, 8>::default();
    let (mut wanted, mut gone) = (BTreeMap::new(), Vec::new());
    let ball = Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap();
    let mut random = 1_u32;
    for tag in 0..500 {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let (grow, place) = (random >> 31 == 0, (random >> 16) as usize % 8);
        if grow {
            match scene.add(ball, tag) {
                Ok(id) => assert_eq!(wanted.insert(id, tag), None),
                Err(full) => assert_eq!((full.capacity, wanted.len()), (8, 8)),
            }
        } else if let Some(&id) = scene.world.ids().get(place) {
            assert_eq!(
                scene.remove(id).unwrap(),
                (ball, wanted.remove(&id).unwrap())
            );
            gone.push(id);
        }
        assert_eq!(scene.tags.len(), wanted.len());
        assert!(
            wanted
                .iter()
                .all(|(&id, &tag)| scene.tag(id) == Ok(&mut tag.clone()))
        );
        assert!(gone.iter().all(|&id| scene.tag(id) == Err(Stale(id))));
    }
    assert!(gone.len() > 100);
}
