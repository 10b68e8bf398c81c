//! The points of both figures as CSV: what a method makes, all digits; the exact solution and the
//! error to six decimals, which no machine's exponential function changes.

use std::fmt::Write;

use crate::flight::Run;

/// x and y are pure numbers.
pub fn fig1(runs: &[Run]) -> String {
    lines("method,h,x,y,exact_y,error_y", runs)
}

/// Seconds and metres per second.
pub fn fig2(runs: &[Run]) -> String {
    lines("method,h_s,t_s,v_m_s,exact_v_m_s,error_v_m_s", runs)
}

/// A header line, then one line a run and sample.
fn lines(header: &str, runs: &[Run]) -> String {
    let mut text = format!("{header}\n");
    for run in runs {
        for sample in &run.samples {
            let _ = writeln!(
                text,
                "{:?},{},{},{},{:.6},{:.6}",
                run.method,
                run.step,
                sample.at,
                sample.value,
                sample.exact,
                sample.error()
            );
        }
    }
    text
}
