//! Proofs of release images, by what is linked into them.

mod elf;
mod sources;
mod symbols;
mod thumb;

use crate::failure::Result;
use crate::report::Report;
pub(crate) fn run(_: &mut Report) -> Result<()> {
    for calls in std::env::var("CALLS").unwrap().split(';') {
        for board in &crate::boards::BOARDS[..] {
            let path = crate::build::Build {
                board,
                package: "links",
                variables: vec![("COSLOBE_CALLS", calls.to_owned())],
                features: &[],
                debug: false,
            }
            .image()?;
            let image = elf::Image::read(&path)?;
            println!(
                "{} {calls}: ram {} double {} single {} fpu {} {:?}",
                board.name,
                image.static_ram(),
                image
                    .symbols()
                    .iter()
                    .filter(|s| symbols::is_double(s))
                    .count(),
                image
                    .symbols()
                    .iter()
                    .filter(|s| symbols::is_single(s))
                    .count(),
                thumb::fpu_instructions(&image).len(),
                sources::bytes_by_file(&path, &image)?
            );
        }
    }
    Ok(())
}
