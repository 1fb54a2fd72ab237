//! What the shader reads and shows.

use crate::outputs::{SCENE, is_refused, merge, shade, succeeds};
use kit::scratch::Scratch;
use std::fs;

#[test]
fn inputs_without_end_are_refused() {
    let scratch = Scratch::new("shade-endless");
    is_refused(
        shade(&scratch.0, &["/dev/zero", "-o", "out.png"]),
        "longer than the most, 262144 bytes",
    );
    is_refused(
        merge(&scratch.0, &["/dev/zero", "-o", "out.png"]),
        "expected a file that --tiles wrote",
    );
    // A tile whose head promises what an endless rest would never stop to be.
    succeeds(shade(&scratch.0, &[SCENE, "-o", "1", "--tiles", "1/1"]));
    let tile = fs::read(scratch.0.join("1")).unwrap();
    fs::write(scratch.0.join("more"), [&tile[..], &[0; 100]].concat()).unwrap();
    fs::write(scratch.0.join("less"), &tile[..tile.len() - 1]).unwrap();
    is_refused(
        merge(&scratch.0, &["more", "-o", "out.png"]),
        "more: more than",
    );
    is_refused(
        merge(&scratch.0, &["less", "-o", "out.png"]),
        "less: fewer than",
    );
    assert_eq!(scratch.names(), ["1", "less", "more"]);
}

#[test]
fn merge_refuses_a_tile_with_a_pixel_that_is_no_number() {
    let scratch = Scratch::new("shade-nan");
    succeeds(shade(&scratch.0, &[SCENE, "-o", "1", "--tiles", "1/1"]));
    let mut tile = fs::read(scratch.0.join("1")).unwrap();
    // After the head of 48 bytes, the second pixel's 80: a count, then its first sample.
    tile[48 + 80 + 8..][..8].copy_from_slice(&f64::NAN.to_le_bytes());
    fs::write(scratch.0.join("1"), tile).unwrap();
    is_refused(
        merge(&scratch.0, &["1", "-o", "out.png"]),
        "1: pixel (1, 0) is [NaN",
    );
    assert_eq!(scratch.names(), ["1"]);
}

#[test]
fn orders_to_the_terminal_are_spelled_out() {
    let scratch = Scratch::new("shade-orders");
    let scene = fs::read_to_string(SCENE).unwrap();
    let title = scene.lines().next().unwrap();
    let orders = "title = \"a \\u001b[31mred\\n title \\u202e\"";
    fs::write(scratch.0.join("title"), scene.replacen(title, orders, 1)).unwrap();
    let key = scene.replacen("[image]", "[image]\n\"\\u001b]0;key\\u0007\" = 1", 1);
    fs::write(scratch.0.join("key"), key).unwrap();
    let name = "na\x1b[2Jme";
    fs::copy(SCENE, scratch.0.join(name)).unwrap();

    let told = succeeds(shade(&scratch.0, &["title", "-o", "out.png"]));
    assert!(
        told.starts_with("title: a \\u{1b}[31mred\\n title \\u{202e}\n"),
        "{told}"
    );
    let told = succeeds(shade(&scratch.0, &[name, "-o", "out\x07.png"]));
    assert!(!told.contains(['\x1b', '\x07']), "{told}");
    is_refused(
        shade(&scratch.0, &["key", "-o", "out.png"]),
        "\\u{1b}]0;key\\u{7}",
    );
    is_refused(
        shade(&scratch.0, &["no\x1b[2J", "-o", "out.png"]),
        "no\\u{1b}[2J",
    );
}
