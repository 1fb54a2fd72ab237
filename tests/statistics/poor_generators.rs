//! Generators whose low bits are poor, as the cheap ones of firmware are: signs, azimuths and the
//! law itself pass χ² all the same, in every number type.

use coslobe::integers::CosPower;
use coslobe::rand_core::Rng;
use coslobe::{CircleArc, Fixed, Law, from_fn};
use fixed::traits::ToFixed;
use fixed::types::U16F16;
use kit::catalogue::{
    IntegerLaw, IntegerVisitor, every_integer_law, every_law, every_number, moments,
};
use kit::integer::{Format, Long, Short, direction};
use kit::stats::claim::{Claim, Direction};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Far below the generators' periods, but not below 2¹⁶, that of the lower half of an LCG's words.
const N: usize = 1 << 16;
/// Of some 500 tests none fails by chance at this level.
const ALARM: f64 = 1e-7;

const EXPONENTS: [f64; 3] = [0.0, 7.25, 100.0];

type Draw = Box<dyn Fn(&mut dyn Rng) -> Direction>;

struct Subject {
    claim: Claim,
    draw: Draw,
}

/// A generator, and whether its words are independent enough for more than their own share: the
/// multiples of the golden section are not.
struct Generator {
    name: &'static str,
    independent: bool,
    next: Box<dyn FnMut() -> u32>,
}

fn generators() -> [Generator; 4] {
    let (mut lcg, mut count, mut shift, mut long) = (1u32, 0u32, 2463534242u32, 1u64);
    [
        Generator {
            name: "LCG of 32 bits",
            independent: true,
            next: Box::new(move || {
                lcg = lcg.wrapping_mul(1664525).wrapping_add(1013904223);
                lcg
            }),
        },
        Generator {
            name: "counter times the golden section",
            independent: false,
            next: Box::new(move || {
                count = count.wrapping_add(0x9E37_79B9);
                count
            }),
        },
        Generator {
            name: "xorshift32",
            independent: true,
            next: Box::new(move || {
                shift ^= shift << 13;
                shift ^= shift >> 17;
                shift ^= shift << 5;
                shift
            }),
        },
        Generator {
            name: "low words of an LCG of 64 bits",
            independent: true,
            next: Box::new(move || {
                long = long
                    .wrapping_mul(6364136223846793005)
                    .wrapping_add(1442695040888963407);
                long as u32
            }),
        },
    ]
}

/// p-values of equally likely cells: too uneven, and too even to be random.
fn uneven(counts: &[u32]) -> [f64; 2] {
    let expected = N as f64 / counts.len() as f64 * share(counts);
    let square = |&count: &u32| (f64::from(count) - expected).powi(2) / expected;
    let statistic = counts.iter().map(square).sum();
    let chi2 = ChiSquared::new((counts.len() - 1) as f64).expect("cells");
    [chi2.sf(statistic), chi2.cdf(statistic)]
}

/// Of N, how many were counted.
fn share(counts: &[u32]) -> f64 {
    f64::from(counts.iter().sum::<u32>()) / N as f64
}

/// Sign of sin θ, or sector of φ among 16.
fn around([x, _, z]: Direction, planar: bool) -> usize {
    if planar {
        usize::from(x < 0.0)
    } else {
        let turn = z.atan2(x) / std::f64::consts::TAU;
        (turn.rem_euclid(1.0) * 16.0) as usize % 16
    }
}

/// Which of 16 cells of equal probability θ is in.
fn along([x, y, z]: Direction, claim: &Claim) -> usize {
    let sin = if claim.planar { x } else { x.hypot(z) };
    let (tail, upper) = claim.tail(y, sin);
    let cell = ((tail * 16.0) as usize).min(7);
    if upper { 15 - cell } else { cell }
}

/// What a subject fails with a generator.
fn failures(subject: &Subject, generator: &mut Generator) -> Vec<String> {
    let Subject { claim, draw } = subject;
    let sides = if claim.planar { 2 } else { 16 };
    let mut theta = [0; 16];
    let mut side = vec![0; sides];
    let mut both = vec![0; 4 * sides];
    let mut pairs = [0; 16];
    let mut before = 0;
    let mut rng = from_fn(&mut generator.next);
    for i in 0..N {
        let direction = draw(&mut rng);
        let (a, t) = (around(direction, claim.planar), along(direction, claim));
        theta[t] += 1;
        side[a] += 1;
        // In the plane the sign is part of θ: its distance from the axis is not.
        let far = if claim.planar {
            t.min(15 - t) / 2
        } else {
            t / 4
        };
        both[4 * a + far] += 1;
        let quarter = 4 * a / sides;
        if i % 2 == 1 {
            pairs[4 * before + quarter] += 1;
        }
        before = quarter;
    }
    // Signs know two of the four quarters.
    let pairs: Vec<u32> = if claim.planar {
        [0, 2, 8, 10].map(|i| pairs[i]).into()
    } else {
        pairs.into()
    };
    let of = |what, counts: &[u32]| (what, uneven(counts));
    let tests = [
        of("side", &side),
        of("theta", &theta),
        of("theta and side", &both),
        of("neighbours", &pairs),
    ];
    let judged = if generator.independent { 4 } else { 1 };
    let failed = tests[..judged]
        .iter()
        .filter(|(_, [uneven, even])| *uneven < ALARM || (generator.independent && *even < ALARM));
    let name = &claim.name;
    failed
        .map(|(what, p)| format!("{name} from {}: {what} {p:?}", generator.name))
        .collect()
}

struct Collect(Vec<Subject>);

impl<T: Number> LawVisitor<T> for Collect {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        let draw: Draw = Box::new(move |rng| {
            let [x, y] = law.sample(rng).map(Into::into);
            [x, y, 0.0]
        });
        self.0.push(Subject { claim, draw });
    }

    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        let draw: Draw = Box::new(move |rng| law.sample(rng).map(Into::into));
        self.0.push(Subject { claim, draw });
    }
}

impl Collect {
    fn integers<F: Format>(&mut self, id: Id, draw: Draw) {
        let moments = moments::<f64>(id).expect("an exponent");
        let claim = F::claim(&id.to_string(), id.planar(), id.exponent(), moments);
        self.0.push(Subject { claim, draw });
    }
}

impl IntegerVisitor for Collect {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        self.integers::<Long>(L::ID, Box::new(move |rng| Long::sample(law, rng)));
        self.integers::<Short>(L::ID, Box::new(move |rng| Short::sample(law, rng)));
    }
}

impl NumberVisitor for Collect {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &EXPONENTS);
    }
}

/// Every law in every number type.
fn subjects() -> Vec<Subject> {
    let mut all = Collect(Vec::new());
    every_number(&mut all);
    every_integer_law(&mut all);
    for k in EXPONENTS {
        let law = Fixed(CosPower::new(k.to_fixed::<U16F16>()));
        let draw: Draw = Box::new(move |rng| direction(&law.sample(rng)));
        all.integers::<Long>(Id::CosPower(k), draw);
    }
    all.0
}

#[test]
fn low_bits_decide_nothing() {
    let mut failed = Vec::new();
    for subject in subjects() {
        for mut generator in generators() {
            failed.extend(failures(&subject, &mut generator));
        }
    }
    assert!(failed.is_empty(), "{failed:#?}");
}

/// What the test is for: a sign from the lowest bit, and an azimuth from the lower half of a word.
#[test]
fn low_bits_are_found_out() {
    let arc = |bit: u32| -> Draw {
        Box::new(move |rng| {
            let word = rng.next_u32();
            let [x, y, z] = Long::sample(CircleArc, &mut from_fn(|| word >> 1));
            [if word >> bit & 1 == 0 { x } else { -x }, y, z]
        })
    };
    let claim = Claim::new::<f64>("CircleArc", true, 0.0, CircleArc.moments());
    let [mut lcg, ..] = generators();
    let low = Subject {
        claim,
        draw: arc(0),
    };
    assert!(!failures(&low, &mut lcg).is_empty());
}
