//! What a test found.

use super::subject::Invalid;
use core::fmt;

/// A table of counts that is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Statistic {
    /// Ones in each of 32 bits of the generator's words; a `u64` counts as two words.
    Bits,
    /// Changes of each of those bits from one word to the next.
    Flips,
    /// φ.
    Azimuth,
    /// θ in eighths.
    Eighths,
    /// θ in finer cells, the finest at both ends.
    Polar,
    /// θ and φ of a sample.
    PolarAzimuth,
    /// θ of a sample and of the next.
    PolarPairs,
    /// φ of a sample and of the next.
    AzimuthPairs,
}

/// A statistic's χ² beside its limits, in tenths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Score {
    /// Which table.
    pub statistic: Statistic,
    /// 10 χ², rounded down.
    pub tenths: u32,
    /// Least value that is believed.
    pub least: u32,
    /// Largest value that is believed.
    pub most: u32,
    /// Degrees of freedom: what χ² is on average.
    pub freedom: u8,
    /// The cell that adds most: of the bits' tables the bit, 0 the lowest.
    pub worst: u8,
}

/// A test that found nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Report {
    /// Samples judged.
    pub samples: u16,
    /// 32-bit words that went through [`run`](super::Test::run).
    pub words: u32,
    /// [`Statistic::Bits`], where words were seen.
    pub bits: Option<Score>,
    /// [`Statistic::Flips`], where words were seen.
    pub flips: Option<Score>,
    /// [`Statistic::Azimuth`], of spatial laws.
    pub azimuth: Option<Score>,
    /// [`Statistic::Eighths`].
    pub eighths: Option<Score>,
    /// [`Statistic::Polar`].
    pub polar: Option<Score>,
    /// [`Statistic::PolarAzimuth`], of spatial laws.
    pub polar_azimuth: Option<Score>,
    /// [`Statistic::PolarPairs`].
    pub polar_pairs: Option<Score>,
    /// [`Statistic::AzimuthPairs`], of spatial laws.
    pub azimuth_pairs: Option<Score>,
}

/// Why the generator or the sampler is not to be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Fault {
    /// A sample that the law cannot give.
    Invalid {
        /// Which, counted from 1.
        sample: u16,
        /// Why not.
        why: Invalid,
    },
    /// Four samples in a row came again: the generator is stuck, or its period is short.
    Repeats {
        /// The last of them, counted from 1.
        sample: u16,
        /// After how many samples they came again.
        period: u16,
    },
    /// Fewer samples than [`FEWEST`](super::FEWEST) allow no verdict.
    TooFew {
        /// How many there were.
        samples: u16,
    },
    /// A χ² above its limit: not this law, or no random words.
    TooUneven(Score),
    /// A χ² below its limit: more even than chance.
    TooEven(Score),
}

impl fmt::Display for Score {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let point = |tenths: u32| (tenths / 10, tenths % 10);
        let ((value, tenth), (least, low), (most, high)) =
            (point(self.tenths), point(self.least), point(self.most));
        write!(
            f,
            "{:?}: χ² = {value}.{tenth} with {} degrees of freedom, \
             expected {least}.{low} to {most}.{high}; most of it in cell {}",
            self.statistic, self.freedom, self.worst
        )
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Invalid { sample, why } => write!(f, "sample {sample} {why}"),
            Fault::Repeats { sample, period } => write!(
                f,
                "the samples up to {sample} repeat those {period} before them"
            ),
            Fault::TooFew { samples } => write!(
                f,
                "{samples} samples allow no verdict; expected at least {}",
                super::FEWEST
            ),
            Fault::TooUneven(score) => write!(f, "too uneven, {score}"),
            Fault::TooEven(score) => write!(f, "too even, {score}"),
        }
    }
}

impl core::error::Error for Fault {}
