//! The table that is printed and stands in the README.

use std::fmt::Write;

use crate::sweep::{Row, chosen};

const HEAD: &str = "| engine | chosen by | rate | setting | median, m | max, m | instructions | thousands a second |\n\
                    |---|---|---|---|---|---|---|---|\n";

/// For each problem a table of its own: of each engine what stands out, each row once.
pub fn report(rows: &[Row]) -> String {
    let mut text = String::new();
    for group in rows.chunk_by(|a, b| a.problem == b.problem) {
        let _ = write!(text, "\n### {}\n\n{HEAD}", group[0].problem);
        for own in group.chunk_by(|a, b| a.engine == b.engine) {
            let own: Vec<&Row> = own.iter().collect();
            for (why, row) in lines(chosen(&own)) {
                line(&mut text, &why, row);
            }
        }
    }
    text
}

/// A row that is chosen twice is shown once, with both reasons. Told by its place: NaN is not itself.
fn lines(chosen: [Option<&Row>; 3]) -> Vec<(String, &Row)> {
    let mut lines: Vec<(String, &Row)> = Vec::new();
    for (why, row) in ["default", "best at its cost", "best"]
        .into_iter()
        .zip(chosen)
    {
        let Some(row) = row else { continue };
        match lines
            .iter_mut()
            .find(|(_, other)| std::ptr::eq(*other, row))
        {
            Some((reasons, _)) => {
                reasons.push_str("; ");
                reasons.push_str(why);
            }
            None => lines.push((why.into(), row)),
        }
    }
    lines
}

fn line(text: &mut String, why: &str, row: &Row) {
    let count = |n: Option<f64>, digits| n.map_or("-".into(), |n| format!("{n:.digits$}"));
    let _ = writeln!(
        text,
        "| {} | {why} | {} | {} | {:.1e} | {:.1e} | {} | {} |",
        row.engine,
        row.rate,
        row.setting,
        row.median,
        row.max,
        count(row.instructions, 0),
        count(row.cost().map(|n| n / 1000.0), 1)
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::tests::row;

    #[test]
    fn a_row_with_two_reasons_stands_once() {
        let rows = [row(60, 2.0, Some(10.0)), row(120, 1.0, Some(10.0))];
        let text = report(&rows);
        assert!(
            text.contains("| e | default; best at its cost | 60 | s | 2.0e0 | 2.0e0 | 10 | 0.6 |")
        );
        assert!(text.contains("| e | best | 120 | s | 1.0e0 | 1.0e0 | 10 | 1.2 |"));
        assert_eq!(text.matches("| e |").count(), 2);
    }

    #[test]
    fn what_was_not_counted_is_a_dash() {
        let text = report(&[row(60, f64::NAN, None)]);
        assert!(
            text.contains("| e | default; best | 60 | s | NaN | NaN | - | - |"),
            "{text}"
        );
    }
}
