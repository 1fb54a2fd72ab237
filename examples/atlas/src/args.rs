//! What the command line may say.

use crate::catalog::LawName;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Samples every law, checks what comes out, and draws the page `index.html` about it.
#[derive(Debug, Parser)]
#[command(name = "atlas")]
pub(crate) struct Args {
    /// Laws to show, separated by commas.
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = LawName::value_variants().to_vec())]
    pub(crate) laws: Vec<LawName>,

    /// Samples of each law in each number type.
    #[arg(long, default_value_t = 1_000_000, allow_negative_numbers = true, value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) samples: u64,

    /// Seed of the generator; the same seed gives the same bytes.
    #[arg(long, default_value_t = 1, allow_negative_numbers = true)]
    pub(crate) seed: u64,

    /// Folder for the page and its figures; other files in it are left alone.
    #[arg(long, default_value = "atlas")]
    pub(crate) out: PathBuf,

    /// Exponent k of the law cos-power: a finite number ≥ 0.
    #[arg(long, default_value_t = 20.0, allow_negative_numbers = true)]
    pub(crate) exponent: f64,
}

impl Args {
    /// The laws asked for, each once, in the order of the page.
    pub(crate) fn chosen(&self) -> Vec<LawName> {
        let mut laws = self.laws.clone();
        laws.sort_unstable();
        laws.dedup();
        laws
    }
}
