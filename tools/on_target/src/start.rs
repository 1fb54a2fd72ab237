//! What the firmware that a reader starts from prints over defmt.

use crate::boards::{BOARDS, Board};
use crate::build::{Build, workspace};
use crate::failure::{Failure, Result, While};
use crate::report::Report;
use coslobe::{Ball, CircleShell, Disk, Lambert, Law, Spatial};
use rand_pcg::Pcg32;
use std::process::Command;

/// The same draws as in `examples/firmware/start`, in the order of its lines.
fn expected() -> Vec<String> {
    let mut rng = Pcg32::new(2024, 1);
    let mut lines = Vec::new();
    let d: [f32; 2] = Disk.sample(&mut rng);
    lines.push(format!("Disk        {d:?}"));
    let d: [f32; 2] = CircleShell.sample(&mut rng);
    lines.push(format!("CircleShell {d:?}"));
    for _ in 0..4 {
        let d: [f32; 3] = Lambert.sample(&mut rng);
        lines.push(format!("Lambert     {d:?}"));
    }
    let d: [f32; 3] = Ball.sample(&mut rng);
    lines.push(format!("Ball        {d:?}"));
    let d: [f32; 3] = Lambert.sample_around([1.0, 0.0, 0.0], &mut rng);
    lines.push(format!("Lambert     {d:?} around +x"));
    lines.push(format!("Lambert at u = 0.25: {:?}", Lambert.warp(0.25f32)));
    lines
}

/// Runs it on every board as `cargo run` does.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    if !crate::boards::succeeds("defmt-print", &["--version"]) {
        report.skip("start: defmt-print is not installed (cargo install defmt-print --locked)");
        return Ok(());
    }
    for board in &BOARDS {
        if let Err(reason) = board.has_target().and_then(|()| board.has_emulator()) {
            report.skip(&format!("start on {reason}"));
            continue;
        }
        report.outcome(&format!("{}: start over defmt", board.name), one(board));
    }
    Ok(())
}

fn one(board: &Board) -> Result<()> {
    let image = Build {
        board,
        package: "start",
        variables: vec![],
        features: &[],
        debug: false,
    }
    .image()?;
    let output = Command::new(workspace().join("run"))
        .arg(board.machine)
        .arg(image)
        .output()
        .while_("starting the runner")?;
    let text = String::from_utf8_lossy(&output.stdout);
    let expected = expected();
    let missing = expected
        .iter()
        .find(|line| !text.lines().any(|l| l == *line));
    match missing {
        None if output.status.success() => Ok(()),
        None => Err(Failure(format!("exit {}", output.status))),
        Some(line) => Err(Failure(format!("expected a line {line}\nfound\n{text}"))),
    }
}
