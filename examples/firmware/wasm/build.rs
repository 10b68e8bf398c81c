//! Has the linker export what the host calls: an image is a module without a start function.

fn main() {
    for argument in ["--no-entry", "--export=run"] {
        println!("cargo:rustc-link-arg-bins={argument}");
    }
}
