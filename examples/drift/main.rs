//! Compares the drift of `f32` and of fixed point: `cargo run --release --example drift`.
//!
//! | module | idea |
//! |---|---|
//! | `cli` | the command line |
//! | `scene` | what is flown, as data |
//! | `exact` | where it should be: closed forms |
//! | `represent` | what a scalar makes of the coefficients |
//! | `run` | one run through `World::step` |
//! | `compare` | the error, and its three parts |
//! | `work` | all runs, on all cores |
//! | `summary` | one screen: the best type of each scene, and a conclusion |
//! | `table`, `csv`, `picture` | all figures |

mod cli;
mod compare;
mod csv;
mod exact;
mod picture;
mod represent;
mod run;
mod scene;
mod summary;
mod table;
mod work;

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use cli::Options;

fn main() -> ExitCode {
    match Options::read().and_then(|options| drift(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn drift(options: &Options) -> Result<(), String> {
    let folder = options.out.display();
    let unwritable = |error: io::Error| format!("cannot write to {folder}: {error}");
    fs::create_dir_all(&options.out).map_err(unwritable)?;
    let file = File::create(options.out.join("drift.csv")).map_err(unwritable)?;

    let cases = work::compare_all(options).map_err(|error| error.to_string())?;
    print(&match options.full {
        true => table::report(options, &cases),
        false => summary::report(options, &cases),
    });
    csv::write(BufWriter::new(file), &cases).map_err(unwritable)?;
    picture::draw_all(&options.out, options, &cases)
        .map_err(|error| format!("cannot draw into {folder}: {error}"))?;
    let first = options.scene.first().map_or("", |scene| scene.name);
    print(&format!(
        "\nOpen {folder}/{first}.png: how the errors grow. Each scene has a picture.\n\
         All figures: {folder}/drift.csv, or print them with `--full`.\n"
    ));
    Ok(())
}

/// A reader that has seen enough, such as `head`, is no error.
fn print(text: &str) {
    let _ = io::stdout().write_all(text.as_bytes());
}
