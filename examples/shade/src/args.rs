//! What the command line may say.

use clap::{Parser, Subcommand, ValueEnum};
use coslobe::{Fast, Precise};
use shade_core::{LawName, NumberVisitor};
use std::path::PathBuf;

/// Renders a scene, simulating only the effects that it calls for.
#[derive(Debug, Parser)]
#[command(name = "shade", args_conflicts_with_subcommands = true)]
pub(crate) struct Args {
    /// The scene file (TOML); see examples/shade/scenes.
    #[arg(required = true)]
    pub(crate) scene: Option<PathBuf>,

    /// The image (PNG), or with --tiles the tiles' file.
    #[arg(short, long, required = true)]
    pub(crate) out: Option<PathBuf>,

    /// Samples of each pixel, in place of the scene's.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=shade::file::SAMPLES))]
    pub(crate) samples: Option<u32>,

    /// Threads; all cores if not given. The image does not depend on them.
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,

    /// The number type.
    #[arg(long = "type", value_enum, default_value = "f32")]
    pub(crate) number: NumberName,

    /// The law that directions of diffuse reflection are drawn by, in place of the scene's.
    #[arg(long)]
    pub(crate) law: Option<LawName>,

    /// Simulate every effect, called for or not: the same image, later.
    #[arg(long)]
    pub(crate) force_all: bool,

    /// Render share I of N alone, to be put together by `merge`.
    #[arg(long, value_name = "I/N")]
    pub(crate) tiles: Option<Share>,

    #[command(subcommand)]
    pub(crate) task: Option<Task>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Task {
    /// What valgrind runs.
    #[command(name = kit::study::count::SUBCOMMAND, hide = true)]
    CountCells,
    /// Measures what each shipped scene costs with the effects that it needs, with all of them, and
    /// as written by hand; writes shade.md and shade.csv.
    Table {
        /// Folder for the tables; other files in it are left alone.
        #[arg(long, default_value = "docs/measured")]
        out: PathBuf,
    },
    /// Renders a scene in every number type with the same random words: time and error, OUT.md and
    /// OUT.png.
    Types {
        /// The scene file (TOML), of a scene in space.
        scene: PathBuf,
        /// What the page and the picture are called, without their endings.
        #[arg(short, long, default_value = "docs/measured/shade_types")]
        out: PathBuf,
    },
    /// Puts the files of all shares of a frame together: the image that one machine would have
    /// made.
    Merge {
        /// The files that --tiles wrote, in any order.
        #[arg(required = true)]
        tiles: Vec<PathBuf>,
        /// The image (PNG).
        #[arg(short, long)]
        out: PathBuf,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NumberName {
    F32,
    F64,
    Fast,
    Precise,
}

impl NumberName {
    /// Shows the type of this name.
    pub(crate) fn show(self, visitor: &mut impl NumberVisitor) {
        match self {
            NumberName::F32 => visitor.number::<f32>(),
            NumberName::F64 => visitor.number::<f64>(),
            NumberName::Fast => visitor.number::<Fast<f32>>(),
            NumberName::Precise => visitor.number::<Precise<f32>>(),
        }
    }
}

/// Share `index` (from 1) of `of`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Share {
    pub(crate) index: u32,
    pub(crate) of: u32,
}

impl Share {
    pub(crate) const WHOLE: Share = Share { index: 1, of: 1 };
}

impl std::str::FromStr for Share {
    type Err = String;
    fn from_str(text: &str) -> Result<Share, String> {
        let parts = text
            .split_once('/')
            .and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match parts {
            Some((index, of)) if (1..=of).contains(&index) && of <= 1 << 16 => {
                Ok(Share { index, of })
            }
            _ => Err("expected I/N with 1 ≤ I ≤ N ≤ 65536".to_owned()),
        }
    }
}
