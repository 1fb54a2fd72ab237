//! What the image calls is said by `COSLOBE_CALLS`, an expression of type u32 in x, a u32, and rng:
//! see `src/operations.rs` and `src/integers.rs` for what it may call. Nothing but that is in the
//! image.

use std::{env, fs, path::Path};

fn main() {
    println!("cargo::rerun-if-env-changed=COSLOBE_CALLS");
    let calls =
        env::var("COSLOBE_CALLS").unwrap_or("spatial_sampler::<f32>(Lambert, rng)".to_owned());
    let out = env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(
        Path::new(&out).join("calls.rs"),
        format!(
            "#[allow(unused_imports)] // which ones, the calls decide\n\
             use {{links::{{integers::*, operations::*}}, coslobe::*, scenes::*}};\n\
             #[allow(unused_variables)]\n\
             pub(crate) fn calls(x: u32, rng: &mut Words) -> u32 {{\n    {calls}\n}}\n"
        ),
    )
    .expect("OUT_DIR is writable");
}
