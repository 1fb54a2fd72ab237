//! Where the shader writes to: refused before it renders, or nothing is lost.

use kit::scratch::Scratch;
use std::fs;
use std::io::Read;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Output, Stdio};

pub(crate) const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/emitter.toml");

pub(crate) fn shade(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shade"));
    command
        .current_dir(folder)
        .args(args)
        .args(["--samples", "1"]);
    command
}

pub(crate) fn merge(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shade"));
    command.current_dir(folder).arg("merge").args(args);
    command
}

/// Fails with one line that says `why`, having printed nothing: before it renders.
pub(crate) fn is_refused(mut command: Command, why: &str) {
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

pub(crate) fn succeeds(mut command: Command) -> String {
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
