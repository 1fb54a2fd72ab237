//! Bad scenes: the line, the column, and what was expected.

use shade::cells::SHIPPED;
use shade::file::parse;

/// The gradient scene with one line replaced, which is its `line`-th.
fn complaint(from: &str, to: &str) -> String {
    let text = SHIPPED[2].text;
    assert!(text.contains(from), "{from}");
    match parse("bad.toml", &text.replacen(from, to, 1)) {
        Ok(_) => format!("{to}: accepted"),
        Err(e) => e.to_string(),
    }
}

#[test]
fn each_names_line_and_expectation() {
    let bad = [
        (
            "width = 320",
            "width = 0",
            "bad.toml:5:9: width is 0; expected a whole number from 1 to 4096",
        ),
        (
            "samples = 128",
            "samples = 1e3",
            "bad.toml:7:11: invalid type: floating point `1000.0`, expected i64",
        ),
        (
            "bounces = 1",
            "bounces = -1",
            "bad.toml:2:11: bounces is -1; expected a whole number from 0 to 64",
        ),
        (
            "bounces = 1",
            "bounces = 1\nlaw = \"disk\"",
            "bad.toml:3:7: a law of flatland in space; expected lambert, sphere_shell, ball or cos_power",
        ),
        (
            "bounces = 1",
            "law = \"cos_power\"",
            "bad.toml:2:7: cos_power without a key `exponent`; expected its k",
        ),
        (
            "bounces = 1",
            "law = \"phong\"",
            "bad.toml:2:7: unknown variant `phong`, expected one of `lambert`, `sphere_shell`, `ball`, `cos_power`, `circle_arc`, `circle_shell`, `disk`",
        ),
        (
            "bounces = 1",
            "bouncse = 1",
            "bad.toml:2:1: unknown field `bouncse`, expected one of `title`, `flatland`, `bounces`, `law`, `exponent`, `combine`, `image`, `camera`, `sky`, `sun`, `fog`, `material`, `lamp`, `sphere`, `plate`",
        ),
        (
            "eye = [0.0, 1.6, 5.0]",
            "eye = [0.0, 1.6]",
            "bad.toml:10:7: eye has 2 numbers; expected 3 (x, y, z: a scene in space)",
        ),
        (
            "eye = [0.0, 1.6, 5.0]",
            "eye = [0.0, nan, 5.0]",
            "bad.toml:10:7: eye holds NaN; expected -1000000 to 1000000",
        ),
        (
            "eye = [0.0, 1.6, 5.0]",
            "eye = [0.0, 0.7, 0.0]",
            "bad.toml:11:11: look_at is where the eye is; expected another point",
        ),
        (
            "fov = 40.0",
            "fov = 180",
            "bad.toml:12:7: fov is 180; expected 0.1 to 170",
        ),
        (
            "fov = 40.0",
            "",
            "bad.toml:9:1: camera of a scene in space; expected `eye`, `look_at` and `fov`",
        ),
        (
            "diffuse = [0.7, 0.68, 0.62]",
            "diffuse = [0.7, 0.68, 1.62]",
            "bad.toml:20:11: diffuse holds 1.62; expected 0 to 1",
        ),
        (
            "radius = 0.75",
            "radius = 0",
            "bad.toml:35:10: sphere.radius is 0; expected 0.000001 to 1000000",
        ),
        (
            "material = \"green\"",
            "material = \"gren\"",
            "bad.toml:36:12: no material \"gren\"; expected one of floor, green, white",
        ),
        (
            "sides = [[8.0, 0.0, 0.0], [0.0, 0.0, 8.0]]",
            "sides = [[8.0, 0.0, 0.0]]",
            "bad.toml:30:9: 1 sides; expected 2",
        ),
        (
            "sides = [[8.0, 0.0, 0.0], [0.0, 0.0, 8.0]]",
            "sides = [[8.0, 0.0, 0.0], [8.0, 0.0, 8.0]]",
            "bad.toml:30:9: sides at an angle of cosine 0.7071067811865475; expected a right angle",
        ),
        (
            "zenith = [0.7, 0.85, 1.2]",
            "",
            "bad.toml:15:1: sky; expected either `constant` or both `nadir` and `zenith`",
        ),
        ("title = ", "title ", "bad.toml:1:7: "),
    ];
    let mut wrong = Vec::new();
    for (from, to, want) in bad {
        let have = complaint(from, to);
        let is_alike = if want.ends_with(": ") {
            have.starts_with(want)
        } else {
            have == want
        };
        if !is_alike {
            wrong.push(format!("have {have}\nwant {want}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn too_many_and_too_long() {
    let sphere = "\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"floor\"\n";
    let text = format!("{}{}", SHIPPED[2].text, sphere.repeat(31));
    let e = parse("bad.toml", &text)
        .expect_err("33 spheres")
        .to_string();
    assert!(e.ends_with("33 of [[sphere]]; expected at most 32"), "{e}");
    let e = parse("bad.toml", &" ".repeat(1 << 19))
        .expect_err("long")
        .to_string();
    assert_eq!(e, "bad.toml:1:1: longer than the most, 262144 bytes");
}

#[test]
fn shipped_scenes_are_sound() {
    for s in &SHIPPED {
        assert!(parse(s.name, s.text).is_ok(), "{}", s.name);
    }
}
