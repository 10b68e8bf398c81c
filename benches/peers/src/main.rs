//! Other engines and fixstep on the same axes, error against instructions: `cargo run --release`.
//!
//! ```text
//! cargo run --release              makes the tables, and writes results.csv and the README's tables
//! cargo run --release -- --check   compares with results.csv; exit code 1 where they differ
//! cargo run --release --no-default-features -- --check     fixstep's rows alone
//! ```
//!
//! | module | idea |
//! |---|---|
//! | `problem` | what is run, and its exact solution |
//! | `engine` | what the bench asks of an engine |
//! | `rapier`, `box2d_3`, `box2d_2`, `fixstep` | the engines |
//! | `count` | instructions, by callgrind |
//! | `sweep` | every rate with every setting, and the best of them |
//! | `held` | a user force over substeps: derived and measured |
//! | `table`, `results` | what is shown, written and compared |

// What only the tables need.
#![cfg_attr(not(feature = "engines"), allow(dead_code))]

#[cfg(feature = "engines")]
mod box2d_2;
#[cfg(feature = "engines")]
mod box2d_3;
mod count;
mod engine;
mod fixstep;
#[cfg(feature = "engines")]
mod held;
mod problem;
#[cfg(feature = "engines")]
mod rapier;
mod results;
mod sweep;
#[cfg(feature = "engines")]
mod table;

use std::fs;
use std::io;
use std::process::ExitCode;

const RESULTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/results.csv");
const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
/// The tables of the README stand below this line.
const MARK: &str = "<!-- made by cargo run --release -->\n";

fn main() -> ExitCode {
    let argument = std::env::args().nth(1);
    let done = match argument.as_deref() {
        Some(count::ARGUMENT) => {
            count::make();
            Ok(true)
        }
        Some("--check") => check(),
        None => write().map(|()| true),
        Some(other) => {
            eprintln!("error: {other} is no argument; --check is");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

#[cfg(not(feature = "engines"))]
fn write() -> io::Result<()> {
    Err(io::Error::other("the tables need the engines"))
}

#[cfg(feature = "engines")]
fn write() -> io::Result<()> {
    let rows = sweep::run();
    let tables = format!(
        "{}\n### A spring as a user force, over substeps\n\n{}",
        table::report(&rows),
        held::table()
    );
    print!("{tables}");
    fs::write(RESULTS, results::write(&rows))?;
    let readme = fs::read_to_string(README)?;
    let above = readme.split(MARK).next().unwrap_or_default();
    fs::write(README, format!("{above}{MARK}{tables}"))
}

fn check() -> io::Result<bool> {
    let mut file = fs::read_to_string(RESULTS)?;
    if cfg!(not(feature = "engines")) {
        let ours = |line: &&str| line.starts_with("problem,") || line.contains(",fixstep ");
        file = file
            .lines()
            .filter(ours)
            .map(|line| format!("{line}\n"))
            .collect();
    }
    let differences = results::differences(&sweep::run(), &file);
    for difference in &differences {
        println!("{difference}");
    }
    println!("{} rows differ from results.csv", differences.len());
    Ok(differences.is_empty())
}
