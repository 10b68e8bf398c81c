//! A rod swings on a pin, a constraint that the scene makes itself, and its period is compared with the complete
//! elliptic integral: `cargo run --release --example pendulum`.
//!
//! | module | idea |
//! |---|---|
//! | `hinge` | the pin: a force of the scene's own |
//! | `swing` | one pendulum through `World::step`, its period and energy |
//! | `exact` | the period by Gauss's arithmetic-geometric mean |
//! | `runs` | amplitudes, number types and rates |
//! | `table` | the figures as text |

mod exact;
mod hinge;
mod runs;
mod swing;
mod table;

use std::io::{self, Write};

fn main() -> Result<(), fixstep::Error> {
    let rows = table::rows(&runs::all()?);
    // A reader that has seen enough, such as `head`, is no error.
    let _ = writeln!(io::stdout(), "{}{}", table::HEAD, rows.join("\n"));
    Ok(())
}
