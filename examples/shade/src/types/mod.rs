//! What accuracy costs, in a picture: one scene in every number type with the same random words.

mod draw;
mod page;
mod sheet;

use crate::image::write_png;
use draw::{Means, halved, median, passes, reference, rmse, worse_than};
use indicatif::{ProgressBar, ProgressStyle};
use output::{File, plain, say};
use shade::file::{Raw, scene};
use shade_core::{Number, NumberVisitor, Scene, Set, every_number};
use std::error::Error;
use std::path::Path;
use std::time::Instant;

/// Samples of a pixel at which the pictures are compared.
const COUNTS: [u32; 5] = [1, 4, 16, 64, 256];
/// Samples of the converged picture, in `f64` and with words of its own.
const CONVERGED: u32 = 4096;
/// Rounds over the types, of every row of pixels by one thread; the quickest of each row counts.
const ROUNDS: usize = 25;
const TIMED: u32 = 2;

/// One number type's pictures.
struct Study {
    name: &'static str,
    /// At each of [`COUNTS`].
    means: Vec<Means>,
    /// Renders a row, for its time.
    timed: Box<dyn Fn(u16)>,
    /// Of each row.
    seconds: Vec<f64>,
}

/// What the page says of a type, at each of [`COUNTS`].
struct Row {
    name: &'static str,
    /// `f32`'s is 1.
    time: f64,
    /// From the converged picture, and from the picture in `Precise<f64>` of the same words.
    noise: Vec<f64>,
    own: Vec<f64>,
    /// Of the median pixel, at the last count.
    typical: f64,
    /// Pixels that are off by more than [`FAR`] of the mean radiance there: paths that went another
    /// way.
    far: usize,
}

const FAR: f64 = 1e-3;

fn prepared<T: Number>(raw: &Raw) -> Option<Scene<[T; 3]>> {
    let (mut scene, _) = scene::<[T; 3]>(raw, None)?;
    halved(&mut scene.camera);
    Some(scene)
}

/// Takes pictures in every number type.
struct Studying<'a> {
    raw: &'a Raw,
    set: Set,
    progress: &'a ProgressBar,
    studies: Vec<Study>,
}

impl NumberVisitor for Studying<'_> {
    fn number<T: Number>(&mut self) {
        let Some(scene) = prepared::<T>(self.raw) else {
            return;
        };
        let (set, rows) = (self.set, usize::from(scene.camera.height));
        self.studies.push(Study {
            name: T::NAME,
            means: passes(&scene, set, &COUNTS, self.progress),
            timed: Box::new(move |y| draw::timed(&scene, set, y, TIMED)),
            seconds: vec![f64::INFINITY; rows],
        });
    }
}

pub(crate) fn run(raw: &Raw, path: &Path, out: &Path) -> Result<(), Box<dyn Error>> {
    let space = || format!("{}: flatland; expected a scene in space", path.display());
    if raw.flatland || raw.law.is_some() {
        return Err(format!(
            "{}; expected a scene in space without a `law`",
            path.display()
        )
        .into());
    }
    let [picture, text] = ["png", "md"].map(|kind| out.with_extension(kind));
    let picture = File::check(&picture, &[path])?;
    let text = File::check(&text, &[path])?;
    let mut exact = prepared::<f64>(raw).ok_or_else(space)?;
    // One set for all: what a type's rounding makes of a parameter must not change it.
    let set = exact.called_for();
    let (width, height) = (exact.camera.width, exact.camera.height);
    let progress = ProgressBar::new(6 * u64::from(height));
    progress.set_style(ProgressStyle::with_template(
        "{bar:40} {pos}/{len} rows, {eta} left",
    )?);
    exact.seed ^= 1 << 23;
    let converged = reference(&exact, set, CONVERGED, &progress);
    let mut studying = Studying {
        raw,
        set,
        progress: &progress,
        studies: Vec::new(),
    };
    every_number(&mut studying);
    progress.finish_and_clear();
    let mut studies = studying.studies;
    time(&mut studies);
    let rows = rows(&studies, &converged).ok_or("a type without pictures")?;
    let exposure = raw.image.exposure.as_ref().map_or(1.0, |e| *e.get_ref());
    let (gains, sheet) = sheet::sheet(&studies, &converged, (width, height), exposure);
    let page = page::page(&page::Facts {
        title: &plain(&raw.title),
        path,
        out,
        size: (width, height),
        mean: draw::mean(&converged),
        rows: &rows,
        gains: &gains,
    });
    let (columns, lines) = sheet::LAYOUT;
    write_png(&picture, width * columns, height * lines, &sheet)?;
    text.write(page.as_bytes())?;
    say(page);
    Ok(())
}

/// Times in interleaved rounds. A row takes well under a millisecond: other programs do not get
/// into all.
fn time(studies: &mut [Study]) {
    for _ in 0..ROUNDS {
        for study in &mut *studies {
            for (y, seconds) in (0..).zip(&mut study.seconds) {
                let start = Instant::now();
                (study.timed)(y);
                *seconds = seconds.min(start.elapsed().as_secs_f64());
            }
        }
    }
}

fn rows(studies: &[Study], converged: &Means) -> Option<Vec<Row>> {
    let best = studies.last()?;
    let (most, far) = (best.means.last()?, FAR * draw::mean(converged));
    let seconds = |s: &Study| s.seconds.iter().sum::<f64>();
    let base = seconds(studies.iter().find(|s| s.name == "f32")?);
    let row = |s: &Study| {
        let own = s.means.iter().zip(&best.means);
        let means = s.means.last()?;
        Some(Row {
            name: s.name,
            time: seconds(s) / base,
            noise: s.means.iter().map(|m| rmse(m, converged)).collect(),
            own: own.map(|(m, b)| rmse(m, b)).collect(),
            typical: median(means, most),
            far: worse_than(far, means, most),
        })
    };
    studies.iter().map(row).collect()
}
