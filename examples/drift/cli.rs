//! The command line. A bad value gives one line and exit code 2.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Parser, ValueEnum};
use fixstep::fixed::types::I16F16;
use fixstep::{Ratio, Step};

use crate::scene::{self, Scene};

/// How far each number type drifts from the exact motion.
///
/// Flies scenes with every method and scalar, splits the error into that of the method, of the
/// coefficients and of the state's rounding, prints a table and writes a CSV file and pictures.
#[derive(Debug, Parser)]
#[command(name = "drift", max_term_width = 100)]
pub struct Options {
    /// Scenes to fly; several with commas. All by default
    #[arg(long, value_name = "NAME", value_delimiter = ',', value_parser = scenes())]
    pub scene: Vec<&'static Scene>,

    /// Methods to compare; several with commas. All by default
    #[arg(long, value_name = "NAME", value_delimiter = ',', ignore_case = true)]
    pub method: Vec<MethodName>,

    /// Scalars to compare; several with commas. All by default
    #[arg(long, value_name = "TYPE", value_delimiter = ',', ignore_case = true)]
    pub scalar: Vec<ScalarName>,

    /// Steps per second: a decimal above 4
    #[arg(long, value_name = "RATE", default_value = "60", value_parser = rate)]
    #[arg(allow_negative_numbers = true)]
    pub hz: Ratio,

    /// Simulated seconds of every scene. Each has its own by default
    #[arg(long, value_name = "TIME", value_parser = seconds)]
    #[arg(allow_negative_numbers = true)]
    pub seconds: Option<f64>,

    /// Print every scene, method and type, with the parts of each error, instead of the summary. So does
    /// a choice of methods or scalars
    #[arg(long)]
    pub full: bool,

    /// Folder for drift.csv and the pictures
    #[arg(long, value_name = "DIR", default_value = "target/drift")]
    pub out: PathBuf,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MethodName {
    Euler,
    ConstantAcceleration,
    SemiImplicitEuler,
    Verlet,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "verbatim")]
pub enum ScalarName {
    #[value(name = "f32")]
    F32,
    I8F24,
    I12F20,
    I16F16,
    I20F12,
    #[value(name = "f64")]
    F64,
}

impl Options {
    /// Reads the command line; prints help where it was asked for. The error is one line.
    pub fn read() -> Result<Options, String> {
        let mut options = Options::try_parse().map_err(|error| {
            if error.use_stderr() {
                one_line(&error.to_string())
            } else {
                error.exit()
            }
        })?;
        options.full |= !(options.method.is_empty() && options.scalar.is_empty());
        if options.scene.is_empty() {
            options.scene = scene::ALL.iter().collect();
        }
        if options.method.is_empty() {
            options.method = MethodName::value_variants().to_vec();
        }
        if options.scalar.is_empty() {
            options.scalar = ScalarName::value_variants().to_vec();
        }
        options.check_length()?;
        Ok(options)
    }

    fn check_length(&self) -> Result<(), String> {
        const MOST: u64 = 1_000_000_000;
        for scene in &self.scene {
            let steps = scene.steps(self.hz, self.seconds);
            if !(1..=MOST).contains(&steps) {
                return Err(format!(
                    "{} would run {steps} steps, not 1 to {MOST}",
                    scene.name
                ));
            }
        }
        Ok(())
    }
}

/// The name of a method or scalar as it is written on the command line.
pub fn name(value: impl ValueEnum) -> String {
    value
        .to_possible_value()
        .map_or_else(String::new, |value| value.get_name().to_string())
}

/// What clap says before its first blank line, without its own "error: ".
fn one_line(text: &str) -> String {
    let lines = text
        .lines()
        .map(str::trim)
        .take_while(|line| !line.is_empty());
    let line = lines.collect::<Vec<_>>().join(" ");
    line.trim_start_matches("error: ").to_string()
}

fn scenes() -> impl TypedValueParser<Value = &'static Scene> {
    let names = PossibleValuesParser::new(scene::ALL.iter().map(|scene| scene.name));
    names.try_map(|name| {
        scene::ALL
            .iter()
            .find(|scene| scene.name == name)
            .ok_or("no scene")
    })
}

fn rate(text: &str) -> Result<Ratio, String> {
    let refused = |error: fixstep::Error| error.to_string();
    let rate = Ratio::parse(text).map_err(|_| "not a plain decimal".to_string())?;
    Step::<f32>::hz(rate).map_err(refused)?;
    Step::<I16F16>::hz(rate).map_err(refused)?;
    Ok(rate)
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds.is_finite() && seconds > 0.0 => Ok(seconds),
        _ => Err("not a time greater than zero".to_string()),
    }
}
