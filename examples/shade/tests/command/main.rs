//! The shader as a command: images that depend on nothing but the scene, and how it fails.

#[cfg(unix)]
mod inputs;
#[cfg(unix)]
mod outputs;

use kit::scratch::Scratch;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const SCENES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");

fn shade(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shade"));
    command.current_dir(folder).args(args).output().unwrap()
}

fn succeeds(folder: &Path, args: &[&str]) -> String {
    let output = shade(folder, args);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{args:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

fn fails(folder: &Path, args: &[&str]) -> String {
    let output = shade(folder, args);
    assert!(!output.status.success(), "{args:?} succeeded");
    String::from_utf8(output.stderr).unwrap()
}

/// Renders a shipped scene with one sample a pixel, and returns the file.
fn image(scratch: &Scratch, scene: &str, more: &[&str]) -> Vec<u8> {
    let scene = format!("{SCENES}/{scene}.toml");
    let args = [&[scene.as_str(), "-o", "image", "--samples", "1"], more].concat();
    succeeds(&scratch.0, &args);
    let file = scratch.0.join("image");
    let bytes = fs::read(&file).unwrap();
    fs::remove_file(file).unwrap();
    bytes
}

#[test]
fn threads_and_effects_that_are_not_called_for_change_no_bit() {
    let scratch = Scratch::new("shade-threads");
    for scene in ["fog", "flat_bounces"] {
        let one = image(&scratch, scene, &["--threads", "1"]);
        assert!(one.starts_with(b"\x89PNG"));
        assert!(
            one == image(&scratch, scene, &["--threads", "2"]),
            "{scene}"
        );
        assert!(one == image(&scratch, scene, &["--force-all"]), "{scene}");
        // The comparison can fail.
        assert!(one != image(&scratch, scene, &["--type", "f64"]), "{scene}");
    }
}

#[test]
fn shares_make_the_whole_and_say_what_is_missing() {
    let scratch = Scratch::new("shade-tiles");
    let whole = image(&scratch, "all", &[]);
    for i in 1..=3 {
        let share = image(&scratch, "all", &["--tiles", &format!("{i}/3")]);
        fs::write(scratch.0.join(format!("{i}")), share).unwrap();
    }
    succeeds(&scratch.0, &["merge", "3", "1", "2", "-o", "merged"]);
    assert!(whole == fs::read(scratch.0.join("merged")).unwrap());

    let missing = fails(&scratch.0, &["merge", "1", "3", "-o", "out"]);
    assert!(missing.contains("share 2/3 is missing"), "{missing}");
    let twice = fails(&scratch.0, &["merge", "1", "1", "2", "3", "-o", "out"]);
    assert!(twice.contains("expected each once"), "{twice}");
    let other = image(&scratch, "fog", &["--tiles", "2/3"]);
    fs::write(scratch.0.join("2"), other).unwrap();
    let other = fails(&scratch.0, &["merge", "1", "2", "3", "-o", "out"]);
    assert!(other.contains("another frame"), "{other}");
    assert_eq!(scratch.names(), ["1", "2", "3", "merged"]);
}

#[test]
fn a_bad_scene_names_its_line_and_leaves_nothing() {
    let scratch = Scratch::new("shade-bad");
    let scene = fs::read_to_string(format!("{SCENES}/emitter.toml")).unwrap();
    let scene = scene.replace("[image]", "[image]\nbanana = 1");
    let line = 1 + scene.lines().position(|l| l == "banana = 1").unwrap();
    fs::write(scratch.0.join("bad.toml"), scene).unwrap();
    let message = fails(&scratch.0, &["bad.toml", "-o", "out.png"]);
    assert!(message.contains(&format!("bad.toml:{line}:")), "{message}");
    assert!(
        message.contains("banana") && message.contains("expected"),
        "{message}"
    );

    let emitter = format!("{SCENES}/emitter.toml");
    fails(&scratch.0, &[&emitter, "-o", "no/such/folder.png"]);
    fails(&scratch.0, &["none.toml", "-o", "out.png"]);
    assert_eq!(scratch.names(), ["bad.toml"]);
}

#[test]
fn the_plan_says_why_an_effect_is_on_and_what_it_costs() {
    let scratch = Scratch::new("shade-plan");
    let scene = format!("{SCENES}/soft_shadow.toml");
    let told = succeeds(&scratch.0, &[&scene, "-o", "out.png", "--samples", "1"]);
    let line = |effect: &str| {
        let found = told.lines().find(|l| l.starts_with(effect));
        found
            .unwrap_or_else(|| panic!("no {effect} in {told}"))
            .to_owned()
    };
    for (effect, why) in [("soft shadow", "1 lamp"), ("diffuse", "2 materials")] {
        assert!(
            line(effect).contains(" on ") && line(effect).contains(why),
            "{told}"
        );
    }
    for absent in ["depth of field", "fog: absorption", "several bounces"] {
        assert!(line(absent).contains(" off "), "{told}");
    }
    assert!(told.contains("samples a second"), "{told}");
    assert!(told.contains("no estimate"), "{told}");
    let told = succeeds(&scratch.0, &[&scene, "-o", "out.png", "--samples", "4"]);
    assert!(told.contains("standard error"), "{told}");
}
