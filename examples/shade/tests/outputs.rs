//! Where the shader writes to, and what it reads: refused before it renders, or nothing is lost.
#![cfg(unix)]

use kit::scratch::Scratch;
use std::fs;
use std::io::Read;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Output, Stdio};

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/emitter.toml");

fn shade(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shade"));
    command
        .current_dir(folder)
        .args(args)
        .args(["--samples", "1"]);
    command
}

fn merge(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shade"));
    command.current_dir(folder).arg("merge").args(args);
    command
}

/// Fails with one line that says `why`, having printed nothing: before it renders.
fn is_refused(mut command: Command, why: &str) {
    let Output {
        status,
        stdout,
        stderr,
    } = command.output().unwrap();
    let message = String::from_utf8(stderr).unwrap();
    assert_eq!(status.code(), Some(1), "{command:?}: {message}");
    assert!(
        message.starts_with("shade: ") && message.contains(why),
        "{message}"
    );
    assert_eq!(message.lines().count(), 1, "{message}");
    assert_eq!(String::from_utf8_lossy(&stdout), "", "{command:?}");
}

fn succeeds(mut command: Command) -> String {
    let output = command.output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

fn is_png(path: &Path) -> bool {
    fs::read(path)
        .is_ok_and(|data| data.starts_with(b"\x89PNG") && data.ends_with(b"IEND\xAEB\x60\x82"))
}

#[test]
fn what_is_read_is_not_overwritten() {
    let scratch = Scratch::new("shade-inputs");
    let at = |name: &str| scratch.0.join(name);
    fs::copy(SCENE, at("scene")).unwrap();
    symlink("scene", at("link")).unwrap();
    fs::hard_link(at("scene"), at("twin")).unwrap();
    for out in ["scene", "./scene", "link", "twin"] {
        is_refused(shade(&scratch.0, &["scene", "-o", out]), "is read as well");
    }
    is_refused(
        shade(&scratch.0, &["link", "-o", "scene"]),
        "is read as well",
    );
    assert_eq!(fs::read(at("scene")).unwrap(), fs::read(SCENE).unwrap());

    for i in ["1", "2"] {
        let share = format!("{i}/2");
        succeeds(shade(&scratch.0, &["scene", "-o", i, "--tiles", &share]));
    }
    let before = fs::read(at("1")).unwrap();
    is_refused(merge(&scratch.0, &["2", "1", "-o", "1"]), "is read as well");
    assert_eq!(fs::read(at("1")).unwrap(), before);
    assert_eq!(scratch.names(), ["1", "2", "link", "scene", "twin"]);
}

#[test]
fn places_that_take_no_file_are_found_before_the_work() {
    let scratch = Scratch::new("shade-places");
    fs::create_dir(scratch.0.join("folder")).unwrap();
    fs::write(scratch.0.join("file"), "mine").unwrap();
    let long = "x".repeat(256);
    for (out, why) in [
        ("no/such/folder.png", "No such file"),
        ("/proc/out.png", "cannot be written"),
        ("folder", "a folder"),
        ("folder/", "a folder"),
        ("new/", "a folder"),
        ("..", "a folder"),
        ("file/out.png", "Not a directory"),
        (&long, "too long"),
    ] {
        is_refused(shade(&scratch.0, &[SCENE, "-o", out]), why);
    }
    // The longest name that there is, and one that leaves no room for more.
    for n in [255, 254] {
        let long = "y".repeat(n);
        succeeds(shade(&scratch.0, &[SCENE, "-o", &long]));
        assert!(is_png(&scratch.0.join(&long)));
        fs::remove_file(scratch.0.join(long)).unwrap();
    }
    assert_eq!(scratch.names(), ["file", "folder"]);
}

#[test]
fn links_modes_and_pipes_stay_what_they_are() {
    let scratch = Scratch::new("shade-kept");
    let at = |name: &str| scratch.0.join(name);
    fs::create_dir(at("below")).unwrap();
    fs::write(at("below/file"), "old").unwrap();
    fs::set_permissions(at("below/file"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("below/file", at("link")).unwrap();
    symlink("below/new", at("dangling")).unwrap();
    for (link, file) in [("link", "below/file"), ("dangling", "below/new")] {
        succeeds(shade(&scratch.0, &[SCENE, "-o", link]));
        assert!(at(link).symlink_metadata().unwrap().is_symlink(), "{link}");
        assert!(is_png(&at(file)), "{file}");
    }
    let mode = |name: &str| at(name).metadata().unwrap().permissions().mode() & 0o777;
    assert_eq!(mode("below/file"), 0o640);
    // A new file's mode is the user's.
    fs::write(at("plain"), "").unwrap();
    assert_eq!(mode("below/new"), mode("plain"));

    assert!(
        Command::new("mkfifo")
            .arg(at("pipe"))
            .status()
            .unwrap()
            .success()
    );
    let mut writer = shade(&scratch.0, &[SCENE, "-o", "pipe"]);
    let mut writer = writer.stdout(Stdio::null()).spawn().unwrap();
    let mut data = Vec::new();
    fs::File::open(at("pipe"))
        .unwrap()
        .read_to_end(&mut data)
        .unwrap();
    assert!(writer.wait().unwrap().success());
    assert!(data.starts_with(b"\x89PNG"));
    assert!(at("pipe").metadata().unwrap().file_type().is_fifo());
    let names = ["below", "dangling", "link", "pipe", "plain"];
    assert_eq!(scratch.names(), names);
}

#[test]
fn a_lost_standard_output_loses_no_picture() {
    let scratch = Scratch::new("shade-stdout");
    let out = scratch.0.join("out.png");
    let closed = || {
        let mut child = Command::new("true").stdin(Stdio::piped()).spawn().unwrap();
        let stdin = child.stdin.take().unwrap();
        child.wait().unwrap();
        Stdio::from(stdin)
    };
    let full = || {
        Stdio::from(
            fs::OpenOptions::new()
                .write(true)
                .open("/dev/full")
                .unwrap(),
        )
    };
    for stdout in [closed(), full()] {
        let mut command = shade(&scratch.0, &[SCENE, "-o", "out.png"]);
        let output = command.stdout(stdout).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(
            message.contains("standard output took no more"),
            "{message}"
        );
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(is_png(&out));
        fs::remove_file(&out).unwrap();
    }
    // Nor does a standard error that takes nothing.
    let mut command = shade(&scratch.0, &[SCENE, "-o", "folder/out.png"]);
    assert_eq!(
        command.stderr(full()).output().unwrap().status.code(),
        Some(1)
    );
}

#[test]
fn a_limit_on_files_leaves_none_and_keeps_the_old() {
    let scratch = Scratch::new("shade-limit");
    fs::write(scratch.0.join("old.png"), "old").unwrap();
    for out in ["old.png", "new.png"] {
        let shader = env!("CARGO_BIN_EXE_shade");
        let text = format!("ulimit -f 1; exec {shader} {SCENE} -o {out} --samples 1 --tiles 1/1");
        let mut command = Command::new("sh");
        let output = command
            .current_dir(&scratch.0)
            .args(["-c", &text])
            .output()
            .unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("too large"), "{message}");
    }
    assert_eq!(scratch.names(), ["old.png"]);
    assert_eq!(
        fs::read_to_string(scratch.0.join("old.png")).unwrap(),
        "old"
    );
}

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
