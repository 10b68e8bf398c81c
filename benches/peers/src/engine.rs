//! What the bench asks of an engine.

use crate::problem::{Kind, State};

/// What an engine can be told besides the rate; `label` is what the table shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    pub label: &'static str,
    /// Substeps and stabilisation passes; iterations for velocities and positions; or the method.
    pub counts: [usize; 2],
}

/// Makes a setting.
pub const fn setting(label: &'static str, counts: [usize; 2]) -> Setting {
    Setting { label, counts }
}

/// An engine, with the settings that the search goes through.
pub trait Engine {
    /// Name and version.
    fn name(&self) -> &'static str;

    /// The default first; none where the engine does not take part.
    fn settings(&self, kind: Kind) -> &'static [Setting];

    /// A world with a body for each start of the problem, without shapes, and none allowed to sleep.
    fn build(&self, kind: Kind, setting: &Setting, rate: u32) -> Box<dyn Scene>;
}

/// A world that is ready to run.
pub trait Scene {
    /// Makes steps; what the caller has to do for each (a user force) is part of it.
    fn advance(&mut self, steps: u32);

    /// In the order of the starts.
    fn states(&self) -> Vec<State>;
}

/// Every engine, in the order of the table.
pub fn all() -> Vec<Box<dyn Engine>> {
    #[cfg(feature = "engines")]
    let mut engines: Vec<Box<dyn Engine>> = {
        use crate::{box2d_2::Box2d2, box2d_3::Box2d3, rapier::Rapier};
        vec![Box::new(Rapier), Box::new(Box2d3), Box::new(Box2d2)]
    };
    #[cfg(not(feature = "engines"))]
    let mut engines: Vec<Box<dyn Engine>> = Vec::new();
    engines.extend(crate::fixstep::all());
    engines
}
