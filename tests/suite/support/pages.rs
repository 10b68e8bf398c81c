//! The pages that show figures: README, ARCHITECTURE and docs, as they stand.

use std::fs;
use std::path::Path;
use std::sync::OnceLock;

/// The root of the crate, from the package of the quick suite and from the lab.
pub fn root() -> &'static Path {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    match super::LAB {
        true => package.parent().unwrap(),
        false => package,
    }
}

/// README, then the pages of `docs/` by name. A figure may stand on any of them.
pub fn pages() -> &'static str {
    static PAGES: OnceLock<String> = OnceLock::new();
    PAGES.get_or_init(|| {
        let folder = fs::read_dir(root().join("docs")).unwrap();
        let mut paths: Vec<_> = folder.map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        assert!(paths.len() > 8, "{paths:?}");
        paths.insert(0, root().join("README.md"));
        let texts = paths.iter().map(|path| fs::read_to_string(path).unwrap());
        texts.collect::<Vec<_>>().join("\n")
    })
}

/// Cells of the rows of the table that begins with `header`, wherever it stands.
pub fn table(text: &'static str, header: &str) -> Vec<Vec<&'static str>> {
    let mut lines = text.lines().skip_while(|line| !line.starts_with(header));
    assert!(lines.next().is_some(), "no table {header}");
    let rows = lines.skip(1).take_while(|line| line.starts_with('|'));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect()
}
