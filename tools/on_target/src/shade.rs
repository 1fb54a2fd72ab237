//! Small scenes on a board with an FPU: the host's pixels to the bit, and no code of effects that a
//! scene does not call for; what they cost.

mod pixels;
mod table;

use crate::args::Shade;
use crate::boards::{BOARDS, Board};
use crate::build::Build;
use crate::failure::{Failure, Result};
use crate::links::caught;
use crate::links::scenes::{nothing, shader};
use crate::qemu::{self, Emulation};
use crate::report::Report;
use crate::run::bar;
use scenes::{Forced, Frame, SCENES, Small, Visitor};
use shade_core::{Effect, Effects, Set};
use std::time::Duration;
use table::Row;

const EMULATION: Emulation = Emulation {
    counts: true,
    timeout: Duration::from_secs(120),
};

/// Builds, runs, compares; then the table.
pub(crate) fn run(options: &Shade, report: &mut Report) -> Result<()> {
    let Some(board) = BOARDS.iter().find(|b| b.name == "M4F") else {
        return Err(Failure("no board M4F".to_owned()));
    };
    if let Err(reason) = board.has_target().and_then(|()| board.has_emulator()) {
        report.skip(&format!("small scenes on {reason}"));
        return Ok(());
    }
    let empty = nothing(board)?;
    let mut scenes = OnBoard {
        board,
        empty,
        rows: Vec::new(),
        bar: bar(SCENES as u64),
        report,
    };
    scenes::each(&mut scenes);
    scenes.bar.finish_and_clear();
    let rows = scenes.rows;
    planted(board, report);
    match rows {
        rows if rows.len() < SCENES => Ok(()), // what failed has been said
        rows if options.write => table::write(&rows),
        rows => table::compare(&rows, report),
    }
}

struct OnBoard<'a> {
    board: &'a Board,
    empty: u64,
    rows: Vec<Row>,
    bar: indicatif::ProgressBar,
    report: &'a mut Report,
}

impl Visitor for OnBoard<'_> {
    fn visit<S: Small>(&mut self, name: &'static str) {
        let outcome = scene::<S>(self.board, name, self.empty);
        self.bar.inc(1);
        let what = format!(
            "{}: {}: the host's pixels, its effects alone",
            self.board.name,
            S::NAME
        );
        let row = outcome.map(|row| self.rows.push(row));
        self.bar.suspend(|| self.report.outcome(&what, row));
    }
}

fn scene<S: Small>(board: &Board, name: &str, empty: u64) -> Result<Row> {
    let set = S::Effects::default().set();
    let scene = S::scene();
    if scene.called_for() != set {
        return Err(Failure(format!(
            "calls for {}; its type says {}",
            names(scene.called_for()),
            names(set)
        )));
    }
    let mut frame = Frame::new();
    frame.render::<S>(&scene);
    let mut expected = String::new();
    if frame.write::<S>(&mut expected).is_err() {
        return Err(Failure("a string that does not grow".to_owned()));
    }
    let image = Build {
        board,
        package: "shade",
        variables: vec![("COSLOBE_SCENE", name.to_owned())],
        features: &[],
        debug: false,
    }
    .image()?;
    let output = qemu::run(board, &image, &[], EMULATION)?;
    let output = String::from_utf8_lossy(&output);
    let instructions = pixels::compare(&expected, &output).map_err(Failure)?;
    Ok(Row {
        name: S::NAME,
        set,
        flash: shader(board, name, set)? - empty,
        instructions,
    })
}

fn names(set: Set) -> String {
    let names: Vec<_> = set.iter().map(Effect::name).collect();
    names.join(", ")
}

/// A shader with every effect that is said to have two.
fn planted(board: &Board, report: &mut Report) {
    type Claimed = <scenes::OpenSky as Small>::Effects;
    type Held = <Forced<scenes::OpenSky> as Small>::Effects;
    let outcome = if Claimed::default().set() == Held::default().set() {
        Err(Failure("nothing is planted".to_owned()))
    } else {
        let claimed = Claimed::default().set();
        let found = shader(board, "Forced<OpenSky>", claimed).map(|_| ());
        caught(found, "which is absent")
    };
    report.outcome(
        "a scene that links more effects than it says is caught",
        outcome,
    );
}
