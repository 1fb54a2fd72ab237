//! What accuracy costs: errors, instructions, time and random words of every operation of every
//! law in every number type, and of what others would write instead.
//!
//! ```text
//! cargo run --release --example accuracy_cost                    # strided errors: some minutes
//! cargo run --release --example accuracy_cost -- --stride 1      # every f32: about an hour
//! cargo run --release --example accuracy_cost -- --keep-errors   # costs alone, errors as they stand
//! cargo run --release --example accuracy_cost -- --check         # counts twice, expects no difference
//! ```
//!
//! Needs valgrind (`apt install valgrind`) for the instructions.

#[path = "../../tests/accuracy/mod.rs"]
mod accuracy;
mod catalog;
mod cell;
mod contender;
mod count;
mod errors;
mod inputs;
mod peers;
mod time;

fn main() {
    let mut list = catalog::all();
    if std::env::args().nth(1).as_deref() == Some(count::SUBCOMMAND) {
        count::child(&mut list);
        return;
    }
    let counts = match count::counts(&list, || ()) {
        Ok(c) => c,
        Err(count::Missing::Skipped(e) | count::Missing::Failed(e)) => panic!("{e}"),
    };
    let times = time::times(&mut list, || ());
    for ((c, n), t) in list.iter().zip(counts).zip(times) {
        let e = c.measure.as_ref().map(|m| m(c.own, 64));
        println!(
            "{:14} {:16} {:50} {n:8.1} {t:8.2} ns {:?} {:?}",
            contender::law_name(c.law),
            c.operation,
            c.name,
            c.cell.words.map(|w| (w.next_u32, w.next_u64)),
            e.map(|e| (e.worst(), e.worst_in_tail())),
        );
    }
}
