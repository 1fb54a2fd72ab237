//! A probability by both its tails.

/// A probability and what it lacks of 1, in Q32; 1 saturates to 1 − 2⁻³².
#[derive(Clone, Copy)]
pub struct Tails {
    pub(crate) lower: u32,
    pub(crate) upper: u32,
}

impl Tails {
    #[inline(always)]
    pub(crate) fn from_lower(lower: u32) -> Self {
        let upper = (!lower).saturating_add(1);
        Tails { lower, upper }
    }

    #[inline(always)]
    pub(crate) fn swapped(self) -> Self {
        Tails {
            lower: self.upper,
            upper: self.lower,
        }
    }

    #[inline(always)]
    pub(crate) fn from_upper(upper: u32) -> Self {
        Tails::from_lower(upper).swapped()
    }

    /// Below and above the whole support.
    pub(crate) const BELOW: Tails = Tails {
        lower: 0,
        upper: u32::MAX,
    };
    pub(crate) const ABOVE: Tails = Tails {
        lower: u32::MAX,
        upper: 0,
    };
}
