//! Sweeps every operation over inputs and keeps the worst error of each.

use super::format::{Format, Subject, error_in_ulps, ulp};
use super::inverse::warp;
use super::reference::{
    Direction, Id, density, density_at_cos, lambert_weight, ln_pdf, pdf, tails,
};
use super::wide::Wide;
use coslobe::CosSin;
use rayon::prelude::*;

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

#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    pub ulps: f64,
    /// Bits of the argument (of the angle that a pair was rounded from).
    pub input: u64,
    pub tried: u64,
    pub correct: u64,
}

impl Worst {
    fn note(&mut self, ulps: f64, input: u64) {
        self.tried += 1;
        self.correct += u64::from(ulps <= 0.5);
        if ulps > self.ulps {
            (self.ulps, self.input) = (ulps, input);
        }
    }

    fn merge(&mut self, other: &Self) {
        let (tried, correct) = (self.tried + other.tried, self.correct + other.correct);
        if other.ulps > self.ulps {
            *self = *other;
        }
        (self.tried, self.correct) = (tried, correct);
    }
}

/// Worst errors by law and operation.
#[derive(Clone, Debug)]
pub struct Tally(pub Vec<[Worst; OPERATIONS.len()]>);

impl Tally {
    pub fn new(laws: usize) -> Self {
        Tally(vec![Default::default(); laws])
    }

    pub fn merge(mut self, other: Self) -> Self {
        for (mine, theirs) in self.0.iter_mut().zip(&other.0) {
            for (a, b) in mine.iter_mut().zip(theirs) {
                a.merge(b);
            }
        }
        self
    }
}

struct Note<'a, T> {
    row: &'a mut [Worst; OPERATIONS.len()],
    input: T,
}

impl<T: Format> Note<'_, T> {
    fn check(&mut self, operation: Op, got: T, want: T::Wide) {
        self.scaled(operation, got, want, 1.0);
    }

    fn scaled(&mut self, operation: Op, got: T, want: T::Wide, share: f64) {
        let ulps = error_in_ulps(got, want) * share;
        self.row[operation as usize].note(ulps, self.input.bits());
    }
}

/// All operations that take an angle, or the pair of one, at θ in [0, π/2].
pub fn at_angle<T: Format>(subjects: &[Subject<T>], theta: T, tally: &mut Tally) {
    let at = Direction::<T::Wide>::at_angle(theta.wide());
    let pair = CosSin {
        cos: T::round(at.cos.near()),
        sin: T::round(at.sin.near()),
    };
    let paired = Direction::<T::Wide>::at_pair(pair.cos.wide(), pair.sin.wide());
    for (s, row) in subjects.iter().zip(&mut tally.0) {
        let mut note = Note { row, input: theta };
        let (id, law) = (s.id, &s.law);
        note.check(Op::Pdf, law.pdf(theta), pdf(id, &at));
        let (got, want) = (law.ln_pdf(theta), ln_pdf(id, &at));
        // A logarithm that crosses zero is judged in ulps of 1 around there.
        let crosses = matches!(id, Id::CosPower(_)) && want.near().abs() < 1.0;
        let share = if crosses {
            ulp::<T>(want.near()) / ulp::<T>(1.0)
        } else {
            1.0
        };
        note.scaled(Op::LnPdf, got, want, share);
        if let Some(solid) = &s.solid {
            note.check(Op::PdfSolidAngle, solid(theta), density(id, &at));
        }
        let reads_both = matches!(id, Id::CosPower(_));
        let want = if reads_both {
            density(id, &paired)
        } else {
            density_at_cos(id, pair.cos.wide())
        };
        note.check(Op::Density, law.density(pair), want);
        if pair.cos.wide() > 0.0 {
            let mut from_cos = paired;
            if !reads_both {
                from_cos.cos = T::Wide::of(pair.cos.wide());
            }
            note.check(
                Op::LambertWeight,
                law.lambert_weight(pair),
                lambert_weight(id, &from_cos),
            );
        }
        let (lower, upper) = tails(id, &at);
        let (pair_lower, pair_upper) = tails(id, &paired);
        if id.planar() {
            let mirrored = CosSin {
                cos: pair.cos,
                sin: -pair.sin,
            };
            note.check(Op::Cdf, law.cdf(-theta), lower);
            note.check(Op::Sf, law.sf(-theta), upper);
            note.check(Op::Cdf, law.cdf(theta), upper);
            note.check(Op::Sf, law.sf(theta), lower);
            note.check(Op::Unwarp, law.unwarp(mirrored), pair_lower);
            note.check(Op::UnwarpSf, law.unwarp_sf(mirrored), pair_upper);
            note.check(Op::Unwarp, law.unwarp(pair), pair_upper);
            note.check(Op::UnwarpSf, law.unwarp_sf(pair), pair_lower);
        } else {
            note.check(Op::Cdf, law.cdf(theta), lower);
            note.check(Op::Sf, law.sf(theta), upper);
            note.check(Op::Unwarp, law.unwarp(pair), pair_lower);
            note.check(Op::UnwarpSf, law.unwarp_sf(pair), pair_upper);
        }
    }
}

/// All operations that take a probability: p in [0, ½] from either end, which is the whole domain,
/// since 1 − u is exact for u ≥ ½.
pub fn at_tail<T: Format>(subjects: &[Subject<T>], p: T, tally: &mut Tally) {
    for (s, row) in subjects.iter().zip(&mut tally.0) {
        let mut note = Note { row, input: p };
        let (id, law) = (s.id, &s.law);
        let reference = |upper: bool| {
            let (cos, sin) = warp::<T::Wide>(id, p.wide(), upper);
            (cos, sin, T::Wide::angle(cos, sin))
        };
        let (cos, sin, theta) = reference(false);
        let minus = |x: T::Wide| if id.planar() { -x } else { x };
        let at = law.warp(p);
        note.check(Op::WarpCos, at.cos, cos);
        note.check(Op::WarpSin, at.sin, minus(sin));
        note.check(Op::Quantile, law.quantile(p), minus(theta));
        // A planar law is its own mirror image: one reference serves both sides.
        let (cos, sin, theta) = if id.planar() {
            (cos, sin, theta)
        } else {
            reference(true)
        };
        let at = law.warp_sf(p);
        note.check(Op::WarpSfCos, at.cos, cos);
        note.check(Op::WarpSfSin, at.sin, sin);
        note.check(Op::Isf, law.isf(p), theta);
    }
}

/// Every `stride`-th bit pattern from 0 to `top` (both ends included), in parallel.
pub fn sweep<T: Format>(
    subjects: &[Subject<T>],
    top: u64,
    stride: u64,
    visit: impl Fn(&[Subject<T>], T, &mut Tally) + Sync,
    progress: impl Fn(u64) + Sync,
) -> Tally {
    let count = top / stride + 1;
    let block = (count / 256).clamp(1, 1 << 22);
    (0..count.div_ceil(block))
        .into_par_iter()
        .map(|b| {
            let mut tally = Tally::new(subjects.len());
            for i in b * block..((b + 1) * block).min(count) {
                // Aligned to the top, so that the edge itself is always tried.
                visit(subjects, T::of_bits(top - i * stride), &mut tally);
            }
            if b == 0 {
                visit(subjects, T::of_bits(0), &mut tally);
            }
            progress(block);
            tally
        })
        .reduce(|| Tally::new(subjects.len()), Tally::merge)
}
