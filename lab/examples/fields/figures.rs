//! What is run for each figure, and which methods cannot be told apart there.
//!
//! ```text
//! Fig. 1   dy/dx = 2x      y = x² + c          methods leave the parabola by n h²
//! Fig. 2   dv/dt = -v/m    v = v0 e^(-t/m)     v(n) = v0 (1 - k h/m)^n with k = 1 kg/s, m = 1 kg
//! ```
//!
//! Steps are halves, so every value of a method is exact in `f64` and files come out the same
//! everywhere; the exact solutions are written to fewer digits than they have.
//! Source: Hecker, "Physics, The Next Frontier" (1996), Fig. 1 and 2.

use fixstep::{DyadicStep, Error};

use crate::flight::{MethodName, Run, friction, parabola};

/// Where Fig. 1 starts, on the parabola of c = 0.
pub const START: [f64; 2] = [-2.0, 4.0];
/// Eight steps of 1/2 lead to x = 2.
const TICKS: u32 = 8;

/// Where Fig. 2 starts, m/s.
pub const V0: f64 = 2.0;
/// Where it ends, s: 15 steps of 1/2, 5 of 3/2, 3 of 5/2.
pub const SECONDS: f64 = 7.5;

/// A run for each method.
pub fn fig1() -> Result<Vec<Run>, Error> {
    let step = DyadicStep::<f64, 1, 1>::new()?;
    let run = |method| parabola(method, &step, TICKS, START);
    MethodName::ALL.into_iter().map(run).collect()
}

/// A run for each step and method.
pub fn fig2() -> Result<Vec<Run>, Error> {
    let runs = [halves::<1>()?, halves::<3>()?, halves::<5>()?];
    Ok(runs.concat())
}

/// Friction with a step of `NUM / 2` s.
fn halves<const NUM: u32>() -> Result<Vec<Run>, Error> {
    let step = DyadicStep::<f64, NUM, 1>::new()?;
    let ticks = (2.0 * SECONDS) as u32 / NUM;
    let run = |method| friction(method, &step, ticks, V0);
    MethodName::ALL.into_iter().map(run).collect()
}

/// Methods that make the same points with the same step.
pub struct Group<'a> {
    pub methods: Vec<MethodName>,
    /// The run of any of them.
    pub run: &'a Run,
}

impl Group<'_> {
    /// As a legend has it.
    pub fn label(&self) -> String {
        if self.methods.len() == MethodName::ALL.len() {
            return "all four methods".to_string();
        }
        let names: Vec<String> = self.methods.iter().map(|m| format!("{m:?}")).collect();
        names.join(" and ")
    }
}

/// All runs, those in one group that agree in every bit that is shown.
pub fn coinciding(runs: &[Run]) -> Vec<Group<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for run in runs {
        let same = |group: &&mut Group| group.run.samples == run.samples;
        match groups.iter_mut().find(same) {
            Some(group) => group.methods.push(run.method),
            None => groups.push(Group {
                methods: vec![run.method],
                run,
            }),
        }
    }
    groups
}
