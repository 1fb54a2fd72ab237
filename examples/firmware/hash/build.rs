//! The number type comes from `COSLOBE_TYPE`: an image of all types would not fit the smallest
//! board.

use std::{env, fs, path::Path};

fn main() {
    println!("cargo::rerun-if-env-changed=COSLOBE_TYPE");
    println!("cargo::rustc-link-arg=-Tboard.x");
    let number = env::var("COSLOBE_TYPE").unwrap_or("f32".to_owned());
    let number = match number.as_str() {
        "Fixed" => "kit::Integers",
        "Fixed16" => "kit::Integers16",
        number => number,
    };
    let out = env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(
        Path::new(&out).join("number.rs"),
        format!("#[allow(unused_imports)] // f32 and f64 need none\nuse coslobe::*;\npub(crate) type Number = {number};\n"),
    )
    .expect("OUT_DIR is writable");
}
