//! Whether what the guide recommends is worth its price: the front of a scene at 60 Hz, and what stands
//! before a recommended line that is not on it.

use crate::cost::Core;
use crate::figures::Row;
use crate::minute_table;
use crate::pareto::{beats, front};
use crate::starts::Plan;
use crate::table::Table;

/// Steps a second.
const RATE: u32 = 60;

/// What the guide recommends for a scene: the default method, and what it names for just this scene.
pub fn recommended(scene: &str, core: Core) -> Vec<[&'static str; 3]> {
    let lines = match scene {
        "spring" => vec![["Verlet", "Anchor"], ["SemiImplicitEuler", "ExactSpring"]],
        "projectile" => vec![["Verlet", "ExactDrag"], ["SemiImplicitEuler", "Ballistic"]],
        "quadratic" => vec![["Verlet", "ExactQuadraticDrag"]],
        "rotor" => vec![["Verlet", "SpinDrag"]],
        "pair" => vec![["Verlet", "Spring"], ["SemiImplicitEuler", "ExactPair"]],
        _ => vec![["Verlet", "Pull"], ["Pefrl", "Pull"]],
    };
    // All scenes fit a table-top.
    let body = match core {
        Core::M0Plus => "I8F24",
        Core::M4F => "f32",
    };
    let with_body = |[method, forces]: [&'static str; 2]| [method, forces, body];
    lines.into_iter().map(with_body).collect()
}

/// The lines of a chart at 60 Hz.
pub struct At60<'a> {
    /// On the front, from cheap to dear.
    pub front: Vec<[&'a str; 3]>,
    /// Of each recommended line, what is as cheap and as good; nothing where it is on the front.
    pub before: Vec<Vec<[&'a str; 3]>>,
}

/// What is on the front, and what stands before the recommended lines.
pub fn at_60_hz<'a>(core: Core, scene: &str, size: f64, rows: &'a [Row]) -> At60<'a> {
    let mut rows: Vec<&Row> = rows.iter().filter(|row| row.rate == RATE).collect();
    rows.sort_by(|a, b| a.work(core).total_cmp(&b.work(core)));
    let points: Vec<_> = rows.iter().map(|row| row.point(core, size)).collect();
    let on = front(&points);
    let names = |keep: &dyn Fn(usize) -> bool| {
        let kept = (0..rows.len()).filter(|&i| keep(i));
        kept.map(|i| rows[i].line()).collect()
    };
    let before = recommended(scene, core).into_iter().map(|name| {
        let ours = rows.iter().position(|row| row.line() == name);
        names(&|i| ours.is_some_and(|ours| beats(&points[i], &points[ours])))
    });
    let before = before.collect();
    At60 {
        front: names(&|i| on[i]),
        before,
    }
}

/// What the charts say of the guide: a line for each scene and a conclusion, or with `full` the whole fronts and
/// the table of a minute.
pub fn report(tables: &[Table], full: bool) -> Result<String, String> {
    let mut text = format!(
        "On the Pareto front at {RATE} Hz (least error for its cost) of what the guide recommends:\n\n{:<12}{:>12}{:>12}\n",
        "scene",
        Core::M0Plus.name(),
        Core::M4F.name()
    );
    let (mut fronts, mut behind, mut counts) = (String::new(), Vec::new(), [0, 0]);
    for table in tables
        .iter()
        .filter(|table| table.name.starts_with("work-"))
    {
        let (rows, plan) = (
            Row::all(table)?,
            Plan::of(table.name.trim_start_matches("work-")),
        );
        text += &format!("{:<12}", plan.scene);
        for core in Core::ALL {
            let At60 { before, .. } = at_60_hz(core, plan.scene, plan.size, &rows);
            let on = before.iter().filter(|before| before.is_empty()).count();
            counts = [counts[0] + on, counts[1] + before.len()];
            text += &format!("{:>12}", format!("{on} of {}", before.len()));
            for (name, before) in recommended(plan.scene, core).iter().zip(&before) {
                if let Some(better) = before.first() {
                    behind.push(format!(
                        "  {}, {}: {} is behind {}",
                        plan.scene,
                        core.name(),
                        name.join(" "),
                        better.join(" ")
                    ));
                }
            }
            fronts += &self::text(core, plan.scene, plan.size, &rows);
        }
        text += "\n";
    }
    text += &format!(
        "\n{} of {} recommended lines are on the front.\n",
        counts[0], counts[1]
    );
    text += &behind
        .iter()
        .map(|line| format!("{line}\n"))
        .collect::<String>();
    if full {
        let minute = tables.iter().find(|table| table.name == "minute");
        let lines = minute.map(|table| minute_table::lines(&table.rows).join("\n"));
        text += &format!(
            "\n{fronts}\n{}{}\n",
            minute_table::HEAD,
            lines.unwrap_or_default()
        );
    }
    Ok(text)
}

/// A few lines for a scene and a core.
fn text(core: Core, scene: &str, size: f64, rows: &[Row]) -> String {
    let At60 { front, before } = at_60_hz(core, scene, size, rows);
    let joined = |names: &[[&str; 3]]| {
        let names = names.iter().map(|name| name.join(" "));
        names.collect::<Vec<_>>().join(", ")
    };
    let mut text = format!(
        "{scene}, {}, front at 60 Hz: {}\n",
        core.name(),
        joined(&front)
    );
    for (name, before) in recommended(scene, core).iter().zip(&before) {
        let stands = match before.is_empty() {
            true => "on it".to_string(),
            false => format!("behind {}", joined(before)),
        };
        text += &format!("  recommended {}: {stands}\n", name.join(" "));
    }
    text
}
