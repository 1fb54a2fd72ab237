//! What the figures were measured on, as far as it decides them.

use std::process::Command;

pub(crate) struct Machine {
    pub(crate) target: String,
    pub(crate) compiler: String,
    pub(crate) flags: String,
}

impl Machine {
    pub(crate) fn here() -> Machine {
        let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
        let version = Command::new(rustc).arg("--version").output();
        let compiler = match version {
            Ok(out) if out.status.success() => {
                String::from_utf8_lossy(&out.stdout).trim().to_owned()
            }
            _ => "an unknown rustc".to_owned(),
        };
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
            "release"
        };
        Machine {
            target: format!("{}-{}", std::env::consts::ARCH, std::env::consts::OS),
            compiler,
            flags: format!("{profile}, target features {}", on.join(" ")),
        }
    }
}
