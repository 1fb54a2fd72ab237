//! The table of costs.
use crate::cells::cells;
use crate::count::{Missing, counts};
use std::error::Error;
use std::path::Path;

pub(crate) fn run(_out: &Path) -> Result<(), Box<dyn Error>> {
    let cells = cells();
    for c in &cells {
        let same = cells
            .iter()
            .find(|d| d.scene == c.scene && d.way == "needed");
        if let Some(n) = same {
            if (n.pixels)() != (c.pixels)() {
                println!("DIFFERS {} {}", c.scene, c.way);
            }
        }
    }
    let calls: Vec<u64> = cells.iter().map(|c| c.samples).collect();
    let counts = match counts(&calls, || ()) {
        Ok(c) => c,
        Err(Missing::Skipped(e) | Missing::Failed(e)) => return Err(e.into()),
    };
    for (c, n) in cells.iter().zip(counts) {
        println!("{:<16}{:<8}{n:10.1}", c.scene, c.way);
    }
    Ok(())
}
