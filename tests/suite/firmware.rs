//! The committed figures of the firmware: the host makes the same bits, and the pages the same
//! numbers. The figures themselves come from `examples/firmware/run`.

#[path = "../firmware/scenes/mod.rs"]
mod scenes;

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::OnceLock;

use crate::support::pages::{pages, table};
use fixstep::fixed::types::I16F16;
use fixstep::{Body, Carried, Error, Force, Method, Point, TimeStep};
use scenes::{
    Meter, Name, Start, chart, every_exact, every_turning, every_verb, force, gravity, long, rigid,
};

const RESULTS: &str = include_str!("../firmware/results.tsv");
/// Names a table to look at instead, which may have some of the targets.
const MEASURED: &str = "FIRMWARE_RESULTS";
const ARCHITECTURE: &str = include_str!("../../ARCHITECTURE.md");

const TARGETS: [&str; 5] = [
    "thumbv6m-none-eabi",
    "thumbv7em-none-eabihf",
    "riscv32imac-unknown-none-elf",
    "thumbv4t-none-eabi",
    "wasm32-unknown-unknown",
];
const M0: &str = TARGETS[0];
const M4F: &str = TARGETS[1];
const RISCV: &str = TARGETS[2];
const GBA: &str = TARGETS[3];

/// A row by the names of its columns.
type Row = HashMap<&'static str, &'static str>;

/// The table, or the one that `examples/firmware/run` has just measured.
fn results() -> &'static str {
    static TEXT: OnceLock<String> = OnceLock::new();
    TEXT.get_or_init(|| match std::env::var_os(MEASURED) {
        Some(path) => std::fs::read_to_string(path).unwrap(),
        None => RESULTS.into(),
    })
}

fn rows() -> Vec<Row> {
    let mut lines = results().lines().map(|line| line.split('\t'));
    let columns: Vec<_> = lines.next().unwrap().collect();
    lines
        .map(|line| columns.iter().copied().zip(line).collect())
        .collect()
}

/// What the host makes of the scenes: the hash by scene, scalar and method.
#[derive(Default)]
struct Bits(HashMap<[String; 3], String>);

impl Bits {
    fn put(&mut self, name: Name, hash: String) {
        let words = name.scene.into_iter().filter(|word| !word.is_empty());
        let scene = words.collect::<Vec<_>>().join(" ");
        let key = [scene, name.scalar.into(), name.method.into()];
        assert!(self.0.insert(key, hash).is_none(), "shown twice");
    }
}

impl Meter for Bits {
    fn run<B, M, H, F, const N: usize>(
        &mut self,
        name: Name,
        _: u32,
        mut start: Start<'_, B, M, H, F, N>,
    ) where
        B: Body,
        M: Method<B, N>,
        H: TimeStep<B::S>,
        F: Force<B>,
    {
        let mut hash = String::new();
        for (i, &ticks) in name.ticks.iter().enumerate() {
            start.run(ticks - start.world.tick() as u32);
            let space = if i == 0 { "" } else { " " };
            write!(hash, "{space}{ticks}:{:x}", start.world.state_hash()).unwrap();
        }
        self.put(name, hash);
    }

    fn work<R>(
        &mut self,
        name: Name,
        _: u32,
        work: impl FnOnce() -> R,
        hash: impl FnOnce(R) -> u64,
    ) {
        self.put(name, format!("{:x}", hash(work())));
    }

    fn whole(&mut self, scene: &'static str, hash: Result<u64, Error>) {
        let name = Name {
            scene: [scene, "", ""],
            scalar: "all",
            method: "all",
            ticks: &[],
        };
        self.put(name, format!("{:x}", hash.unwrap()));
    }
}

/// The host's bits of every scene.
fn host() -> Result<Bits, Error> {
    let mut bits = Bits::default();
    gravity::show(&mut bits)?;
    force::show(&mut bits)?;
    long::show(&mut bits)?;
    rigid::show(&mut bits)?;
    bits.whole("every verb", every_verb::hash());
    bits.whole("every exact verb", every_exact::hash());
    bits.whole("every turning verb", every_turning::hash());
    chart::show::<chart::Springs>(&mut bits)?;
    chart::show::<chart::Projectile>(&mut bits)?;
    chart::show::<chart::QuadraticProjectile>(&mut bits)?;
    chart::show::<chart::Kepler>(&mut bits)?;
    chart::show::<chart::Cluster>(&mut bits)?;
    chart::show::<chart::Pair>(&mut bits)?;
    chart::show::<chart::Rotor>(&mut bits)?;
    Ok(bits)
}

/// Each target has a row of each scene, and it has the host's bits. The console has some scenes twice: in
/// its fast RAM they are looked at after 600 steps.
#[test]
fn the_host_makes_the_bits_of_every_target() {
    let Bits(bits) = host().unwrap();
    let scenes = bits.len();
    let mut compared = HashMap::<_, usize>::new();
    for row in rows().iter().filter(|row| row["hash"] != "-") {
        let scene = row["scene"]
            .trim_end_matches(" in IWRAM")
            .trim_end_matches(" by Long");
        let key = [scene, row["scalar"], row["method"]].map(String::from);
        let expected = bits.get(&key).unwrap_or_else(|| panic!("no scene {key:?}"));
        let (target, hash) = (row["target"], row["hash"]);
        if scene == row["scene"] {
            assert_eq!(hash, expected, "{target} {key:?}");
            *compared.entry(target).or_default() += 1;
        } else {
            assert!(
                expected.ends_with(&format!(" 600:{hash}")),
                "{target} {key:?}"
            );
        }
    }
    let of_all = std::env::var_os(MEASURED).is_none();
    for target in TARGETS {
        if of_all || compared.contains_key(target) {
            assert_eq!(compared.get(target), Some(&scenes), "{target}");
        }
    }
    assert!(!compared.is_empty());
}

/// A figure of the table, `-` where it is not measured.
fn figure(target: &str, scene: &str, scalar: &str, method: &str, column: &str) -> &'static str {
    let wanted = [target, scene, scalar, method];
    let of = |row: &Row| ["target", "scene", "scalar", "method"].map(|name| row[name]);
    let mut found = rows().into_iter().filter(|row| of(row) == wanted);
    let row = found.next().unwrap_or_else(|| panic!("no row {wanted:?}"));
    assert!(found.next().is_none(), "two rows {wanted:?}");
    row[column]
}

/// Instructions or, of the console, cycles for each body or pair and step.
fn each(target: &str, scene: &str, scalar: &str, method: &str) -> &'static str {
    let column = if target == GBA {
        "cycles_per_body_step"
    } else {
        "insn_per_body_step"
    };
    figure(target, scene, scalar, method, column)
}

fn rounded(figure: &str) -> String {
    figure.parse::<f64>().unwrap().round().to_string()
}

/// The whole table, and the short one of the README.
#[test]
fn the_pages_say_what_a_step_costs() {
    let told = table(pages(), "| body | step | method | M0+ | M4F |");
    assert_eq!(told.len(), 20);
    let short = table(pages(), "| number type | step, s | method | M0+ | M4F |");
    assert_eq!(short.len(), 9);
    let told = told.into_iter().chain(short);
    for cells in told {
        let [body, step, method, costs @ ..] = &cells[..] else {
            panic!("{cells:?}");
        };
        let costs: [_; 4] = costs.try_into().unwrap();
        for (said, target) in costs.into_iter().zip([M0, M4F, RISCV, GBA]) {
            let cost = each(target, &format!("gravity {step}"), body, method);
            assert_eq!(said, cost, "{target} {cells:?}");
        }
    }
}

/// Beside each core there is a column that was counted by hand.
#[test]
fn the_pages_say_what_a_step_of_a_body_that_turns_costs() {
    let told = table(pages(), "| body that turns | step | method |");
    assert_eq!(told.len(), 9);
    for cells in told {
        let &[
            body,
            step,
            method,
            m0,
            by_hand_m0,
            m4f,
            by_hand_m4f,
            riscv,
            gba,
        ] = &cells[..]
        else {
            panic!("{cells:?}");
        };
        for (said, target) in [m0, m4f, riscv, gba].into_iter().zip([M0, M4F, RISCV, GBA]) {
            let body = format!("{body} rigid");
            let cost = each(target, &format!("gravity {step}"), &body, method);
            assert_eq!(said, cost, "{target} {cells:?}");
        }
        for (cost, by_hand) in [(m0, by_hand_m0), (m4f, by_hand_m4f)] {
            let below = |least: f64| least <= cost.parse::<f64>().unwrap();
            assert!(
                by_hand.is_empty() || below(by_hand.parse().unwrap()),
                "{cells:?}"
            );
        }
    }
}

#[test]
fn the_pages_say_what_a_force_costs() {
    forces_cost("| | for each | M0+ I16F16 |", 14 + 4, "");
    forces_cost("| of a body that turns | for each |", 4 + 3, " rigid");
}

fn forces_cost(header: &str, rows: usize, of: &str) {
    let told = table(pages(), header);
    assert_eq!(told.len(), rows);
    for cells in told {
        let [name, _, costs @ ..] = &cells[..] else {
            panic!("{cells:?}");
        };
        let (group, bodies): (_, &[_]) = if name.contains("::") {
            ("beside", &["I16F16", "f32"])
        } else {
            ("force", &["I16F16", "f32", "I16F16 carried"])
        };
        let scene = format!("{group} {}", name.replace('`', ""));
        let costs: [_; 8] = costs.try_into().unwrap();
        let cores = [M0; 3].into_iter().chain([M4F; 3]).chain([RISCV, GBA]);
        let all = ["I16F16", "f32", "I16F16 carried"];
        let scalars = all.into_iter().cycle().take(6).chain(["I16F16"; 2]);
        for ((said, target), scalar) in costs.into_iter().zip(cores).zip(scalars) {
            if bodies.contains(&scalar) {
                let scalar = format!("{scalar}{of}");
                let cost = each(target, &scene, &scalar, "SemiImplicitEuler");
                assert_eq!(said, rounded(cost), "{target} {scalar} {cells:?}");
            } else {
                assert_eq!(said, "", "{scalar} {cells:?}");
            }
        }
    }
}

#[test]
fn the_pages_say_what_a_feature_takes_in_flash_and_ram() {
    let told = table(pages(), "| the scene, and | M0+ | M4F |");
    let flash = rows().into_iter();
    let of_m0 = flash.filter(|row| row["target"] == M0 && row["scene"].starts_with("flash"));
    assert_eq!(told.len(), of_m0.count());
    for cells in told {
        let [more, said @ .., ram] = &cells[..] else {
            panic!("{cells:?}");
        };
        assert_eq!(*ram, ram_more(more.trim_matches('`')), "{more}");
        for (said, target) in said.iter().zip([M0, M4F]) {
            let scene = "flash gravity 1/64 at s".to_string();
            let bytes = |scene: &str| -> i64 {
                let bytes = figure(target, scene, "-", "-", "flash_bytes");
                bytes.parse().unwrap()
            };
            let alone = bytes(&scene);
            let expected = match *more {
                "nothing more" => alone.to_string(),
                more => {
                    let with = bytes(&format!("{scene} + {}", more.replace('`', "")));
                    format!("{:+}", with - alone)
                }
            };
            assert_eq!(*said, expected, "{target} {more}");
        }
    }
}

/// Bytes of RAM that a force, a method or a number type adds; of what a scene has eight or four times, one.
fn ram_more(name: &str) -> String {
    let of = |scene: &str, scalar, method| -> i64 {
        let bytes = figure(M0, scene, scalar, method, "ram_bytes");
        bytes.parse().unwrap()
    };
    let semi = "SemiImplicitEuler";
    let gravity =
        |scalar, method| of("gravity 1/60", scalar, method) - of("gravity 1/60", "I16F16", semi);
    let force = |times| {
        let more =
            of(&format!("force {name}"), "I16F16", semi) - of("force no force", "I16F16", semi);
        more / times
    };
    let more = match name {
        "nothing more" => return of("gravity 1/64", "I16F16", semi).to_string(),
        "Accumulator" | "snapshot" => return String::new(),
        name if name.contains(" + ") => return String::new(),
        "Verlet" | "Rk4" | "Pefrl" => gravity("I16F16", name),
        "Carried" => gravity("I16F16 carried", semi),
        "Rigid" => gravity("I16F16 rigid", semi),
        "I8F24" | "f32" => gravity(name, semi),
        "Anchor" | "ExactSpring" => force(8),
        "ExactPair" => force(4),
        _ => force(1),
    };
    format!("{more:+}")
}

#[test]
fn the_pages_say_what_the_scene_takes() {
    let of = |column| figure(M0, "gravity 1/64", "I16F16", "SemiImplicitEuler", column);
    let text = pages().replace('\n', " ");
    for sentence in [
        format!("takes {} bytes of flash", of("flash_bytes")),
        format!("{} bytes of RAM", of("ram_bytes")),
        format!("{} bytes of stack", of("stack_bytes")),
    ] {
        assert!(text.contains(&sentence), "no page says: {sentence}");
    }
}

/// The tables of methods on the page of costs and in the documentation, columns 9 and 10.
#[test]
fn the_tables_of_methods_say_what_they_cost() {
    let documentation = include_str!("../../src/integrate/mod.rs");
    for method in [
        "Euler",
        "ConstantAcceleration",
        "SemiImplicitEuler",
        "Verlet",
        "Rk4",
        "Pefrl",
    ] {
        let said = [
            (
                pages(),
                "| method | order | force calls |",
                format!("`{method}`"),
            ),
            (
                documentation,
                "//! | method | order | force calls |",
                format!("//! | [`{method}`]"),
            ),
        ];
        for (text, header, name) in said {
            let mut rows = text.lines().skip_while(|line| !line.starts_with(header));
            let row = rows.find(|line| line.trim_start_matches("| ").starts_with(&name));
            let row = row.unwrap_or_else(|| panic!("{name}"));
            let cells: Vec<_> = row.split('|').collect();
            for (cell, core) in [cells[9], cells[10]].into_iter().zip([M0, M4F]) {
                let cost = rounded(each(core, "gravity 1/60", "I16F16", method));
                assert_eq!(cell.trim(), cost, "{name}");
            }
        }
    }
}

/// What a body costs, in ARCHITECTURE.md (rounded) and in the guide:
/// `| body | bytes | M0+ 1/60 | M0+ 1/64 | M4F 1/60 | M4F 1/64 |`.
#[test]
fn the_guide_and_the_architecture_say_what_a_body_costs() {
    let guide = include_str!("../../src/guide/mod.rs");
    let bodies = [
        ("I16F16", "`Point<I16F16>`", size_of::<Point<I16F16>>()),
        (
            "I16F16 carried",
            "`Carried<I16F16>`",
            size_of::<Carried<I16F16>>(),
        ),
        ("f32", "`Point<f32>`", size_of::<Point<f32>>()),
        ("f32 carried", "`Carried<f32>`", size_of::<Carried<f32>>()),
    ];
    for (body, title, size) in bodies {
        let mut exact = vec![title.to_string(), size.to_string()];
        let mut whole = exact.clone();
        for core in [M0, M4F] {
            for step in ["1/60", "1/64"] {
                let cost = (step == "1/60" || !body.starts_with("f32"))
                    .then(|| each(core, &format!("gravity {step}"), body, "SemiImplicitEuler"));
                exact.push(cost.unwrap_or_default().into());
                whole.push(cost.map_or(String::new(), rounded));
            }
        }
        for (text, cells) in [(guide, exact), (ARCHITECTURE, whole)] {
            assert!(has_row(text, &cells), "no row {cells:?}");
        }
    }
}

/// Whether a line of `text` has these cells.
/// Columns 6 to 9 of its table: a step of a body that turns less that of one that does not, and what else is
/// priced.
#[test]
fn the_architecture_says_what_an_angle_costs() {
    let told = table(ARCHITECTURE, "| | bytes | 0.1 turns/s |");
    assert_eq!(told.len(), 4);
    let semi = "SemiImplicitEuler";
    let number = |target, scene, scalar: &str| -> f64 {
        let figure = each(target, scene, scalar, semi);
        figure.parse().unwrap()
    };
    for (cells, body) in told.iter().zip(["I16F16", "I16F16 carried", "", ""]) {
        let sine = |target| number(target, "beside Angle::rotation", "I16F16 rigid");
        let costs = [M0, M4F].map(|target| match body {
            "" => number(target, "beside a kept direction", "I16F16 rigid"),
            _ => {
                let turning = number(target, "gravity 1/60", &format!("{body} rigid"));
                turning - number(target, "gravity 1/60", body)
            }
        });
        assert_eq!(cells[5..7], costs.map(|cost| cost.round().to_string()));
        if !body.is_empty() {
            let sines = [M0, M4F].map(|target| sine(target).round().to_string());
            assert_eq!(cells[7..9], sines);
        }
    }
}

fn has_row(text: &str, cells: &[String]) -> bool {
    let row = format!("| {} |", cells.join(" | ")).replace("|  |", "| |");
    text.lines().any(|line| {
        line.trim_start_matches("//! ").replace("|  |", "| |") == row.replace("|  |", "| |")
    })
}
