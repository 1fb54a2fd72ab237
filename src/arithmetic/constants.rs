//! Exact constants, in any arithmetic.

/// Exact constants, each as wide as the arithmetic asks.
pub struct Constants<P> {
    pub(crate) half_pi: P,
    pub(crate) two_pi: P,
    pub(crate) pi: P,
    pub(crate) recip_pi: P,
    pub(crate) two_over_pi: P,
    pub(crate) recip_two_pi: P,
    pub(crate) twelve_pi: P,
    pub(crate) three_over_two_pi: P,
    pub(crate) two_over_three_pi: P,
    pub(crate) ln_2: P,
    pub(crate) ln_two_pi: P,
    pub(crate) ln_pi: P,
    pub(crate) ln_two_over_pi: P,
    pub(crate) ln_three_over_two_pi: P,
}
