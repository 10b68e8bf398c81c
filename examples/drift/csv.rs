//! The same figures as a CSV file, for every tick that was looked at.

use std::io::{self, Write};

use crate::cli::name;
use crate::work::Case;

/// A header line, then one line a case and tick. What is out of range reads `inf`; a scene that a
/// scalar cannot hold has no lines.
pub fn write(mut to: impl Write, cases: &[Case]) -> io::Result<()> {
    writeln!(
        to,
        "scene,method,scalar,bytes_per_body,tick,seconds,error_m,worst_m,\
         method_m,coefficient_m,rounding_m,scalar_m,energy,momentum_kg_m_s"
    )?;
    for case in cases {
        let (method, scalar) = (name(case.method), name(case.scalar));
        let labels = format!(
            "{},{method},{scalar},{}",
            case.scene.name, case.bytes_per_body
        );
        for row in case.rows.iter().flatten() {
            write!(to, "{labels},{},{}", row.tick, row.seconds)?;
            let parts = [row.method, row.coefficient, row.rounding, row.scalar];
            for value in [row.error, row.worst].into_iter().chain(parts) {
                write!(to, ",{value:.5e}")?;
            }
            let kept = case.scene.kept;
            for (kept, value) in [(kept.energy, row.energy), (kept.momentum, row.momentum)] {
                match kept {
                    true => write!(to, ",{value:.5e}")?,
                    false => write!(to, ",")?,
                }
            }
            writeln!(to)?;
        }
    }
    to.flush()
}
