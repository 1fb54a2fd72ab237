//! A law's lobe beside its disk or ball, small enough to stand in the law's documentation.

use crate::catalog::Entry;
use std::f64::consts::FRAC_PI_2;

/// Diameter of the tangent disk, in the picture's units.
const DIAMETER: f64 = 100.0;

/// The picture, in colours that can be seen on light and on dark pages. Without blank lines, so
/// that Markdown takes it as it is.
pub(crate) fn svg(entry: &Entry) -> String {
    let probe = &entry.double.probe;
    let peak = probe.lobe(0.0);
    let points: Vec<String> = (-30..=30)
        .map(|i| {
            let theta = FRAC_PI_2 * f64::from(i) / 30.0;
            let r = DIAMETER * probe.lobe(theta.abs()) / peak;
            format!("{:.1},{:.1}", r * theta.sin(), -r * theta.cos())
        })
        .collect();
    let (lobe, radius) = (points.join(" "), DIAMETER / 2.0);
    let tangent = match entry.point {
        Some(_) => format!(
            "<circle cx=\"0\" cy=\"-{radius}\" r=\"{radius}\" stroke=\"#888\"/>\n<circle cx=\"0\" \
             cy=\"-{radius}\" r=\"1.5\" fill=\"#888\" stroke=\"none\"/>\n"
        ),
        None => String::new(),
    };
    let title = match entry.point {
        Some(_) => "lobe (filled) and the disk or ball that it comes from",
        None => "lobe",
    };
    format!(
        "<svg role=\"img\" width=\"210\" height=\"120\" viewBox=\"-105 -108 210 120\" fill=\"none\" \
         stroke-width=\"1.5\" style=\"background:none\">\n<title>{}: {title}</title>\n\
         <path d=\"M-104 0H104M0 4V-107\" stroke=\"#888\" stroke-width=\"0.7\"/>\n\
         {tangent}<polygon points=\"{lobe}\" fill=\"#3b82c4\" fill-opacity=\"0.25\" \
         stroke=\"#3b82c4\"/>\n</svg>\n",
        entry.title
    )
}

#[cfg(test)]
mod tests {
    use super::svg;
    use crate::catalog::{Entry, LawName};
    use clap::ValueEnum;

    /// With COSLOBE_BLESS set they are written instead.
    #[test]
    fn the_documentation_shows_them() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured/lobes");
        for law in LawName::value_variants() {
            let entry = Entry::new(*law, 20.0).expect("20 is an exponent");
            let path = format!("{folder}/{}.svg", law.slug());
            if std::env::var_os("COSLOBE_BLESS").is_some() {
                std::fs::write(&path, svg(&entry)).expect("the folder is there");
            }
            let shown = std::fs::read_to_string(&path).unwrap_or_default();
            assert!(shown == svg(&entry), "{path} is out of date");
        }
    }
}
