//! A law in a number type, by what can be hashed of it.

use crate::Number;
use coslobe::{CosSin, Law};
use rand_pcg::Pcg32;

/// Takes results one by one.
pub trait Sink {
    /// Whether a sample's words are wanted before it.
    const NAMES_INPUTS: bool;

    /// A result and the operation it is of.
    fn take(&mut self, operation: &'static str, bits: u64);
}

/// A law in a number type.
pub trait Subject {
    /// The law's name.
    const LAW: &'static str;
    /// The number type's name.
    const NUMBER: &'static str;

    /// One sample.
    fn sample(&self, rng: &mut Pcg32, sink: &mut impl Sink);

    /// Every operation on input number `index`.
    fn evaluate(&self, index: u32, sink: &mut impl Sink);
}

/// What laws of the plane and of space share.
#[inline]
pub(crate) fn evaluate<T: Number>(
    law: &impl Law<T>,
    input: &crate::input::Input<T>,
    sink: &mut impl Sink,
) {
    let x = input.x;
    sink.take("x", x.bits());
    sink.take("pdf(x)", law.pdf(x).bits());
    sink.take("ln_pdf(x)", law.ln_pdf(x).bits());
    sink.take("cdf(x)", law.cdf(x).bits());
    sink.take("sf(x)", law.sf(x).bits());
    sink.take("quantile(x)", law.quantile(x).bits());
    sink.take("isf(x)", law.isf(x).bits());
    let (mut at, far) = (law.warp(x), law.warp_sf(x));
    sink.take("warp(x).cos", at.cos.bits());
    sink.take("warp(x).sin", at.sin.bits());
    sink.take("warp_sf(x).cos", far.cos.bits());
    sink.take("warp_sf(x).sin", far.sin.bits());
    if input.hostile {
        at = CosSin {
            cos: x,
            sin: input.y,
        };
        sink.take("y", at.sin.bits());
    }
    // Of warp(x), or of (cos, sin) = (x, y) where y is named before it.
    sink.take("density(at)", law.density(at).bits());
    sink.take("unwarp(at)", law.unwarp(at).bits());
    sink.take("unwarp_sf(at)", law.unwarp_sf(at).bits());
    sink.take("lambert_weight(at)", law.lambert_weight(at).bits());
}

/// The moments, which have no input.
pub(crate) fn moments<T: Number>(law: &impl Law<T>, sink: &mut impl Sink) {
    let m = law.moments();
    sink.take("moments().mean_cos", m.mean_cos.bits());
    sink.take("moments().var_cos", m.var_cos.bits());
    sink.take("moments().mean_theta", m.mean_theta.bits());
    sink.take("moments().var_theta", m.var_theta.bits());
    sink.take("moments().entropy", m.entropy.bits());
}
