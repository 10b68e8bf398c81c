//! Boxes and a gear that are pushed off their centres, and how fast they then turn, beside the exact:
//! `cargo run --release --example spinner`.
//!
//! | module | idea |
//! |---|---|
//! | `lane` | the five bodies, and how each is pushed |
//! | `flight` | one body through `World::step` |
//! | `exact` | what it does exactly |
//! | `table` | the figures as text |
//! | `canvas`, `chart` | the picture |

#[path = "../../../examples/picture/canvas.rs"]
mod canvas;
mod chart;
mod exact;
mod flight;
mod lane;
mod table;

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use fixstep::fixed::types::I16F16;
use fixstep::{Carried, Point};

use flight::found;
use lane::Lane;

/// Bodies that turn after a push: speed, spin and angular momentum against the exact values.
///
/// Prints a table of errors, and draws the bodies as a stroboscope shows them.
#[derive(Debug, Parser)]
#[command(name = "spinner", max_term_width = 100)]
struct Options {
    /// Folder for the picture
    #[arg(long, value_name = "DIR", default_value = "lab/examples/spinner")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match spinner(&Options::parse().out) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn spinner(out: &Path) -> Result<(), Box<dyn Error>> {
    print(table::HEAD);
    for lane in Lane::ALL {
        print(&rows(lane)?);
    }
    let flown = Lane::ALL.map(|lane| Ok((lane, flight::fly::<Carried<I16F16>>(lane)?)));
    let flown = flown
        .into_iter()
        .collect::<Result<Vec<_>, fixstep::Error>>()?;
    let folder = out.display();
    fs::create_dir_all(out).map_err(|error| format!("cannot write to {folder}: {error}"))?;
    canvas::save(&out.join("spinner.png"), |area| chart::draw(area, &flown))
        .map_err(|error| format!("cannot draw into {folder}: {error}"))?;
    print(&format!("\nWritten: spinner.png, in {folder}\n"));
    Ok(())
}

/// A row for each number type.
fn rows(lane: Lane) -> Result<String, fixstep::Error> {
    let looks = table::looks(lane);
    let exact = [
        exact::motion(lane, looks[0])?,
        exact::motion(lane, looks[1])?,
    ];
    let row = |numbers, found| table::row(lane, numbers, found, exact);
    Ok([
        row("I16F16", found::<Point<I16F16>>(lane)?),
        row("I16F16, carried", found::<Carried<I16F16>>(lane)?),
        row("f32", found::<Point<f32>>(lane)?),
    ]
    .concat())
}

/// A reader that has seen enough, such as `head`, is no error.
fn print(text: &str) {
    let _ = io::stdout().write_all(text.as_bytes());
}
