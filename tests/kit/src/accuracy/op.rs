//! The operations that are judged.

/// Operations in the order of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    Pdf,
    LnPdf,
    PdfSolidAngle,
    Cdf,
    Sf,
    Density,
    LambertWeight,
    Unwarp,
    UnwarpSf,
    WarpCos,
    WarpSin,
    WarpSfCos,
    WarpSfSin,
    Quantile,
    Isf,
}

pub const OPERATIONS: [(Op, &str); 15] = [
    (Op::Pdf, "pdf"),
    (Op::LnPdf, "ln_pdf"),
    (Op::PdfSolidAngle, "pdf_solid_angle"),
    (Op::Cdf, "cdf"),
    (Op::Sf, "sf"),
    (Op::Density, "density"),
    (Op::LambertWeight, "lambert_weight"),
    (Op::Unwarp, "unwarp"),
    (Op::UnwarpSf, "unwarp_sf"),
    (Op::WarpCos, "warp: cos"),
    (Op::WarpSin, "warp: sin"),
    (Op::WarpSfCos, "warp_sf: cos"),
    (Op::WarpSfSin, "warp_sf: sin"),
    (Op::Quantile, "quantile"),
    (Op::Isf, "isf"),
];

/// What is computed at an angle, or at the pair of one; the last four at −θ, for planar laws.
pub const AT_ANGLE: [Op; 13] = [
    Op::Pdf,
    Op::LnPdf,
    Op::PdfSolidAngle,
    Op::Density,
    Op::LambertWeight,
    Op::Cdf,
    Op::Sf,
    Op::Unwarp,
    Op::UnwarpSf,
    Op::Cdf,
    Op::Sf,
    Op::Unwarp,
    Op::UnwarpSf,
];

/// What is computed at a probability.
pub const AT_TAIL: [Op; 6] = [
    Op::WarpCos,
    Op::WarpSin,
    Op::WarpSfCos,
    Op::WarpSfSin,
    Op::Quantile,
    Op::Isf,
];

/// The name in the tables.
pub fn name(op: Op) -> &'static str {
    OPERATIONS[op as usize].1
}
