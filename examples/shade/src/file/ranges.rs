//! Numbers within their ranges, lists within their lengths.

use super::LARGEST;
use super::raw::{Value, Values};
use std::ops::{Range, RangeInclusive};
use toml::Spanned;

pub(super) type Wrong = (Range<usize>, String);
pub(super) type Checked = Result<(), Wrong>;

pub(super) fn wrong<T>(at: &Spanned<T>, what: impl Into<String>) -> Wrong {
    (at.span(), what.into())
}

pub(super) fn number(key: &str, x: &Value, range: RangeInclusive<f64>) -> Checked {
    if range.contains(x.get_ref()) {
        return Ok(());
    }
    let (low, high) = (range.start(), range.end());
    let what = format!("{key} is {}; expected {low} to {high}", x.get_ref());
    Err(wrong(x, what))
}

pub(super) fn whole(key: &str, x: &Spanned<i64>, range: RangeInclusive<i64>) -> Checked {
    if range.contains(x.get_ref()) {
        return Ok(());
    }
    let (low, high) = (range.start(), range.end());
    let what = format!(
        "{key} is {}; expected a whole number from {low} to {high}",
        x.get_ref()
    );
    Err(wrong(x, what))
}

pub(super) fn components(
    key: &str,
    x: &Values,
    n: usize,
    range: RangeInclusive<f64>,
    what: &str,
) -> Checked {
    if x.get_ref().len() != n {
        let have = x.get_ref().len();
        return Err(wrong(
            x,
            format!("{key} has {have} numbers; expected {n} ({what})"),
        ));
    }
    match x.get_ref().iter().find(|&&c| !range.contains(&c)) {
        None => Ok(()),
        Some(c) => {
            let (low, high) = (range.start(), range.end());
            Err(wrong(
                x,
                format!("{key} holds {c}; expected {low} to {high}"),
            ))
        }
    }
}

pub(super) fn light(key: &str, x: &Values) -> Checked {
    components(key, x, 3, 0.0..=LARGEST, "red, green, blue")
}

pub(super) fn share(key: &str, x: &Values) -> Checked {
    components(key, x, 3, 0.0..=1.0, "red, green, blue")
}

pub(super) fn count<T>(key: &str, list: &[Spanned<T>], most: usize) -> Checked {
    match list.get(most) {
        Some(one) => Err(wrong(
            one,
            format!("{} of [[{key}]]; expected at most {most}", list.len()),
        )),
        None => Ok(()),
    }
}
