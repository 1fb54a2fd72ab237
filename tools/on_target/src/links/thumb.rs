//! Instructions of the floating-point unit in Thumb code.

use super::elf::Image;

/// Addresses of all of them.
pub(super) fn fpu_instructions(image: &Image) -> Vec<u64> {
    let mapping = image.mapping();
    let mut found = Vec::new();
    for (address, bytes) in image.code() {
        scan(address, &bytes, &mapping, &mut found);
    }
    found
}

fn scan(start: u64, bytes: &[u8], mapping: &[(u64, bool)], found: &mut Vec<u64>) {
    let half = |at: usize| Some(u16::from_le_bytes([*bytes.get(at)?, *bytes.get(at + 1)?]));
    let mut at = 0;
    while let Some(first) = half(at) {
        let address = start + at as u64;
        // Before the first mark there is code.
        let marks = mapping.partition_point(|m| m.0 <= address);
        if marks > 0 && !mapping[marks - 1].1 {
            at += 2;
            continue;
        }
        if is_long(first) {
            if half(at + 2).is_some_and(|second| is_fpu(first, second)) {
                found.push(address);
            }
            at += 2;
        }
        at += 2;
    }
}

/// The first half of a 32-bit instruction (Armv7-M, A5.1).
fn is_long(first: u16) -> bool {
    first >> 11 >= 0b11101
}

/// A coprocessor instruction (A5.3.18) for coprocessor 10 or 11.
fn is_fpu(first: u16, second: u16) -> bool {
    first & 0xEC00 == 0xEC00 && matches!(second >> 8 & 15, 10 | 11)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_is_found_among_code_and_not_in_data() {
        // As assembled by Debian's binutils, little-endian halves.
        let code: [u16; 13] = [
            0xEE30, 0x0A20, // vadd.f32 s0, s0, s1
            0x4608, // mov r0, r1
            0xED9F, 0x0A01, // vldr s0, [pc, #4]
            0xFB00, 0xF001, // mul r0, r0, r1
            0xEEB1, 0x0AC0, // vsqrt.f32 s0, s0
            0x4770, // bx lr
            0xEE30, 0x0A20, // a constant that looks like the first
            0xBF00,
        ];
        let bytes: Vec<u8> = code.iter().flat_map(|h| h.to_le_bytes()).collect();
        let mut found = Vec::new();
        scan(0x100, &bytes, &[(0x100, true), (0x114, false)], &mut found);
        assert_eq!(found, [0x100, 0x106, 0x10E]);
    }
}
