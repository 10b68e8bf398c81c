//! Sources point down the ladder only, and keep the promises that a compiler does not check.

#[path = "layers/doubles.rs"]
mod doubles;

use std::fs;
use std::path::{Path, PathBuf};

/// The ladder, from bottom to top: what a scene adds, and the folders that it adds with it. A folder
/// may import those before it, on its rung or below, and no other. Some are not built yet.
const LADDER: [(&str, &[&str]); 6] = [
    ("numbers", &["ratio", "error", "scalar", "vec2"]),
    (
        "1: points, forces, a method",
        &["time", "body", "mass", "force", "integrate", "world"],
    ),
    ("2: rotation", &["rigid"]),
    ("3: touch", &["shape", "collide", "contact"]),
    ("4: joints", &["joint"]),
    ("the way in", &["interop", "guide", "prelude"]),
];

/// Folders whose files are alike, one force or one shape each, and do not import each other; behind
/// it the files that the others stand on.
const ALIKE: [(&str, &[&str]); 5] = [
    ("force", &["frame", "memo", "per_step"]),
    ("force/exact", &["oscillation", "propagator"]),
    ("integrate", &["rewinds", "seen"]),
    ("mass", &["centre", "outline", "properties"]),
    ("rigid/torque", &[]),
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

/// How far up a folder stands.
fn height(module: &str) -> usize {
    let mut all = LADDER.iter().flat_map(|(_, folders)| *folders);
    let found = all.position(|&folder| folder == module);
    found.unwrap_or_else(|| panic!("give `{module}` a rung of the ladder"))
}

#[test]
fn paths_point_down_the_ladder() {
    let mut edges = 0;
    for source in sources().iter().filter(|source| source.name != "lib.rs") {
        let from = source.module();
        for to in source
            .behind("crate::")
            .into_iter()
            .filter(|&to| to != from)
        {
            let macros = ["dec", "vec2"].contains(&to) && from == "prelude";
            assert!(
                macros || height(to) < height(from),
                "src/{} uses crate::{to}",
                source.name
            );
            edges += 1;
        }
    }
    assert!(edges > 200, "the search found only {edges} paths");
}

/// Files and folders beside a file that it imports: by `super` or by the path of their folder.
fn siblings<'a>(source: &'a Source, beside: &[String]) -> Vec<&'a str> {
    let (folder, file) = source.name.rsplit_once('/').unwrap_or(("", &source.name));
    let within = format!("crate::{}::", folder.replace('/', "::"));
    let imports = [source.behind("super::"), source.behind(&within)].concat();
    let own = file.trim_end_matches(".rs");
    let named = |import: &&str| *import != own && beside.iter().any(|name| name == import);
    imports.into_iter().filter(named).collect()
}

/// The names of the modules in a folder, `mod.rs` left out: it brings all of them together.
fn modules(sources: &[Source], folder: &str) -> Vec<String> {
    let inside = |source: &Source| {
        let below = source.name.strip_prefix(folder)?.strip_prefix('/')?;
        let name = below.split('/').next()?.trim_end_matches(".rs");
        (name != "mod").then(|| name.to_owned())
    };
    let mut names: Vec<_> = sources.iter().filter_map(inside).collect();
    names.dedup();
    names
}

#[test]
fn files_that_are_alike_do_not_import_each_other() {
    let sources = sources();
    for (folder, foundations) in ALIKE {
        let beside = modules(&sources, folder);
        assert!(beside.len() > 3, "{folder} has {beside:?}");
        for name in foundations {
            assert!(beside.iter().any(|file| file == name), "no {folder}/{name}");
        }
        for source in sources.iter().filter(|source| {
            source
                .name
                .rsplit_once('/')
                .is_some_and(|(of, file)| of == folder && file != "mod.rs")
        }) {
            for import in siblings(source, &beside) {
                let allowed = foundations.contains(&import);
                assert!(allowed, "src/{} imports its sibling {import}", source.name);
            }
        }
    }
}

/// In every folder there is an order in which its files can be read: none needs, by way of others,
/// one that needs it.
#[test]
fn no_folder_has_a_circle() {
    let sources = sources();
    let folder = |source: &Source| Some(source.name.rsplit_once('/')?.0.to_owned());
    let mut folders: Vec<_> = sources.iter().filter_map(folder).collect();
    folders.sort();
    folders.dedup();
    assert!(folders.len() > 12, "{folders:?}");
    for folder in folders {
        let beside = modules(&sources, &folder);
        let inside = |name: &str| {
            let prefix = format!("{folder}/{name}");
            let files = sources.iter().filter(move |source| {
                source.name == format!("{prefix}.rs") || source.name == format!("{prefix}/mod.rs")
            });
            files
                .flat_map(|source| siblings(source, &beside))
                .collect::<Vec<_>>()
        };
        let mut left: Vec<_> = beside.iter().map(|name| (name, inside(name))).collect();
        while !left.is_empty() {
            let names: Vec<_> = left.iter().map(|(name, _)| name.as_str()).collect();
            let free = left
                .iter()
                .position(|(_, needs)| !needs.iter().any(|need| names.contains(need)));
            let free = free.unwrap_or_else(|| panic!("src/{folder}: a circle in {left:?}"));
            left.remove(free);
        }
    }
}

#[test]
fn only_scalar_talks_to_libm_and_fixed() {
    for source in sources() {
        let (libm, fixed) = (source.behind("libm::"), source.behind("fixed::"));
        let inside = source.module() == "scalar";
        assert!(
            inside || libm.is_empty() || source.name == "ratio/mod.rs",
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
            let constant = [
                ("ratio/decimal.rs", "panic!"),
                ("time/dyadic.rs", "unreachable!"),
            ];
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
            source.text.lines().count() <= 250,
            "src/{} is long",
            source.name
        );
    }
}
