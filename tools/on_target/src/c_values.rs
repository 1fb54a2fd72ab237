//! What the C program has to print: a hash of the same calls, made in Rust, for each function.

use crate::c_integers;
use coslobe::self_test::{self, Alarm, Fault, Subject, Test};
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Fast, Lambert, Law, Planar, PlanarPoint,
    Radius, Real, Spatial, SpatialPoint, SphereShell,
};
use rand_pcg::Pcg32;

/// As in test/main.c.
pub(crate) const INPUTS: [u32; 23] = [
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
const NORMAL: [f32; 3] = [0.6, 0.0, -0.8];
const RADIUS: f32 = 2.5;
/// The header's statuses.
const NULL_POINTER: i32 = -1;
const FAULT: i32 = -4;
/// What the program's generator returns when it fails.
const FAILURE: i32 = 7;

/// All lines, in the order of their names.
pub(crate) fn expected() -> String {
    let mut lines = Lines::default();
    floats::<f32>(&mut lines, "f32");
    floats::<Fast<f32>>(&mut lines, "fast");
    c_integers::expected(&mut lines);
    lines.sorted("refused as documented\n")
}

/// The lines of `output` in that order.
pub(crate) fn sorted(output: &str) -> String {
    let mut lines: Vec<_> = output.lines().collect();
    lines.sort_unstable();
    lines.iter().map(|line| format!("{line}\n")).collect()
}

#[derive(Default)]
pub(crate) struct Lines(String);

impl Lines {
    /// FNV-1a over `words`.
    pub(crate) fn add(
        &mut self,
        law: &str,
        op: &str,
        number: &str,
        words: impl IntoIterator<Item = u32>,
    ) {
        let hash = words.into_iter().fold(2_166_136_261, |hash: u32, word| {
            (hash ^ word).wrapping_mul(16_777_619)
        });
        self.0 += &format!("coslobe_{law}_{op}_{number} {hash:08x}\n");
    }

    fn sorted(self, last: &str) -> String {
        sorted(&(self.0 + last))
    }

    /// A drawing function's line: sixteen draws, a failure, two null pointers, nothing written.
    pub(crate) fn draws(&mut self, law: &str, op: &str, number: &str, draws: Vec<Vec<u32>>) {
        let nothing = vec![0; draws[0].len()];
        let drawn = draws
            .into_iter()
            .flat_map(|words| [vec![0], words].concat());
        let refused = [FAILURE, NULL_POINTER, NULL_POINTER].map(i32::cast_unsigned);
        self.add(law, op, number, drawn.chain(refused).chain(nothing));
    }

    /// The line of `warp_direction`: each with its status, then a null pointer.
    pub(crate) fn directions(
        &mut self,
        law: &str,
        number: &str,
        warped: impl Iterator<Item = Vec<u32>>,
    ) {
        let words = warped.flat_map(|words| [vec![0], words].concat());
        let null = NULL_POINTER.cast_unsigned();
        self.add(law, "warp_direction", number, words.chain([null]));
    }

    /// A self-test's line: a good generator, one that fails, one that is stuck, none.
    pub(crate) fn self_test<S: Subject + Clone>(
        &mut self,
        law: &str,
        number: &str,
        mut check: Test<S>,
    ) {
        let mut stuck = check.clone();
        check.run(&mut rng(), self_test::SAMPLES);
        let good = check.verdict(Alarm::OneInBillion).map_or(FAULT, |_| 0);
        stuck.run(&mut Stuck, self_test::SAMPLES);
        let why = match stuck.verdict(Alarm::OneInBillion) {
            Err(Fault::Repeats { sample, period }) => [2, sample.into(), period.into()],
            Err(Fault::Invalid { sample, .. }) => [1, sample.into(), 0],
            other => panic!("a stuck generator passes as {other:?}"),
        };
        let statuses = [good, FAILURE, FAULT].map(i32::cast_unsigned);
        let words = statuses.into_iter().chain(why);
        self.add(
            law,
            "self_test",
            number,
            words.chain([NULL_POINTER.cast_unsigned()]),
        );
    }
}

/// The program's generator.
pub(crate) fn rng() -> Pcg32 {
    Pcg32::new(2024, 1)
}

struct Stuck;

impl coslobe::rand_core::TryRng for Stuck {
    type Error = core::convert::Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Self::Error> {
        Ok(0x1234_5678)
    }
    fn try_next_u64(&mut self) -> Result<u64, Self::Error> {
        Ok(0x1234_5678_1234_5678)
    }
    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Self::Error> {
        unreachable!("no law asks for bytes")
    }
}

/// A float type that C knows as `float`.
trait Float: Real {
    fn of(x: f32) -> Self;
    fn bits(self) -> u32;
}

impl Float for f32 {
    fn of(x: f32) -> f32 {
        x
    }
    fn bits(self) -> u32 {
        if self.is_nan() {
            0x7fc0_0000
        } else {
            self.to_bits()
        }
    }
}

impl Float for Fast<f32> {
    fn of(x: f32) -> Self {
        Fast(x)
    }
    fn bits(self) -> u32 {
        self.0.bits()
    }
}

fn inputs<T: Float>() -> impl Iterator<Item = T> {
    INPUTS.into_iter().map(|x| T::of(f32::from_bits(x)))
}

fn floats<T: Float>(lines: &mut Lines, number: &str) {
    planar::<T, _>(lines, "disk", number, Disk);
    planar::<T, _>(lines, "circle_shell", number, CircleShell);
    planar::<T, _>(lines, "circle_arc", number, CircleArc);
    spatial::<T, _>(lines, "ball", number, Ball);
    spatial::<T, _>(lines, "sphere_shell", number, SphereShell);
    spatial::<T, _>(lines, "lambert", number, Lambert);
    point3::<T>(lines, "ball", number, |rho, rng| {
        Ball.sample_point(rho, rng)
    });
    point3::<T>(lines, "sphere_shell", number, |rho, rng| {
        SphereShell.sample_point(rho, rng)
    });
    point3::<T>(lines, "lambert", number, |rho, rng| {
        Lambert.sample_point(rho, rng)
    });
    let lobe = CosPower::new(T::of(7.3)).expect("7.3 is an exponent");
    spatial::<T, _>(lines, "cos_power", number, lobe);
}

fn values<T: Float>(lines: &mut Lines, law: &str, number: &str, l: &impl Law<T>) {
    let mut of_number = |op: &str, f: &dyn Fn(T) -> T| {
        lines.add(law, op, number, inputs().map(|x| f(x).bits()));
    };
    of_number("pdf", &|x| l.pdf(x));
    of_number("ln_pdf", &|x| l.ln_pdf(x));
    of_number("cdf", &|x| l.cdf(x));
    of_number("sf", &|x| l.sf(x));
    of_number("quantile", &|x| l.quantile(x));
    of_number("isf", &|x| l.isf(x));
    let mut to_pair = |op: &str, f: &dyn Fn(T) -> CosSin<T>| {
        let words = inputs()
            .map(f)
            .flat_map(|at| [at.cos.bits(), at.sin.bits()]);
        lines.add(law, op, number, words);
    };
    to_pair("warp", &|x| l.warp(x));
    to_pair("warp_sf", &|x| l.warp_sf(x));
    let mut of_pair = |op: &str, f: &dyn Fn(CosSin<T>) -> T| {
        let pairs = inputs().flat_map(|cos| inputs().map(move |sin| CosSin { cos, sin }));
        lines.add(law, op, number, pairs.map(|at| f(at).bits()));
    };
    of_pair("unwarp", &|at| l.unwarp(at));
    of_pair("unwarp_sf", &|at| l.unwarp_sf(at));
    of_pair("density", &|at| l.density(at));
    of_pair("lambert_weight", &|at| l.lambert_weight(at));
}

fn bits<T: Float, const N: usize>(d: [T; N]) -> Vec<u32> {
    d.map(T::bits).to_vec()
}

/// Sixteen of what `draw` draws.
pub(crate) fn sixteen(mut draw: impl FnMut(&mut Pcg32) -> Vec<u32>) -> Vec<Vec<u32>> {
    let mut rng = rng();
    (0..16).map(|_| draw(&mut rng)).collect()
}

/// Three at a time.
pub(crate) fn filled(mut draw: impl FnMut(&mut Pcg32) -> Vec<u32>) -> Vec<Vec<u32>> {
    sixteen(|rng| [draw(rng), draw(rng), draw(rng)].concat())
}

fn planar<T: Float, L>(lines: &mut Lines, law: &str, number: &str, l: L)
where
    L: Planar<T> + PlanarPoint<T> + Clone,
{
    values(lines, law, number, &l);
    let draw = |rng: &mut Pcg32| bits(l.sample(rng));
    lines.draws(law, "sample", number, sixteen(draw));
    lines.draws(law, "fill", number, filled(draw));
    let rho = Radius::new(T::of(RADIUS)).expect("a radius");
    lines.draws(
        law,
        "point",
        number,
        sixteen(|rng| bits(l.sample_point(rho, rng))),
    );
    lines.self_test(law, number, self_test::planar::<T, _>(l.clone()));
}

fn point3<T: Float>(
    lines: &mut Lines,
    law: &str,
    number: &str,
    draw: impl Fn(Radius<T>, &mut Pcg32) -> [T; 3],
) {
    let rho = Radius::new(T::of(RADIUS)).expect("a radius");
    lines.draws(law, "point", number, sixteen(|rng| bits(draw(rho, rng))));
}

fn spatial<T: Float, L: Spatial<T> + Clone>(lines: &mut Lines, law: &str, number: &str, l: L) {
    values(lines, law, number, &l);
    let words = inputs().map(|x: T| l.pdf_solid_angle(x).bits());
    lines.add(law, "pdf_solid_angle", number, words);
    let draw = |rng: &mut Pcg32| bits(l.sample(rng));
    lines.draws(law, "sample", number, sixteen(draw));
    lines.draws(law, "fill", number, filled(draw));
    let normal = NORMAL.map(T::of);
    let around = sixteen(|rng| bits(l.sample_around(normal, rng)));
    lines.draws(law, "sample_around", number, around);
    let square = inputs().flat_map(|p: T| inputs().map(move |turn| [p, turn]));
    lines.directions(law, number, square.map(|u| bits(l.warp_direction(u))));
    lines.self_test(law, number, self_test::spatial::<T, _>(l.clone()));
}
