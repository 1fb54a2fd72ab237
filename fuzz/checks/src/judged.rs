//! Plain and `Fast` results against `Precise` ones, by the cells of `docs/bounds.md`.

use super::input::Input;
use coslobe::{CosSin, Fast, Law, Precise};
use kit::accuracy::bounds::allowed;
use kit::accuracy::format::ulp;
use kit::accuracy::op::{OPERATIONS, Op};
use kit::catalogue::one_law;
use kit::{Format, Id, LawVisitor, Number, PlanarLaw, SpatialLaw};
use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

/// What `Precise` itself may err by, in ulp.
const JUDGE_ULP: f64 = 0.55;
const TYPES: [&str; 3] = ["f32", "f64", "Fast<f32>"];

/// By number type, law and operation.
static CELLS: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let mut cells = Vec::new();
    for tier in TYPES {
        for law in Id::ALL {
            let cell = |(_, name)| allowed(tier, law.name(), name).unwrap_or(0.0);
            cells.extend(OPERATIONS.map(cell));
        }
    }
    cells
});

pub(super) fn check(input: Input) {
    match input.number_type(3) {
        0 => judge::<f32, Precise<f32>>(0, input),
        1 => judge::<f64, Precise<f64>>(1, input),
        _ => judge::<Fast<f32>, Precise<f32>>(2, input),
    }
}

/// An operation at an angle, a probability or a direction.
struct Call<F> {
    op: Op,
    x: F,
    at: CosSin<F>,
    value: Option<F>,
}

impl<F: Format> Call<F> {
    fn law<T: Number<Raw = F>>(&mut self, law: &impl Law<T>) {
        let (x, at) = (T::of_raw(self.x), pair::<T>(self.at));
        let value = match self.op {
            Op::Pdf => law.pdf(x),
            Op::LnPdf => law.ln_pdf(x),
            Op::PdfSolidAngle => return,
            Op::Cdf => law.cdf(x),
            Op::Sf => law.sf(x),
            Op::Density => law.density(at),
            Op::LambertWeight => law.lambert_weight(at),
            Op::Unwarp => law.unwarp(at),
            Op::UnwarpSf => law.unwarp_sf(at),
            Op::WarpCos => law.warp(x).cos,
            Op::WarpSin => law.warp(x).sin,
            Op::WarpSfCos => law.warp_sf(x).cos,
            Op::WarpSfSin => law.warp_sf(x).sin,
            Op::Quantile => law.quantile(x),
            Op::Isf => law.isf(x),
        };
        self.value = Some(value.raw());
    }
}

fn pair<T: Number>(at: CosSin<T::Raw>) -> CosSin<T> {
    CosSin {
        cos: T::of_raw(at.cos),
        sin: T::of_raw(at.sin),
    }
}

impl<F: Format, T: Number<Raw = F>> LawVisitor<T> for Call<F> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        self.law(&law);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        if self.op == Op::PdfSolidAngle {
            self.value = Some(law.pdf_solid_angle(T::of_raw(self.x)).raw());
        } else {
            self.law(&law);
        }
    }
}

fn judge<T: Number, P: Number<Raw = T::Raw>>(tier: usize, mut input: Input) {
    let id = input.law::<T::Raw>();
    let which = input.words.word() as usize % OPERATIONS.len();
    let (op, name) = OPERATIONS[which];
    let low = if id.planar() { -FRAC_PI_2 } else { 0.0 };
    let x = match op {
        Op::Pdf | Op::LnPdf | Op::PdfSolidAngle | Op::Cdf | Op::Sf => input.number(low, FRAC_PI_2),
        _ => input.number::<T::Raw>(0.0, 1.0),
    };
    let mut at = input.direction::<T::Raw>();
    if !id.planar() && at.sin.negative() {
        at.sin = -at.sin;
    }
    let mut call = Call {
        op,
        x,
        at,
        value: None,
    };
    one_law::<T, _>(id, &mut call);
    let Some(got) = call.value.take() else { return };
    one_law::<P, _>(id, &mut call);
    let want = call.value.expect("the same laws").wide();
    let got = got.wide();
    if got == want || (got.is_nan() && want.is_nan()) {
        return;
    }
    // An infinity stands for what lies beyond the largest number.
    let largest = <T::Raw as Number>::LARGEST.wide();
    let [a, b] = [got, want].map(|value| value.clamp(-largest, largest));
    let law = id_index(id);
    let cell = CELLS[(tier * Id::ALL.len() + law) * OPERATIONS.len() + which];
    let mut size = b.abs();
    if let (Op::LnPdf, Id::CosPower(k)) = (op, id) {
        // The difference of two logarithms.
        size = size.max(1.0).max((k + 1.0).ln());
    }
    let slack = if T::NAME.starts_with("Fast") {
        (cell / 4096.0 + T::EPSILON) * size.max(T::SMALLEST.wide())
    } else {
        (cell + JUDGE_ULP) * ulp::<T::Raw>(size)
    };
    assert!(
        (a - b).abs() <= slack,
        "{} of {id} in {}: {got:?} is not {want:?} to {cell}, at {x:?} or {at:?}",
        name,
        T::NAME
    );
}

fn id_index(id: Id) -> usize {
    let same = |other: &Id| other.name() == id.name();
    Id::ALL
        .iter()
        .position(same)
        .expect("a law of the catalogue")
}
