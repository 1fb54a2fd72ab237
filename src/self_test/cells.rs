//! Tables of counts and their χ², in integers.

use super::subject::Place;
use core::num::NonZeroU64;

/// Pearson's statistic of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chi2 {
    /// Tenths of χ², rounded down; `u32::MAX` if it is more.
    pub(super) tenths: u32,
    pub(super) freedom: u8,
    /// The cell that adds most to it.
    pub(super) worst: u8,
}

/// χ² · n on its way.
#[derive(Default)]
pub(super) struct Sum {
    total: u64,
    most: u64,
    worst: u8,
}

impl Sum {
    /// Adds (O/p − n)² · p of a cell whose probability is p = 2^−`halvings`: its part of χ² times
    /// n.
    ///
    /// Of 65 535 samples and p ≥ 2⁻¹¹ the square is below 2⁵⁴. Each cell's shift drops less than
    /// 1: of at most 64 cells and n ≥ 1024 together less than a tenth of χ².
    pub(super) fn cell(&mut self, cell: u8, observed: u64, halvings: u32, n: u64) {
        let off = observed.wrapping_shl(halvings).abs_diff(n);
        self.add(cell, off.wrapping_mul(off), halvings);
    }

    pub(super) fn add(&mut self, cell: u8, square: u64, shift: u32) {
        let part = square.wrapping_shr(shift);
        self.total = self.total.saturating_add(part);
        if part > self.most {
            self.most = part;
            self.worst = cell;
        }
    }

    /// The statistic, of `n` counts in all; none of no counts.
    pub(super) fn over(self, n: u64, freedom: u8) -> Option<Chi2> {
        let tenths = self.total.saturating_mul(10) / NonZeroU64::new(n)?;
        Some(Chi2 {
            tenths: u32::try_from(tenths).unwrap_or(u32::MAX),
            freedom,
            worst: self.worst,
        })
    }
}

/// χ² of 2^`halvings` equally likely cells.
fn even(counts: &[u16], halvings: u32) -> Option<Chi2> {
    let n = counts
        .iter()
        .fold(0u64, |sum, &n| sum.wrapping_add(n.into()));
    let mut sum = Sum::default();
    for (cell, &count) in (0..=u8::MAX).zip(counts) {
        sum.cell(cell, count.into(), halvings, n);
    }
    sum.over(n, counts.len().wrapping_sub(1) as u8)
}

/// 16 equal sectors of φ.
#[derive(Clone, Debug, Default)]
pub(super) struct Sectors {
    counts: [u16; 16],
}

impl Sectors {
    pub(super) fn add(&mut self, sector: u8) {
        increment(&mut self.counts, sector.into());
    }

    pub(super) fn chi2(&self) -> Option<Chi2> {
        even(&self.counts, 4)
    }
}

/// Two eighths together.
#[derive(Clone, Debug)]
pub(super) struct Pairs {
    counts: [u16; 64],
}

impl Default for Pairs {
    fn default() -> Self {
        Pairs { counts: [0; 64] }
    }
}

impl Pairs {
    pub(super) fn add(&mut self, a: u8, b: u8) {
        increment(&mut self.counts, usize::from(a) << 3 | usize::from(b));
    }

    pub(super) fn chi2(&self) -> Option<Chi2> {
        even(&self.counts, 6)
    }
}

/// Equal cells of a side: 1/32 each, the one at the end excepted.
const EQUAL: usize = 15;
/// The one at the end, halved: 2⁻⁶, …, 2⁻¹¹ and what is left.
const HALVED: usize = 7;
/// The first halving leaves 2⁻⁵ of the law.
const FIRST: u32 = 5;
/// log₂ of the samples expected in the last cell, at least.
const FULL: u32 = 4;

/// θ by its cdf, finer towards both ends.
#[derive(Clone, Debug, Default)]
pub(super) struct Polar {
    equal: [[u16; EQUAL]; 2],
    halved: [[u16; HALVED]; 2],
}

impl Polar {
    pub(super) fn add(&mut self, place: Place) {
        let side = usize::from(place.upper);
        let cell = (place.tail >> 26) as usize;
        if cell > 0 {
            if let Some(side) = self.equal.get_mut(side) {
                // The tail ½ itself belongs to the last cell.
                increment(side, cell.min(EQUAL) - 1);
            }
        } else if let Some(side) = self.halved.get_mut(side) {
            // 2⁻⁵ of 2³¹ has six zeros in front.
            let halvings = place.tail.leading_zeros().saturating_sub(1 + FIRST);
            increment(side, (halvings as usize).min(HALVED - 1));
        }
    }

    /// The same in eighths alone: fewer degrees of freedom see a smaller change of shape.
    pub(super) fn eighths(&self) -> Option<Chi2> {
        let mut eighths = [0; 8];
        let sides = self.equal.iter().zip(&self.halved);
        for (side, outwards) in sides.zip(eighths.chunks_exact_mut(4)) {
            let (equal, halved) = side;
            // The halved cell is the first of four; sums stay within the number of samples.
            let mut cells = [0; EQUAL + 1];
            let (first, others) = cells.split_at_mut(1);
            first.fill(halved.iter().fold(0u16, |sum, &n| sum.saturating_add(n)));
            others.copy_from_slice(equal);
            for (eighth, four) in outwards.iter_mut().zip(cells.chunks_exact(4)) {
                *eighth = four.iter().fold(0u16, |sum, &n| sum.saturating_add(n));
            }
        }
        even(&eighths, 3)
    }

    /// The finer table: ends halved as often as leaves 2⁴ expected samples.
    pub(super) fn chi2(&self, n: u16) -> Chi2 {
        let depth = (n.max(1).ilog2().saturating_sub(FULL)).clamp(FIRST + 1, FIRST + 6);
        let n = u64::from(n);
        let mut sum = Sum::default();
        let mut cells = 0..=u8::MAX;
        let mut add = |observed: u64, halvings| {
            sum.cell(cells.next().unwrap_or(u8::MAX), observed, halvings, n);
        };
        for (equal, halved) in self.equal.iter().zip(&self.halved) {
            let mut end = 0;
            for (halvings, &count) in (FIRST..FIRST + HALVED as u32).zip(halved) {
                if halvings < depth {
                    add(count.into(), halvings.wrapping_add(1));
                } else {
                    end = u64::wrapping_add(end, count.into());
                }
            }
            add(end, depth);
            for &count in equal {
                add(count.into(), FIRST);
            }
        }
        let cells = (EQUAL as u32 - FIRST + 1).wrapping_add(depth) << 1;
        sum.over(n, cells.wrapping_sub(1) as u8).unwrap_or(Chi2 {
            tenths: 0,
            freedom: 0,
            worst: 0,
        })
    }
}

fn increment(counts: &mut [u16], cell: usize) {
    if let Some(count) = counts.get_mut(cell) {
        *count = count.saturating_add(1);
    }
}

#[cfg(test)]
mod tests {
    use super::{Place, Polar};

    #[test]
    fn every_sample_is_counted() {
        let mut polar = Polar::default();
        for i in 0..64u32 {
            polar.add(Place {
                tail: (1 << 30) >> (i >> 1),
                upper: i & 1 == 1,
                sector: None,
            });
        }
        let count = |cells: &[u16]| cells.iter().sum::<u16>();
        for (equal, halved) in polar.equal.iter().zip(&polar.halved) {
            assert_eq!(count(equal) + count(halved), 32);
        }
    }
}
