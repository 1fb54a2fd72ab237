//! Square roots of ratios.

use super::pair::Pair;
use crate::arithmetic::native::format::Native;

/// √x to the last bit or nearly so, for x > 0 that is far from under- and overflow.
#[inline(always)]
pub(crate) fn sqrt_pair<T: Native>(x: Pair<T>) -> T {
    let root = x.hi.sqrt();
    let square = Pair::two_prod(root, root);
    root + ((x.hi - square.hi) - square.lo + x.lo) / (root + root)
}

/// √(a·b) or √(a/b) by `f`, which is given a scaled up: the quotient of a subnormal a would lose
/// digits that its root still has.
#[inline(always)]
pub(crate) fn sqrt_scaled<T: Native>(a: T, f: impl Fn(T) -> T) -> T {
    f(a * T::ROOT_UP).sqrt() * T::ROOT_DOWN
}
