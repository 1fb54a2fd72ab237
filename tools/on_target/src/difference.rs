//! Compares texts line by line.

/// Ok if the texts are the same; else the first line that differs.
///
/// # Errors
/// Both lines, each of which names its law, type, stream and input.
pub(crate) fn same(expected: &str, found: &str) -> Result<(), String> {
    match first(expected, found) {
        None => Ok(()),
        Some((expected, found)) => Err(format!("expected {expected}\n   found {found}")),
    }
}

/// The first pair of lines that differ.
pub(crate) fn first<'a>(expected: &'a str, found: &'a str) -> Option<(&'a str, &'a str)> {
    let (mut expected, mut found) = (expected.lines(), found.lines());
    loop {
        match (expected.next(), found.next()) {
            (None, None) => return None,
            (a, b) if a == b => {}
            (a, b) => return Some((a.unwrap_or("no line"), b.unwrap_or("no line"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_difference_is_named() {
        assert_eq!(same("a\nb\n", "a\nb\n"), Ok(()));
        let found = same(
            "Ball f32 samples 64 1\nBall f32 samples 256 2\n",
            "Ball f32 samples 64 1\n",
        );
        assert_eq!(
            found,
            Err("expected Ball f32 samples 256 2\n   found no line".to_owned())
        );
        assert_eq!(first("", "x"), Some(("no line", "x")));
    }
}
