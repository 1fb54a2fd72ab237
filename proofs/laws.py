"""The laws' warp, density and unwarp in roundings, beside each its source.

A function of the number that is read: the given tail, or the smaller component of a pair. `one` is the
source's 1, which a planted fault spoils.
"""

from functools import partial

from balls import arb, horner, power
from pairs import cbrt, constant, missed, off_by
from sweep import Formula

DEEP = 2.0**-40  # README, step 9


def half(form):
    """The most that a pair's smaller component is."""
    return 0.7071067811865476 * (1 + 4 * form.u)


def least(form):
    return power(-1074 if form.bits == 53 else -149)


def pieces(form, high, tiny=None):
    """(0, high] as it is swept: the top, and with `tiny` = k the numbers below 2^-k, where terms underflow."""
    low = [(least(form), power(-tiny))] if tiny else []
    return [*low, (arb(DEEP), arb(high))]


def shell_sin(form, one, of_lower):
    """sphere_shell.rs warp_tails: sin, from the lower tail or from the upper."""
    def result(tape, p):
        lower, upper = (p, 1.0 - p) if of_lower else (1.0 - p, p)
        cos = cbrt(tape, upper)
        next_to = cos + one
        return [lower.sqrt_times(next_to.share_of(next_to + cos * cos))]

    def true(p):
        lower, cos = (p, (1 - p).root(3)) if of_lower else (1 - p, p.root(3))
        return (lower * (1 + cos) / (1 + cos + cos * cos)).sqrt()

    return [Formula(result, true, pieces(form, 0.5) if of_lower else [(least(form), arb(0.5))])]


def power_density(form, one, k, name, exact):
    """disk.rs (k = 2) and ball.rs (k = 3) density: cos ... cos K, from the left."""
    def result(tape, c):
        p = c
        for _ in range(k - 1):
            p = p * c
        return [p * tape.constant(exact(), form.rounded(form.pair[name][0] * one))]

    tiny = (960 if form.bits == 53 else 96) // k
    return [Formula(result, lambda c: c**k * exact(), pieces(form, 1.0, tiny))]


def ball_sin_sf(form, one):
    """ball.rs warp_tails: sin from the upper tail."""
    def result(_, q):
        return [(1.0 - q).sqrt_over(q.sqrt() + one)]

    return [Formula(result, lambda q: (1 - q.sqrt()).sqrt(), [(least(form), arb(0.5))])]


def tails(form, upper, parts, ends, tiny):
    """One tail of a pair. `parts`: (nearer tail, is it the upper, its closed form) on (0, end] each, overlapping
    where rounding decides between them; the farther tail is 1 - the nearer."""
    found = []
    for (nearer, is_upper, true), (low, high) in zip(parts, ends):
        same = is_upper == upper
        found.append(Formula(
            lambda tape, x, nearer=nearer, same=same: [nearer(tape, x) if same else 1.0 - nearer(tape, x)],
            true if same else lambda x, true=true: 1 - true(x),
            [(arb(low), arb(high))] if low else pieces(form, high, tiny)))
    return found


def ball_unwarp(form, one, upper):
    """ball.rs unwarp_tails."""
    def square_of_sin(s):
        s2 = s * s
        return s2, one - s2

    def lower(_, s):
        s2, c2 = square_of_sin(s)
        return s2 * (c2 + 1.0)

    def upper_of_sin(_, s):
        _, c2 = square_of_sin(s)
        return c2 * c2

    def upper_of_cos(_, c):
        c2 = c * c
        return c2 * c2 * one

    middle = (1 - 0.5**0.5)**0.5  # sin where the tails are equal
    slack = 32 * form.u  # no rounding is off by that
    return tails(form, upper, [
        (lower, False, lambda s: s * s * (2 - s * s)), (upper_of_sin, True, lambda s: (1 - s * s)**2),
        (upper_of_cos, True, lambda c: c**4)],
        [(None, middle * (1 + slack)), (middle * (1 - slack), half(form)), (None, half(form))], 240 if form.bits == 53 else 24)
