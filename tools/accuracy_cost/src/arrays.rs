//! Loops over arrays: `out[i] = f(u[i])` of pairs, as a renderer's author writes it, and the
//! functions of slices at each width of vectors.

use crate::contender::{Contender, EXPONENT, plain};
use coslobe::batch::width::{Width, limit, widest};
use coslobe::rand_core::Rng;
use coslobe::uniform::{TailBits, TurnBits};
use coslobe::{CosSin, Law, LengthError};
use kit::batch::{BatchNumber, BatchVisitor, every_batch_number};
use kit::catalogue::every_law;
use kit::study::cell::{Cell, generator};
use kit::study::inputs::Uniforms;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};
use std::hint::black_box;
use std::ops::Range;
use std::rc::Rc;

/// Elements of a slice.
const SLICE: usize = 4096;
/// Elements that time is taken over: more than a branch predictor learns.
const ALL: usize = 1 << 16;

/// A loop over part of the data, as a cell.
fn cell(mut f: impl FnMut(Range<usize>) + Clone + 'static) -> Cell {
    let mut counted = f.clone();
    Cell {
        run: Box::new(move || counted(0..SLICE)),
        empty: Box::new(|| {}),
        calls: SLICE as u64,
        timed: Box::new(move || (0..ALL).step_by(SLICE).for_each(|i| f(i..i + SLICE))),
        timed_calls: ALL as u64,
        words: None,
        mean_cos: None,
    }
}

/// Multiples of 2⁻²⁴ in [0, 1).
fn uniforms<T: Number>() -> [Rc<[T]>; 2] {
    let mut rng = generator();
    [(); 2].map(|()| {
        let mut next = || T::of(f64::from(rng.next_u32() >> 8) / f64::from(1 << 24));
        (0..ALL).map(|_| next()).collect()
    })
}

/// A direction of each pair, in a loop that the compiler may make what it can of.
pub(crate) fn over_pairs<T: Number>(f: impl Fn([T; 2]) -> [T; 3] + Copy + 'static) -> Cell {
    // As two numbers: to a generic function, unlike to a law's own, a pair of `f32` goes as an
    // integer of 64 bits, which halves the vectors.
    over_arrays(move |pairs, out| {
        for (out, &[u, v]) in out.iter_mut().zip(pairs) {
            *out = f([u, v]);
        }
    })
}

/// The same, of a loop that is written out.
pub(crate) fn over_arrays<T: Number>(
    f: impl Fn(&[[T; 2]], &mut [[T; 3]]) + Copy + 'static,
) -> Cell {
    let ([u, v], mut out) = (uniforms::<T>(), vec![[T::ZERO; 3]; SLICE]);
    let pairs: Rc<[[T; 2]]> = u.iter().zip(&*v).map(|(&u, &v)| [u, v]).collect();
    cell(move |range| {
        f(black_box(&pairs[range]), &mut out);
        black_box(&mut out);
    })
}

type Done = Result<(), LengthError>;
type Unary<L, T> = fn(&L, &[T], &mut [T]) -> Done;
type OfPairs<L, T> = fn(&L, CosSin<&[T]>, &mut [T]) -> Done;

/// Every function of slices, of every law in one type.
struct Slices<'a, T: BatchNumber> {
    list: &'a mut Vec<Contender>,
    u: [Rc<[T]>; 2],
    theta: Rc<[TailBits<T>]>,
    phi: Rc<[TurnBits<T>]>,
}

impl<T: BatchNumber> Slices<'_, T> {
    /// A function at each width, which is to fill the slices.
    fn push<const N: usize>(
        &mut self,
        law: Id,
        operation: &'static str,
        f: impl FnMut(Range<usize>, [&mut [T]; N]) -> bool + Clone + 'static,
    ) {
        let widths = [Width::Compiled, Width::Avx2, Width::Avx512];
        for width in widths.into_iter().filter(|&w| w <= widest()) {
            let (mut f, mut out) = (f.clone(), [(); N].map(|()| vec![T::ZERO; SLICE]));
            let at_width = move |range: Range<usize>| {
                limit(width);
                let equal_lengths = f(range, out.each_mut().map(|x| &mut x[..]));
                limit(Width::Avx512);
                assert!(black_box(equal_lengths));
                black_box(&mut out);
            };
            self.list.push(Contender {
                name: T::NAME.to_owned(),
                short: T::NAME.to_owned(),
                ours: true,
                format: plain(T::NAME),
                law,
                operation,
                width: Some(width),
                cell: cell(at_width),
                own: Uniforms::Grid,
                measure: None,
            });
        }
    }

    /// What a law of either kind has.
    fn functions<L: Law<T> + Copy + 'static>(&mut self, id: Id, law: L) {
        let unary: [(_, Unary<L, T>); 6] = [
            ("pdf_slice", L::pdf_slice),
            ("ln_pdf_slice", L::ln_pdf_slice),
            ("cdf_slice", L::cdf_slice),
            ("sf_slice", L::sf_slice),
            ("quantile_slice", L::quantile_slice),
            ("isf_slice", L::isf_slice),
        ];
        let [u, v] = self.u.clone();
        for (name, f) in unary {
            let u = u.clone();
            self.push(id, name, move |range, [out]| {
                f(&law, black_box(&u[range]), out).is_ok()
            });
        }
        let of_pairs: [(_, OfPairs<L, T>); 2] = [
            ("density_slice", L::density_slice),
            ("unwarp_slice", L::unwarp_slice),
        ];
        for (name, f) in of_pairs {
            let (cos, sin) = (u.clone(), v.clone());
            self.push(id, name, move |range, [out]| {
                let (cos, sin) = (black_box(&cos[range.clone()]), &sin[range]);
                f(&law, CosSin { cos, sin }, out).is_ok()
            });
        }
        self.push(id, "warp_slice", move |range, [cos, sin]| {
            let out = CosSin { cos, sin };
            law.warp_slice(black_box(&u[range]), out).is_ok()
        });
    }
}

impl<T: BatchNumber> LawVisitor<T> for Slices<'_, T> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        self.functions(id, law);
        let mut rng = generator();
        self.push(id, "sample_slice", move |_, out| {
            law.sample_slice(&mut rng, out).is_ok()
        });
        let theta = self.theta.clone();
        self.push(id, "sample_from_bits_slice", move |range, out| {
            law.sample_from_bits_slice(black_box(&theta[range]), out)
                .is_ok()
        });
    }

    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        self.functions(id, law);
        let [u, v] = self.u.clone();
        self.push(id, "warp_direction_slice", move |range, out| {
            let u = [black_box(&u[range.clone()]), &v[range]];
            law.warp_direction_slice(u, out).is_ok()
        });
        let mut rng = generator();
        self.push(id, "sample_slice", move |_, out| {
            law.sample_slice(&mut rng, out).is_ok()
        });
        let (theta, phi) = (self.theta.clone(), self.phi.clone());
        self.push(id, "sample_from_bits_slice", move |range, out| {
            let (theta, phi) = (black_box(&theta[range.clone()]), &phi[range]);
            law.sample_from_bits_slice(theta, phi, out).is_ok()
        });
    }
}

struct All<'a>(&'a mut Vec<Contender>);

impl BatchVisitor for All<'_> {
    fn number<T: BatchNumber>(&mut self) {
        let mut rng = generator();
        let mut next = || rng.next_u64();
        let bits = |_| (T::tail_bits(&mut next), T::turn_bits(&mut next));
        let (theta, phi): (Vec<_>, Vec<_>) = (0..ALL).map(bits).unzip();
        let mut slices = Slices::<T> {
            list: self.0,
            u: uniforms(),
            theta: theta.into(),
            phi: phi.into(),
        };
        every_law::<T>(&mut slices, &[EXPONENT]);
    }
}

/// Every function of slices, at every width of this processor.
pub(crate) fn all(list: &mut Vec<Contender>) {
    every_batch_number(&mut All(list));
}
