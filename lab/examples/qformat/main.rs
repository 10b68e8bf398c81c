//! Which fixed-point type fits a scene: `cargo run --release --example qformat -- --scene spring`.
//!
//! A scene is flown in `f64` by a number type of its own that takes notes. The report says which type of
//! 32 bits to take, how wrong it will be, what saturates first and what a dyadic rate would change.
//! A scene of yours, generic over its body as it should be anyway, goes in like this:
//!
//! ```text
//! type Forces<S> = (GravityY<S>, LinearDrag<S>);
//!
//! fn scene<B: Body + From<Point<B::S>>>(world: &mut World<B, 8>) -> Result<Forces<B::S>, Error> {
//!     let ball = Point::new(vec2(0, 2)?, vec2(12, 9)?, dec!(0.45))?;
//!     world.add(ball.into())?;
//!     Ok((GravityY::new(dec!(-9.81))?, LinearDrag::new(dec!(0.1))?))
//! }
//!
//! let question = Question {
//!     plan: Plan { method: Scheme::Verlet, rate: dec!(60), seconds: 4.0, circle: None },
//!     bears: 1e-3,
//!     headroom: 0.5,
//!     beside: USUAL,
//! };
//! print!("{}", report("my scene", &advise(&scene, &question)?));
//! ```
//!
//! `Point<I16F16>` is a body that `scene` takes too: the game flies what was judged. A scene of bodies that
//! turn is one for any `B: Rotating + From<Rigid<Point<B::S>>>`, and an angle that is wrong counts as the arc at
//! 1 m. Bodies that carry remainders are more accurate than what is said here.
//!
//! | module | idea |
//! |---|---|
//! | `cli` | the command line |
//! | `described` | a scene as data; those of the drift example |
//! | `rotor` | a scene of bodies that turn |
//! | `flight` | one run, in any number type |
//! | `notes` | what a run writes down |
//! | `recorded`, `angles`, `noted` | the number and the body that do |
//! | `grid` | what rounding does, as a theory |
//! | `flown` | what types make of a scene |
//! | `spread` | whether an error can be told at all |
//! | `advise` | which type to take |
//! | `report` | the answer on one screen |

mod advise;
mod angles;
mod cli;
mod described;
mod flight;
mod flown;
mod grid;
mod noted;
mod notes;
mod recorded;
mod report;
mod rotor;
#[path = "../../../examples/drift/scene.rs"]
#[allow(dead_code)] // what is kept is for the drift example
mod scene;
mod spread;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;
use fixstep::{Error, World};

use cli::{Asked, Options};
use described::{Described, Forces, ROOM};
use noted::Noted;
use recorded::Recorded;
use rotor::ROTOR;

fn main() -> ExitCode {
    let options = Options::parse();
    match answer(&options) {
        Ok(text) => {
            // A reader that has seen enough, such as `head`, is no error.
            let _ = io::stdout().write_all(text.as_bytes());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn answer(options: &Options) -> Result<String, String> {
    let question = options.question();
    match options.scene {
        Asked::Drift(scene) => {
            let described = Described::of_drift(scene, 0, options.distance);
            let build = |world: &mut World<Noted, ROOM>| -> Result<Forces<Recorded>, Error> {
                described.build(world, Noted::from)
            };
            let advice = advise::advise(&build, &question)?;
            Ok(report::report(scene.title, &advice))
        }
        Asked::Rotor => {
            let build = |world: &mut World<Noted, ROOM>| ROTOR.build(world, Noted::from);
            let advice = advise::advise(&build, &question)?;
            Ok(report::report(rotor::TITLE, &advice))
        }
    }
}
