//! The two slope fields of Chris Hecker's "Physics, The Next Frontier" (Game Developer, 1996), with
//! what each method makes of them at a coarse step: `cargo run --release --example fields`.
//!
//! | module | idea |
//! |---|---|
//! | `flight` | one run through `World::step` |
//! | `figures` | what is run for each figure, and the exact solutions |
//! | `csv`, `table` | the figures as text |
//! | `canvas`, `chart` | what both pictures share: pixels; axes, slopes, marks |
//! | `fig1`, `fig2` | the pictures |

#[path = "../../../examples/picture/canvas.rs"]
mod canvas;
mod chart;
mod csv;
mod fig1;
mod fig2;
mod figures;
mod flight;
mod table;

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;

/// Draws the slope fields of dy/dx = 2x and dv/dt = -v/m, and every method over them.
///
/// Prints where each method ends, and writes a picture and a CSV file for each figure.
#[derive(Debug, Parser)]
#[command(name = "fields", max_term_width = 100)]
struct Options {
    /// Folder for the pictures and the CSV files
    #[arg(long, value_name = "DIR", default_value = "lab/examples/fields")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match fields(&Options::parse().out) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn fields(out: &Path) -> Result<(), Box<dyn Error>> {
    let (fig1, fig2) = (figures::fig1()?, figures::fig2()?);
    print(&table::report(&fig1, &fig2));

    let folder = out.display();
    let file = |name: &str| out.join(name);
    let unwritable = |error: io::Error| format!("cannot write to {folder}: {error}");
    fs::create_dir_all(out).map_err(unwritable)?;
    fs::write(file("fig1.csv"), csv::fig1(&fig1)).map_err(unwritable)?;
    fs::write(file("fig2.csv"), csv::fig2(&fig2)).map_err(unwritable)?;

    let undrawn = |error: Box<dyn Error>| format!("cannot draw into {folder}: {error}");
    canvas::save(&file("fig1.png"), |area| fig1::draw(area, &fig1)).map_err(undrawn)?;
    canvas::save(&file("fig2.png"), |area| fig2::draw(area, &fig2)).map_err(undrawn)?;
    print(&format!(
        "\nWritten: fig1 and fig2, each as .png and .csv, in {folder}\n"
    ));
    Ok(())
}

/// A reader that has seen enough, such as `head`, is no error.
fn print(text: &str) {
    let _ = io::stdout().write_all(text.as_bytes());
}
