//! A line for each function of the C program: its name, and a hash of the same calls made in Rust.

use coslobe::CosSin;
use coslobe::self_test::{self, Alarm, Fault, Subject, Test};
use fixed::{FixedI16, FixedI32, FixedU16, FixedU32};
use rand_pcg::Pcg32;

/// As in test/main.c.
const INPUTS: [u32; 23] = [
    0x0000_0000,
    0x8000_0000,
    0x0000_0001,
    0x1e3c_e508,
    0x38d1_b717,
    0x3dcc_cccd,
    0x3e80_0000,
    0x3f00_0000,
    0x3f19_999a,
    0x3f7f_ffff,
    0x3f80_0000,
    0x3f80_0001,
    0x3fc9_0fda,
    0x3fc9_0fdb,
    0xbf00_0000,
    0xbfc9_0fda,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0x3f4c_cccd,
    0x7fff_ffff,
    0x4ccc_cccd,
    0x6666_6666,
];
/// The header's statuses.
const NULL_POINTER: i32 = -1;
const FAULT: i32 = -4;
/// What the program's generator returns when it fails.
const FAILURE: i32 = 7;

/// A number as the program makes it of an input's word, and as it hashes it.
pub(super) trait Word: Copy {
    fn from_word(word: u32) -> Self;
    fn bits(self) -> u32;
}

impl Word for f32 {
    fn from_word(word: u32) -> f32 {
        f32::from_bits(word)
    }
    fn bits(self) -> u32 {
        // Any NaN is one.
        if self.is_nan() {
            0x7fc0_0000
        } else {
            self.to_bits()
        }
    }
}

impl<Frac> Word for FixedU32<Frac> {
    fn from_word(word: u32) -> Self {
        Self::from_bits(word)
    }
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

impl<Frac> Word for FixedI32<Frac> {
    fn from_word(word: u32) -> Self {
        Self::from_bits(word.cast_signed())
    }
    fn bits(self) -> u32 {
        self.to_bits().cast_unsigned()
    }
}

// Of 16 bits the upper half of the word, without its sign.

impl<Frac> Word for FixedU16<Frac> {
    fn from_word(word: u32) -> Self {
        Self::from_bits((word >> 16) as u16)
    }
    fn bits(self) -> u32 {
        self.to_bits().into()
    }
}

impl<Frac> Word for FixedI16<Frac> {
    fn from_word(word: u32) -> Self {
        Self::from_bits(((word >> 16) as u16).cast_signed())
    }
    fn bits(self) -> u32 {
        self.to_bits().cast_unsigned().into()
    }
}

fn inputs<A: Word>() -> impl Iterator<Item = A> {
    INPUTS.into_iter().map(A::from_word)
}

fn pairs<A: Word>() -> impl Iterator<Item = [A; 2]> {
    inputs().flat_map(|a| inputs().map(move |b| [a, b]))
}

fn words<A: Word, const N: usize>(of: [A; N]) -> Vec<u32> {
    of.map(A::bits).to_vec()
}

/// The program's generator.
fn rng() -> Pcg32 {
    Pcg32::new(2024, 1)
}

/// The lines of one law in one number type.
pub(super) struct Lines<'a> {
    pub(super) text: &'a mut String,
    pub(super) law: String,
    pub(super) number: &'static str,
}

impl Lines<'_> {
    /// FNV-1a over `words`.
    fn add(&mut self, op: &str, words: impl IntoIterator<Item = u32>) {
        let hash = words.into_iter().fold(2_166_136_261, |hash: u32, word| {
            (hash ^ word).wrapping_mul(16_777_619)
        });
        let (law, number) = (&self.law, self.number);
        *self.text += &format!("coslobe_{law}_{op}_{number} {hash:08x}\n");
    }

    /// A function of a number.
    pub(super) fn value<A: Word, B: Word>(&mut self, op: &str, f: impl Fn(A) -> B) {
        self.add(op, inputs().map(|x| f(x).bits()));
    }

    /// One that gives a pair.
    pub(super) fn pair<A: Word, B: Word>(&mut self, op: &str, f: impl Fn(A) -> CosSin<B>) {
        let words = inputs().map(f).flat_map(|at| [at.cos, at.sin]);
        self.add(op, words.map(B::bits));
    }

    /// A function of a pair.
    pub(super) fn of_pair<A: Word, B: Word>(&mut self, op: &str, f: impl Fn(CosSin<A>) -> B) {
        let pairs = pairs().map(|[cos, sin]| CosSin { cos, sin });
        self.add(op, pairs.map(|at| f(at).bits()));
    }

    /// A drawing function: sixteen draws, a failure, two null pointers, nothing written.
    pub(super) fn draws<A: Word, const N: usize>(
        &mut self,
        op: &str,
        mut draw: impl FnMut(&mut Pcg32) -> [A; N],
    ) {
        let mut rng = rng();
        self.drawn(op, || words(draw(&mut rng)));
    }

    /// `sample`, and three at a time.
    pub(super) fn sample<A: Word, const N: usize>(
        &mut self,
        draw: impl Fn(&mut Pcg32) -> [A; N] + Copy,
    ) {
        self.draws("sample", draw);
        let mut rng = rng();
        let mut next = || words(draw(&mut rng));
        self.drawn("fill", || [next(), next(), next()].concat());
    }

    fn drawn(&mut self, op: &str, mut draw: impl FnMut() -> Vec<u32>) {
        let draws: Vec<_> = (0..16).map(|_| draw()).collect();
        let nothing = vec![0; draws[0].len()];
        let drawn = draws
            .into_iter()
            .flat_map(|words| [vec![0], words].concat());
        let refused = [FAILURE, NULL_POINTER, NULL_POINTER].map(i32::cast_unsigned);
        self.add(op, drawn.chain(refused).chain(nothing));
    }

    /// `warp_direction`: each with its status, then a null pointer.
    pub(super) fn warped<A: Word, B: Word>(&mut self, f: impl Fn([A; 2]) -> [B; 3]) {
        let all = pairs().flat_map(|u| [vec![0], words(f(u))].concat());
        self.add("warp_direction", all.chain([NULL_POINTER.cast_unsigned()]));
    }

    /// A self-test: a good generator, one that fails, one that is stuck, none.
    pub(super) fn self_test<S: Subject + Clone>(&mut self, mut check: Test<S>) {
        let mut stuck = check.clone();
        check.run(&mut rng(), self_test::SAMPLES);
        let good = check.verdict(Alarm::OneInBillion).map_or(FAULT, |_| 0);
        stuck.run(&mut coslobe::from_fn(|| 0x1234_5678), self_test::SAMPLES);
        let why = match stuck.verdict(Alarm::OneInBillion) {
            Err(Fault::Repeats { sample, period }) => [2, sample.into(), period.into()],
            Err(Fault::Invalid { sample, .. }) => [1, sample.into(), 0],
            other => panic!("a stuck generator passes as {other:?}"),
        };
        let statuses = [good, FAILURE, FAULT].map(i32::cast_unsigned);
        let words = statuses.into_iter().chain(why);
        self.add("self_test", words.chain([NULL_POINTER.cast_unsigned()]));
    }
}
