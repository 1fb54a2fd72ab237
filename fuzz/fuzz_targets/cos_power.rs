#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| checks::cos_power::check(data));
