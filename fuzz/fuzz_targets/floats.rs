#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| checks::floats::check(data));
