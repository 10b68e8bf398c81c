//! Fronts: the rule, and what the committed tables say of the recommendations.

use crate::cost::Core;
use crate::figures::{KEYS, Row, header};
use crate::minute_table;
use crate::pareto::{front, stairs};
use crate::starts::Plan;
use crate::table::Table;
use crate::verdict::{At60, at_60_hz, recommended};

const MINUTE: &str = include_str!("../../examples/charts/minute.csv");
const WORK: [(&str, &str); 7] = [
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
    (
        "rotor",
        include_str!("../../examples/charts/work-rotor.csv"),
    ),
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

pub fn rows(scene: &'static str, text: &str) -> Vec<Row> {
    let mut table = Table {
        name: "committed",
        keys: KEYS,
        header: header(Plan::of(scene).unit()),
        rows: Vec::new(),
    };
    table.rows = table.read(text).unwrap();
    Row::all(&table).unwrap()
}

/// What the guide recommends is on the front at 60 Hz, but for the default method where a spring is solved
/// exactly for less.
#[test]
fn what_the_guide_recommends_is_on_the_front_but_where_a_spring_is_solved() {
    let mut behind = Vec::new();
    for (scene, text) in WORK {
        let (rows, size) = (rows(scene, text), Plan::of(scene).size);
        for core in Core::ALL {
            let At60 { front, before } = at_60_hz(core, scene, size, &rows);
            for (name, before) in recommended(scene, core).iter().zip(before) {
                let name = name.join(" ");
                let on = front.iter().any(|line| line.join(" ") == name);
                assert_eq!(on, before.is_empty(), "{scene}, {}: {name}", core.name());
                if !on {
                    behind.push(format!("{scene}, {}: {name}", core.name()));
                }
            }
        }
    }
    let expected = [
        "spring, Cortex-M0+: Verlet Anchor I8F24",
        "pair, Cortex-M4F: Verlet Spring f32",
    ];
    assert_eq!(behind, expected);
}

/// The least error that is bought for less than `price`, and the least of all, by explicit forces.
fn least_explicit(core: Core, rows: &[Row], price: f64) -> [f64; 2] {
    let explicit = rows
        .iter()
        .filter(|row| !row.forces.starts_with("Exact") && row.forces != "Ballistic");
    let all: Vec<_> = explicit
        .map(|row| (row.work(core), row.errors[1]))
        .collect();
    let least = |most: f64| {
        let errors = all.iter().filter(|one| one.0 <= most).map(|one| one.1);
        errors.fold(f64::INFINITY, f64::min)
    };
    [least(price), least(f64::INFINITY)]
}

/// What the page of accuracy says of flows: in carried I8F24 at 15 Hz nothing explicit is as exact at any rate; for the
/// price of one in a recommended point, what is explicit errs by 5 cm or more.
#[test]
fn nothing_explicit_is_as_exact_as_a_flow_for_its_price() {
    for (scene, text) in WORK
        .into_iter()
        .filter(|work| ["spring", "projectile"].contains(&work.0))
    {
        let rows = rows(scene, text);
        let flow = |body: &str| {
            let is = |row: &&Row| {
                row.line()[1..]
                    == [
                        ["ExactSpring", "Ballistic"][usize::from(scene != "spring")],
                        body,
                    ]
            };
            rows.iter().find(|row| is(row) && row.rate == 15).unwrap()
        };
        for core in Core::ALL {
            let carried = flow("I8F24 carried");
            let [_, least] = least_explicit(core, &rows, f64::INFINITY);
            assert!(carried.errors[1] < least, "{scene}: {least}");
            let body = recommended(scene, core)[1][2];
            let [cheap, _] = least_explicit(core, &rows, flow(body).work(core));
            assert!(cheap >= 0.05, "{scene}, {}: {cheap}", core.name());
        }
    }
}

/// All that the chart has to show is in the table, and costs what the firmware's table says.
#[test]
fn tables_are_whole_and_have_the_costs_of_the_firmware() {
    let costs = crate::cost::Costs::load().unwrap();
    for ((scene, text), runs) in WORK.into_iter().zip([7, 9, 8, 6, 6, 7, 5]) {
        let rows = rows(scene, text);
        assert_eq!(rows.len(), runs * 5 * 7, "{scene}: runs, bodies, rates");
        for row in &rows {
            let cost = |core| costs.get(core, scene, row.line()).unwrap();
            assert_eq!(row.costs, Core::ALL.map(cost), "{scene} {:?}", row.line());
            assert_eq!(row.work(Core::M4F), row.costs[1] * f64::from(row.rate));
        }
    }
    let missing = costs.get(Core::M4F, "spring", ["Verlet", "Pull", "f32"]);
    let row = "thumbv7em-none-eabihf / chart spring Pull / f32 / Verlet";
    assert!(missing.unwrap_err().contains(row));
}

/// The table of a page, from its head to the blank line, is that of the committed file.
#[test]
fn a_page_shows_the_minute() {
    let mut table = Table {
        name: "minute",
        keys: minute_table::KEYS,
        header: minute_table::HEADER.to_vec(),
        rows: Vec::new(),
    };
    table.rows = table.read(MINUTE).unwrap();
    let (_, below) = fixstep_lab::support::pages::pages()
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
