//! Shares of a frame as files, and how they are put together: the sums of each pixel, exactly.

use crate::args::Share;
use crate::image::Frame;
use output::{File, plain};
use shade_core::Pixel;
use std::fs;
use std::io::Read;
use std::path::PathBuf;

/// First bytes of a share's file.
const MAGIC: &[u8; 8] = b"shade\x01\r\n";
/// Bytes before the pixels, and of a pixel.
const HEADER: usize = 48;
const PIXEL: usize = 8 + 9 * 8;

/// What all shares of a frame have in common.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Frames {
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) exposure: f64,
    /// A digest of the scene and of how it is rendered.
    pub(crate) digest: u64,
}

/// FNV-1a, to tell frames apart (not to withstand anyone).
pub(crate) fn digest(parts: &[&str]) -> u64 {
    let bytes = parts.iter().flat_map(|p| p.bytes().chain([0]));
    bytes.fold(0xCBF2_9CE4_8422_2325, |h, b| {
        (h ^ u64::from(b)).wrapping_mul(0x100_0000_01B3)
    })
}

/// The file of one share.
pub(crate) fn write(out: &File, of: &Frames, share: Share, frame: &Frame) -> Result<(), String> {
    let mut data = MAGIC.to_vec();
    let numbers = [
        u64::from(of.width),
        u64::from(of.height),
        of.exposure.to_bits(),
        of.digest,
        u64::from(share.index) << 32 | u64::from(share.of),
    ];
    numbers.iter().for_each(|n| data.extend(n.to_le_bytes()));
    for block in frame.blocks_of(share) {
        for at in frame.places(block) {
            let p = frame.get(at);
            data.extend(u64::from(p.count).to_le_bytes());
            let sums = p.first.iter().chain(&p.sum).chain(&p.squares);
            sums.for_each(|x| data.extend(x.to_bits().to_le_bytes()));
        }
    }
    out.write(&data)
}

/// The frame of all shares. Every one has to be there once, and of the same frame.
pub(crate) fn merge(paths: &[PathBuf]) -> Result<(Frames, Frame), String> {
    let mut whole: Option<(Frames, u32, Frame, Vec<u32>)> = None;
    for path in paths {
        let wrong = |what: String| format!("{}: {what}", plain(path.display()));
        let open = || -> std::io::Result<_> {
            let (mut file, mut head) = (fs::File::open(path)?, Vec::new());
            file.by_ref().take(HEADER as u64).read_to_end(&mut head)?;
            Ok((file, head))
        };
        let unread = |e| wrong(format!("{e}; expected a file of --tiles"));
        let (file, head) = open().map_err(unread)?;
        let (of, share) = header(&head).map_err(wrong)?;
        let (first, n, frame, seen) = whole.get_or_insert_with(|| {
            (
                of.clone(),
                share.of,
                Frame::new(of.width, of.height),
                Vec::new(),
            )
        });
        if *first != of || *n != share.of {
            return Err(wrong(
                "a share of another frame; expected shares of one frame".to_owned(),
            ));
        }
        if seen.contains(&share.index) {
            return Err(wrong(format!(
                "share {}/{n} again; expected each once",
                share.index
            )));
        }
        seen.push(share.index);
        fill(frame, share, file).map_err(wrong)?;
        frame.check().map_err(wrong)?;
    }
    let (of, n, frame, mut seen) = whole.ok_or("no files; expected all shares of a frame")?;
    seen.sort_unstable();
    match (1..=n)
        .zip(seen.into_iter().map(Some).chain([None]))
        .find(|(i, s)| Some(*i) != *s)
    {
        Some((missing, _)) => Err(format!("share {missing}/{n} is missing; expected all {n}")),
        None => Ok((of, frame)),
    }
}

fn header(head: &[u8]) -> Result<(Frames, Share), String> {
    let expected = || "expected a file that --tiles wrote".to_owned();
    let numbers = head.strip_prefix(MAGIC).ok_or_else(expected)?;
    if head.len() != HEADER {
        return Err(expected());
    }
    let number = |i: usize| {
        let bytes = numbers[8 * i..8 * i + 8].try_into();
        bytes.map(u64::from_le_bytes).map_err(|_| expected())
    };
    let side = |n: u64| {
        u16::try_from(n)
            .ok()
            .filter(|&n| (1..=shade::file::SIDE).contains(&i64::from(n)))
    };
    let shares = number(4)?;
    let share = Share {
        index: (shares >> 32) as u32,
        of: shares as u32,
    };
    let exposure = f64::from_bits(number(2)?);
    if !(1..=share.of).contains(&share.index) || !exposure.is_finite() {
        return Err(expected());
    }
    let of = Frames {
        width: side(number(0)?).ok_or_else(expected)?,
        height: side(number(1)?).ok_or_else(expected)?,
        exposure,
        digest: number(3)?,
    };
    Ok((of, share))
}

fn fill(frame: &mut Frame, share: Share, file: fs::File) -> Result<(), String> {
    let blocks: Vec<u32> = frame.blocks_of(share).collect();
    let pixels: usize = blocks.iter().map(|&b| frame.places(b).count()).sum();
    let bytes = pixels * PIXEL;
    let mut body = Vec::new();
    // One more would be too many: not all of what may have no end.
    let read = file.take(bytes as u64 + 1).read_to_end(&mut body);
    read.map_err(|e| e.to_string())?;
    if body.len() != bytes {
        let than = if body.len() < bytes { "fewer" } else { "more" };
        return Err(format!(
            "{than} than {bytes} bytes of pixels; expected as many"
        ));
    }
    let mut rest = body.chunks_exact(PIXEL).map(|bytes| {
        let mut numbers = bytes
            .chunks_exact(8)
            .map(|b| b.iter().rev().fold(0, |n, &b| n << 8 | u64::from(b)));
        let count = numbers.next().unwrap_or(0) as u32;
        let mut rgb = || core::array::from_fn(|_| f64::from_bits(numbers.next().unwrap_or(0)));
        Pixel {
            count,
            first: rgb(),
            sum: rgb(),
            squares: rgb(),
            rests: [[0.0; 3]; 2],
        }
    });
    for block in blocks {
        let pixels: Vec<Pixel<f64>> = rest.by_ref().take(frame.places(block).count()).collect();
        frame.put(block, &pixels);
    }
    Ok(())
}
