//! The power-on self-test: its limits, its false alarms, and planted faults that it must see.
//!
//! `cargo test --release --test self_test -- --ignored` rewrites `src/self_test/table.rs` and
//! `docs/self_test.md` (two minutes) and tries the false alarms ten times as often.

#[path = "self_test/alarms.rs"]
mod alarms;
#[path = "self_test/faults.rs"]
mod faults;
#[path = "self_test/generators.rs"]
mod generators;
#[path = "self_test/limits.rs"]
mod limits;
#[path = "self_test/page.rs"]
mod page;
#[path = "self_test/samplers.rs"]
mod samplers;
#[path = "self_test/semantics.rs"]
mod semantics;
