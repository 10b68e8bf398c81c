//! What the charts rest on: where bodies should be, which points are on a front, how tables are compared,
//! and what the committed tables say of the recommendations of the guide and of the README;
//! and the faults that the chart of what goes wrong shows.
//!
//! `cargo run --release --example charts` makes the tables and pictures; `-- --check` holds the tables against
//! a fresh run.

#[allow(dead_code)] // the example loads the costs, too
#[path = "../examples/charts/cost.rs"]
mod cost;
#[path = "../examples/charts/exact.rs"]
mod exact;
#[path = "charts/exact.rs"]
mod exact_places;
#[allow(dead_code)] // the example makes rows, too
#[path = "../examples/charts/figures.rs"]
mod figures;
#[path = "charts/front.rs"]
mod fronts;
#[path = "../examples/charts/minute_table.rs"]
mod minute_table;
#[allow(dead_code)] // the example draws stairs
#[path = "../examples/charts/pareto.rs"]
mod pareto;
#[path = "../examples/charts/reference.rs"]
mod reference;
#[allow(dead_code)] // only the constants are used
#[path = "../examples/charts/rotor.rs"]
mod rotor;
#[path = "charts/rotor.rs"]
mod rotors;
#[allow(dead_code)] // only the constants are used
#[path = "../examples/charts/scenes.rs"]
mod scenes;
#[allow(dead_code)] // the example has titles
#[path = "../examples/charts/starts.rs"]
mod starts;
use fixstep_lab::support;
#[path = "../examples/charts/table.rs"]
mod table;
#[path = "charts/tables.rs"]
mod tables;
#[allow(dead_code)] // the example prints it
#[path = "../examples/charts/verdict.rs"]
mod verdict;
#[path = "charts/wrong.rs"]
mod wrong;
