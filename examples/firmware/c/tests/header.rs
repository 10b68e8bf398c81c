//! The committed header is the one that the sources make. `UPDATE=1 cargo test --test header` writes it.

use std::{env, fs, path::Path};

#[test]
fn the_header_is_that_of_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut made = Vec::new();
    cbindgen::generate(root).unwrap().write(&mut made);
    let made = String::from_utf8(made).unwrap();
    let committed = root.join("include/fixstep.h");
    if env::var_os("UPDATE").is_some() {
        fs::write(&committed, &made).unwrap();
    }
    assert!(
        fs::read_to_string(committed).unwrap() == made,
        "include/fixstep.h is stale: UPDATE=1 cargo test --test header"
    );
}
