//! The power-on self-test: its limits, its false alarms, and planted faults that it must see.
//!
//! `cargo test --release --test self_test -- --ignored` rewrites `src/self_test/table.rs` and
//! `docs/measured/self_test.md` (two minutes) and tries the false alarms ten times as often.

mod alarms;
mod faults;
mod generators;
mod limits;
mod page;
mod samplers;
mod semantics;
