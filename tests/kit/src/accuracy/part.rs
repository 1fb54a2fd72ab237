//! A share of a sweep, for machines that work side by side.

use std::ops::Range;
use std::str::FromStr;

/// The `index`-th of `of` equal shares, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    pub index: u64,
    pub of: u64,
}

impl Part {
    pub const WHOLE: Part = Part { index: 1, of: 1 };

    /// The share of `count` things in a row: the shares of all parts follow each other.
    pub fn share(self, count: u64) -> Range<u64> {
        let end = |parts: u64| (u128::from(count) * u128::from(parts) / u128::from(self.of)) as u64;
        end(self.index - 1)..end(self.index)
    }
}

impl FromStr for Part {
    type Err = String;
    fn from_str(text: &str) -> Result<Part, String> {
        let expected = || format!("{text}: expected I/N with 1 ≤ I ≤ N, such as 2/8");
        let (index, of) = text.split_once('/').ok_or_else(expected)?;
        let number = |text: &str| text.parse::<u64>().map_err(|_| expected());
        let part = Part {
            index: number(index)?,
            of: number(of)?,
        };
        let valid = (1..=part.of).contains(&part.index);
        valid.then_some(part).ok_or_else(expected)
    }
}

#[test]
fn shares_follow_each_other() {
    for (count, of) in [(10, 3), (2, 5), (0, 4), (1 << 40, 7)] {
        let shares = (1..=of).map(|index| Part { index, of }.share(count));
        let end = shares.fold(0, |end, share| {
            assert_eq!(share.start, end);
            share.end
        });
        assert_eq!(end, count);
    }
    assert!("0/2".parse::<Part>().is_err() && "3/2".parse::<Part>().is_err());
}
