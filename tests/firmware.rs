//! The committed figures of the firmware: the host makes the same bits, and the README the same
//! numbers. The figures themselves come from `examples/firmware/run`.

#[path = "firmware/every_exact.rs"]
mod every_exact;
#[path = "firmware/every_verb.rs"]
mod every_verb;
#[path = "firmware/force_scene.rs"]
mod force_scene;
#[path = "firmware/scene.rs"]
mod scene;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Body, Carried, ConstantAcceleration, Decay, DyadicStep, Error, Euler, Force, Method, Pefrl,
    Point, Rk4, SemiImplicitEuler, Step, Stored, TimeStep, Verlet, World,
};
use force_scene::{Eight, Meter};
use scene::POINTS;

const RESULTS: &str = include_str!("firmware/results.tsv");
const ARCHITECTURE: &str = include_str!("../ARCHITECTURE.md");
const README: &str = include_str!("../README.md");

/// Steps that the image makes before it hashes.
const STEPS: u32 = 600;
/// The same of a scene with a force.
const FORCE_STEPS: u32 = 200;

/// Target, scene, body, step, method, figure and hash.
type Row = [&'static str; 7];

fn all_rows() -> impl Iterator<Item = Row> {
    RESULTS.lines().skip(1).map(|line| {
        let mut fields = line.split('\t');
        std::array::from_fn(|_| fields.next().unwrap_or(""))
    })
}

/// All but those of the charts, which their example reads.
fn rows() -> impl Iterator<Item = Row> {
    all_rows().filter(|row| !row[1].starts_with("chart "))
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
        ("1/60", "Euler") => hash::<B, _, _>(Euler::new(), Step::hz(60).unwrap()),
        ("1/60", "ConstantAcceleration") => {
            hash::<B, _, _>(ConstantAcceleration::new(), Step::hz(60).unwrap())
        }
        ("1/60", "Rk4") => hash::<B, _, _>(Rk4::new(), Step::hz(60).unwrap()),
        ("1/60", "Pefrl") => hash::<B, _, _>(Pefrl::new(), Step::hz(60).unwrap()),
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

/// What each force or work beside the steps makes on the host.
#[derive(Default)]
struct Hashes(Vec<(String, u64)>);

impl<B: Body + From<Point<B::S>>> Meter<B> for Hashes {
    fn force<F: Force<B>>(&mut self, name: &str, _: u32, mut force: F) -> Result<(), Error> {
        let mut world = Eight::<B>::new();
        force_scene::build(&mut world)?;
        force_scene::run(&mut world, &mut force, &Step::hz(60)?, FORCE_STEPS);
        self.0.push((name.into(), world.state_hash()));
        Ok(())
    }

    fn work<T>(&mut self, name: &str, _: u32, work: impl FnOnce() -> T, hash: fn(T) -> u64) {
        self.0.push((name.into(), hash(work())));
    }
}

impl Hashes {
    fn of<S: Decay<InvMass: Stored> + Stored>() -> Hashes {
        let mut hashes = Hashes::of_forces::<Point<S>>();
        force_scene::beside::<S>(&mut hashes).unwrap();
        hashes
    }

    fn of_forces<B: Body<S: Decay> + From<Point<B::S>>>() -> Hashes {
        let mut hashes = Hashes::default();
        force_scene::forces::<B>(&mut hashes).unwrap();
        hashes
    }

    fn named(&self, name: &str) -> u64 {
        let found = self.0.iter().find(|(other, _)| other == name);
        found.unwrap_or_else(|| panic!("no such scene: {name}")).1
    }
}

#[test]
fn the_host_makes_the_bits_of_the_targets() {
    let (fixed, float) = (Hashes::of::<I16F16>(), Hashes::of::<f32>());
    let carried = Hashes::of_forces::<Carried<I16F16>>();
    let mut compared = 0;
    for [target, scene, body, step, method, _, expected] in rows() {
        let hash = match (scene, body) {
            (scene, _) if scene.starts_with("flash") => continue,
            ("every verb", _) => every_verb::hash().unwrap(),
            ("every exact verb", _) => every_exact::hash().unwrap(),
            ("gravity", "I16F16") => by_step::<Point<I16F16>>(step, method),
            ("gravity", "I8F24") => by_step::<Point<I8F24>>(step, method),
            ("gravity", "f32") => by_step::<Point<f32>>(step, method),
            ("gravity", "I16F16 carried") => by_step::<Carried<I16F16>>(step, method),
            ("gravity", "f32 carried") => by_step::<Carried<f32>>(step, method),
            (scene, "I16F16") => fixed.named(scene),
            (scene, "f32") => float.named(scene),
            (scene, "I16F16 carried") => carried.named(scene),
            other => panic!("no such row: {other:?}"),
        };
        assert_eq!(
            format!("{hash:x}"),
            expected,
            "{target} {scene} {body} {step} {method}"
        );
        compared += 1;
    }
    assert_eq!(compared, 2 * (20 + 2 + 2 * 18 + 14));
}

/// Runs of a scene (spring, projectile, quadratic, kepler, cluster, pair) in five kinds of bodies.
#[test]
fn both_cores_make_the_same_bits_of_the_charts_scenes() {
    let of = |core: &str| -> Vec<_> {
        let rows =
            all_rows().filter(|row| row[1].starts_with("chart ") && row[0].starts_with(core));
        rows.map(|[_, scene, body, step, method, _, hash]| [scene, body, step, method, hash])
            .collect()
    };
    assert_eq!(of("thumbv6m"), of("thumbv7em"));
    assert_eq!(of("thumbv6m").len(), 5 * (7 + 9 + 8 + 6 + 6 + 7));
}

/// The cell of the README's row that begins with `start`.
fn cell(start: &str, column: usize) -> &'static str {
    let row = README.lines().find(|line| line.starts_with(start));
    let row = row.unwrap_or_else(|| panic!("the README lacks {start}"));
    row.split('|').nth(column).unwrap_or("").trim()
}

/// A row of the README's first table: `| body | step | method | M0+ | M4F |`.
#[test]
fn the_readme_says_what_a_step_costs() {
    let mut told = 0;
    for [target, _, body, step, method, figure, _] in rows().filter(|row| row[1] == "gravity") {
        let start = format!("| {body} | {step} | {method} |");
        let column = if target.starts_with("thumbv6m") { 4 } else { 5 };
        assert_eq!(cell(&start, column), figure, "{target}: {start}");
        told += 1;
    }
    assert_eq!(told, 2 * 20);
}

/// A row of its second: `| force | unit |` and of each core `I16F16 | f32 | carried |`.
#[test]
fn the_readme_says_what_a_force_costs() {
    let mut told = 0;
    for [target, scene, body, _, _, figure, _] in rows() {
        if ["gravity", "every verb", "every exact verb"].contains(&scene)
            || scene.starts_with("flash")
        {
            continue;
        }
        let core = if target.starts_with("thumbv6m") { 3 } else { 6 };
        let bodies = ["I16F16", "f32", "I16F16 carried"];
        let column = core + bodies.iter().position(|&b| b == body).unwrap();
        let rounded = figure.parse::<f64>().unwrap().round();
        let said = cell(&format!("| `{scene}` |"), column);
        assert_eq!(said, rounded.to_string(), "{target} {scene} {body}");
        told += 1;
    }
    assert_eq!(told, 2 * (2 * 18 + 14));
}

#[test]
fn the_readme_says_what_it_takes_in_flash() {
    let mut told = 0;
    for [_, scene, _, _, _, figure, _] in rows().filter(|row| row[1].starts_with("flash")) {
        let (bytes, level) = figure.split_once(" bytes at opt-level ").unwrap();
        let sentence = match (scene, level) {
            ("flash of gravity", "3") => format!("takes {bytes} bytes of flash"),
            ("flash of gravity", _) => format!("{bytes} at `{level}`"),
            ("flash of quadratic_drag more", _) => format!("quadratic drag {bytes}"),
            ("flash of spring more", _) => format!("springs {bytes}"),
            ("flash of pull more", _) => format!("pulls {bytes}"),
            ("flash of exact_drag more", _) => format!("exact drag {bytes}"),
            ("flash of exact_spring more", _) => format!("exact springs {bytes}"),
            ("flash of carried more", _) => format!("bodies that carry {bytes}"),
            ("flash of rk4 more", _) => format!("method `Rk4` {bytes}"),
            ("flash of pefrl more", _) => format!("`Pefrl` {bytes}"),
            ("flash of accumulator more", _) => format!("an accumulator {bytes}"),
            ("flash of snapshot more", _) => format!("saving and loading {bytes}"),
            other => panic!("no such row: {other:?}"),
        };
        let text = README.replace('\n', " ");
        assert!(
            text.contains(&sentence),
            "the README does not say: {sentence}"
        );
        told += 1;
    }
    assert_eq!(told, 2 + 10);
}

/// The figure of the gravity scene on a core.
fn gravity(core: &str, body: &str, step: &str, method: &str) -> f64 {
    let wanted = ["gravity", body, step, method];
    let mut found = rows().filter(|row| row[0].starts_with(core) && row[1..5] == wanted);
    let row = found
        .next()
        .unwrap_or_else(|| panic!("no row {core} {wanted:?}"));
    row[5].parse().unwrap()
}

const CORES: [&str; 2] = ["thumbv6m", "thumbv7em"];

/// The tables of methods in the README and in the documentation, columns 9 and 10.
#[test]
fn the_tables_of_methods_say_what_they_cost() {
    let documentation = include_str!("../src/integrate/mod.rs");
    for method in [
        "Euler",
        "ConstantAcceleration",
        "SemiImplicitEuler",
        "Verlet",
        "Rk4",
        "Pefrl",
    ] {
        let figures = CORES.map(|core| gravity(core, "I16F16", "1/60", method).round());
        let said = [
            (README, format!("| `{method}` |")),
            (documentation, format!("//! | [`{method}`] |")),
        ];
        for (text, start) in said {
            let row = text.lines().find(|line| line.starts_with(&start));
            let cells: Vec<_> = row
                .unwrap_or_else(|| panic!("{start}"))
                .split('|')
                .collect();
            for (cell, figure) in [cells[9], cells[10]].into_iter().zip(figures) {
                assert_eq!(cell.trim(), figure.to_string(), "{start}");
            }
        }
    }
}

/// What a body costs, in ARCHITECTURE.md (rounded) and in the guide:
/// `| body | bytes | M0+ 1/60 | M0+ 1/64 | M4F 1/60 | M4F 1/64 |`.
#[test]
fn the_guide_and_the_architecture_say_what_a_body_costs() {
    let guide = include_str!("../src/guide.rs");
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
        let steps: &[_] = if body.starts_with("f32") {
            &["1/60"]
        } else {
            &["1/60", "1/64"]
        };
        let mut exact = vec![title.to_string(), size.to_string()];
        let mut rounded = exact.clone();
        for core in CORES {
            for step in ["1/60", "1/64"] {
                let figure = steps
                    .contains(&step)
                    .then(|| gravity(core, body, step, "SemiImplicitEuler"));
                exact.push(figure.map_or(String::new(), |f| format!("{f:.1}")));
                rounded.push(figure.map_or(String::new(), |f| f.round().to_string()));
            }
        }
        for (text, cells) in [(guide, exact), (ARCHITECTURE, rounded)] {
            assert!(has_row(text, &cells), "no row {cells:?}");
        }
    }
}

/// Whether a line of `text` has these cells.
fn has_row(text: &str, cells: &[String]) -> bool {
    let row = format!("| {} |", cells.join(" | ")).replace("|  |", "| |");
    text.lines().any(|line| {
        line.trim_start_matches("//! ").replace("|  |", "| |") == row.replace("|  |", "| |")
    })
}
