//! Instructions by callgrind: this program runs itself once under valgrind, and each cell is
//! dumped apart.

use std::fs;
use std::hint::black_box;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The hidden subcommand that valgrind runs.
pub const SUBCOMMAND: &str = "count-cells";
/// What callgrind calls [`counted`], whose symbol is mangled.
const SYMBOL: &str = concat!(module_path!(), "::counted");

/// Why there are no counts.
pub enum Missing {
    /// No valgrind: the columns stay empty.
    Skipped(String),
    /// Something that should have worked did not.
    Failed(String),
}

/// Counts start at zero where this function is entered, and are dumped where it returns.
#[inline(never)]
fn counted(cell: &mut dyn FnMut()) {
    cell();
    // Not a tail call: callgrind must see this function return.
    black_box(());
}

/// The child's side: what each cell runs, then its empty loop; a line for each.
pub fn child<'a>(cells: impl Iterator<Item = [&'a mut (dyn FnMut() + 'static); 2]>) {
    for [run, empty] in cells {
        // Once before, so that lazily bound symbols are not billed to a cell.
        run();
        counted(run);
        counted(empty);
        println!("counted");
    }
}

/// A folder that is gone when the counts have been read.
struct Scratch(PathBuf);

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Mean instructions of a call of each cell, of which this is told the calls; `step` hears of each.
pub fn counts(calls: &[u64], step: impl Fn()) -> Result<Vec<f64>, Missing> {
    if let Err(e) = Command::new("valgrind").arg("--version").output() {
        return Err(Missing::Skipped(format!(
            "valgrind does not start ({e}); `apt install valgrind`"
        )));
    }
    let name = format!("{}-{}", env!("CARGO_CRATE_NAME"), std::process::id());
    let scratch = Scratch(std::env::temp_dir().join(name));
    let failed = |what: &str, e: std::io::Error| Missing::Failed(format!("{what}: {e}"));
    fs::create_dir_all(&scratch.0).map_err(|e| failed("temporary folder", e))?;
    let program = std::env::current_exe().map_err(|e| failed("own path", e))?;
    let mut child = Command::new("valgrind")
        .args(["--tool=callgrind", "--quiet", "--compress-strings=no"])
        .arg(format!("--zero-before={SYMBOL}"))
        .arg(format!("--dump-after={SYMBOL}"))
        .arg(format!(
            "--callgrind-out-file={}",
            scratch.0.join("cost").display()
        ))
        .arg(program)
        .arg(SUBCOMMAND)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| failed("valgrind", e))?;
    if let Some(stdout) = child.stdout.take() {
        BufReader::new(stdout).lines().for_each(|_| step());
    }
    let end = child
        .wait_with_output()
        .map_err(|e| failed("valgrind", e))?;
    if !end.status.success() {
        return Err(Missing::Failed(format!(
            "valgrind: {}: {}",
            end.status,
            String::from_utf8_lossy(&end.stderr)
        )));
    }
    calls
        .iter()
        .enumerate()
        .map(|(i, &calls)| {
            let total = summary(&scratch.0, 2 * i + 1)?;
            let empty = summary(&scratch.0, 2 * i + 2)?;
            Ok((total - empty) / calls as f64)
        })
        .collect()
}

/// The instructions of dump `n`.
fn summary(folder: &Path, n: usize) -> Result<f64, Missing> {
    let path = folder.join(format!("cost.{n}"));
    let text = fs::read_to_string(&path).map_err(|e| {
        Missing::Failed(format!(
            "{}: {e}; expected a dump of callgrind for each cell",
            path.display()
        ))
    })?;
    let total = text
        .lines()
        .find_map(|l| l.strip_prefix("summary: "))
        .and_then(|n| n.trim().parse().ok());
    total.ok_or_else(|| {
        Missing::Failed(format!(
            "{}: expected a line `summary: INSTRUCTIONS`",
            path.display()
        ))
    })
}
