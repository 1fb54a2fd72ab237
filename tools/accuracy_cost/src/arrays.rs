//! Loops over arrays: `warp_direction` and `warp` of pairs, of slices at each width, and the same loops in
//! the hand of a renderer's author.

use crate::contender::{Contender, EXPONENT, plain};
use crate::peers::{concentric, lobe};
use coslobe::batch::width::{Width, limit, widest};
use coslobe::rand_core::Rng;
use coslobe::{CosSin, Disk, Planar, Spatial};
use kit::batch::{BatchNumber, BatchVisitor, every_batch_number};
use kit::catalogue::every_law;
use kit::study::cell::{Cell, generator};
use kit::study::inputs::Uniforms;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};
use rand_distr::{Distribution, UnitSphere};
use std::hint::black_box;
use std::ops::Range;

/// Elements of a slice.
const SLICE: usize = 4096;
/// Elements that time is taken over: more than a branch predictor learns.
const ALL: usize = 1 << 16;

pub(crate) const DIRECTION: &str = "warp_direction";
pub(crate) const WARP: &str = "warp";
pub(crate) const SAMPLE: &str = "sample";
pub(crate) const PAIRS: &str = "array of pairs";
pub(crate) const SCALAR: &str = "one at a time";

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

struct List {
    widths: Vec<Width>,
    all: Vec<Contender>,
}

impl List {
    fn push(&mut self, law: Id, operation: &'static str, name: String, ours: bool, cell: Cell) {
        self.all.push(Contender {
            short: name.clone(),
            format: plain(&name),
            name,
            ours,
            law,
            operation,
            cell,
            own: Uniforms::Grid,
            measure: None,
        });
    }

    /// A slice function at each width.
    fn slices<T: Number>(
        &mut self,
        law: Id,
        operation: &'static str,
        what: &str,
        f: impl FnMut(Range<usize>) + Clone + 'static,
    ) {
        for width in self.widths.clone() {
            let mut f = f.clone();
            let at_width = move |range: Range<usize>| {
                limit(width);
                f(range);
                limit(Width::Avx512);
            };
            self.push(law, operation, name::<T>(what, width), true, cell(at_width));
        }
    }

    fn peer(&mut self, law: Id, name: &str, f: impl Fn(f32, f32) -> [f32; 3] + Copy + 'static) {
        let ([u, v], mut out) = (uniforms::<f32>(), vec![[0.0; 3]; SLICE]);
        let pairs: Vec<_> = u.into_iter().zip(v).collect();
        let each = move |range: Range<usize>| {
            for (out, &(u, v)) in out.iter_mut().zip(black_box(&pairs[range])) {
                *out = f(u, v);
            }
            black_box(&mut out);
        };
        self.push(
            law,
            DIRECTION,
            format!("{name}, {PAIRS}"),
            false,
            cell(each),
        );
    }
}

/// As a contender at a width is called.
pub(crate) fn name<T: Number>(what: &str, width: Width) -> String {
    format!("{} {what}, {width:?}", T::NAME)
}

fn uniforms<T: Number>() -> [Vec<T>; 2] {
    let mut rng = generator();
    [(); 2].map(|()| {
        let mut next = || T::of(f64::from(rng.next_u32() >> 8) / f64::from(1 << 24));
        (0..ALL).map(|_| next()).collect()
    })
}

fn spatial<T: BatchNumber, L: Spatial<T> + Copy + 'static>(list: &mut List, id: Id, law: L) {
    let ([u, v], mut out) = (uniforms::<T>(), vec![[T::ZERO; 3]; SLICE]);
    let pairs: Vec<_> = u.iter().zip(&v).map(|(&u, &v)| [u, v]).collect();
    let each = move |range: Range<usize>| {
        for (out, &u) in out.iter_mut().zip(black_box(&pairs[range])) {
            *out = law.warp_direction(u);
        }
        black_box(&mut out);
    };
    let name = format!("{} {PAIRS}", T::NAME);
    list.push(id, DIRECTION, name, true, cell(each));

    let mut out = [(); 3].map(|()| vec![T::ZERO; SLICE]);
    list.slices::<T>(id, DIRECTION, "slices", move |range| {
        let u = [black_box(&u[range.clone()]), &v[range]];
        let done = law.warp_direction_slice(u, out.each_mut().map(|x| &mut x[..]));
        black_box((done, &mut out)).0.expect("equal lengths");
    });

    let mut out = [(); 3].map(|()| vec![T::ZERO; SLICE]);
    let mut rng = generator();
    list.slices::<T>(id, SAMPLE, "sample_slice", move |_| {
        let done = law.sample_slice(&mut rng, out.each_mut().map(|x| &mut x[..]));
        black_box((done, &mut out)).0.expect("equal lengths");
    });

    let mut out = [(); 3].map(|()| vec![T::ZERO; SLICE]);
    let mut rng = generator();
    let mut next = || rng.next_u64();
    let bits = |_| (T::tail_bits(&mut next), T::turn_bits(&mut next));
    let (theta, phi): (Vec<_>, Vec<_>) = (0..ALL).map(bits).unzip();
    list.slices::<T>(id, SAMPLE, "sample_from_bits_slice", move |range| {
        let (theta, phi) = (black_box(&theta[range.clone()]), &phi[range]);
        let out = out.each_mut().map(|x| &mut x[..]);
        let done = law.sample_from_bits_slice(theta, phi, out);
        black_box(done).expect("equal lengths");
    });
}

/// `Disk.warp`, whose root is the hardest.
fn disk<T: BatchNumber>(list: &mut List)
where
    Disk: Planar<T>,
{
    use coslobe::Law;
    let [u, _] = uniforms::<T>();
    let same = u.clone();
    let each = move |range: Range<usize>| {
        for &u in &same[range] {
            black_box(Disk.warp(black_box(u)));
        }
    };
    list.push(
        Id::Disk,
        WARP,
        format!("{} {SCALAR}", T::NAME),
        true,
        cell(each),
    );
    let (mut cos, mut sin) = (vec![T::ZERO; SLICE], vec![T::ZERO; SLICE]);
    list.slices::<T>(Id::Disk, WARP, "slices", move |range| {
        let out = CosSin {
            cos: &mut cos[..],
            sin: &mut sin[..],
        };
        let done = Disk.warp_slice(black_box(&u[range]), out);
        black_box((done, &mut cos, &mut sin))
            .0
            .expect("equal lengths");
    });
}

impl<T: BatchNumber> LawVisitor<T> for List {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, _: L) {
        if id == Id::Disk {
            disk::<T>(self);
        }
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        spatial::<T, L>(self, id, law);
    }
}

impl BatchVisitor for List {
    fn number<T: BatchNumber>(&mut self) {
        every_law::<T>(self, &[EXPONENT]);
    }
}

fn peers(list: &mut List) {
    list.peer(Id::Lambert, "polar form, std f32", lobe::polar);
    list.peer(Id::Lambert, "concentric map, std f32", concentric);
    list.peer(Id::Ball, "cos³ by √√u, std f32", lobe::two_roots);
    list.peer(Id::SphereShell, "cos² by cbrt, std f32", lobe::cube_root);
    let k = EXPONENT as f32;
    list.peer(
        Id::CosPower(EXPONENT),
        "cosⁿ by powf, std f32",
        move |u, v| lobe::power(u, v, k),
    );
    let mut rng = generator();
    let mut out = vec![[0.0f32; 3]; SLICE];
    let each = move |_: Range<usize>| {
        for out in &mut out {
            let [x, y, z]: [f32; 3] = UnitSphere.sample(&mut rng);
            let length = (x * x + (y + 1.0) * (y + 1.0) + z * z).sqrt();
            *out = [x / length, (y + 1.0) / length, z / length];
        }
        black_box(&mut out);
    };
    let name = "UnitSphere + normal, rand_distr f32".to_owned();
    list.push(Id::Lambert, SAMPLE, name, false, cell(each));
}

fn at_widths(widths: Vec<Width>) -> List {
    let mut list = List {
        widths,
        all: Vec::new(),
    };
    every_batch_number(&mut list);
    list
}

/// All loops, at every width of this processor.
pub(crate) fn timed() -> Vec<Contender> {
    let widths = [Width::Compiled, Width::Avx2, Width::Avx512];
    let mut list = at_widths(widths.into_iter().filter(|&w| w <= widest()).collect());
    peers(&mut list);
    list.all
}

/// Our loops, at the widths that valgrind knows.
pub(crate) fn counted() -> Vec<Contender> {
    at_widths(vec![Width::Compiled, Width::Avx2]).all
}
