//! What is judged: a law in a number type, seen through the type's raw format.

use super::format::Format;
use super::reference::Id;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Fast, Lambert, Law, Precise, Real,
    Spatial, SphereShell,
};
use std::marker::PhantomData;

/// A number type that wraps a format: the accuracy tier that its name says.
pub trait Tier: Real {
    type Raw: Format;
    /// As in the tables.
    const NAME: &'static str;
    fn of(raw: Self::Raw) -> Self;
    fn raw(self) -> Self::Raw;
}

impl Tier for f32 {
    type Raw = f32;
    const NAME: &'static str = "f32";
    fn of(raw: f32) -> f32 {
        raw
    }
    fn raw(self) -> f32 {
        self
    }
}

impl Tier for f64 {
    type Raw = f64;
    const NAME: &'static str = "f64";
    fn of(raw: f64) -> f64 {
        raw
    }
    fn raw(self) -> f64 {
        self
    }
}

impl Tier for Precise<f32> {
    type Raw = f32;
    const NAME: &'static str = "Precise<f32>";
    fn of(raw: f32) -> Self {
        Precise(raw)
    }
    fn raw(self) -> f32 {
        self.0
    }
}

impl Tier for Precise<f64> {
    type Raw = f64;
    const NAME: &'static str = "Precise<f64>";
    fn of(raw: f64) -> Self {
        Precise(raw)
    }
    fn raw(self) -> f64 {
        self.0
    }
}

impl Tier for Fast<f32> {
    type Raw = f32;
    const NAME: &'static str = "Fast<f32>";
    fn of(raw: f32) -> Self {
        Fast(raw)
    }
    fn raw(self) -> f32 {
        self.0
    }
}

/// A law in each number type that there is of a format.
pub trait Tiers: Format {
    fn tiers(id: Id) -> Vec<Subject<Self>>;
}

impl Tiers for f32 {
    fn tiers(id: Id) -> Vec<Subject<f32>> {
        vec![
            Subject::of::<f32>(id),
            Subject::of::<Precise<f32>>(id),
            Subject::of::<Fast<f32>>(id),
        ]
    }
}

impl Tiers for f64 {
    fn tiers(id: Id) -> Vec<Subject<f64>> {
        vec![Subject::of::<f64>(id), Subject::of::<Precise<f64>>(id)]
    }
}

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

/// All values of a law at an input in one call, so that the compiler may share work among them.
pub trait Values<F>: Send + Sync {
    /// In the order of [`AT_ANGLE`]; 0 for what the law has not.
    fn at_angle(&self, theta: F, pair: CosSin<F>) -> [F; AT_ANGLE.len()];
    /// In the order of [`AT_TAIL`].
    fn at_tail(&self, p: F) -> [F; AT_TAIL.len()];
    fn quantile(&self, p: F) -> F;
    fn isf(&self, p: F) -> F;
    /// The same over a block, `out[slot][i]`.
    fn angles(&self, theta: &[F], pairs: &[CosSin<F>], out: &mut [Vec<F>]);
    fn tails(&self, p: &[F], out: &mut [Vec<F>]);
}

struct On<T, L, S> {
    law: L,
    solid: S,
    planar: bool,
    number: PhantomData<fn() -> T>,
}

impl<T, L, S> Values<T::Raw> for On<T, L, S>
where
    T: Tier,
    L: Law<T> + Send + Sync,
    S: Fn(&L, T) -> T + Send + Sync,
{
    #[inline]
    fn at_angle(&self, theta: T::Raw, pair: CosSin<T::Raw>) -> [T::Raw; AT_ANGLE.len()] {
        let (law, theta) = (&self.law, T::of(theta));
        let (cos, sin) = (T::of(pair.cos), T::of(pair.sin));
        let pair = CosSin { cos, sin };
        let zero = T::default();
        let mut values = [zero; AT_ANGLE.len()];
        values[..9].copy_from_slice(&[
            law.pdf(theta),
            law.ln_pdf(theta),
            (self.solid)(law, theta),
            law.density(pair),
            law.lambert_weight(pair),
            law.cdf(theta),
            law.sf(theta),
            law.unwarp(pair),
            law.unwarp_sf(pair),
        ]);
        if self.planar {
            let mirrored = CosSin { cos, sin: -sin };
            values[9..].copy_from_slice(&[
                law.cdf(-theta),
                law.sf(-theta),
                law.unwarp(mirrored),
                law.unwarp_sf(mirrored),
            ]);
        }
        values.map(T::raw)
    }

    #[inline]
    fn at_tail(&self, p: T::Raw) -> [T::Raw; AT_TAIL.len()] {
        let (law, p) = (&self.law, T::of(p));
        let (lower, upper) = (law.warp(p), law.warp_sf(p));
        let (quantile, isf) = (law.quantile(p), law.isf(p));
        [lower.cos, lower.sin, upper.cos, upper.sin, quantile, isf].map(T::raw)
    }

    fn quantile(&self, p: T::Raw) -> T::Raw {
        self.law.quantile(T::of(p)).raw()
    }

    fn isf(&self, p: T::Raw) -> T::Raw {
        self.law.isf(T::of(p)).raw()
    }

    fn angles(&self, theta: &[T::Raw], pairs: &[CosSin<T::Raw>], out: &mut [Vec<T::Raw>]) {
        for (i, (&theta, &pair)) in theta.iter().zip(pairs).enumerate() {
            for (slot, value) in out.iter_mut().zip(self.at_angle(theta, pair)) {
                slot[i] = value;
            }
        }
    }

    fn tails(&self, p: &[T::Raw], out: &mut [Vec<T::Raw>]) {
        for (i, &p) in p.iter().enumerate() {
            for (slot, value) in out.iter_mut().zip(self.at_tail(p)) {
                slot[i] = value;
            }
        }
    }
}

/// A law in a number type.
pub struct Subject<F> {
    pub id: Id,
    /// The number type's name.
    pub tier: &'static str,
    pub solid: bool,
    pub law: Box<dyn Values<F>>,
}

impl<F: Format> Subject<F> {
    /// A law with no solid angle: planar, or with that one operation left out.
    pub fn planar<T: Tier<Raw = F>>(id: Id, law: impl Law<T> + Send + Sync + 'static) -> Self {
        Self::on(id, false, law, |_, _| T::default())
    }

    pub fn spatial<T: Tier<Raw = F>>(id: Id, law: impl Spatial<T> + Send + Sync + 'static) -> Self {
        Self::on(id, true, law, |law, theta| law.pdf_solid_angle(theta))
    }

    fn on<T: Tier<Raw = F>, L: Law<T> + Send + Sync + 'static>(
        id: Id,
        solid: bool,
        law: L,
        value: impl Fn(&L, T) -> T + Send + Sync + 'static,
    ) -> Self {
        let law = On {
            law,
            solid: value,
            planar: id.planar(),
            number: PhantomData,
        };
        Subject {
            id,
            tier: T::NAME,
            solid,
            law: Box::new(law),
        }
    }

    /// The law in the number type T.
    pub fn of<T: Tier<Raw = F>>(id: Id) -> Self {
        match id {
            Id::Disk => Self::planar::<T>(id, Disk),
            Id::CircleShell => Self::planar::<T>(id, CircleShell),
            Id::CircleArc => Self::planar::<T>(id, CircleArc),
            Id::Ball => Self::spatial::<T>(id, Ball),
            Id::SphereShell => Self::spatial::<T>(id, SphereShell),
            Id::Lambert => Self::spatial::<T>(id, Lambert),
            Id::CosPower(k) => {
                let law = CosPower::new(T::of(F::round(k))).expect("a valid exponent");
                // The exponent that the format holds is the one to judge by.
                Self::spatial::<T>(Id::CosPower(law.exponent().raw().wide()), law)
            }
        }
    }

    /// The laws in all their number types, those of a law side by side: they share its reference.
    pub fn all(ids: &[Id]) -> Vec<Self>
    where
        F: Tiers,
    {
        ids.iter().flat_map(|&id| F::tiers(id)).collect()
    }

    /// The laws in the format's plain number type.
    pub fn plain(ids: &[Id]) -> Vec<Self>
    where
        F: Tier<Raw = F>,
    {
        ids.iter().map(|&id| Self::of::<F>(id)).collect()
    }

    /// One operation by the name in the tables, of an angle or a probability.
    pub fn call(&self, operation: &str, x: F) -> F {
        let at = |slots: &[Op]| slots.iter().position(|&op| name(op) == operation);
        if let Some(slot) = at(&AT_TAIL) {
            return self.law.at_tail(x)[slot];
        }
        let slot = at(&AT_ANGLE).unwrap_or_else(|| panic!("unknown operation {operation}"));
        self.law.at_angle(x, CosSin { cos: x, sin: x })[slot]
    }
}

/// The name in the tables.
pub fn name(op: Op) -> &'static str {
    OPERATIONS[op as usize].1
}
