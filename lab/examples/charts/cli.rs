//! The command line. A bad value gives one line and exit code 2.

use std::path::PathBuf;

use clap::Parser;

use crate::table::Effort;

/// Where the committed charts are.
pub const HOME: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/charts");

/// Where those of a quick run go.
const QUICK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/charts");

/// Makes every chart of the project: a PNG and the CSV that it is drawn from.
#[derive(Debug, Parser)]
#[command(name = "charts", max_term_width = 100)]
pub struct Options {
    /// Makes few rows of each chart, the same as those of the full run
    #[arg(long)]
    quick: bool,

    /// Writes nothing, and compares what it makes with the committed CSV files
    #[arg(long, conflicts_with = "out")]
    pub check: bool,

    /// Draws the committed CSV files anew, with the costs that the firmware has now, and makes no rows
    #[arg(long, conflicts_with_all = ["quick", "check"])]
    pub draw: bool,

    /// Prints the whole front of each scene instead of a summary
    #[arg(long)]
    pub full: bool,

    /// Folder for pictures and CSV files [default: lab/examples/charts, of a quick run target/charts]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Options {
    /// Reads the command line; prints help where it was asked for. The error is one line.
    pub fn read() -> Result<Options, String> {
        Options::try_parse().map_err(|error| match error.use_stderr() {
            true => one_line(&error.to_string()),
            false => error.exit(),
        })
    }

    pub fn effort(&self) -> Effort {
        match self.quick {
            true => Effort::Quick,
            false => Effort::Full,
        }
    }

    pub fn folder(&self) -> PathBuf {
        // What is committed has all rows.
        let home = if self.quick { QUICK } else { HOME };
        self.out.clone().unwrap_or_else(|| home.into())
    }
}

/// What clap says before its first blank line, without its own "error: ".
fn one_line(text: &str) -> String {
    let lines = text.lines().map(str::trim);
    let said: Vec<&str> = lines.take_while(|line| !line.is_empty()).collect();
    said.join(" ").trim_start_matches("error: ").to_string()
}
