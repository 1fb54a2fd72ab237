//! Which scene of `../scenes` is rendered: `COSLOBE_SCENE=SoftShadow cargo run -p shade`. The code
//! of effects that it does not call for is not in the image.

use std::{env, fs, path::Path};

fn main() {
    println!("cargo::rerun-if-env-changed=COSLOBE_SCENE");
    println!("cargo::rustc-link-arg=-Tboard.x");
    let scene = env::var("COSLOBE_SCENE").unwrap_or("SoftShadow".to_owned());
    let out = env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(
        Path::new(&out).join("scene.rs"),
        format!("pub(crate) type Chosen = scenes::{scene};\n"),
    )
    .expect("OUT_DIR is writable");
}
