//! Whether what the guide recommends is worth its price: the front of a scene at 60 Hz, and what stands
//! before a recommended line that is not on it.

use crate::cost::Core;
use crate::figures::Row;
use crate::pareto::{beats, front};
use crate::starts::Plan;
use crate::table::Table;

/// Steps a second.
const RATE: u32 = 60;

/// What the guide recommends for a scene on a core: method, forces, body. Drag and springs that hold one
/// body are solved exactly; an exact spring goes with any method, and is measured with the simplest.
pub fn recommended(scene: &str, core: Core) -> [&'static str; 3] {
    let [method, forces] = match scene {
        "spring" => ["SemiImplicitEuler", "ExactSpring"],
        "projectile" => ["Verlet", "ExactDrag"],
        "quadratic" => ["Verlet", "ExactQuadraticDrag"],
        "pair" => ["Verlet", "Spring"],
        _ => ["Verlet", "Pull"],
    };
    // All scenes fit a table-top.
    match core {
        Core::M0Plus => [method, forces, "I8F24"],
        Core::M4F => [method, forces, "f32"],
    }
}

/// Lines on the front at 60 Hz, from cheap to dear; and lines that are as cheap as the recommended one and as
/// good.
pub fn at_60_hz<'a>(core: Core, scene: &str, size: f64, rows: &'a [Row]) -> [Vec<[&'a str; 3]>; 2] {
    let mut rows: Vec<&Row> = rows.iter().filter(|row| row.rate == RATE).collect();
    rows.sort_by(|a, b| a.work(core).total_cmp(&b.work(core)));
    let points: Vec<_> = rows.iter().map(|row| row.point(core, size)).collect();
    let on = front(&points);
    let is = |row: &&Row| row.line() == recommended(scene, core);
    let ours = rows.iter().position(is).map(|i| points[i]);
    let names = |keep: &dyn Fn(usize) -> bool| {
        let kept = (0..rows.len()).filter(|&i| keep(i));
        kept.map(|i| rows[i].line()).collect()
    };
    [
        names(&|i| on[i]),
        names(&|i| ours.is_some_and(|ours| beats(&points[i], &ours))),
    ]
}

/// Of a table of work and precision, on all cores.
pub fn all(table: &Table) -> Result<String, String> {
    let (rows, plan) = (
        Row::all(table)?,
        Plan::of(table.name.trim_start_matches("work-")),
    );
    Ok(Core::ALL
        .map(|core| text(core, plan.scene, plan.size, &rows))
        .concat())
}

/// Two lines for a scene and a core.
fn text(core: Core, scene: &str, size: f64, rows: &[Row]) -> String {
    let [front, before] = at_60_hz(core, scene, size, rows);
    let joined = |names: &[[&str; 3]]| {
        names
            .iter()
            .map(|name| name.join(" "))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let stands = match before.is_empty() {
        true => "on it".to_string(),
        false => format!("behind {}", joined(&before)),
    };
    let (core_name, ours) = (core.name(), recommended(scene, core).join(" "));
    format!(
        "{scene}, {core_name}, front at 60 Hz: {}\n  recommended {ours}: {stands}\n",
        joined(&front)
    )
}
