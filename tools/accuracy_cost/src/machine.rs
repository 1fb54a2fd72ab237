//! What the figures were measured on, as far as it decides them.

use std::process::Command;

pub(crate) struct Machine {
    pub(crate) target: String,
    pub(crate) compiler: String,
    pub(crate) flags: String,
    pub(crate) valgrind: String,
}

/// What a program says of its version.
fn version(program: &str) -> Option<String> {
    let out = Command::new(program).arg("--version").output().ok()?;
    let words = String::from_utf8_lossy(&out.stdout).trim().to_owned();
    out.status.success().then_some(words)
}

impl Machine {
    pub(crate) fn here() -> Machine {
        let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
        let features = [
            ("sse2", cfg!(target_feature = "sse2")),
            ("avx", cfg!(target_feature = "avx")),
            ("avx2", cfg!(target_feature = "avx2")),
            ("fma", cfg!(target_feature = "fma")),
            ("neon", cfg!(target_feature = "neon")),
        ];
        let on: Vec<&str> = features.iter().filter(|f| f.1).map(|f| f.0).collect();
        let profile = if cfg!(debug_assertions) {
            "with debug assertions (take `--release`)"
        } else {
            "release profile (opt-level 3)"
        };
        Machine {
            target: format!("{}-{}", std::env::consts::ARCH, std::env::consts::OS),
            compiler: version(&rustc).unwrap_or_else(|| "an unknown rustc".to_owned()),
            valgrind: version("valgrind").unwrap_or_else(|| "no valgrind".to_owned()),
            flags: format!("{profile}, target features {}", on.join(" ")),
        }
    }
}
