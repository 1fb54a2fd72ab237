//! An atlas of the laws: samples each of them, checks the samples, and draws a page.
//!
//! `cargo run --release -p atlas` prints a table and writes `atlas/index.html`.

mod args;
mod catalog;
mod emblem;
mod errors;
mod figure;
mod lobe;
mod measure;
mod naive;
mod number;
mod overview;
mod page;
mod probe;
mod random;
mod reference;
mod sweep;

use args::Args;
use catalog::Entry;
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use output::{Folder, say};
use page::Plate;
use std::error::Error;
use std::process::ExitCode;

const OVERVIEW: &str = "overview.svg";
const PAGE: &str = "index.html";

fn main() -> ExitCode {
    output::exit_code("atlas", run(&Args::parse()))
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    catalog::check_exponent(args.exponent)?;
    let laws = args.chosen();
    let figures: Vec<String> = laws.iter().flat_map(|law| law.files()).collect();
    let names = figures.iter().map(String::as_str);
    let mut folder = Folder::check(&args.out, names.chain([OVERVIEW, PAGE]))?;

    // indicatif draws on stderr, and only on a terminal.
    let bar = ProgressBar::new(args.samples.saturating_mul(2 * laws.len() as u64));
    let style = "{msg:20} {wide_bar} {human_pos}/{human_len} samples, {eta} left";
    bar.set_style(ProgressStyle::with_template(style)?);
    let mut plates = Vec::new();
    for law in laws {
        let entry = Entry::new(law, args.exponent)?;
        bar.set_message(entry.title);
        let work = 2 * law as u64;
        let single = measure::measure(&entry.single, args.samples, args.seed, work, &bar);
        let double = measure::measure(&entry.double, args.samples, args.seed, work + 1, &bar);
        let figure = figure::draw(&entry, [&single, &double], args.seed)?;
        plates.push(Plate {
            entry,
            reports: [single, double],
            figure,
        });
    }
    bar.finish_and_clear();

    let entries: Vec<&Entry> = plates.iter().map(|plate| &plate.entry).collect();
    let overview = overview::draw(&entries, args.seed)?;
    for plate in &plates {
        let [figure, emblem] = plate.entry.name.files();
        folder.add(figure, plate.figure.as_str());
        folder.add(emblem, emblem::svg(&plate.entry));
    }
    folder.add(OVERVIEW, overview.as_str());
    folder.add(
        PAGE,
        page::html(&plates, &overview, args.samples, args.seed),
    );
    folder.publish()?;

    say(page::table(&plates));
    say(format_args!(
        "Wrote {}",
        output::plain(args.out.join(PAGE).display())
    ));
    Ok(())
}
