//! Writes the functions that C calls, and holds the committed header to the table of both.
//!
//! `COSLOBE_BLESS=1 cargo build -p c_api` writes that header anew.

use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=include/coslobe.h");
    println!("cargo::rerun-if-changed=../../Cargo.toml");
    println!("cargo::rerun-if-env-changed=COSLOBE_BLESS");
    let shims = Path::new(&env::var("OUT_DIR")?).join("shims.rs");
    fs::write(shims, c_surface::shims())?;
    let manifest = fs::read_to_string("../../Cargo.toml")?;
    let version = manifest
        .lines()
        .find_map(|line| line.strip_prefix("version = \""));
    let version = version
        .ok_or("no version in Cargo.toml")?
        .trim_end_matches('"');
    let header = c_surface::header(version);
    let path = "include/coslobe.h";
    if env::var_os("COSLOBE_BLESS").is_some() {
        fs::write(path, header)?;
    } else if fs::read_to_string(path)? != header {
        return Err(
            "include/coslobe.h is not its table's: COSLOBE_BLESS=1 cargo build -p c_api".into(),
        );
    }
    Ok(())
}
