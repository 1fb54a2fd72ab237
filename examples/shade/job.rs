//! From the command line to the image.

use crate::args::{Args, NumberName, Share, Task};
use crate::file::{Raw, World, parse, scene};
use crate::image::Frame;
use crate::{plan, render};
use coslobe::{Fast, Precise};
use indicatif::{ProgressBar, ProgressStyle};
use shade_core::effect::Lamp;
use shade_core::{Asked, Set};
use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::Instant;

pub(crate) fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    match &args.task {
        Some(Task::CountCells) => {
            let mut cells = crate::cells::cells();
            crate::count::child(cells.iter_mut().map(|c| [&mut *c.run, &mut *c.empty]));
            return Ok(());
        }
        Some(Task::Table { out }) => return crate::table::run(out),
        Some(Task::Merge { .. }) => todo!(),
        None => {}
    }
    let (Some(path), Some(out)) = (&args.scene, &args.out) else {
        return Err("expected a scene and -o OUT.png".into());
    };
    let raw = read(path)?;
    if let Some(threads) = args.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        pool.build_global()?;
    }
    println!("{}: {}", path.display(), raw.title);
    let frame = match (raw.flatland, args.number) {
        (false, NumberName::F32) => frame::<[f32; 3]>(&raw, args),
        (false, NumberName::F64) => frame::<[f64; 3]>(&raw, args),
        (false, NumberName::Fast) => frame::<[Fast<f32>; 3]>(&raw, args),
        (false, NumberName::Precise) => frame::<[Precise<f32>; 3]>(&raw, args),
        (true, NumberName::F32) => frame::<[f32; 2]>(&raw, args),
        (true, NumberName::F64) => frame::<[f64; 2]>(&raw, args),
        (true, NumberName::Fast) => frame::<[Fast<f32>; 2]>(&raw, args),
        (true, NumberName::Precise) => frame::<[Precise<f32>; 2]>(&raw, args),
    }?;
    let exposure = raw.image.exposure.as_ref().map_or(1.0, |e| *e.get_ref());
    frame.write_png(out, exposure)?;
    println!("wrote {}", out.display());
    Ok(())
}

pub(crate) fn read(path: &Path) -> Result<Raw, Box<dyn Error>> {
    let name = path.display().to_string();
    let text =
        fs::read_to_string(path).map_err(|e| format!("{name}: {e}; expected a scene file"))?;
    Ok(parse(&name, &text)?)
}

fn frame<V: World>(raw: &Raw, args: &Args) -> Result<Frame, Box<dyn Error>> {
    let world = if raw.flatland { "flatland" } else { "space" };
    let (mut scene, law) = scene::<V>(raw, args.law).ok_or_else(|| {
        format!("--law: not a law of {world}, or cos_power without an exponent in the scene")
    })?;
    let needed = scene.called_for();
    let e = Asked(if args.force_all { Set::ALL } else { needed });
    if args.force_all && scene.lamps.is_empty() {
        let _ = scene.lamps.push(Lamp::neutral());
    }
    let samples = args.samples.unwrap_or(*raw.image.samples.get_ref() as u32);
    println!("{}", plan::describe(&scene, e, &law, needed));
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} blocks, {eta} left")?;
    let progress = ProgressBar::new(0).with_style(style);
    let start = Instant::now();
    let share = args.tiles.unwrap_or(Share::WHOLE);
    let frame = render::render(&scene, e, &law, samples, share, &progress);
    let seconds = start.elapsed().as_secs_f64();
    progress.finish_and_clear();
    let pixels = frame.pixels.iter().filter(|p| p.count > 0).count();
    let total = pixels as f64 * f64::from(samples);
    let (mean, error) = frame.noise();
    println!(
        "{:.3e} samples in {seconds:.2} s: {:.3e} samples a second",
        total,
        total / seconds
    );
    println!(
        "noise: standard error of a pixel {error:.2e} (root mean square), {:.2} % of the mean radiance {mean:.4}",
        100.0 * error / mean
    );
    Ok(frame)
}
