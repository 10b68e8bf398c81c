//! `f64` is for reports: no step of another scalar makes one, holds one or reads one.
//!
//! An `f64` comes into code by its name, by a literal with a point, or from a function that returns
//! one. All three may stand inside the read-outs only, and a read-out is called by read-outs only.
//! The images of `examples/firmware` are searched for the same by `run`.

use super::{Source, names, sources, word};

/// What returns or takes an `f64`: read-outs, and `from_f64`, which makes constants on the host.
const READ_OUTS: [&str; 12] = [
    "to_f64",
    "from_f64",
    "momentum",
    "kinetic_energy",
    "potential_energy",
    "potential",
    "kept_to_f64",
    "spin_to_f64",
    "spin_energy",
    "spin_momentum",
    "angular_momentum",
    "potential_along",
];

/// Where `f64` is the scalar itself.
const INSTANCES: [(&str, &str); 9] = [
    ("scalar/angular/float.rs", "count!(count_f64, f64, "),
    ("scalar/angular/float.rs", "count!(count_fine_f64, f64, "),
    ("scalar/angular/float.rs", "float_angular!(f64, "),
    ("scalar/angular/float.rs", "float_carry_angular!(f64, "),
    ("scalar/carry/float.rs", "float_carry!(f64, "),
    ("scalar/decay.rs", "float_decay!(f64, "),
    ("scalar/float.rs", "float_scalar!(f64, "),
    ("scalar/rational.rs", "float_rational!(f64, "),
    ("scalar/stored.rs", "float!(f64, "),
];

/// Places of an `f64`: its name, a read-out, a literal. Literals in the files of
/// floats have the type that their macros are for.
fn mentions(source: &Source) -> Vec<usize> {
    let code = &source.code;
    let named = READ_OUTS.iter().chain(&["f64"]).flat_map(|name| {
        let hits = code.match_indices(name).map(|(at, _)| at);
        hits.filter(move |&at| !names(&code[..at]) && word(&code[at..]) == *name)
    });
    let points = code.match_indices('.').map(|(at, _)| at);
    let literals = points.filter(|&at| {
        let before = code[..at].trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
        let whole = before.len() < at && !before.ends_with('.') && !names(before);
        whole && code[at + 1..].starts_with(|c: char| c.is_ascii_digit())
    });
    match source.name.as_str() {
        "scalar/angular/float.rs"
        | "scalar/carry/float.rs"
        | "scalar/decay.rs"
        | "scalar/float.rs" => named.collect(),
        _ => named.chain(literals).collect(),
    }
}

/// Whether the function at the start of `code` ends in it, with its body or, without one, at `;`.
fn ends(code: &str) -> bool {
    let mut depth = 0;
    code.chars().any(|c| {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        depth <= 0 && matches!(c, '}' | ';')
    })
}

/// The functions around a place, the innermost first.
fn functions_around(code: &str, at: usize) -> impl Iterator<Item = &str> {
    let starts = code[..at].rmatch_indices("fn ").map(|(start, _)| start);
    let around = starts.filter(move |&start| !names(&code[..start]) && !ends(&code[start..at]));
    around.map(|start| word(&code[start + 3..]))
}

#[test]
fn no_step_knows_f64() {
    let mut used = Vec::new();
    for source in sources() {
        for at in mentions(&source) {
            let line = code_line(&source.code, at);
            let instance = INSTANCES
                .iter()
                .any(|&(file, start)| source.name == file && line.1.starts_with(start));
            let inside = functions_around(&source.code, at).find(|name| READ_OUTS.contains(name));
            used.extend(inside.map(str::to_owned));
            assert!(
                instance || inside.is_some(),
                "src/{}:{}: {}",
                source.name,
                line.0,
                line.1
            );
        }
    }
    for name in READ_OUTS {
        assert!(used.iter().any(|n| n == name), "no `{name}` needs an f64");
    }
}

/// Number and text of the line of a place.
fn code_line(code: &str, at: usize) -> (usize, &str) {
    let number = code[..at].matches('\n').count();
    (number + 1, code.lines().nth(number).unwrap())
}
