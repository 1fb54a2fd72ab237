//! What an image may call.
#![no_std]

pub mod integers;
pub mod operations;
