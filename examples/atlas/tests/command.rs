//! The atlas example: what it writes, that it repeats itself, and how it fails.

use kit::scratch::{Scratch, names};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn command(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_atlas"));
    command.current_dir(folder);
    command
}

fn atlas(folder: &Path, args: &[&str]) -> Output {
    command(folder).args(args).output().unwrap()
}

fn succeeds(folder: &Path, args: &[&str]) -> String {
    let output = atlas(folder, args);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{args:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn writes_a_page_and_its_figures() {
    let scratch = Scratch::new("atlas-page");
    let table = succeeds(&scratch.0, &["--samples", "2000"]);
    assert_eq!(scratch.names(), ["atlas"]);
    let out = scratch.0.join("atlas");
    let figures = [
        "ball.svg",
        "circle-arc.svg",
        "circle-shell.svg",
        "cos-power.svg",
        "disk.svg",
        "lambert.svg",
        "overview.svg",
        "sphere-shell.svg",
    ];
    let (small, mut found): (Vec<_>, Vec<_>) = names(&out)
        .into_iter()
        .partition(|name| name.ends_with("-small.svg"));
    assert_eq!(small.len(), 7);
    let expected: Vec<&str> = figures.iter().copied().chain(["index.html"]).collect();
    found.sort_by_key(|name| name.ends_with(".html"));
    assert_eq!(found, expected);

    let page = fs::read_to_string(out.join("index.html")).unwrap();
    assert!(page.ends_with("</html>\n"));
    for name in figures {
        let figure = fs::read_to_string(out.join(name)).unwrap();
        assert!(figure.starts_with("<svg") && figure.trim_end().ends_with("</svg>"));
        assert!(!figure.contains("NaN") && !figure.contains("inf"), "{name}");
        assert!(page.contains(&figure), "{name} is not on the page");
    }
    assert!(!page.contains("NaN"));
    for hole in ["{overview}", "{heads}", "{body}", "{sections}", "{seed}"] {
        assert!(!page.contains(hole), "{hole} was not filled");
    }
    // Two rows a law under one heading, and the documented words of randomness.
    let words = |law: &str| -> Vec<&str> {
        let rows = table.lines().filter(|line| line.starts_with(law));
        rows.filter_map(|row| row.split_whitespace().last())
            .collect()
    };
    assert_eq!(words("Disk "), ["2", "4"]);
    assert_eq!(words("Ball "), ["3", "6"]);
}

#[test]
fn the_plain_tier_holds_in_the_tails() {
    let scratch = Scratch::new("atlas-ulp");
    let exponent = ["--exponent", "2.5"];
    let table = succeeds(
        &scratch.0,
        &[&["--samples", "20000"], &exponent[..]].concat(),
    );
    let rows: Vec<&str> = table.lines().filter(|line| line.contains(" 0x")).collect();
    assert_eq!(rows.len(), 14);
    for row in rows {
        let cells: Vec<&str> = row.split_whitespace().rev().collect();
        let (ulp, p): (f64, f64) = (cells[2].parse().unwrap(), cells[3].parse().unwrap());
        assert!(ulp <= 4.0, "{row}");
        assert!(p > 1e-6, "{row}");
    }
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let scratch = Scratch::new("atlas-seed");
    let run = |out: &str, seed: &str, threads: &str| {
        let args = "--samples 70000 --laws disk,ball,cos-power --out OUT --seed SEED";
        let args = args.replace("OUT", out).replace("SEED", seed);
        let output = command(&scratch.0)
            .args(args.split(' '))
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap();
        assert!(output.status.success());
        let folder = scratch.0.join(out);
        let files = names(&folder).into_iter();
        files
            .map(|name| fs::read(folder.join(name)).unwrap())
            .collect::<Vec<_>>()
    };
    let once = run("a", "7", "1");
    assert_eq!(once.len(), 8);
    assert!(once == run("b", "7", "3"), "threads or a second run matter");
    assert!(once != run("c", "8", "1"), "the seed does not matter");
}

#[test]
fn a_second_run_replaces_its_files_and_leaves_others() {
    let scratch = Scratch::new("atlas-again");
    fs::write(scratch.0.join("mine.txt"), "mine").unwrap();
    fs::write(scratch.0.join("index.html"), "old").unwrap();
    succeeds(
        &scratch.0,
        &["--samples", "1", "--laws", "lambert,lambert", "--out", "."],
    );
    let expected = [
        "index.html",
        "lambert-small.svg",
        "lambert.svg",
        "mine.txt",
        "overview.svg",
    ];
    assert_eq!(scratch.names(), expected);
    let mine = fs::read_to_string(scratch.0.join("mine.txt"));
    assert_eq!(mine.unwrap(), "mine");
    let page = fs::read_to_string(scratch.0.join("index.html"));
    assert_ne!(page.unwrap(), "old");
}

#[test]
fn a_folder_in_a_files_place_is_refused_and_kept() {
    let scratch = Scratch::new("atlas-half");
    // A folder where the page should go.
    fs::create_dir_all(scratch.0.join("out/index.html/full")).unwrap();
    let output = atlas(
        &scratch.0,
        &["--samples", "100", "--laws", "disk", "--out", "out"],
    );
    assert!(!output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("index.html"));
    assert_eq!(names(&scratch.0.join("out")), ["index.html"]);
}

#[test]
fn extreme_exponents_are_drawn() {
    let scratch = Scratch::new("atlas-extreme");
    for k in ["0", "-0", "0.1", "1e6", "1e30"] {
        let args = ["--samples", "500", "--laws", "cos-power", "--exponent", k];
        succeeds(&scratch.0, &args);
        let figure = fs::read_to_string(scratch.0.join("atlas/cos-power.svg")).unwrap();
        assert!(!figure.contains("NaN") && !figure.contains("inf"), "{k}");
    }
}

#[test]
fn bad_arguments_say_what_was_expected_and_write_nothing() {
    let scratch = Scratch::new("atlas-bad");
    let cases: [(&[&str], &str); 11] = [
        (&["--samples", "0"], "1.."),
        (&["--samples", "many"], "invalid digit"),
        (&["--samples", "-5"], "invalid digit"),
        (&["--seed", "x"], "invalid digit"),
        (&["--laws", "cube"], "possible values: disk"),
        (&["--exponent", "NaN"], "expected a finite number ≥ 0"),
        (&["--exponent", "-1"], "expected a finite number ≥ 0"),
        (&["--exponent", "inf"], "expected a finite number ≥ 0"),
        // Finite in f64 alone.
        (&["--exponent", "1e300"], "as f32: the exponent is infinite"),
        (
            &["--laws", "disk", "--exponent", "NaN"],
            "expected a finite number ≥ 0",
        ),
        (&["--frobnicate"], "--frobnicate"),
    ];
    for (args, expected) in cases {
        let output = atlas(&scratch.0, args);
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{args:?}");
        assert!(message.contains(expected), "{args:?}: {message}");
        assert!(scratch.names().is_empty(), "{args:?} wrote something");
    }
}

#[test]
fn a_file_in_the_folders_place_is_refused_and_kept() {
    let scratch = Scratch::new("atlas-file");
    fs::write(scratch.0.join("taken"), "mine").unwrap();
    for out in ["taken", "taken/below"] {
        let output = atlas(&scratch.0, &["--samples", "100", "--out", out]);
        assert!(!output.status.success());
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains("expected a folder"), "{message}");
    }
    assert_eq!(scratch.names(), ["taken"]);
    assert_eq!(fs::read_to_string(scratch.0.join("taken")).unwrap(), "mine");
}

/// What the atlas prints may go nowhere, where it writes may be no place for files: see `output`.
#[cfg(unix)]
#[test]
fn outputs_are_checked_before_the_work_and_nothing_is_lost() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let scratch = Scratch::new("atlas-outputs");
    let args = ["--samples", "1000", "--laws", "disk", "--out", "out"];
    let full = fs::OpenOptions::new().write(true).open("/dev/full");
    let output = command(&scratch.0)
        .args(args)
        .stdout(full.unwrap())
        .output();
    let output = output.unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.contains("standard output took no more"),
        "{message}"
    );
    let out = scratch.0.join("out");
    let files = ["disk-small.svg", "disk.svg", "index.html", "overview.svg"];
    assert_eq!(names(&out), files);

    // What is there stays what it is.
    fs::rename(out.join("disk.svg"), scratch.0.join("mine.svg")).unwrap();
    symlink("../mine.svg", out.join("disk.svg")).unwrap();
    fs::write(scratch.0.join("mine.svg"), "old").unwrap();
    let page = out.join("index.html");
    fs::set_permissions(&page, fs::Permissions::from_mode(0o604)).unwrap();
    succeeds(&scratch.0, &args);
    assert!(
        out.join("disk.svg")
            .symlink_metadata()
            .unwrap()
            .is_symlink()
    );
    let mine = fs::read_to_string(scratch.0.join("mine.svg")).unwrap();
    assert!(mine.starts_with("<svg"));
    assert_eq!(page.metadata().unwrap().permissions().mode() & 0o777, 0o604);

    // A million million samples would never end.
    let endless = ["--samples", "1000000000000", "--laws", "disk", "--out"];
    for place in ["/proc", "/proc/atlas", "mine.svg", "out/disk.svg/below"] {
        let output = atlas(&scratch.0, &[&endless[..], &[place]].concat());
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{place}: {message}");
        assert_eq!(message.lines().count(), 1, "{message}");
    }
    fs::remove_file(&page).unwrap();
    fs::create_dir(&page).unwrap();
    let output = atlas(&scratch.0, &[&endless[..], &["out"]].concat());
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("index.html: a folder"), "{message}");
}
