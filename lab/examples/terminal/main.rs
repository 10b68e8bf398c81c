//! Terminal velocity: a body falls under linear or quadratic drag until its speed stays, which is
//! compared with the exact terminal speed: `cargo run --release --example terminal`.
//!
//! | module | idea |
//! |---|---|
//! | `scene` | what falls, and the exact terminal speed |
//! | `fall` | one fall through `World::step`, and its error |
//! | `bound` | how large the error can be, derived |
//! | `series` | all scalars, methods and falls; methods that made the same bits |
//! | `csv`, `table` | the figures as text |
//! | `canvas`, `chart` | the picture |
//! | `support` | number types that know their unit, methods by name: from the tests |

mod bound;
#[path = "../../../examples/picture/canvas.rs"]
mod canvas;
mod chart;
mod csv;
mod fall;
mod scene;
mod series;
use fixstep_lab::support;
mod table;

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;

/// Terminal velocity under linear and quadratic drag, against the exact value.
///
/// Prints a table of relative errors, and writes a chart and a CSV file.
#[derive(Debug, Parser)]
#[command(name = "terminal", max_term_width = 100)]
struct Options {
    /// Folder for the chart and the CSV file
    #[arg(long, value_name = "DIR", default_value = "lab/examples/terminal")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match terminal(&Options::parse().out) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn terminal(out: &Path) -> Result<(), Box<dyn Error>> {
    let all = series::measure();
    print(&format!(
        "{}{}\n",
        table::HEAD,
        table::rows(&all).join("\n")
    ));

    let folder = out.display();
    let unwritable = |error: io::Error| format!("cannot write to {folder}: {error}");
    fs::create_dir_all(out).map_err(unwritable)?;
    fs::write(out.join("terminal.csv"), csv::lines(&all)).map_err(unwritable)?;

    let undrawn = |error: Box<dyn Error>| format!("cannot draw into {folder}: {error}");
    canvas::save(&out.join("terminal.png"), |area| chart::draw(area, &all)).map_err(undrawn)?;
    print(&format!(
        "\nWritten: terminal.png and terminal.csv, in {folder}\n"
    ));
    Ok(())
}

/// A reader that has seen enough, such as `head`, is no error.
fn print(text: &str) {
    let _ = io::stdout().write_all(text.as_bytes());
}
