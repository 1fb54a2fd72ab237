//! From the command line to the image.

use crate::args::{Args, NumberName, Share, Task};
use crate::image::Frame;
use crate::tiles::{self, Frames, digest};
use crate::{plan, render, table, types};
use coslobe::{CircleShell, Lambert};
use indicatif::{ProgressBar, ProgressStyle};
use kit::study::count;
use output::{File, plain, say};
use shade::cells::cells;
use shade::file::{BYTES, Raw, World, parse, scene};
use shade::sets::{Compiled, Job};
use shade_core::effect::Lamp;
use shade_core::{Asked, Effects, Number, NumberVisitor, Sampling, Scene, Set, Vector};
use std::error::Error;
use std::fs;
use std::io::Read;
use std::path::Path;
use std::time::Instant;

type Done<T> = Result<T, Box<dyn Error>>;

pub(crate) fn run(args: &Args) -> Done<()> {
    match &args.task {
        Some(Task::CountCells) => {
            let mut cells = cells();
            count::child(cells.iter_mut().map(|c| [&mut *c.run, &mut *c.empty]));
            Ok(())
        }
        Some(Task::Table { out }) => table::run(out),
        Some(Task::Types { scene, out }) => types::run(&read(scene)?.1, scene, out),
        Some(Task::Merge { tiles, out }) => {
            let inputs: Vec<&Path> = tiles.iter().map(|t| t.as_path()).collect();
            let file = File::check(out, &inputs)?;
            let (of, frame) = tiles::merge(tiles)?;
            report(&frame);
            frame.write_png(&file, of.exposure)?;
            say(format_args!("wrote {}", plain(out.display())));
            Ok(())
        }
        None => image(args),
    }
}

fn image(args: &Args) -> Done<()> {
    let (Some(path), Some(out)) = (&args.scene, &args.out) else {
        return Err("expected a scene file and -o OUT.png".into());
    };
    let (text, raw) = read(path)?;
    let file = File::check(out, &[path])?;
    if let Some(threads) = args.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        pool.build_global()?;
    }
    say(plain(format_args!("{}: {}", path.display(), raw.title)));
    let frame = match (raw.flatland, args.number) {
        // What most renders take is compiled for each set of effects; the others ask.
        (false, NumberName::F32) => {
            frame::<[f32; 3]>(&raw, args, |of, draw| apart(of, draw, Lambert))
        }
        (true, NumberName::F32) => {
            frame::<[f32; 2]>(&raw, args, |of, draw| apart(of, draw, CircleShell))
        }
        (_, number) => {
            let mut asking = Asking(&raw, args, Err("no number type".into()));
            number.show(&mut asking);
            asking.2
        }
    }?;
    frame
        .check()
        .map_err(|e| format!("{e}; a fault of the shader, by which nothing is written"))?;
    let exposure = raw.image.exposure.as_ref().map_or(1.0, |e| *e.get_ref());
    match args.tiles {
        None => frame.write_png(&file, exposure)?,
        Some(share) => {
            let how = format!("{:?} {:?} {:?}", args.samples, args.number, args.law);
            let of = Frames {
                width: frame.width,
                height: frame.height,
                exposure,
                digest: digest(&[&text, &how]),
            };
            tiles::write(&file, &of, share, &frame)?;
        }
    }
    say(format_args!("wrote {}", plain(out.display())));
    Ok(())
}

/// Draws the frame in any number type.
struct Asking<'a>(&'a Raw, &'a Args, Done<Frame>);

impl NumberVisitor for Asking<'_> {
    fn number<T: Number>(&mut self) {
        let Asking(raw, args, done) = self;
        *done = if raw.flatland {
            frame::<[T; 2]>(raw, args, asked)
        } else {
            frame::<[T; 3]>(raw, args, asked)
        };
    }
}

fn read(path: &Path) -> Done<(String, Raw)> {
    let name = path.display().to_string();
    // One byte more is too long: not all of what may have no end.
    let mut text = String::new();
    fs::File::open(path)
        .and_then(|file| file.take(BYTES as u64 + 1).read_to_string(&mut text))
        .map_err(|e| format!("{name}: {e}; expected a scene file"))?;
    let raw = parse(&name, &text)?;
    Ok((text, raw))
}

/// All that a share of the frame is drawn from.
struct Draw<'a, L> {
    law: L,
    set: Set,
    /// The law is that of diffuse reflection itself.
    is_own: bool,
    samples: u32,
    share: Share,
    progress: &'a ProgressBar,
}

struct Exactly<'a, V: Vector, L>(&'a Scene<V>, Draw<'a, L>);

impl<V: Vector, L: Sampling<V>> Job for Exactly<'_, V, L> {
    type Out = Frame;
    fn run<E: Effects>(self, e: E) -> Frame {
        let Exactly(scene, draw) = self;
        render::render(scene, e, &draw.law, draw.samples, draw.share, draw.progress)
    }
}

fn asked<V: Vector>(scene: &Scene<V>, draw: Draw<V::Law>) -> Frame {
    let e = Asked(draw.set);
    Exactly(scene, draw).run(e)
}

fn apart<V: Compiled>(scene: &Scene<V>, draw: Draw<V::Law>, own: impl Sampling<V>) -> Frame {
    if !draw.is_own || !V::is_apart(draw.set) {
        return asked(scene, draw);
    }
    let Draw {
        set,
        is_own,
        samples,
        share,
        progress,
        ..
    } = draw;
    let draw = Draw {
        law: own,
        set,
        is_own,
        samples,
        share,
        progress,
    };
    V::exactly(set, Exactly(scene, draw))
}

fn frame<V: World>(
    raw: &Raw,
    args: &Args,
    render: impl FnOnce(&Scene<V>, Draw<V::Law>) -> Frame,
) -> Done<Frame> {
    let world = if raw.flatland { "flatland" } else { "space" };
    let (mut scene, law) = scene::<V>(raw, args.law).ok_or_else(|| {
        format!("--law: expected a law of {world}, and an `exponent` in the scene for cos_power")
    })?;
    let needed = scene.called_for();
    let set = if args.force_all { Set::ALL } else { needed };
    if args.force_all && scene.lamps.is_empty() {
        let _ = scene.lamps.push(Lamp::neutral());
    }
    say(plan::describe(&scene, Asked(set), &law, needed));
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} blocks, {eta} left")?;
    let progress = ProgressBar::new(0).with_style(style);
    let samples = args.samples.unwrap_or(*raw.image.samples.get_ref() as u32);
    let draw = Draw {
        is_own: args.law.is_none() && raw.law.is_none(),
        law,
        set,
        samples,
        share: args.tiles.unwrap_or(Share::WHOLE),
        progress: &progress,
    };
    let start = Instant::now();
    let frame = render(&scene, draw);
    let seconds = start.elapsed().as_secs_f64();
    progress.finish_and_clear();
    let samples: f64 = frame.pixels.iter().map(|p| f64::from(p.count)).sum();
    let rate = samples / seconds;
    say(format_args!(
        "{samples:.3e} samples in {seconds:.2} s: {rate:.3e} samples a second"
    ));
    report(&frame);
    Ok(frame)
}

fn report(frame: &Frame) {
    if frame.pixels.iter().all(|p| p.count < 2) {
        say("noise: no estimate from one sample a pixel");
        return;
    }
    let (mean, error) = frame.noise();
    let share = if mean > 0.0 {
        100.0 * error / mean
    } else {
        0.0
    };
    say(format_args!(
        "noise: a pixel's standard error is {error:.2e} (root mean square), {share:.2} % of the mean radiance {mean:.4}"
    ));
}
