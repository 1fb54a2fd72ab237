"""The laws' warp, density and unwarp in roundings, beside each its source.

A function of the number that is read: the given tail, or the smaller component of a pair. `one` is the
source's 1, which a planted fault spoils.
"""

from balls import arb, horner, power
from pairs import cbrts, constant, missed, off_by
from sweep import Formula



def half(form):
    """The most that a pair's smaller component is."""
    return 0.7071067811865476 * (1 + 4 * form.u)


def least(form):
    return power(-1074 if form.bits == 53 else -149)


def pieces(form, high, degree=0):
    """(0, high] as it is swept (README, step 9): the top, and the numbers that a product of `degree` of them underflows of."""
    deep, tiny = (-40, -960) if form.bits == 53 else (-30, -120)
    low = [(least(form), power(tiny // degree))] if degree else []
    return [*low, (power(deep), arb(high))]


def shell_sin(form, one, of_lower):
    """sphere_shell.rs warp_tails: sin, from the lower tail or from the upper."""
    def result(tape, p):
        lower, upper = (p, 1.0 - p) if of_lower else (1.0 - p, p)
        nexts = [(cos, cos + tape.constant(arb(1), one)) for cos in cbrts(tape, upper)]
        return [lower.sqrt_times(y.share_of(y + cos * cos)) for cos, y in nexts]

    def true(p):
        lower, cos = (p, (1 - p).root(3)) if of_lower else (1 - p, p.root(3))
        return (lower * (1 + cos) / (1 + cos + cos * cos)).sqrt()

    return [Formula(result, true, pieces(form, 0.5) if of_lower else [(least(form), arb(0.5))])]


def power_density(form, one, k):
    """disk.rs (k = 2) and ball.rs (k = 3) density: cos ... cos 2/pi, from the left."""
    def exact():
        return 2 / arb.pi()

    def result(tape, c):
        p = c
        for _ in range(k - 1):
            p = p * c
        return [p * tape.constant(exact(), form.rounded(form.pair["two_over_pi"][0] * one))]

    return [Formula(result, lambda c: c**k * exact(), pieces(form, 1.0, k))]


def ball_sin_sf(form, one):
    """ball.rs warp_tails: sin from the upper tail."""
    def result(tape, q):
        return [(1.0 - q).sqrt_over(q.sqrt() + tape.constant(arb(1), one))]

    return [Formula(result, lambda q: (1 - q.sqrt()).sqrt(), [(least(form), arb(0.5))])]


def tails(form, upper, parts):
    """One tail of a pair. `parts`: (nearer tail, is it the upper, its closed form, ends, degree), overlapping where
    rounding decides between them; the farther tail is 1 - the nearer."""
    found = []
    for nearer, is_upper, true, (low, high), degree in parts:
        same = is_upper == upper
        found.append(Formula(
            lambda tape, x, nearer=nearer, same=same: [nearer(tape, x) if same else 1.0 - nearer(tape, x)],
            true if same else lambda x, true=true: 1 - true(x),
            [(arb(low), arb(high))] if low else pieces(form, high, degree if same else 0)))
    return found


def ball_unwarp(form, one, upper):
    """ball.rs unwarp_tails."""
    def square_of_sin(tape, s):
        s2 = s * s
        return s2, tape.constant(arb(1), one) - s2

    def lower(tape, s):
        s2, c2 = square_of_sin(tape, s)
        return s2 * (c2 + 1.0)

    def upper_of_sin(tape, s):
        _, c2 = square_of_sin(tape, s)
        return c2 * c2

    def upper_of_cos(_, c):
        c2 = c * c
        return c2 * c2

    middle = (1 - 0.5**0.5)**0.5  # sin where the tails are equal
    slack = 32 * form.u  # no rounding is off by that
    return tails(form, upper, [
        (lower, False, lambda s: s * s * (2 - s * s), (None, middle * (1 + slack)), 2),
        (upper_of_sin, True, lambda s: (1 - s * s)**2, (middle * (1 - slack), half(form)), 0),
        (upper_of_cos, True, lambda c: c**4, (None, half(form)), 4)])


def half_turn(form, one, of_sin):
    """turn.rs half_turn, p <= 1/4 or d = 1/2 - p there: sin(pi p), cos(pi p)."""
    poly = form.poly["sin_turn" if of_sin else "cos_turn"]

    def result(tape, p):
        v = p * 0.5 * (p * 0.5)
        h = v * horner(v, poly)
        v = p.value / 2 * (p.value / 2)
        if not of_sin:
            return [1.0 + off_by(tape, h, v.abs_upper() * missed(form, "cos_turn"))]
        slope = constant(tape, arb.pi(), form.pair["pi"])
        bend = off_by(tape, h * 0.5, v.abs_upper() * missed(form, "sin_turn"))
        return [p * slope.hi + p * (slope.lo + bend)]

    return [Formula(result, lambda p: (p * arb.pi()).sin() if of_sin else (p * arb.pi()).cos(), pieces(form, 0.25, 1))]


def disk_unwarp(form, one, nearer):
    """kepler.rs tail_at_direction: the nearer tail, and 1 - that."""
    def of_cos(tape, c):
        cs = form.poly["disk_tail_of_cos"]
        w = c * c
        wh = off_by(tape, w * horner(w, cs), w.value.abs_upper() * missed(form, "disk_tail_of_cos"))
        c0 = constant(tape, 2 / (3 * arb.pi()), form.pair["two_over_three_pi"])
        return c * w * (c0.hi + (c0.lo + wh))

    def of_sin(tape, s):
        cs = form.poly["disk_centre_of_sin"]
        w = s * s
        line_hi, line_lo = tape.exact_product(s, form.pair["two_over_pi"][0])
        lo = tape.constant(2 / arb.pi() - arb(form.pair["two_over_pi"][0]), form.pair["two_over_pi"][1])
        bend = off_by(tape, s * w * horner(w, cs), (s.value.abs_upper() * w.value.abs_upper()) * missed(form, "disk_centre_of_sin"))
        half = tape.constant(arb(1), one) * 0.5
        return (half - line_hi) - (line_lo + (s * lo + bend))

    def tail_of_cos(c):
        return 2 * c**3 / (3 * arb.pi()) * (c * c).hypgeom_2f1(0.5, 1.5, 2.5)

    def tail_of_sin(s):
        return arb(0.5) - (s.asin() + s * (1 - s * s).sqrt()) / arb.pi()

    return tails(form, True, [
        (of_cos, nearer, tail_of_cos, (None, half(form)), 3),
        (of_sin, nearer, tail_of_sin, (None, half(form)), 0)])
