//! Whatever is measured: an operation of a law, ours in a number type or a peer's.

use kit::study::cell::Cell;
use kit::study::errors::Errors;
use kit::study::inputs::Uniforms;
use kit::{Id, catalogue};

/// Exponent of the power law that is measured.
pub(crate) const EXPONENT: f64 = 20.0;

/// What a `sample` in space cannot do without: its uniform and its azimuth, with no law between them.
pub(crate) const PARTS: &str = "uniform and azimuth";

/// The operation whose time that of `operation` is compared with.
pub(crate) fn whole(operation: &'static str) -> &'static str {
    if operation == PARTS {
        "sample"
    } else {
        operation
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
    pub(crate) cell: Cell,
    /// Uniforms that the sampler itself draws.
    pub(crate) own: Uniforms,
    pub(crate) measure: Option<Measure>,
}

impl Contender {
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
