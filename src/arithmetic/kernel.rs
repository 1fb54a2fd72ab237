//! What an arithmetic gives the laws' formulas.

use super::constants::Constants;
use crate::scalar::Scalar;
use crate::{CosSin, Tails};

/// An intermediate result; where the arithmetic keeps it, with what rounding took from it.
pub trait Wide<W>: Copy + Send + Sync + 'static {
    fn from_value(x: W) -> Self;
    fn value(self) -> W;
    /// The value as far as one number holds it, without arithmetic.
    fn leading(self) -> W;
    /// a + b.
    fn two_sum(a: W, b: W) -> Self;
    fn neg(self) -> Self;
    /// First-order product: carries the factors' low parts but not the rounding of the product.
    fn times(self, b: Self) -> Self;
    fn mul(self, b: Self) -> Self;
    fn add(self, b: Self) -> Self;
    fn div(self, b: Self) -> Self;
    /// √self, for self that is far from under- and overflow.
    fn sqrt(self) -> W;
}

/// An arithmetic by the kernels that it gives the laws. A law's formula is written once; the
/// arithmetic that runs it decides what it costs and how exact it is.
pub trait Kernel: Scalar {
    type Wide: Wide<Self>;
    /// cos θ as its powers are taken.
    type Cosine: Copy;
    /// A positive factor of a power.
    type Scale: Copy + Send + Sync + 'static;
    /// What n needs for the n-th root of a tail.
    type TailRoot: Copy + Send + Sync + 'static;

    const CONSTANTS: Constants<Self::Wide>;

    /// √f(a), where f(a) is a product or quotient of a, without losing digits where a is subnormal.
    fn sqrt_scaled(a: Self, f: impl Fn(Self) -> Self) -> Self;
    /// ∛self for self ≥ 0.
    fn cbrt(self) -> Self;
    /// [`cbrt`](Kernel::cbrt) of the upper tail with what rounding took; `None` where nothing is
    /// refined, and of a tail so small that cubes would underflow.
    #[inline(always)]
    fn cbrt_wide(_: Tails<Self>) -> Option<Self::Wide> {
        None
    }

    fn ln(self) -> Self;
    /// ln cos θ, from the smaller of cos θ and sin θ.
    fn ln_cos(at: CosSin<Self::Wide>) -> Self;
    /// atan2(self, x).
    fn atan2(self, x: Self) -> Self;
    /// θ of a direction with cos θ ≥ 0.
    #[inline(always)]
    fn angle(at: CosSin<Self>) -> Self {
        at.sin.atan2(at.cos)
    }

    /// π/2 − a for 0 ≤ a ≤ π/2, relatively accurate.
    fn from_end(a: Self) -> Self::Wide;
    /// (cos θ, |sin θ|) for |θ| ≤ π/2.
    fn at_angle(theta: Self) -> CosSin<Self::Wide>;
    /// (cos, sin) at u turns, 0 ≤ u ≤ 1; of other numbers some, of NaN NaN.
    fn at_turn(u: Self) -> CosSin<Self>;
    /// (cos, sin) of the angle πp from an end, 0 ≤ p ≤ ½: cos is that of the angle from the axis.
    fn half_turn(p: Self) -> CosSin<Self>;

    /// Nearer tail of the disk's law at |θ| = a ≤ π/2.
    fn disk_tail_at_angle(a: Self) -> Self;
    /// Nearer tail of the disk's law at a direction, from the smaller of cos θ and |sin θ|.
    fn disk_tail_at_direction(cos: Self, sin: Self) -> Self;
    /// (cos θ, |sin θ|) of the disk's law at nearer tail p.
    fn disk_direction_at_tail(p: Self) -> CosSin<Self>;
    /// |θ| of the disk's law at nearer tail p.
    fn disk_angle_at_tail(p: Self) -> Self;

    /// ln x for finite x > 0.
    fn ln_wide(x: Self::Wide) -> Self::Wide;
    /// cos θ of a direction, from the smaller of cos θ and sin θ.
    fn cosine(at: CosSin<Self>) -> Self::Cosine;
    /// cos θ of an angle 0 ≤ θ ≤ π/2, and sin θ.
    fn cosine_at_angle(theta: Self) -> (Self::Cosine, Self);
    fn scale(x: Self::Wide) -> Self::Scale;
    /// 2/x.
    fn two_over(x: Self::Wide) -> Self::Scale;
    /// `scale`·cosᵏθ·`factor`.
    fn power_times(k: Self::Wide, at: Self::Cosine, scale: Self::Scale, factor: Self) -> Self;
    /// k·ln cos θ + ln sin θ + c, −∞ where one of them is 0.
    fn ln_power_times_sine(k: Self::Wide, at: Self::Cosine, c: Self::Wide) -> Self;
    /// (1 − cosⁿθ, cosⁿθ) for n ≥ 1.
    fn power_tails(n: Self::Wide, at: Self::Cosine) -> (Self, Self);
    fn tail_root(n: Self::Wide) -> Self::TailRoot;
    /// (cos θ, sin θ) with cos²θ = the upper of the tails p.
    #[inline(always)]
    fn square_warp(p: Tails<Self>) -> CosSin<Self> {
        CosSin {
            cos: p.upper().sqrt(),
            sin: p.lower().sqrt(),
        }
    }
    /// (cos θ, sin θ) with cos³θ = the upper of the tails p.
    #[inline(always)]
    fn cube_warp(p: Tails<Self>) -> CosSin<Self> {
        let cos = p.upper().cbrt();
        let ratio = (Self::ONE + cos) / (Self::ONE + cos + cos * cos);
        let sin = Self::sqrt_scaled(p.lower(), |x| x * ratio);
        CosSin { cos, sin }
    }
    /// (cos θ, sin θ) with cos⁴θ = the upper of the tails p.
    #[inline(always)]
    fn fourth_power_warp(p: Tails<Self>) -> CosSin<Self> {
        let square = p.upper().sqrt();
        CosSin {
            cos: square.sqrt(),
            sin: Self::sqrt_scaled(p.lower(), |x| x / (Self::ONE + square)),
        }
    }
    /// (cos θ, sin θ) with cosⁿθ = the upper of the tails p, n ≥ 1.
    fn power_warp(p: Tails<Self>, root: Self::TailRoot) -> CosSin<Self>;
}

/// An arithmetic that keeps nothing beside its numbers, since they have digits to spare or since it
/// does not aim that high, is its own wide type.
impl<W: Kernel<Wide = W>> Wide<W> for W {
    #[inline(always)]
    fn from_value(x: W) -> W {
        x
    }
    #[inline(always)]
    fn value(self) -> W {
        self
    }
    #[inline(always)]
    fn leading(self) -> W {
        self
    }
    #[inline(always)]
    fn two_sum(a: W, b: W) -> W {
        a + b
    }
    #[inline(always)]
    fn neg(self) -> W {
        -self
    }
    #[inline(always)]
    fn times(self, b: W) -> W {
        self * b
    }
    #[inline(always)]
    fn mul(self, b: W) -> W {
        self * b
    }
    #[inline(always)]
    fn add(self, b: W) -> W {
        self + b
    }
    #[inline(always)]
    fn div(self, b: W) -> W {
        self / b
    }
    #[inline(always)]
    fn sqrt(self) -> W {
        Scalar::sqrt(self)
    }
}
