//! Slices: the bits of the scalar calls, for every law and number type, at every width of vectors
//! that this processor has, for any length and any input.
//!
//! With the feature `simd` the widths are forced one after the other; without it there is the
//! compiled one.

mod batches {
    pub(crate) mod inputs;
    pub(crate) mod planar;
    pub(crate) mod spatial;
}

use batches::inputs::{LENGTHS, bits, numbers, pairs};
use batches::{planar, spatial};
use coslobe::uniform::{TailBits, TurnBits};
use coslobe::{Batch, CosSin, Law, LengthError};
use kit::batch::{BatchNumber, BatchVisitor, every_batch_number};
use kit::{Id, LawVisitor, Named, Number, PlanarLaw, SpatialLaw, catalogue};

/// Runs `test` at every width that there is. The width is one for the whole process: one test calls
/// this.
fn at_every_width(test: impl Fn(&str)) {
    #[cfg(feature = "simd")]
    {
        use coslobe::batch::width::{Width, limit, widest};
        for width in [Width::Compiled, Width::Avx2, Width::Avx512] {
            if width <= widest() {
                limit(width);
                test(&format!("{width:?}"));
            }
        }
        limit(Width::Avx512);
    }
    #[cfg(not(feature = "simd"))]
    test("compiled");
}

/// `found` against `expected`, of which each is a scalar call's.
fn same<T: Number>(what: &str, found: &[T], expected: impl Iterator<Item = T>) {
    let mut compared = 0;
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        let bits = (found.bits(), expected.bits());
        assert_eq!(
            bits.0, bits.1,
            "{what}, element {i} of {}: {found:?}, {expected:?}",
            compared
        );
        compared += 1;
    }
    assert_eq!(compared, found.len(), "{what}");
}

/// A slice function of one argument and one result.
type Unary<L, T> = fn(&L, &[T], &mut [T]) -> Result<(), LengthError>;

fn unary<T: Batch + Number, L: Law<T> + Named>(law: &L, width: &str) {
    type Scalar<L, T> = fn(&L, T) -> T;
    type Row<L, T> = (&'static str, Unary<L, T>, Scalar<L, T>);
    let all: [Row<L, T>; 6] = [
        ("pdf", L::pdf_slice, L::pdf),
        ("ln_pdf", L::ln_pdf_slice, L::ln_pdf),
        ("cdf", L::cdf_slice, L::cdf),
        ("sf", L::sf_slice, L::sf),
        ("quantile", L::quantile_slice, L::quantile),
        ("isf", L::isf_slice, L::isf),
    ];
    let inputs = numbers::<T>();
    for (name, slice, scalar) in all {
        for len in LENGTHS.chain([inputs.len()]) {
            for part in inputs.windows(len.max(1)).step_by(37) {
                let part = &part[..len];
                let mut out = vec![T::HALF; len];
                assert_eq!(slice(law, part, &mut out), Ok(()));
                let what = format!("{} {} {name}, {width}, {len}", L::ID.name(), T::NAME);
                same(&what, &out, part.iter().map(|&x| scalar(law, x)));
            }
        }
        let mut out = vec![T::HALF; 70];
        let error = slice(law, &inputs[..71], &mut out);
        assert_eq!(
            error,
            Err(LengthError {
                expected: 71,
                found: 70
            }),
            "{name}"
        );
        assert!(out.iter().all(|&x| x == T::HALF), "{name} wrote");
    }
}

fn components<T: Batch + Number, L: Law<T> + Named>(law: &L, width: &str) {
    let inputs = numbers::<T>();
    let (cos, sin) = pairs::<T>();
    for len in LENGTHS.chain([inputs.len()]) {
        let what = format!("{} {}, {width}, {len}", L::ID.name(), T::NAME);
        let u = &inputs[..len];
        let (mut a, mut b) = (vec![T::HALF; len], vec![T::HALF; len]);
        let out = CosSin {
            cos: &mut a[..],
            sin: &mut b[..],
        };
        assert_eq!(law.warp_slice(u, out), Ok(()));
        same(
            &format!("{what} warp cos"),
            &a,
            u.iter().map(|&u| law.warp(u).cos),
        );
        same(
            &format!("{what} warp sin"),
            &b,
            u.iter().map(|&u| law.warp(u).sin),
        );
    }
    for len in LENGTHS.chain([cos.len()]) {
        let what = format!("{} {}, {width}, {len}", L::ID.name(), T::NAME);
        let at = CosSin {
            cos: &cos[..len],
            sin: &sin[..len],
        };
        let each = || {
            at.cos
                .iter()
                .zip(at.sin)
                .map(|(&cos, &sin)| CosSin { cos, sin })
        };
        let mut out = vec![T::HALF; len];
        assert_eq!(law.density_slice(at, &mut out), Ok(()));
        same(
            &format!("{what} density"),
            &out,
            each().map(|at| law.density(at)),
        );
        assert_eq!(law.unwarp_slice(at, &mut out), Ok(()));
        same(
            &format!("{what} unwarp"),
            &out,
            each().map(|at| law.unwarp(at)),
        );
    }
}

/// Each slice in turn a longer or a shorter one.
fn unequal<T: Batch + Number, L: Law<T>>(law: &L) {
    let inputs = numbers::<T>();
    for wrong in 0..3 {
        for other in [0, 63, 65, 128] {
            let mut n = [64; 3];
            n[wrong] = other;
            let (mut a, mut b) = (vec![T::HALF; n[1]], vec![T::HALF; n[2]]);
            let out = CosSin {
                cos: &mut a[..],
                sin: &mut b[..],
            };
            let (expected, found) = (n[0], if wrong == 0 { 64 } else { other });
            let error = Err(LengthError { expected, found });
            assert_eq!(law.warp_slice(&inputs[..n[0]], out), error);
            assert!(a.iter().chain(&b).all(|&x| x == T::HALF), "written");
            let at = CosSin {
                cos: &inputs[..n[0]],
                sin: &inputs[..n[1]],
            };
            let mut out = vec![T::HALF; n[2]];
            assert_eq!(law.density_slice(at, &mut out), error);
            assert_eq!(law.unwarp_slice(at, &mut out), error);
            assert!(out.iter().all(|&x| x == T::HALF), "written");
        }
    }
}

/// Every function of slices, at a width.
struct Functions<'a, T: BatchNumber> {
    width: &'a str,
    tails: &'a [TailBits<T>],
    turns: &'a [TurnBits<T>],
}

impl<T: BatchNumber> Functions<'_, T> {
    fn law<L: Law<T> + Named>(&self, law: &L) {
        unary(law, self.width);
        components(law, self.width);
        unequal(law);
    }
}

impl<T: BatchNumber> LawVisitor<T> for Functions<'_, T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        self.law::<L>(&law);
        planar::law(&law, self.tails, self.width);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        self.law::<L>(&law);
        spatial::law(&law, self.tails, self.turns, self.width);
    }
}

/// Every law at every width.
struct Laws;

impl BatchVisitor for Laws {
    fn number<T: BatchNumber>(&mut self) {
        let (tails, turns) = &bits::<T>();
        at_every_width(|width| {
            let mut functions = Functions::<T> {
                width,
                tails,
                turns,
            };
            catalogue::every_law(&mut functions, &[0.0, 1.0, 7.3, 1e4]);
        });
    }
}

#[test]
fn slices_give_the_bits_of_scalar_calls() {
    every_batch_number(&mut Laws);
}
