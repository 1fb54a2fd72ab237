//! The page, and the table that it shares with the terminal.

use crate::catalog::Entry;
use crate::measure::Report;

/// A law with what was seen of it and its figure.
pub(crate) struct Plate {
    pub(crate) entry: Entry,
    pub(crate) reports: [Report; 2],
    pub(crate) figure: String,
}

const COLUMNS: [&str; 10] = [
    "law",
    "density",
    "type",
    "mean cos θ",
    "exact",
    "z",
    "χ² p",
    "worst ulp",
    "at tail p",
    "words",
];

/// One row a law and number type.
pub(crate) fn rows(plate: &Plate) -> Vec<[String; 10]> {
    let entry = &plate.entry;
    let row = |report: &Report| {
        let (fewest, most) = report.words;
        [
            entry.title.to_owned(),
            format!("{} {}", entry.formula, entry.unit),
            report.format.to_owned(),
            format!("{:.6}", report.mean_cos),
            format!("{:.6}", report.exact_mean),
            format!("{:+.2}", report.z),
            report
                .chi_squared_p
                .map_or("–".to_owned(), |p| format!("{p:.4}")),
            format!("{:.3}", report.sweep.worst_ulp),
            report.sweep.worst_input.clone(),
            if fewest == most {
                most.to_string()
            } else {
                format!("{fewest}–{most}")
            },
        ]
    };
    plate.reports.iter().map(row).collect()
}

/// The table as plain text.
pub(crate) fn table(plates: &[Plate]) -> String {
    let mut rows: Vec<[String; 10]> = vec![COLUMNS.map(str::to_owned)];
    rows.extend(plates.iter().flat_map(self::rows));
    let width = |i: usize| rows.iter().map(|r| r[i].chars().count()).max().unwrap_or(0);
    let widths: [usize; 10] = std::array::from_fn(width);
    let mut out = String::new();
    for row in &rows {
        let cells: Vec<String> = row
            .iter()
            .zip(widths)
            .map(|(cell, width)| format!("{cell:width$}"))
            .collect();
        out.push_str(cells.join("  ").trim_end());
        out.push('\n');
    }
    out
}

/// The page as HTML that needs no other file.
pub(crate) fn html(plates: &[Plate], overview: &str, samples: u64, seed: u64) -> String {
    let heads: String = COLUMNS.iter().map(|c| format!("<th>{c}</th>")).collect();
    let body: String = plates
        .iter()
        .flat_map(rows)
        .map(|row| {
            let cells: String = row.iter().map(|c| format!("<td>{c}</td>")).collect();
            format!("<tr>{cells}</tr>\n")
        })
        .collect();
    let sections: String = plates.iter().map(section).collect();
    let tried = plates.first().map_or(0, |p| p.reports[0].sweep.tried);
    include_str!("page.html")
        .replace("{overview}", overview)
        .replace("{heads}", &heads)
        .replace("{body}", &body)
        .replace("{sections}", &sections)
        .replace("{samples}", &grouped(samples))
        .replace("{tried}", &grouped(tried))
        .replace("{seed}", &seed.to_string())
}

fn section(plate: &Plate) -> String {
    let Plate { entry, figure, .. } = plate;
    format!(
        "<section id=\"{slug}\">\n<h2>{title} <span>{formula} {unit}</span></h2>\n\
         <p><b>By {measure}.</b> {caption}</p>\n<figure>\n{figure}</figure>\n</section>\n",
        slug = entry.name.slug(),
        title = entry.title,
        formula = entry.formula,
        unit = entry.unit,
        measure = entry.measure,
        caption = entry.caption,
    )
}

/// Digits in groups of three, by narrow spaces.
fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    out
}
