//! Makes every chart of the project: `cargo run --release --example charts [-- --quick] [--out DIR]
//! [--check]`.
//!
//! | module | idea |
//! |---|---|
//! | `cli` | the command line |
//! | `table` | rows of text, as CSV; what is different in two of them |
//! | `scenes`, `rotor` | the scenes, with all methods and ways to state forces |
//! | `starts`, `exact`, `reference` | where bodies start, and where they should be |
//! | `run`, `subject` | one scene with one kind of body; what it asks of a body |
//! | `cost` | what a step costs on a core |
//! | `work`, `figures` | the tables of work and precision, and a row of one |
//! | `pareto`, `verdict` | what is worth its price, and whether the guide recommends it |
//! | `panel`, `head`, `lines`, `look`, `frame`, `labels` | the picture |
//! | `minute`, `minute_table` | errors after a minute, for the README |
//! | `growth`, `maps`, `wrong`, `axes` | errors over long runs, stability, what goes wrong; their panels |
//! | `support` | points and medians: from the tests |

mod axes;
#[path = "../../../examples/picture/canvas.rs"]
mod canvas;
mod cli;
mod cost;
mod exact;
mod figures;
mod frame;
mod growth;
mod head;
mod labels;
mod lines;
mod look;
mod maps;
mod minute;
mod minute_table;
mod panel;
mod pareto;
mod reference;
mod rotor;
mod run;
mod scenes;
mod starts;
mod subject;
use fixstep_lab::support;
mod table;
mod verdict;
mod work;
mod wrong;

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget};

use canvas::Drawn;
use cli::{HOME, Options};
use table::{Effort, Table};

/// A chart: its name, how its rows are made, and how it is drawn from them.
struct Chart {
    name: &'static str,
    make: fn(&'static str, Effort, &ProgressBar) -> Result<Table, String>,
    draw: fn(&Path, &Table) -> Drawn,
}

/// All of them.
const CHARTS: [Chart; 11] = [
    work("work-spring"),
    work("work-projectile"),
    work("work-quadratic"),
    work("work-kepler"),
    work("work-cluster"),
    work("work-pair"),
    work("work-rotor"),
    Chart {
        name: "minute",
        make: minute::make,
        draw: no_picture,
    },
    Chart {
        name: "growth",
        make: |_, effort, progress| Ok(growth::make(effort, progress)),
        draw: growth::draw,
    },
    Chart {
        name: "maps",
        make: |_, effort, progress| Ok(maps::make(effort, progress)),
        draw: maps::draw,
    },
    Chart {
        name: "wrong",
        make: |_, effort, progress| Ok(wrong::make(effort, progress)),
        draw: wrong::draw,
    },
];

const fn work(name: &'static str) -> Chart {
    Chart {
        name,
        make: work::make,
        draw: panel::draw,
    }
}

/// A table has no picture.
fn no_picture(_: &Path, _: &Table) -> Drawn {
    Ok(())
}

fn main() -> ExitCode {
    let failed = |code: u8, error: String| {
        eprintln!("error: {error}");
        ExitCode::from(code)
    };
    match Options::read() {
        Err(error) => failed(2, error),
        Ok(options) => match charts(&options) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => failed(1, error),
        },
    }
}

fn charts(options: &Options) -> Result<(), String> {
    let (progress, begin) = (hidden(), Instant::now());
    let (mut differences, mut tables) = (Vec::new(), Vec::new());
    for chart in &CHARTS {
        if begin.elapsed() > Duration::from_secs(1) {
            progress.set_draw_target(ProgressDrawTarget::stderr());
        }
        let effort = match options.draw {
            true => Effort::Quick, // for its columns
            false => options.effort(),
        };
        let mut table = (chart.make)(chart.name, effort, &progress)?;
        if options.draw {
            table.rows = committed(&table)?;
            price(&mut table)?;
        }
        match options.check {
            true => differences.extend(check(&table, options.effort())?),
            false => progress.suspend(|| write(&options.folder(), chart, &table))?,
        }
        let seconds = begin.elapsed().as_secs_f32();
        progress.suspend(|| {
            eprintln!("{}: {} rows, {seconds:.1} s", chart.name, table.rows.len());
        });
        tables.push(table);
    }
    progress.finish_and_clear();
    print(&verdict::report(&tables, options.full)?);
    if !options.check {
        let folder = options.folder();
        print(&format!(
            "\nOpen {}: each chart has a PNG and its CSV there.\n",
            folder.join("work-kepler-m4f.png").display()
        ));
    }
    match differences.is_empty() {
        true => Ok(()),
        false => Err(format!(
            "the charts are other ones:\n{}",
            differences.join("\n")
        )),
    }
}

/// A bar that appears once something takes long.
fn hidden() -> ProgressBar {
    ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::hidden())
}

/// Gives the rows of a table the costs that the firmware has now; their errors stay.
fn price(table: &mut Table) -> Result<(), String> {
    let costs = cost::Costs::load()?;
    let column = |name| table.header.iter().position(|&header| header == name);
    let (Some(m0), Some(m4f)) = (
        column("m0_instructions_per_step"),
        column("m4f_instructions_per_step"),
    ) else {
        return Ok(());
    };
    // A minute is priced by its fall, and has a column more before the body: that of the spring.
    let (scene, body) = match table.name {
        "minute" => ("projectile", 3),
        name => (name.trim_start_matches("work-"), 2),
    };
    for row in &mut table.rows {
        for (column, core) in [(m0, cost::Core::M0Plus), (m4f, cost::Core::M4F)] {
            let cost = costs.get(core, scene, [&row[0], &row[1], &row[body]])?;
            row[column] = format!("{cost:.1}");
        }
    }
    Ok(())
}

/// The committed rows of a table.
fn committed(table: &Table) -> Result<Vec<Vec<String>>, String> {
    let path = Path::new(HOME).join(format!("{}.csv", table.name));
    let text =
        fs::read_to_string(&path).map_err(|e| format!("cannot read {}: {e}", path.display()))?;
    table.read(&text)
}

fn check(table: &Table, effort: Effort) -> Result<Vec<String>, String> {
    Ok(table.differences(&committed(table)?, effort))
}

fn write(folder: &Path, chart: &Chart, table: &Table) -> Result<(), String> {
    let place = folder.display();
    let unwritable = |error: io::Error| format!("cannot write to {place}: {error}");
    fs::create_dir_all(folder).map_err(unwritable)?;
    fs::write(folder.join(format!("{}.csv", table.name)), table.csv()).map_err(unwritable)?;
    (chart.draw)(folder, table).map_err(|e| format!("cannot draw {} into {place}: {e}", table.name))
}

/// A reader that has seen enough, such as `head`, is no error.
fn print(text: &str) {
    let _ = io::stdout().write_all(text.as_bytes());
}
