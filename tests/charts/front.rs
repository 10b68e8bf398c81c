//! Fronts: the rule, and what the committed tables say of the recommendations.

use crate::cost::Core;
use crate::figures::{HEADER, KEYS, Row};
use crate::minute_table;
use crate::pareto::{front, stairs};
use crate::starts::Plan;
use crate::table::Table;
use crate::verdict::at_60_hz;

const README: &str = include_str!("../../README.md");
const MINUTE: &str = include_str!("../../examples/charts/minute.csv");
const WORK: [(&str, &str); 6] = [
    (
        "spring",
        include_str!("../../examples/charts/work-spring.csv"),
    ),
    (
        "projectile",
        include_str!("../../examples/charts/work-projectile.csv"),
    ),
    (
        "quadratic",
        include_str!("../../examples/charts/work-quadratic.csv"),
    ),
    (
        "kepler",
        include_str!("../../examples/charts/work-kepler.csv"),
    ),
    (
        "cluster",
        include_str!("../../examples/charts/work-cluster.csv"),
    ),
    ("pair", include_str!("../../examples/charts/work-pair.csv")),
];

#[test]
fn a_front_has_what_nothing_beats() {
    let points = [
        (1.0, 9.0),
        (2.0, 9.0),
        (2.0, 5.0),
        (3.0, 6.0),
        (2.0, 5.0),
        (4.0, 1.0),
        (9.0, 1.0),
    ];
    assert_eq!(
        front(&points),
        [true, false, true, false, true, true, false]
    );
    // What failed is cheapest, and on no front; nor does it beat anything.
    let failed = [(0.5, f64::INFINITY), (0.5, f64::NAN), (1.0, 2.0)];
    assert_eq!(front(&failed), [false, false, true]);
    assert_eq!(front(&[]), [false; 0]);
}

#[test]
fn stairs_go_down_through_the_front() {
    let corners = stairs(&[(4.0, 1.0), (1.0, 9.0)], 10.0, 8.0);
    assert_eq!(
        corners,
        [(1.0, 10.0), (1.0, 9.0), (4.0, 9.0), (4.0, 1.0), (8.0, 1.0)]
    );
}

fn rows(text: &str) -> Vec<Row> {
    let mut table = Table {
        name: "committed",
        keys: KEYS,
        header: HEADER.to_vec(),
        rows: Vec::new(),
    };
    table.rows = table.read(text).unwrap();
    Row::all(&table).unwrap()
}

/// The recommended line of each scene and core is on the front at 60 Hz; these stand before the one that
/// is not: an exact pair costs an FPU less than the square root and divisions of a spring.
#[test]
fn what_the_guide_recommends_is_on_the_front_but_for_the_pair() {
    let mut behind = Vec::new();
    for (scene, text) in WORK {
        let (rows, size) = (rows(text), Plan::of(scene).size);
        for core in Core::ALL {
            let [front, before] = at_60_hz(core, scene, size, &rows);
            assert!(front.len() >= 2, "{scene}: {front:?}");
            let names = before.iter().map(|name| name.join(" "));
            behind.extend(names.map(|name| format!("{scene}, {}: {name}", core.name())));
        }
    }
    assert_eq!(
        behind,
        ["pair, Cortex-M4F: SemiImplicitEuler ExactPair f32"]
    );
}

/// All that the chart has to show is in the table, and costs what the firmware's table says.
#[test]
fn tables_are_whole_and_have_the_costs_of_the_firmware() {
    let costs = crate::cost::Costs::load().unwrap();
    for ((scene, text), runs) in WORK.into_iter().zip([7, 9, 8, 6, 6, 7]) {
        let rows = rows(text);
        assert_eq!(rows.len(), runs * 5 * 7, "{scene}: runs, bodies, rates");
        for row in &rows {
            let cost = |core| costs.get(core, scene, row.line()).unwrap();
            assert_eq!(row.costs, Core::ALL.map(cost), "{scene} {:?}", row.line());
            assert_eq!(row.work(Core::M4F), row.costs[1] * f64::from(row.rate));
        }
    }
    let missing = costs.get(Core::M4F, "spring", ["Verlet", "Pull", "f32"]);
    let row = "thumbv7em-none-eabihf / chart spring Pull / f32 / 1/60 / Verlet";
    assert!(missing.unwrap_err().contains(row));
}

/// The table of the README, from its head to the blank line, is that of the committed file.
#[test]
fn the_readme_shows_the_minute() {
    let mut table = Table {
        name: "minute",
        keys: minute_table::KEYS,
        header: minute_table::HEADER.to_vec(),
        rows: Vec::new(),
    };
    table.rows = table.read(MINUTE).unwrap();
    let (_, below) = README
        .split_once(minute_table::HEAD)
        .expect("no table of the minute");
    let shown: Vec<&str> = below.lines().take_while(|line| !line.is_empty()).collect();
    assert_eq!(shown, minute_table::lines(&table.rows));
    let kinds = minute_table::COMBINATIONS.map(|kind| kind.join(" "));
    let made = table
        .rows
        .iter()
        .map(|row| row[..minute_table::KEYS].join(" "));
    assert!(made.eq(kinds));
}
