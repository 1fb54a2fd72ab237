//! Components of directions of `Precise` are rounded once: correctly in f32, to 0.55 ulp in f64.

use coslobe::uniform::{TailBits, TurnBits, tails_from_bits};
use coslobe::{Lambert, Precise, Spatial};
use kit::accuracy::format::{Format, ulp};
use kit::accuracy::inverse::warp;
use kit::accuracy::reference::{Direction, Formula, Id};
use kit::accuracy::wide::Wide;
use kit::catalogue::every_law;
use kit::{LawVisitor, Number, PlanarLaw, SpatialLaw};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

pub(crate) type Fine<T> = <<T as Number>::Raw as Format>::Fine;

/// |got − want| in ulps of `want`.
pub(crate) fn error<T: Number>(got: T, want: Fine<T>) -> f64 {
    let near = want.near();
    let lift = if near.abs() < 1e-200 { 600 } else { 0 };
    let apart = (want - Fine::<T>::of(got.wide())).lifted(lift).hi.abs();
    apart / (ulp::<T::Raw>(near) * 2f64.powi(lift))
}

struct Worst<T: Number> {
    allowed: f64,
    worst: f64,
    number: std::marker::PhantomData<T>,
}

impl<T: Number> Worst<T> {
    fn judge(&mut self, got: T, want: Fine<T>, place: &dyn Fn() -> String) {
        let off = error(got, want);
        assert!(off <= self.allowed, "{}: {off} ulp", place());
        self.worst = self.worst.max(off);
    }
}

/// (cos φ, sin φ) at hi + lo turns.
pub(crate) fn azimuth<W: Wide>(hi: f64, lo: f64) -> (W, W) {
    let quarter = (hi * 4.0).round();
    let x = W::of(hi - quarter / 4.0) + W::of(lo);
    let negative = x < W::default();
    let (s, c) = (if negative { -x } else { x } * W::pi() * W::of(2.0)).sin_cos();
    let s = if negative { -s } else { s };
    match quarter as i32 & 3 {
        0 => (c, s),
        1 => (-s, c),
        2 => (-c, -s),
        _ => (s, -c),
    }
}

/// True components at the nearer tail p and an azimuth.
pub(crate) fn components<W: Wide>(id: Id, p: f64, upper: bool, (cos, sin): (W, W)) -> [W; 3] {
    let at = warp::<W>(id, p, upper);
    [at.1 * cos, at.0, at.1 * sin]
}

pub(crate) trait Words: Number {
    fn words(rng: &mut Pcg64) -> (TailBits<Self>, TurnBits<Self>);
    /// n + ½ parts of the whole turn, in turns.
    fn turn(bits: TurnBits<Self>) -> (f64, f64);
    /// The word of θ as two numbers, each of half its bits at the left.
    fn halves(theta: TailBits<Self>) -> [u64; 2];
}

/// The law whose warp a sample is, with the nearer tail and whether it is the upper one: of two
/// uniforms the larger, or the square of one, is Lambert's cos²θ.
pub(crate) fn drawn_tail<T: Words>(id: Id, theta: TailBits<T>) -> (Id, T, bool) {
    if !id.has_two_uniforms() {
        let tails = tails_from_bits::<T>(theta);
        let upper = tails.upper() < tails.lower();
        let nearer = if upper { tails.upper() } else { tails.lower() };
        return (id, nearer, upper);
    }
    let [u, v] = T::halves(theta);
    let square = ((u128::from(v) * u128::from(v)) >> 64) as u64;
    let n = u.max(if id == Id::Ball { v } else { square });
    let upper = n >> 63 == 0;
    // The number and a half, in units of the last bit of half a word.
    let unit = 8 * size_of::<TailBits<T>>() as u32 / 2;
    let whole = (if upper { n } else { !n }) >> (64 - unit);
    let halves = whole << 1 | 1;
    let p = T::of(halves as f64 * 0.5f64.powi(unit as i32 + 1));
    (Id::Lambert, p, upper)
}

impl Words for Precise<f32> {
    fn words(rng: &mut Pcg64) -> (u64, u32) {
        (rng.next_u64() >> (rng.next_u32() & 31), rng.next_u32())
    }
    fn turn(bits: u32) -> (f64, f64) {
        ((f64::from(bits) + 0.5) / 2f64.powi(32), 0.0)
    }
    fn halves(theta: u64) -> [u64; 2] {
        [theta >> 32 << 32, theta << 32]
    }
}

impl Words for Precise<f64> {
    fn words(rng: &mut Pcg64) -> (u128, u64) {
        let high = u128::from(rng.next_u64() >> (rng.next_u32() & 31));
        (high << 64 | u128::from(rng.next_u64()), rng.next_u64())
    }
    fn turn(bits: u64) -> (f64, f64) {
        let (high, low) = (bits >> 32, bits & 0xFFFF_FFFF);
        let part = |n: u64, power| (n as f64) * 2f64.powi(power);
        (part(high, -32), part(2 * low + 1, -65))
    }
    fn halves(theta: u128) -> [u64; 2] {
        [(theta >> 64) as u64, theta as u64]
    }
}

fn directions<T: Words>(id: Id, law: impl Spatial<T>, allowed: f64) {
    let mut rng = Pcg64::seed_from_u64(29);
    let mut worst = Worst::<T> {
        allowed,
        worst: 0.0,
        number: Default::default(),
    };
    let one = T::of(1.0).bits();
    for i in 0..20_000 {
        // Probabilities evenly, and by their exponents.
        let mut number = || match i % 2 {
            0 => T::of_bits(rng.next_u64() % (one + 1)),
            _ => T::of((rng.next_u64() >> 11) as f64 * 2f64.powi(-53)),
        };
        let u = [number(), number()];
        let nearer = u[0].wide().min(1.0 - u[0].wide());
        let upper = u[0].wide() > 0.5;
        let want = components(id, nearer, upper, azimuth::<Fine<T>>(u[1].wide(), 0.0));
        let place = || format!("{id:?} {} u {u:?}", T::NAME);
        let got = law.warp_direction(u);
        (0..3).for_each(|i| worst.judge(got[i], want[i], &place));

        let (theta, phi) = T::words(&mut rng);
        let (drawn, nearer, upper) = drawn_tail::<T>(id, theta);
        let (hi, lo) = T::turn(phi);
        let want = components(drawn, nearer.wide(), upper, azimuth::<Fine<T>>(hi, lo));
        let place = || format!("{id:?} {} tail {nearer:?} turn {hi:e}", T::NAME);
        let got = law.sample_from_bits(theta, phi);
        (0..3).for_each(|i| worst.judge(got[i], want[i], &place));

        // Back again, from the three rounded components.
        let [x, cos, z] = got.map(|c| Fine::<T>::of(c.wide()));
        let sin = (x * x + z * z).root();
        let place = || format!("{id:?} {} unwarp of {got:?}", T::NAME);
        let unwarped = law.unwarp_direction(got);
        let one = Fine::<T>::of(1.0);
        let at = if cos <= sin {
            Direction::pair(cos, (one - cos * cos).root())
        } else {
            Direction::pair((one - sin * sin).root(), sin)
        };
        worst.judge(unwarped[0], Formula::new(id).tails(&at).0, &place);
        let absolute = |w: Fine<T>| if w < Fine::<T>::default() { -w } else { w };
        let angle = Fine::<T>::angle(absolute(x) / sin, absolute(z) / sin);
        let half = angle / (Fine::<T>::pi() * Fine::<T>::of(2.0));
        let zero = Fine::<T>::default();
        let turn = match (x < zero, z < zero) {
            (false, false) => half,
            (true, false) => Fine::<T>::of(0.5) - half,
            (true, true) => Fine::<T>::of(0.5) + half,
            (false, true) => one - half,
        };
        worst.judge(unwarped[1], turn, &place);
    }
    println!("{id:?} {}: {:.4} ulp", T::NAME, worst.worst);
}

/// Every law in space, held to this error.
struct Directions(f64);

impl<T: Words> LawVisitor<T> for Directions {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, _: L) {}
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        directions::<T>(id, law, self.0);
    }
}

/// Once the product of two rounded numbers: 1.82 ulp.
#[test]
fn a_component_is_rounded_once() {
    let u = [0x2642_3fc2, 0x3eb1_c138].map(|bits| Precise(f32::from_bits(bits)));
    let turn = azimuth::<Fine<Precise<f32>>>(u[1].wide(), 0.0);
    let want = components(Id::Lambert, u[0].wide(), false, turn);
    let got = Lambert.warp_direction(u);
    assert!(error(got[0], want[0]) <= 0.5, "{got:?}");
}

#[test]
fn f32_directions() {
    every_law::<Precise<f32>>(&mut Directions(0.5 + 1e-9), &[20.0]);
}

#[test]
fn f64_directions() {
    every_law::<Precise<f64>>(&mut Directions(0.55), &[20.0]);
}
