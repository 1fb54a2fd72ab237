//! Runs an image on its board.

use crate::boards::Board;
use crate::failure::{Failure, Result, While};
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// How to run.
#[derive(Clone, Copy)]
pub(crate) struct Emulation {
    /// One instruction is one nanosecond of the board's clocks: counts repeat, at a third of the
    /// speed.
    pub(crate) counts: bool,
    pub(crate) timeout: Duration,
}

/// What the image wrote to its standard output, if it exited with 0 in time.
pub(crate) fn run(
    board: &Board,
    image: &Path,
    arguments: &[&str],
    emulation: Emulation,
) -> Result<Vec<u8>> {
    let mut semihosting = "enable=on,target=native".to_owned();
    // QEMU doubles commas that are no separators.
    for argument in std::iter::once(&"image").chain(arguments) {
        semihosting += &format!(",arg={}", argument.replace(',', ",,"));
    }
    let mut command = Command::new(board.emulator);
    command
        .args(["-M", board.machine, "-nographic", "-monitor", "none"])
        .args(["-serial", "none", "-semihosting-config", &semihosting])
        .args(board.options)
        .arg("-kernel")
        .arg(image);
    if emulation.counts {
        command.args(["-icount", "shift=0"]);
    }
    let what = format!("{} {}", board.name, image.display());
    let (status, output, errors) = finish(command, emulation.timeout).while_(&what)?;
    if status {
        Ok(output)
    } else {
        Err(Failure(format!(
            "{what}: the image failed\n{}{}",
            String::from_utf8_lossy(&output),
            String::from_utf8_lossy(&errors)
        )))
    }
}

/// Whether it succeeded, its output and its errors.
fn finish(mut command: Command, timeout: Duration) -> Result<(bool, Vec<u8>, Vec<u8>)> {
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .while_("starting the emulator")?;
    let output = read(child.stdout.take());
    let errors = read(child.stderr.take());
    let in_time = wait(&mut child, timeout)?;
    let (output, errors) = (output.join(), errors.join());
    let text = |bytes: thread::Result<Vec<u8>>| bytes.unwrap_or_default();
    match in_time {
        Some(success) => Ok((success, text(output), text(errors))),
        None => Err(Failure(format!("no end after {} s", timeout.as_secs()))),
    }
}

/// Reads a pipe to its end beside this thread, so that the child cannot wait for a full one.
fn read(pipe: Option<impl Read + Send + 'static>) -> thread::JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // What was read before an error is what the image wrote.
            let _ = pipe.read_to_end(&mut bytes);
        }
        bytes
    })
}

/// Whether the child succeeded; None if it had to be stopped.
fn wait(child: &mut Child, timeout: Duration) -> Result<Option<bool>> {
    let end = Instant::now() + timeout;
    loop {
        if let Some(status) = child.try_wait().while_("waiting for the emulator")? {
            return Ok(Some(status.success()));
        }
        if Instant::now() > end {
            child.kill().while_("stopping the emulator")?;
            child.wait().while_("stopping the emulator")?;
            return Ok(None);
        }
        thread::sleep(Duration::from_millis(5));
    }
}
