//! Routines of the compiler by name.

/// Whether it computes in `f64`: `__aeabi_dadd`, `__aeabi_f2d`, `__muldf3`, `__truncdfsf2`, …
pub(super) fn is_double(name: &str) -> bool {
    is_soft(name, 'd', "df")
}

/// Whether it computes in `f32` or converts from or to it: `__aeabi_fmul`, `__addsf3`, …
pub(super) fn is_single(name: &str) -> bool {
    is_soft(name, 'f', "sf")
}

/// Whether it multiplies, divides or shifts integers of 64 bits, or divides those of 32.
pub(super) fn is_long(name: &str) -> bool {
    let long = [
        "lmul", "llsl", "llsr", "lasr", "ldivmod", "uldivmod", "idiv", "uidiv", "idivmod",
        "uidivmod",
    ];
    let arm = name.strip_prefix("__aeabi_");
    arm.is_some_and(|name| long.contains(&name))
        || [
            "__muldi3",
            "__udivmoddi4",
            "__divdi3",
            "__udivdi3",
            "__udivsi3",
            "__divsi3",
        ]
        .contains(&name)
}

/// `letter`: the type in names of the Arm ABI; `mode`: in names of libgcc's.
fn is_soft(name: &str, letter: char, mode: &str) -> bool {
    let Some(name) = name.strip_prefix("__") else {
        return false;
    };
    match name.strip_prefix("aeabi_") {
        // What it works on comes first, but for the comparisons that set flags; or last, in
        // conversions.
        Some(name) => {
            name.starts_with(letter)
                || name.starts_with(&format!("c{letter}cmp"))
                || name.ends_with(&format!("2{letter}"))
        }
        None => name.contains(mode),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn soft_float_routines_are_told_apart() {
        for double in [
            "__aeabi_dadd",
            "__aeabi_ddiv",
            "__aeabi_d2f",
            "__aeabi_d2iz",
            "__aeabi_f2d",
            "__aeabi_ul2d",
            "__aeabi_cdcmple",
            "__adddf3",
            "__truncdfsf2",
            "__floatunsidf",
            "__fixdfsi",
            "__unorddf2",
        ] {
            assert!(is_double(double), "{double}");
        }
        for single in [
            "__aeabi_fadd",
            "__aeabi_f2iz",
            "__aeabi_ul2f",
            "__mulsf3",
            "__floatsisf",
        ] {
            assert!(is_single(single) && !is_double(single), "{single}");
        }
        for integer in [
            "__aeabi_lmul",
            "__aeabi_uidiv",
            "__aeabi_idivmod",
            "__aeabi_llsl",
            "__aeabi_memcpy",
            "__udivmoddi4",
            "__clzsi2",
            "__muldi3",
            "_start",
            "_ZN4libm4math4sqrt5sqrtf17h0bdf",
        ] {
            assert!(!is_double(integer) && !is_single(integer), "{integer}");
            let long = !["memcpy", "clz", "_start", "libm"]
                .iter()
                .any(|s| integer.contains(s));
            assert_eq!(is_long(integer), long, "{integer}");
        }
    }
}
