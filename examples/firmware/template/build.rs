//! Lets the linker find `memory.x` and tells it to lay the image out as `cortex-m-rt` says. In a build
//! script and not in `.cargo/config.toml`: flags there would be lost where `RUSTFLAGS` is set.

fn main() {
    println!("cargo:rustc-link-search={}", env!("CARGO_MANIFEST_DIR"));
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rustc-link-arg-bins=--nmagic");
    println!("cargo:rerun-if-changed=memory.x");
}
