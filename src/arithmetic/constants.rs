//! The constants of the laws' formulas, in any arithmetic.

/// Constants with all digits that the arithmetic holds.
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
