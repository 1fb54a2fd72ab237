//! Limits of χ², in tenths. Made by `cargo test --test self_test -- --ignored write_limits`.

/// Degrees of freedom, and the \[least, most\] believed for each alarm in its order.
#[rustfmt::skip]
pub(super) const TABLE: [(u8, [[u32; 2]; 2]); 8] = [
    (7, [[0, 483], [0, 635]]),
    (15, [[7, 653], [2, 820]]),
    (32, [[54, 955], [33, 1147]]),
    (37, [[73, 1037], [47, 1235]]),
    (39, [[81, 1069], [53, 1269]]),
    (41, [[90, 1101], [59, 1303]]),
    (43, [[98, 1133], [66, 1337]]),
    (63, [[196, 1437], [146, 1662]]),
];
