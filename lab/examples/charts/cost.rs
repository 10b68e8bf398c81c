//! What a step costs, from the firmware's table: counted in an emulator, for the same scene, forces,
//! body and method. A cost that is not there is an error; none is guessed.

use std::collections::HashMap;
use std::fs;

/// Where the firmware writes its figures.
const RESULTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/firmware/results.tsv");

/// A core that the charts are drawn for, from small to large.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Core {
    M0Plus,
    M4F,
}

impl Core {
    pub const ALL: [Core; 2] = [Core::M0Plus, Core::M4F];

    pub fn name(self) -> &'static str {
        match self {
            Core::M0Plus => "Cortex-M0+",
            Core::M4F => "Cortex-M4F",
        }
    }

    /// In the name of a picture.
    pub fn short(self) -> &'static str {
        match self {
            Core::M0Plus => "m0",
            Core::M4F => "m4f",
        }
    }

    fn target(self) -> &'static str {
        match self {
            Core::M0Plus => "thumbv6m-none-eabi",
            Core::M4F => "thumbv7em-none-eabihf",
        }
    }
}

/// Instructions per body and step.
pub struct Costs(HashMap<String, f64>);

impl Costs {
    pub fn load() -> Result<Costs, String> {
        let text =
            fs::read_to_string(RESULTS).map_err(|e| format!("cannot read {RESULTS}: {e}"))?;
        Ok(Costs::of(&text))
    }

    /// Columns: target, scene, scalar, method, hash, instructions, and more.
    fn of(text: &str) -> Costs {
        let figures = text.lines().filter_map(|line| {
            let fields: Vec<_> = line.split('\t').collect();
            let figure = fields.get(5)?.parse().ok()?;
            Some((fields[..4].join("\t"), figure))
        });
        Costs(figures.collect())
    }

    /// Of a run of a scene on a core. Nothing in a `Step` depends on its length: it is counted at 60 Hz.
    pub fn get(&self, core: Core, scene: &str, run: [&str; 3]) -> Result<f64, String> {
        let [method, forces, body] = run;
        let target = core.target();
        let key = format!("{target}\tchart {scene} {forces}\t{body}\t{method}");
        let missing = || {
            format!(
                "tests/firmware/results.tsv has no row {}",
                key.replace('\t', " / ")
            )
        };
        self.0.get(&key).copied().ok_or_else(missing)
    }
}
