//! One source for every law and number type: `COSLOBE_LAW=Ball COSLOBE_TYPE='Precise<f32>' cargo
//! run -p law`. Nothing but what they name is in the image.

use std::{env, fs, path::Path};

fn main() {
    println!("cargo::rerun-if-env-changed=COSLOBE_LAW");
    println!("cargo::rerun-if-env-changed=COSLOBE_TYPE");
    println!("cargo::rustc-link-arg=-Tboard.x");
    let law = env::var("COSLOBE_LAW").unwrap_or("Lambert".to_owned());
    let number = env::var("COSLOBE_TYPE").unwrap_or("f32".to_owned());
    let subject = match law.as_str() {
        "CosPower" if number == "Fixed" => "integers(kit::catalogue::power())".to_owned(),
        _ if number == "Fixed" => format!("integers({law})"),
        _ if number == "Fixed16" => format!("integers16({law})"),
        "Disk" | "CircleShell" | "CircleArc" => format!("planar::<_, {number}>({law})"),
        "CosPower" => format!(
            "spatial::<_, {number}>(CosPower::new(Number::of(EXPONENT)).expect(\"an exponent ≥ 0\"))"
        ),
        _ => format!("spatial::<_, {number}>({law})"),
    };
    let out = env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(
        Path::new(&out).join("subject.rs"),
        format!(
            "#[allow(unused_imports)] // which ones, the law decides\nuse {{coslobe::*, kit::*}};\n\
             pub(crate) fn subject() -> impl Subject {{\n    {subject}\n}}\n"
        ),
    )
    .expect("OUT_DIR is writable");
}
