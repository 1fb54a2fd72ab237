//! Whatever is measured: an operation of a law, ours in a number type or a peer's.

use coslobe::batch::width::Width;
use kit::study::cell::Cell;
use kit::study::errors::Errors;
use kit::study::inputs::Uniforms;
use kit::{Id, catalogue};

/// Exponent of the power law that is measured.
pub(crate) const EXPONENT: f64 = 20.0;

/// What a `sample` in space takes one at a time before any law: its words and its azimuth.
pub(crate) const PARTS: &str = "words and azimuth";

/// The operation whose time that of `operation` is compared with, one at a time; a function of
/// slices has its bits, too.
pub(crate) fn whole(operation: &str) -> &str {
    match operation {
        PARTS | "sample_from_bits_slice" => SAMPLE,
        _ => operation.strip_suffix("_slice").unwrap_or(operation),
    }
}

pub(crate) const SAMPLE: &str = "sample";
/// A direction of two given uniforms: an element of a loop over an array of pairs.
pub(crate) const DIRECTION: &str = "warp_direction";

/// The vectors of a width, by the names of the processors' makers.
pub(crate) fn vectors(width: Width) -> &'static str {
    match width {
        Width::Avx512 => "AVX-512",
        Width::Avx2 => "AVX2",
        _ if cfg!(target_feature = "avx512f") => "AVX-512",
        _ if cfg!(target_feature = "avx2") => "AVX2",
        _ if cfg!(target_feature = "sse2") => "SSE2",
        _ if cfg!(target_feature = "neon") => "NEON",
        _ => "compiled",
    }
}

/// Errors measured by this study, given the uniforms to take and how many in each octave.
pub(crate) type Measure = Box<dyn Fn(Uniforms, u32) -> Errors>;

pub(crate) struct Contender {
    /// The number type, or the peer's name.
    pub(crate) name: String,
    /// A few characters for a plot.
    pub(crate) short: String,
    pub(crate) ours: bool,
    /// The plain type of the same format: `f32` or `f64`.
    pub(crate) format: &'static str,
    pub(crate) law: Id,
    pub(crate) operation: &'static str,
    /// Of a function of slices.
    pub(crate) width: Option<Width>,
    pub(crate) cell: Cell,
    /// Uniforms that the sampler itself draws.
    pub(crate) own: Uniforms,
    pub(crate) measure: Option<Measure>,
}

impl Contender {
    /// Whether valgrind has the vectors.
    pub(crate) fn countable(&self) -> bool {
        self.width.is_none_or(|width| width < Width::Avx512)
    }

    /// Mean and standard deviation of cos θ that the law has.
    pub(crate) fn expected_cos(&self) -> (f64, f64) {
        let moments = catalogue::moments::<f64>(self.law).expect("a law");
        (moments.mean_cos, moments.var_cos.sqrt())
    }
}

/// The plain type of a number type's format.
pub(crate) fn plain(name: &str) -> &'static str {
    if name.contains("f64") { "f64" } else { "f32" }
}
