//! Value stability: the bits of every law's samples and functions, as committed in
//! `golden/values.txt`.
//!
//! A mismatch is a value-breaking change. If it is meant, mark it "value-breaking" in the changelog
//! and regenerate the file: `COSLOBE_BLESS=1 cargo test --test values`.

use coslobe::rand_core::Rng;
use coslobe::{Law, Spatial};
use kit::catalogue::{every_law, every_number};
use kit::stats::claim::Claim;
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};
use rand_pcg::{Pcg32, Pcg64};
use std::fmt::Write;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/values.txt");
const COUNT: usize = 10_000;

/// FNV-1a over 64-bit values: short, and the same everywhere.
struct Hash(u64);

impl Hash {
    fn of<T: Number, const N: usize>(values: impl IntoIterator<Item = [T; N]>) -> u64 {
        let mut hash = Hash(0xcbf2_9ce4_8422_2325);
        for value in values.into_iter().flatten() {
            hash.add(value.bits());
        }
        hash.0
    }

    fn add(&mut self, value: u64) {
        for byte in value.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}

/// One line per law, number type and operation.
#[derive(Default)]
struct Lines(String);

impl Lines {
    fn samples<T: Number, const N: usize>(
        &mut self,
        law: &str,
        draw: impl Fn(&mut dyn Rng) -> [T; N],
    ) {
        self.stream(law, "Pcg32", &mut Pcg32::new(1, 2), &draw);
        self.stream(law, "Pcg64", &mut Pcg64::new(1, 2), &draw);
    }

    fn stream<T: Number, const N: usize>(
        &mut self,
        law: &str,
        name: &str,
        rng: &mut dyn Rng,
        draw: impl Fn(&mut dyn Rng) -> [T; N],
    ) {
        let samples: Vec<_> = (0..COUNT).map(|_| draw(&mut *rng)).collect();
        let digits = 2 * size_of::<T>();
        for (i, sample) in samples.iter().take(4).enumerate() {
            let bits = sample.map(|c| format!("{:0digits$x}", c.bits())).join(" ");
            self.line(law, &format!("sample {i} {name}"), &bits);
        }
        self.hash(law, &format!("samples {name}"), samples);
    }

    /// The functions, at angles and probabilities that run a little beyond their domains' ends.
    fn functions<T: Number>(&mut self, name: &str, law: &impl Law<T>) {
        let steps = |from: f64, to: f64| {
            (0..COUNT).map(move |i| T::of(from + (to - from) * i as f64 / (COUNT - 1) as f64))
        };
        let angles = || steps(-1.7, 1.7);
        let shares = || steps(0.0, 1.0);
        self.hash(name, "pdf", angles().map(|x| [law.pdf(x)]));
        self.hash(name, "ln_pdf", angles().map(|x| [law.ln_pdf(x)]));
        self.hash(name, "cdf", angles().map(|x| [law.cdf(x)]));
        self.hash(name, "sf", angles().map(|x| [law.sf(x)]));
        self.hash(name, "quantile", shares().map(|p| [law.quantile(p)]));
        self.hash(name, "isf", shares().map(|p| [law.isf(p)]));
        let pairs = || shares().map(|p| law.warp(p));
        self.hash(name, "warp", pairs().map(|at| [at.cos, at.sin]));
        self.hash(name, "unwarp", pairs().map(|at| [law.unwarp(at)]));
        self.hash(name, "density", pairs().map(|at| [law.density(at)]));
        let m = law.moments();
        let moments = [m.mean_cos, m.var_cos, m.mean_theta, m.var_theta, m.entropy];
        self.hash(name, "moments", [moments]);
    }

    fn hash<T: Number, const N: usize>(
        &mut self,
        law: &str,
        operation: &str,
        values: impl IntoIterator<Item = [T; N]>,
    ) {
        self.line(law, operation, &format!("{:016x}", Hash::of(values)));
    }

    fn line(&mut self, law: &str, operation: &str, value: &str) {
        writeln!(self.0, "{law} {operation}: {value}").expect("a string grows");
    }
}

impl<T: Number> LawVisitor<T> for Lines {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        self.samples(&claim.name, |mut rng| law.sample(&mut rng));
        self.functions(&claim.name, &law);
    }

    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        self.samples(&claim.name, |mut rng| Spatial::sample(&law, &mut rng));
        self.functions(&claim.name, &law);
    }
}

impl NumberVisitor for Lines {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[7.3]);
    }
}

#[test]
fn values_are_stable() {
    let mut lines = Lines::default();
    every_number(&mut lines);
    if std::env::var_os("COSLOBE_BLESS").is_some() {
        std::fs::write(FILE, &lines.0).expect("the golden file is writable");
        return;
    }
    let golden = std::fs::read_to_string(FILE).unwrap_or_default();
    let mut golden = golden.lines();
    let mut changes = String::new();
    for found in lines.0.lines() {
        let expected = golden.next().unwrap_or("nothing");
        if found != expected {
            writeln!(changes, "expected {expected}\n   found {found}").expect("a string grows");
        }
    }
    let rest = golden.count();
    assert!(
        changes.is_empty() && rest == 0,
        "value-breaking change ({rest} golden lines without a value):\n{changes}If it is meant: mark it \
         \"value-breaking\" in the changelog and run COSLOBE_BLESS=1 cargo test --test values"
    );
}
