//! Periods, by Brent's method: a mark is left behind at every power of two, and compared with.

/// So many samples in a row that come again are no chance, even of 16 bits each: 2⁻⁶⁴ a comparison.
const ROW: usize = 4;

#[derive(Clone, Debug, Default)]
pub(super) struct Repeat {
    last: [u32; ROW],
    mark: [u32; ROW],
    marked_at: u16,
    found: Option<(u16, u16)>,
}

impl Repeat {
    /// Adds the fingerprint of the `n`-th sample, counted from 1.
    pub(super) fn add(&mut self, n: u16, fingerprint: u32) {
        let [_, b, c, d] = self.last;
        self.last = [b, c, d, fingerprint];
        if self.marked_at > 0 && self.found.is_none() && self.last == self.mark {
            self.found = Some((n, n.wrapping_sub(self.marked_at)));
        }
        if n.is_power_of_two() && usize::from(n) >= ROW {
            self.mark = self.last;
            self.marked_at = n;
        }
    }

    /// The sample at which a period was seen, and the period.
    pub(super) fn found(&self) -> Option<(u16, u16)> {
        self.found
    }
}
