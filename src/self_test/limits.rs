//! Which values of χ² are believed.

use super::cells::Chi2;
use super::report::{Fault, Score, Statistic};
use super::table::TABLE;

/// How often a test of a perfect generator and sampler may fail, at most.
///
/// Each of the eight statistics is judged on two sides, each side at 1/32 of this and not at 1/16:
/// so far out the tails of a χ² of counts are up to 6 times heavier than those of the χ²
/// distribution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Alarm {
    /// 10⁻⁶: for a bench, where a failure is looked at.
    OneInMillion,
    /// 10⁻⁹: for power-on, where a million devices start a thousand times.
    OneInBillion,
}

/// \[least, most\]; a number of degrees of freedom that has no row believes nothing.
fn limits(freedom: u8, alarm: Alarm) -> [u32; 2] {
    let row = TABLE.iter().find(|row| row.0 == freedom);
    row.map_or([u32::MAX, 0], |&(_, [million, billion])| match alarm {
        Alarm::OneInMillion => million,
        Alarm::OneInBillion => billion,
    })
}

/// The score of a statistic, if there is one and its value is believed.
pub(super) fn judge(
    statistic: Statistic,
    alarm: Alarm,
    chi2: Option<Chi2>,
) -> Result<Option<Score>, Fault> {
    let Some(chi2) = chi2 else {
        return Ok(None);
    };
    let [least, most] = limits(chi2.freedom, alarm);
    let score = Score {
        statistic,
        tenths: chi2.tenths,
        least,
        most,
        freedom: chi2.freedom,
        worst: chi2.worst,
    };
    if score.tenths > most {
        Err(Fault::TooUneven(score))
    } else if score.tenths < least {
        Err(Fault::TooEven(score))
    } else {
        Ok(Some(score))
    }
}
