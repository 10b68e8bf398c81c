//! Sources point down the ladder only, and keep the promises that a compiler does not check.

#[path = "layers/doubles.rs"]
mod doubles;

use std::fs;
use std::path::{Path, PathBuf};

/// From bottom to top; files of one rung do not import each other, but for the first.
const RUNGS: [&[&str]; 20] = [
    &[
        "error",
        "ratio",
        "decimal",
        "fnv",
        "oscillation",
        "fraction",
    ],
    &["scalar"],
    &["vec2", "spin"],
    &["id", "step"],
    &["time", "accumulator", "between"],
    &["body"],
    &["point"],
    &["mass", "propagator", "carried"],
    &["shape"],
    &["force"],
    &["integrate"],
    &["world"],
    &["measure"],
    &["snapshot"],
    &["watched"],
    &["rewind"],
    &["rigid"],
    &["torque"],
    &["defmt", "mint", "serde"],
    &["guide"],
];

struct Source {
    /// Path below `src/`, such as `force/gravity.rs`.
    name: String,
    /// Its code without comments and without what stands behind `#[cfg(test)]`.
    code: String,
    text: String,
}

impl Source {
    fn read(root: &Path, path: &Path) -> Source {
        let text = fs::read_to_string(path).unwrap();
        let tested = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
        let code = tested
            .lines()
            .map(|line| line.split("//").next().unwrap_or_default());
        let code = code.collect::<Vec<_>>().join("\n");
        let name = path
            .strip_prefix(root)
            .unwrap()
            .to_str()
            .unwrap()
            .replace('\\', "/");
        Source { name, code, text }
    }

    /// The module directly below the crate: `force` for `force/gravity.rs`.
    fn module(&self) -> &str {
        self.name.split('/').next().unwrap().trim_end_matches(".rs")
    }

    /// Every name that stands behind `prefix`; each of `{a, b::c}`.
    fn behind(&self, prefix: &str) -> Vec<&str> {
        let code = &self.code;
        let hits = code
            .match_indices(prefix)
            .filter(|&(at, _)| !names(&code[..at]));
        hits.flat_map(|(at, _)| firsts(&code[at + prefix.len()..]))
            .collect()
    }
}

/// Whether `text` ends within a name, or with the `$` of a macro.
fn names(text: &str) -> bool {
    text.ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$')
}

fn word(text: &str) -> &str {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
        .next()
        .unwrap_or_default()
}

fn firsts(text: &str) -> Vec<&str> {
    match text.strip_prefix('{') {
        Some(list) => list
            .split('}')
            .next()
            .unwrap()
            .split(',')
            .map(|s| word(s.trim()))
            .collect(),
        None => vec![word(text)],
    }
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    entries
        .flat_map(|path| {
            if path.is_dir() {
                files(&path)
            } else {
                vec![path]
            }
        })
        .collect()
}

fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut paths = files(&root);
    paths.sort();
    let sources: Vec<_> = paths.iter().map(|path| Source::read(&root, path)).collect();
    assert!(sources.len() > 20);
    sources
}

fn rung(module: &str) -> usize {
    let found = RUNGS.iter().position(|rung| rung.contains(&module));
    found.unwrap_or_else(|| panic!("give `{module}` a place on the ladder"))
}

#[test]
fn paths_point_down_the_ladder() {
    let mut edges = 0;
    for source in sources().iter().filter(|source| source.name != "lib.rs") {
        let from = source.module();
        for to in source.behind("crate::") {
            let down = rung(to) < rung(from);
            let allowed = down || to == from || rung(from) == 0 && rung(to) == 0;
            assert!(allowed, "src/{} uses crate::{to}", source.name);
            edges += 1;
        }
    }
    assert!(edges > 50, "the search found only {edges} paths");
}

// `super` in a file of a folder is that folder's mod.rs.
#[test]
fn files_of_one_folder_do_not_import_each_other() {
    for folder in ["force", "integrate", "shape"] {
        let sources = sources();
        let inside: Vec<_> = sources
            .iter()
            .filter(|source| source.module() == folder)
            .collect();
        let modules: Vec<_> = inside
            .iter()
            .map(|s| s.name.rsplit('/').next().unwrap())
            .collect();
        assert!(inside.len() > 3);
        for source in inside
            .iter()
            .filter(|source| !source.name.ends_with("mod.rs"))
        {
            let within = format!("crate::{folder}::");
            let imports = [source.behind("super::"), source.behind(&within)].concat();
            for import in imports {
                let sibling = modules.contains(&format!("{import}.rs").as_str());
                assert!(!sibling, "src/{} imports its sibling {import}", source.name);
            }
        }
    }
}

#[test]
fn only_scalar_talks_to_libm_and_fixed() {
    for source in sources() {
        let (libm, fixed) = (source.behind("libm::"), source.behind("fixed::"));
        let inside = source.module() == "scalar";
        assert!(
            inside || libm.is_empty() || source.name == "ratio.rs",
            "src/{}",
            source.name
        );
        assert!(inside || fixed.is_empty(), "src/{}", source.name);
    }
}

// In constants alone, which the compiler makes: of `dec!`, and of a dyadic step.
#[test]
fn nothing_panics_by_hand() {
    for source in sources() {
        for call in [
            ".unwrap()",
            ".expect(",
            "panic!",
            "todo!",
            "unimplemented!",
            "unreachable!",
        ] {
            let constant = [("decimal.rs", "panic!"), ("step.rs", "unreachable!")];
            let allowed = usize::from(constant.contains(&(source.name.as_str(), call)));
            assert_eq!(
                source.code.matches(call).count(),
                allowed,
                "{call} in src/{}",
                source.name
            );
        }
    }
}

#[test]
fn the_crate_keeps_its_promises() {
    let sources = sources();
    let lib = sources
        .iter()
        .find(|source| source.name == "lib.rs")
        .unwrap();
    for line in [
        "#![no_std]",
        "#![forbid(unsafe_code)]",
        "#![deny(missing_docs)]",
    ] {
        assert!(lib.text.lines().any(|l| l == line), "{line}");
    }
    for source in &sources {
        assert!(
            source.text.starts_with("//! "),
            "src/{} has no header",
            source.name
        );
        assert!(
            source.text.lines().count() <= 300,
            "src/{} is long",
            source.name
        );
    }
}
