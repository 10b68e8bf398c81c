//! What the chart shows, as CSV: a line for each law, scalar, method and terminal speed. Errors are
//! relative and have four digits; figures and bounds are medians over sixteen falls.

use std::fmt::Write;

use crate::scene::Law;
use crate::series::Series;

pub fn lines(all: &[Series]) -> String {
    let mut text = "drag,scalar,method,v_t_m_s,mean_velocity_median,mean_velocity_bound,\
                    worst_tick_median,worst_tick_bound,worst_tick_max\n"
        .to_string();
    for law in Law::BOTH {
        for series in all {
            for cell in &series.laws[law as usize] {
                let _ = writeln!(
                    text,
                    "{law:?},{},{:?},{},{:.3e},{:.3e},{:.3e},{:.3e},{:.3e}",
                    series.scalar,
                    series.scheme,
                    cell.speed(),
                    cell.mean(),
                    cell.mean_bound(),
                    cell.error(),
                    cell.bound(),
                    cell.largest(),
                );
            }
        }
    }
    text
}
