//! The table of the README: errors after a minute, from the rows of `minute.csv`.

/// Method, drag, spring, body: what is on the way from the article's method to the recommended ones.
pub const COMBINATIONS: [[&str; 4]; 14] = [
    ["Euler", "LinearDrag", "Anchor", "f32"],
    ["SemiImplicitEuler", "LinearDrag", "Anchor", "f32"],
    ["SemiImplicitEuler", "LinearDrag", "Anchor", "I16F16"],
    ["Verlet", "LinearDrag", "Anchor", "I16F16"],
    ["Verlet", "ExactDrag", "Anchor", "f32"],
    ["Verlet", "ExactDrag", "Anchor", "I16F16"],
    ["Verlet", "ExactDrag", "Anchor", "I8F24 carried"],
    ["SemiImplicitEuler", "Ballistic", "ExactSpring", "f32"],
    ["SemiImplicitEuler", "Ballistic", "ExactSpring", "I16F16"],
    ["SemiImplicitEuler", "Ballistic", "ExactSpring", "I8F24"],
    ["Rk4", "LinearDrag", "Anchor", "f32"],
    ["Rk4", "LinearDrag", "Anchor", "I16F16"],
    ["Pefrl", "LinearDrag", "Anchor", "f32"],
    ["Pefrl", "LinearDrag", "Anchor", "I8F24 carried"],
];

pub const HEADER: [&str; 9] = [
    "method",
    "drag",
    "spring",
    "body",
    "m0_instructions_per_step",
    "m4f_instructions_per_step",
    "fall_m",
    "spring_m",
    "orbit_m",
];
/// Columns that name a row.
pub const KEYS: usize = 4;

pub const HEAD: &str = "\
| method | drag, spring | body | bytes | M0+ | M4F | fall | spring | orbit | spring: `h ω <` | worst known failure |
|---|---|---|---|---|---|---|---|---|---|---|
";

/// A line of the table for each row.
pub fn lines(rows: &[Vec<String>]) -> Vec<String> {
    rows.iter().map(|row| line(row)).collect()
}

fn line(row: &[String]) -> String {
    let cell = |i: usize| row.get(i).map_or("", String::as_str);
    let [method, drag, spring, body] = [0, 1, 2, 3].map(cell);
    let [fall, swing, orbit] = [6, 7, 8].map(|i| error(cell(i)));
    let (bytes, limit, failure) = (
        bytes(method, body),
        limit(method, spring),
        failure(method, drag),
    );
    let (small, large) = (cell(4), cell(5));
    format!(
        "| `{method}` | `{drag}`, `{spring}` | {body} | {bytes} | {small} | {large} | {fall} | {swing} | {orbit} | \
         {limit} | {failure} |"
    )
}

/// Two digits, in the exponent too; what left its range says so.
fn error(cell: &str) -> String {
    let Ok(figure) = cell.parse::<f64>() else {
        return cell.into();
    };
    if figure.is_infinite() {
        return "range".into();
    }
    let text = format!("{figure:.1e}");
    match text.split_once("e-") {
        Some((digits, exponent)) => format!("{digits}e-{exponent:0>2}"),
        None => text,
    }
}

/// Of the body and of what its method keeps beside it.
fn bytes(method: &str, body: &str) -> usize {
    let point = if body.ends_with("carried") { 32 } else { 20 };
    match method {
        "Euler" | "ConstantAcceleration" => 2 * point,
        "Rk4" => point + 48,
        _ => point,
    }
}

fn limit(method: &str, spring: &str) -> &'static str {
    match (method, spring) {
        (_, "ExactSpring") => "none",
        ("Euler", _) => "0",
        ("Rk4", _) => "2.828",
        ("Pefrl", _) => "2.989",
        _ => "2",
    }
}

fn failure(method: &str, drag: &str) -> &'static str {
    match (method, drag) {
        (_, "Ballistic") => "not with a second spring on the body",
        ("Verlet", "ExactDrag") => "a spring runs ahead by `(h ω)²/24` of its phase",
        ("Verlet", _) => "order 1 with explicit drag",
        ("Euler", _) => "a spring grows by `(h ω)²/2` a step",
        ("Rk4", _) => "a spring loses `(h ω)^6/144` a step",
        ("Pefrl", _) => "order 1 with explicit drag",
        _ => "a fall is `g T h / 2` long",
    }
}
