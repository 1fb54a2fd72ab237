//! What each law claims, in `f64` closed forms that share nothing with the crate.

use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, Disk, Fast, Lambert, Law, Moments, PlanarPoint,
    Precise, Real, Spatial, SpatialPoint, SphereShell,
};
use std::f64::consts::{PI, TAU};

/// Calls of `next_u32` and `next_u64`.
pub type Drawn = (usize, usize);

pub trait Float: Real + Into<f64> {
    const NAME: &'static str;
    const EPSILON: f64;
    /// How far from 1 a direction's length may be: 2 ulp just above 1, or what the type promises.
    const LENGTH: f64 = 2.0 * Self::EPSILON;
    /// Relative error of a direction's components.
    const ERROR: f64 = Self::EPSILON;
    /// Distance of neighbouring cosines, relative to them.
    const GRID: f64 = Self::EPSILON;
    /// Calls of `next_u32` and `next_u64` for one probability, and for one azimuth.
    const TAIL_WORDS: Drawn;
    const TURN_WORDS: Drawn;
    const SMALLEST: Self;
    const LARGEST: Self;
    fn of(x: f64) -> Self;
    fn bits(self) -> u64;
}

impl Float for f32 {
    const NAME: &'static str = "f32";
    const EPSILON: f64 = f32::EPSILON as f64;
    const TAIL_WORDS: Drawn = (0, 1);
    const TURN_WORDS: Drawn = (1, 0);
    const SMALLEST: f32 = f32::MIN_POSITIVE;
    const LARGEST: f32 = f32::MAX;
    fn of(x: f64) -> f32 {
        x as f32
    }
    fn bits(self) -> u64 {
        self.to_bits().into()
    }
}

impl Float for f64 {
    const NAME: &'static str = "f64";
    const EPSILON: f64 = f64::EPSILON;
    const TAIL_WORDS: Drawn = (0, 2);
    const TURN_WORDS: Drawn = (0, 1);
    const SMALLEST: f64 = f64::MIN_POSITIVE;
    const LARGEST: f64 = f64::MAX;
    fn of(x: f64) -> f64 {
        x
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

impl<T: Float> Float for Precise<T>
where
    Precise<T>: Real + Into<f64>,
{
    const NAME: &'static str = if size_of::<T>() == 4 {
        "Precise<f32>"
    } else {
        "Precise<f64>"
    };
    const EPSILON: f64 = T::EPSILON;
    const TAIL_WORDS: Drawn = T::TAIL_WORDS;
    const TURN_WORDS: Drawn = T::TURN_WORDS;
    const SMALLEST: Self = Precise(T::SMALLEST);
    const LARGEST: Self = Precise(T::LARGEST);
    fn of(x: f64) -> Self {
        Precise(T::of(x))
    }
    fn bits(self) -> u64 {
        self.0.bits()
    }
}

impl Float for Fast<f32> {
    const NAME: &'static str = "Fast<f32>";
    const EPSILON: f64 = f32::EPSILON as f64;
    const LENGTH: f64 = 1.0 / 4096.0;
    const ERROR: f64 = 1.0 / 4096.0;
    const GRID: f64 = 1.0 / 32768.0; // its roots have 16 bits
    const TAIL_WORDS: Drawn = (1, 0);
    const TURN_WORDS: Drawn = (1, 0);
    const SMALLEST: Self = Fast(f32::MIN_POSITIVE);
    const LARGEST: Self = Fast(f32::MAX);
    fn of(x: f64) -> Self {
        Fast(x as f32)
    }
    fn bits(self) -> u64 {
        self.0.bits()
    }
}

/// A direction as \[x, y, z\], y along the axis; z = 0 in the plane.
pub type Direction = [f64; 3];

/// A law p ∝ cosᵏθ with its moments as the crate has them.
#[derive(Clone)]
pub struct Claim {
    pub name: String,
    pub planar: bool,
    pub k: f64,
    pub moments: Moments<f64>,
    /// Precision of the number type.
    pub epsilon: f64,
    /// [`Float::LENGTH`], [`Float::ERROR`] and [`Float::GRID`].
    pub length: f64,
    pub error: f64,
    pub grid: f64,
}

impl Claim {
    pub fn new<T: Float>(name: &str, planar: bool, k: f64, m: Moments<T>) -> Self {
        Claim {
            name: format!("{name} {}", T::NAME),
            planar,
            k,
            moments: Moments {
                mean_cos: m.mean_cos.into(),
                var_cos: m.var_cos.into(),
                mean_theta: m.mean_theta.into(),
                var_theta: m.var_theta.into(),
                entropy: m.entropy.into(),
            },
            epsilon: T::EPSILON,
            length: T::LENGTH,
            error: T::ERROR,
            grid: T::GRID,
        }
    }

    /// Relative error of the nearer tail, and of −k ln cos θ + 1, for that of the smaller component.
    pub fn slack(&self, cos: f64, sin: f64) -> f64 {
        let tangent = sin / cos;
        self.error * (2.0f64).max((self.k + 1.0) * (tangent * tangent).min(1.0))
    }

    /// (smaller of cdf and sf of θ, whether it is the sf), from the smaller of cos θ and |sin θ|.
    pub fn tail(&self, cos: f64, sin: f64) -> (f64, bool) {
        if self.planar {
            (self.planar_tail(cos, sin.abs()), sin > 0.0)
        } else {
            let power = (self.k + 1.0) * ln_cos(cos, sin);
            let (lower, upper) = (-power.exp_m1(), power.exp());
            (lower.min(upper), upper < lower)
        }
    }

    fn planar_tail(&self, cos: f64, sin: f64) -> f64 {
        let from_end = cos.atan2(sin);
        match self.k {
            0.0 => from_end / PI,
            1.0 => cos * cos / (2.0 * (1.0 + sin)),
            2.0 => minus_sine(2.0 * from_end) / TAU,
            k => panic!("no closed form for k = {k} in the plane"),
        }
    }

    /// −ln p of a direction, per radian or per steradian.
    pub fn surprise(&self, cos: f64, sin: f64) -> f64 {
        let scale = match (self.planar, self.k) {
            (false, k) => (k + 1.0) / TAU,
            (true, 0.0) => 1.0 / PI,
            (true, 1.0) => 0.5,
            (true, _) => 2.0 / PI,
        };
        -scale.ln() - self.k * ln_cos(cos, sin)
    }
}

fn ln_cos(cos: f64, sin: f64) -> f64 {
    if cos < sin.abs() {
        cos.ln()
    } else {
        0.5 * (-sin * sin).ln_1p()
    }
}

/// y − sin y; by its series where the difference would lose digits.
fn minus_sine(y: f64) -> f64 {
    if y > 0.5 {
        return y - y.sin();
    }
    let mut term = y * y * y / 6.0;
    let mut sum = 0.0;
    for n in 2..10 {
        sum += term;
        term *= -y * y / f64::from((2 * n) * (2 * n + 1));
    }
    sum
}

/// Visits every law with its own type.
pub trait Visitor<T: Float> {
    fn planar<L: PlanarPoint<T> + Copy + 'static>(&mut self, claim: Claim, law: L);
    fn spatial<L: Spatial<T> + Copy + 'static>(&mut self, claim: Claim, law: L);
    /// A spatial law that has a point.
    fn tangent<L: SpatialPoint<T> + Copy + 'static>(&mut self, claim: Claim, law: L) {
        self.spatial(claim, law);
    }
}

pub fn each<T: Float>(visitor: &mut impl Visitor<T>, exponents: &[f64]) {
    let planar = |name, k, moments| Claim::new::<T>(name, true, k, moments);
    let spatial = |name: &str, k, moments| Claim::new::<T>(name, false, k, moments);
    visitor.planar(planar("Disk", 2.0, Disk.moments()), Disk);
    visitor.planar(
        planar("CircleShell", 1.0, CircleShell.moments()),
        CircleShell,
    );
    visitor.planar(planar("CircleArc", 0.0, CircleArc.moments()), CircleArc);
    visitor.tangent(spatial("Ball", 3.0, Ball.moments()), Ball);
    visitor.tangent(
        spatial("SphereShell", 2.0, SphereShell.moments()),
        SphereShell,
    );
    visitor.tangent(spatial("Lambert", 1.0, Lambert.moments()), Lambert);
    for &k in exponents {
        let (name, k) = (format!("CosPower({k})"), T::of(k));
        let law = CosPower::new(k).expect("a finite exponent");
        visitor.spatial(spatial(&name, k.into(), law.moments()), law);
    }
}
