//! Limits of χ², in tenths. Made by `cargo test --test self_test -- --ignored write_limits`.

use super::limits::Row;

#[rustfmt::skip]
pub(super) const TABLE: [Row; 8] = [
    Row { freedom: 7, limits: [[0, 483], [0, 635]] },
    Row { freedom: 15, limits: [[7, 653], [2, 820]] },
    Row { freedom: 32, limits: [[54, 955], [33, 1147]] },
    Row { freedom: 37, limits: [[73, 1037], [47, 1235]] },
    Row { freedom: 39, limits: [[81, 1069], [53, 1269]] },
    Row { freedom: 41, limits: [[90, 1101], [59, 1303]] },
    Row { freedom: 43, limits: [[98, 1133], [66, 1337]] },
    Row { freedom: 63, limits: [[196, 1437], [146, 1662]] },
];
