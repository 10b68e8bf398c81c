//! The rows as a file, and a comparison with the file that is checked in.

use crate::sweep::Row;

const HEAD: &str =
    "problem,engine,rate_hz,setting,default,median_m,max_m,instructions_per_body_step";

/// As CSV; a comma in a setting becomes a plus, so that nothing has to be quoted.
pub fn write(rows: &[Row]) -> String {
    let lines = rows.iter().map(|row| {
        let count = row.instructions.map_or("-".into(), |n| format!("{n:.1}"));
        format!(
            "{},{},{},{},{},{:.4e},{:.4e},{count}\n",
            row.problem,
            row.engine,
            row.rate,
            row.setting.replace(", ", " + "),
            row.default,
            row.median,
            row.max
        )
    });
    format!("{HEAD}\n{}", lines.collect::<String>())
}

/// Where a fresh run differs from the file, each in words.
///
/// * Errors may differ by 1 %, those of floats by 1e-5 m more: a compiler may order their operations
///   otherwise, and `10^4` steps add as many roundings of `1e-7` of a metre, or their root if by chance.
/// * Counts may differ by 5 %, if both sides have them.
pub fn differences(rows: &[Row], file: &str) -> Vec<String> {
    let fresh = write(rows);
    if fresh.lines().count() != file.lines().count() {
        return vec!["another number of rows".into()];
    }
    fresh
        .lines()
        .zip(file.lines())
        .filter(|(new, old)| !agree(new, old))
        .map(|(new, old)| format!("was {old}\nnow {new}"))
        .collect()
}

fn agree(new: &str, old: &str) -> bool {
    let [new, old] = [new, old].map(|line| line.split(',').collect::<Vec<_>>());
    if new.len() != 8 || old.len() != 8 || new[..5] != old[..5] {
        return false;
    }
    let floats = !(new[1].contains("I16F16") || new[1].contains("I8F24"));
    let slack = if floats { 1e-5 } else { 0.0 };
    close(new[5], old[5], 0.01, slack)
        && close(new[6], old[6], 0.01, slack)
        && (new[7] == "-" || old[7] == "-" || close(new[7], old[7], 0.05, 0.0))
}

/// The same text, or two numbers of which neither is NaN.
fn close(new: &str, old: &str, part: f64, slack: f64) -> bool {
    match (new.parse::<f64>(), old.parse::<f64>()) {
        _ if new == old => true,
        (Ok(new), Ok(old)) => (new - old).abs() <= part * old.abs() + slack,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::tests::row;

    /// Whether a row of `engine` with another error and count passes for 1 m and 100.
    fn passes(engine: &str, median: f64, instructions: Option<f64>) -> bool {
        let named = |median, instructions| {
            let engine = engine.into();
            vec![Row {
                engine,
                ..row(60, median, instructions)
            }]
        };
        let file = write(&named(1.0, Some(100.0)));
        differences(&named(median, instructions), &file).is_empty()
    }

    #[test]
    fn a_run_agrees_with_its_own_file() {
        assert!(passes("fixstep I8F24", 1.0, Some(100.0)));
        assert!(passes("rapier2d", 1.009, Some(104.0)));
        assert!(passes("rapier2d", 1.0, None));
    }

    #[test]
    fn what_has_moved_is_told() {
        assert!(!passes("rapier2d", 1.02, Some(100.0)));
        assert!(!passes("rapier2d", f64::NAN, Some(100.0)));
        assert!(!passes("rapier2d", 1.0, Some(106.0)));
        assert!(!passes("rapier2d", 1.0, Some(94.0)));
    }

    #[test]
    fn floats_have_slack_and_fixed_point_has_none() {
        for (engine, slack) in [("rapier2d", true), ("fixstep I8F24", false)] {
            let named = |median| {
                vec![Row {
                    engine: engine.into(),
                    ..row(60, median, None)
                }]
            };
            let moved = differences(&named(3e-6), &write(&named(1e-6)));
            assert_eq!(moved.is_empty(), slack, "{engine}");
        }
    }

    /// A comma in a name would move every column behind it.
    #[test]
    fn names_fit_their_columns() {
        let engines = crate::engine::all();
        let names = engines.iter().map(|engine| engine.name());
        for name in names.chain(crate::problem::ALL.map(|kind| kind.name())) {
            assert!(!name.contains(','), "{name}");
        }
    }

    #[test]
    fn another_setting_or_number_of_rows_is_told() {
        let rows = [row(60, 1.0, None), row(120, 1.0, None)];
        assert!(!differences(&rows[..1], &write(&rows)).is_empty());
        assert!(!differences(&rows[..1], &write(&rows[1..])).is_empty());
    }
}
