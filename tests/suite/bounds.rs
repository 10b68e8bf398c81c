//! `bounds.md` is the index of what tests allow: each test that it names exists, and each target that
//! holds a bound is named.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use crate::support::pages::root;

const TABLE: &str = include_str!("bounds.md");

/// Target and test of each row.
fn rows() -> Vec<[&'static str; 2]> {
    let lines = TABLE.lines().filter(|line| line.starts_with("| `"));
    let cell = |line: &'static str, i| line.split('|').nth(i).unwrap().trim().trim_matches('`');
    lines.map(|line| [cell(line, 1), cell(line, 2)]).collect()
}

/// Where tests stand: the quick suite, the lab's sweeps and the lab's other targets.
fn folders() -> [PathBuf; 3] {
    ["tests/suite", "lab/tests/sweeps", "lab/tests"].map(|folder| root().join(folder))
}

/// The sources of a target: its file and those in its folder.
fn sources(target: &str) -> String {
    let mut text = String::new();
    for folder in folders() {
        text += &fs::read_to_string(folder.join(format!("{target}.rs"))).unwrap_or_default();
        let Ok(parts) = fs::read_dir(folder.join(target)) else {
            continue;
        };
        let paths = parts.map(|part| part.unwrap().path());
        for path in paths.filter(|path| path.extension().is_some_and(|end| end == "rs")) {
            text += &fs::read_to_string(path).unwrap();
        }
    }
    text
}

#[test]
fn every_test_of_the_table_exists() {
    let rows = rows();
    assert!(rows.len() > 40, "only {} rows", rows.len());
    for [target, test] in rows {
        let written = sources(target).contains(&format!("fn {test}("));
        let made = sources(target).contains(&format!(" {test},")); // by a macro
        assert!(written || made, "no test {test} in {target}");
    }
}

/// Those that print bounds through `within` are all in the table.
#[test]
fn every_target_with_bounds_is_in_the_table() {
    let named: BTreeSet<_> = rows().into_iter().map(|[target, _]| target).collect();
    let all = folders().map(|folder| fs::read_dir(folder).unwrap());
    let entries = all.into_iter().flatten().map(|entry| entry.unwrap().path());
    let targets = entries.filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let mut seen = 0;
    for target in targets {
        let name = target.file_stem().unwrap().to_str().unwrap().to_owned();
        let bounded = |line: &str| line.trim_start().starts_with("within(");
        if sources(&name).lines().any(bounded) {
            assert!(named.contains(name.as_str()), "{name}.rs has no row");
            seen += 1;
        }
    }
    assert!(seen > 10, "only {seen} targets hold bounds");
}
