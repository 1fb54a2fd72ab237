//! A power-on self-test: does this generator, through this sampler, yield this law?
//!
//! ```
//! use coslobe::{Lambert, self_test::{self, Alarm}};
//! let mut rng = rand_pcg::Pcg32::new(2024, 1);
//! let mut test = self_test::spatial::<f32, _>(Lambert);
//! test.run(&mut rng, self_test::SAMPLES);
//! let report = test.verdict(Alarm::OneInBillion)?;
//! assert_eq!(report.samples, 16_384);
//! # Ok::<(), coslobe::self_test::Fault>(())
//! ```
//!
//! Samples are counted in cells that the law makes equally likely or that are halved towards both
//! ends of θ, and each table of counts is judged by χ² on both sides: too uneven, or too even to
//! be random. The limits were computed on a host; here everything but the law's own formulas is
//! integers.
//!
//! | statistic | cells | sees |
//! |---|---|---|
//! | [`Bits`](Statistic::Bits), [`Flips`](Statistic::Flips) | each bit of the generator's words, and whether it differs from the word before | stuck, biased and alternating bits, counters |
//! | [`Azimuth`](Statistic::Azimuth) | 16 sectors of φ | a slice left out, a tilted axis |
//! | [`Eighths`](Statistic::Eighths) | 8 of probability 1/8 in θ | a wrong exponent |
//! | [`Polar`](Statistic::Polar) | 30 of probability 1/32, and the two ends halved again and again while 16 samples are expected | a wrong law, wrong tails |
//! | [`PolarAzimuth`](Statistic::PolarAzimuth) | 8 × 8 | θ and φ made of the same bits |
//! | [`PolarPairs`](Statistic::PolarPairs), [`AzimuthPairs`](Statistic::AzimuthPairs) | 8 × 8, of one sample and the next | correlated samples |
//!
//! Besides, every sample must be [valid](Invalid), and no four samples in a row may come again
//! ([`Fault::Repeats`]: any period up to half the number of samples).
//!
//! A sample is placed in its law by [`Law::unwarp_tails`](crate::Law::unwarp_tails). If that were
//! wrong together with the sampler, this test would not see it; tests on a host do.
#![doc = include_str!("../../docs/measured/self_test.md")]

mod cells;
#[cfg(feature = "fixed")]
mod fixed;
mod limits;
mod repeat;
mod report;
mod subject;
mod table;
mod words;

#[cfg(feature = "fixed")]
pub use fixed::{InFixed, fixed};
pub use limits::Alarm;
pub use report::{Fault, Report, Score, Statistic};
pub use subject::{InPlane, InSpace, Invalid, Place, Subject};

use crate::{Planar, Real, Spatial};
use cells::{Pairs, Polar, Sectors};
use limits::judge;
use rand_core::Rng;
use repeat::Repeat;
use words::{Tally, Tap};

/// Samples that a power-on test takes by default.
pub const SAMPLES: u16 = 1 << 14;

/// Fewest samples for a verdict: below it the cells hold too few for χ².
pub const FEWEST: u16 = 1 << 12;

/// Counts samples and judges them; see [the module](self).
///
/// All of it lives where the caller puts it, the stack as a rule: no static memory.
#[derive(Clone, Debug)]
pub struct Test<S> {
    subject: S,
    samples: u16,
    invalid: Option<(u16, Invalid)>,
    repeat: Repeat,
    polar: Polar,
    sectors: Sectors,
    polar_azimuth: Pairs,
    polar_pairs: Pairs,
    azimuth_pairs: Pairs,
    /// Eighths of θ and φ of the sample whose successor completes a pair.
    waiting: Option<(u8, Option<u8>)>,
    words: Tally,
}

/// A test of a law in the plane, sampled in the number type `T`.
pub fn planar<T: Real, L: Planar<T>>(law: L) -> Test<InPlane<T, L>> {
    Test::new(InPlane::new(law))
}

/// A test of a law in space, sampled in the number type `T`.
pub fn spatial<T: Real, L: Spatial<T>>(law: L) -> Test<InSpace<T, L>> {
    Test::new(InSpace::new(law))
}

impl<S: Subject> Test<S> {
    /// An empty test of `subject`: a law by [`InPlane`] or [`InSpace`], or a sampler of your own.
    pub fn new(subject: S) -> Self {
        Test {
            subject,
            samples: 0,
            invalid: None,
            repeat: Repeat::default(),
            polar: Polar::default(),
            sectors: Sectors::default(),
            polar_azimuth: Pairs::default(),
            polar_pairs: Pairs::default(),
            azimuth_pairs: Pairs::default(),
            waiting: None,
            words: Tally::default(),
        }
    }

    /// Draws and counts `samples` samples, and the bits of the words that they took.
    ///
    /// Stops early at what no further sample can mend: an invalid sample, or a period.
    pub fn run<R: Rng + ?Sized>(&mut self, rng: &mut R, samples: u16) {
        for _ in 0..samples {
            if self.invalid.is_some() || self.repeat.found().is_some() {
                return;
            }
            let mut tap = Tap::new(rng, &mut self.words);
            let sample = self.subject.draw(&mut tap);
            self.feed(&sample);
        }
    }

    /// Counts a sample that was drawn elsewhere. After 65 535 samples nothing more is counted.
    pub fn feed(&mut self, sample: &S::Sample) {
        let Some(samples) = self.samples.checked_add(1) else {
            return;
        };
        self.samples = samples;
        match self.subject.place(sample) {
            Ok(place) => self.count(place),
            Err(why) => self.invalid = self.invalid.or(Some((samples, why))),
        }
    }

    fn count(&mut self, place: Place) {
        self.repeat.add(self.samples, place.fingerprint());
        self.polar.add(place);
        let polar = place.eighth();
        let azimuth = place.sector.map(|sector| sector >> 1);
        if let (Some(sector), Some(azimuth)) = (place.sector, azimuth) {
            self.sectors.add(sector);
            self.polar_azimuth.add(polar, azimuth);
        }
        // Pairs that do not overlap, so that their counts are independent.
        self.waiting = match self.waiting {
            None => Some((polar, azimuth)),
            Some((polar_before, azimuth_before)) => {
                self.polar_pairs.add(polar_before, polar);
                if let (Some(before), Some(azimuth)) = (azimuth_before, azimuth) {
                    self.azimuth_pairs.add(before, azimuth);
                }
                None
            }
        };
    }

    /// Judges what was counted so far; counting may go on.
    ///
    /// # Errors
    /// The first fault, the plainest and the generator's own first: an invalid sample, a period,
    /// too few samples to say more, then the [`Statistic`]s in their order.
    pub fn verdict(&self, alarm: Alarm) -> Result<Report, Fault> {
        if let Some((sample, why)) = self.invalid {
            return Err(Fault::Invalid { sample, why });
        }
        if let Some((sample, period)) = self.repeat.found() {
            return Err(Fault::Repeats { sample, period });
        }
        if self.samples < FEWEST {
            return Err(Fault::TooFew {
                samples: self.samples,
            });
        }
        use Statistic::*;
        let polar = self.polar.chi2(self.samples);
        Ok(Report {
            samples: self.samples,
            words: self.words.words(),
            bits: judge(Bits, alarm, self.words.bits())?,
            flips: judge(Flips, alarm, self.words.flips())?,
            azimuth: judge(Azimuth, alarm, self.sectors.chi2())?,
            eighths: judge(Eighths, alarm, self.polar.eighths())?,
            polar: judge(Polar, alarm, Some(polar))?,
            polar_azimuth: judge(PolarAzimuth, alarm, self.polar_azimuth.chi2())?,
            polar_pairs: judge(PolarPairs, alarm, self.polar_pairs.chi2())?,
            azimuth_pairs: judge(AzimuthPairs, alarm, self.azimuth_pairs.chi2())?,
        })
    }
}
