//! What a board printed of a frame against what the host computes.

use crate::difference::first;
use scenes::{HEIGHT, SAMPLES, WIDTH};

const PARTS: [&str; 5] = ["first", "sum", "squares", "sum_rest", "squares_rest"];
const COLOURS: [&str; 3] = ["red", "green", "blue"];

/// Instructions a sample, if the pixels are the same.
///
/// # Errors
/// The first scene, pixel and channel that differ, with the bits of both.
pub(super) fn compare(expected: &str, found: &str) -> Result<f64, String> {
    let (pixels, instructions) = found
        .trim_end()
        .rsplit_once('\n')
        .ok_or_else(|| format!("expected pixels and a count of instructions, found {found}"))?;
    if let Some((expected, found)) = first(expected, pixels) {
        return Err(difference(expected, found));
    }
    let count = instructions.strip_prefix("instructions ");
    let count = count.and_then(|n| n.parse::<u32>().ok());
    let count = count.ok_or_else(|| format!("expected a count, found {instructions}"))?;
    Ok(f64::from(count) / (f64::from(WIDTH) * f64::from(HEIGHT) * f64::from(SAMPLES)))
}

/// Which of a pixel's values differ, by two lines `scene (x, y): first r g b sum r g b …`.
fn difference(expected: &str, found: &str) -> String {
    let split = |line: &str| -> Option<(String, Vec<String>)> {
        let (pixel, values) = line.split_once("): ")?;
        let values = values.split(' ').filter(|w| !PARTS.contains(w));
        Some((format!("{pixel})"), values.map(str::to_owned).collect()))
    };
    match (split(expected), split(found)) {
        (Some((pixel, a)), Some((same, b))) if pixel == same && a.len() == b.len() => {
            let differs = (0..a.len()).find(|&i| a[i] != b[i]).unwrap_or(0);
            let (part, colour) = (PARTS[differs / 3 % PARTS.len()], COLOURS[differs % 3]);
            let (a, b) = (&a[differs], &b[differs]);
            format!("{pixel}: {colour} of {part}: expected {a}, found {b}")
        }
        _ => format!("expected {expected}\n   found {found}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PIXEL: &str = "sky (3, 7): first 0 1 2 sum 3 4 5 squares 6 7 8\n";

    #[test]
    fn the_channel_that_differs_is_named() {
        let count = u32::from(WIDTH) * u32::from(HEIGHT) * SAMPLES * 2;
        let end = format!("instructions {count}\n");
        assert_eq!(compare(PIXEL, &format!("{PIXEL}{end}")), Ok(2.0));
        let planted = PIXEL.replace(" 4 ", " 9 ");
        let said = compare(PIXEL, &format!("{planted}{end}"));
        let expected = "sky (3, 7): green of sum: expected 4, found 9";
        assert_eq!(said, Err(expected.to_owned()));
    }

    #[test]
    fn a_frame_that_ends_early_is_no_frame() {
        assert!(compare(PIXEL, "instructions 1536\n").is_err());
        assert!(compare(PIXEL, PIXEL).is_err());
        assert!(compare(PIXEL, &format!("{PIXEL}\nhalted\n")).is_err());
    }
}
