#!/usr/bin/env python3
"""Writes tests/reference/double.csv: true values for the double-double kernels, with proven bounds.

Needs python-flint (PyPI), that is Arb: every value is a ball, and a value is written only if its
ball is narrower than 1e-50 relative. Run from the repository's root: python3 tools/double_reference.py

A row: function, first argument hi, lo, second argument hi, lo, value as an unevaluated sum of three;
numbers are the bits of an f64 in hex, a trailing run of zeros left out. Of exp the second argument is n
and the value e^x / 2^n.
"""

import random
import struct
from fractions import Fraction

from flint import arb, ctx, fmpq

ctx.prec = 1600
PI = arb.pi()
TOP = 1.5707963267948966
rng = random.Random(1)


def bits(x):
    return f"{struct.unpack('<Q', struct.pack('<d', x))[0]:016x}"


def f64(b):
    return struct.unpack("<d", struct.pack("<Q", b))[0]


def next_up(x, n=1):
    return f64(struct.unpack("<Q", struct.pack("<d", x))[0] + n)


def rational(q):
    return arb(fmpq(q.numerator, q.denominator))


def exact(x):
    """An argument: a float, or a pair of them."""
    hi, lo = x if isinstance(x, tuple) else (x, 0.0)
    return rational(Fraction(hi) + Fraction(lo))


def to_float(q):
    return q.numerator / q.denominator if q else 0.0


def split(a):
    m, e = a.mid().man_exp()
    value = Fraction(int(m)) * Fraction(2) ** int(e)
    m, e = arb(a.rad()).mid().man_exp()
    width = Fraction(int(m)) * Fraction(2) ** int(e)
    assert width <= abs(value) * Fraction(1, 10**50), "ball too wide"
    assert value == 0 or Fraction(2) ** -401 < abs(value) < Fraction(2) ** 401, "beyond the kernels' range"
    words = []
    for _ in range(3):
        words.append(to_float(value))
        value -= Fraction(words[-1])
    return words


def pair(q):
    """The pair nearest a rational."""
    hi = to_float(q)
    return hi, to_float(q - Fraction(hi))


def widened(x):
    """x with a random low word."""
    return pair(Fraction(x) * (1 + Fraction(rng.uniform(-1, 1)) / 2**53))


def both(values):
    for x in values:
        yield x
        yield widened(x)


def between(a, b, n):
    return [rng.uniform(a, b) for _ in range(n)]


def decades(low, high, n):
    """Random numbers of every size from 2^low to 2^high."""
    return [2.0 ** rng.uniform(low, high) for _ in range(n)]


def beside(x, steps=(0, 1, 2, 3, 17)):
    return [next_up(x, s * n) for n in steps for s in (1, -1)]


def roots():
    for x in both(decades(-400, 400, 40) + between(0.5, 2, 20) + beside(1.0) + beside(0.25)):
        yield "sqrt", x, exact(x).sqrt()
        yield "cbrt", x, exact(x).root(3)
    for n in (1, 2, 3, 5, 7, 1234567, 94906265):
        yield "sqrt", float(n * n), arb(n)
        yield "sqrt", n * n * 2.0**-200, arb(n) * arb(2) ** -100
    for n in (1, 2, 3, 5, 7, 12345, 208063):
        yield "cbrt", float(n**3), arb(n)
        yield "cbrt", n**3 * 2.0**-300, arb(n) * arb(2) ** -100


def angles():
    values = [0.0, 1e-120, 1e-30, 2.0**-27, TOP] + decades(-400, 0, 30) + between(0, TOP, 60)
    values += [f64(0x3FF921FB54442D18 - n) for n in (1, 2, 3, 4, 5, 100, 12345)]
    values += [TOP - 2.0**-k for k in range(2, 52, 3)] + beside(0.7853981633974483) + beside(0.5)
    return sorted(set(values))


def cos_sin(x):
    """(cos x, sin x), the first with a bound relative to it."""
    return (PI / 2 - x).sin(), x.sin()


def disk_tail(eta):
    return (2 * eta - (2 * eta).sin()) / (2 * PI)


def trigonometry():
    for a in angles():
        x = exact(a)
        c, s = cos_sin(x)
        yield "from_end", a, PI / 2 - x
        yield "at_angle cos", a, c
        yield "at_angle sin", a, s
        yield "tail_at_angle", a, arb(1) / 2 if a == 0 else disk_tail(PI / 2 - x)
    for a in both([0.0, 0.9] + decades(-400, -1, 20) + between(0, 0.9, 60)):
        if exact(a) <= exact(0.9):
            yield "sin_cos cos", a, exact(a).cos()
            yield "sin_cos sin", a, exact(a).sin()
    for a in both([0.0, 0.125, -0.125] + between(-0.125, 0.125, 50) + decades(-390, -3, 20)):
        if abs(exact(a)) <= exact(0.125):
            yield "at_eighth cos", a, (2 * PI * exact(a)).cos()
            yield "at_eighth sin", a, (2 * PI * exact(a)).sin()
    for a in both([0.0, TOP] + decades(-400, 0, 20) + between(0, TOP, 30) + beside(TOP, (0,))):
        if exact(a) < PI / 2:
            yield "pair_from_end", a, PI / 2 - exact(a)
    for k in (52, 54, 57, 60, 64):
        a = pair_of(PI / 2 - arb(2) ** -k)
        yield "pair_from_end", a, PI / 2 - exact(a)


def atan2(y, x):
    """In every quadrant, with a bound relative to the result."""
    a = (abs(y) / abs(x)).atan()
    if x < 0:
        a = PI - a
    return -a if y < 0 else a


def pairs():
    """(y, x) of all sizes and slopes, and unit vectors to rounding."""
    for _ in range(60):
        yield rng.choice((-1, 1)) * 2.0 ** rng.uniform(-200, 200), rng.choice((-1, 1)) * 2.0 ** rng.uniform(-200, 200)
    for t in between(-3.1, 3.1, 60) + decades(-300, -5, 15) + [TOP + d for d in (-1e-9, 1e-12, -1e-15)]:
        c, s = exact(t).cos(), exact(t).sin()
        yield float(s), float(c)
        yield pair_of(s), pair_of(c)
    for t in (0.7853981633974483,):
        for n in (-3, -1, 0, 1, 3):
            yield next_up(t, n), t
            yield -t, -next_up(t, n)
    yield 1.0, 1.0
    yield -1.0, 1.0
    yield 2.0**-390, 1.0
    yield 1.0, -(2.0**-100)


def pair_of(a):
    m, e = a.mid().man_exp()
    return pair(Fraction(int(m)) * Fraction(2) ** int(e))


def exponentials():
    ln2 = arb(2).log()
    cuts = [float((n + Fraction(1, 2)) * Fraction(0.6931471805599453)) for n in (-3, -1, 0, 4)]
    sizes = between(-1, 1, 40) + between(-745, 709, 60) + decades(-60, 9, 20)
    for x in both([0.0, -745.0, -1e3, -2e3, 2e3] + sizes + [-x for x in decades(-60, 9, 20)] + cuts):
        n = round(float(exact(x) / ln2))
        yield "exp", x, (exact(x) - n * ln2).exp(), float(n)
    near = [-x for x in decades(-400, 0, 40)] + between(-1, 0, 40) + between(-200, 0, 20) + beside(-0.34, (0, 1))
    for x in both([0.0] + near):
        yield "exp_m1", x, exact(x).expm1() if x != 0.0 else arb(0)


def logarithms():
    halves = [2.0**0.5, 0.5**0.5, 2.0**0.5 * 1024]
    values = decades(-400, 400, 50) + between(0.5, 2, 60) + beside(1.0) + [1 + d for d in decades(-52, -2, 20)]
    values += [1 - d for d in decades(-52, -2, 20)] + [x for h in halves for x in beside(h, (0, 1, 2))]
    for x in both(values):
        yield "ln", x, arb(0) if x == 1.0 else exact(x).log()
    yield "ln", (1.0, 2.0**-60), exact((1.0, 2.0**-60)).log()
    small = decades(-400, -1, 40)
    values = [0.0] + small + [-x for x in small] + between(-1, 3, 60) + decades(0, 400, 20)
    values += [-1 + d for d in decades(-53, -1, 15)] + beside(-0.29, (0, 1)) + beside(0.41, (0, 1))
    for x in both(values):
        if exact(x) > -1:
            yield "ln_1p", x, exact(x).log1p() if x != 0.0 else arb(0)


def kepler(p):
    """eta with disk_tail(eta) = p, as a ball whose ends bracket p."""
    target = exact(p)
    eta = (12 * PI * target).root(3) / 2
    if target > exact(0.2):
        eta = PI / 2 - PI * (arb(1) / 2 - target) / 2
    for _ in range(60):
        step = (disk_tail(eta) - target) / (2 * eta.sin() ** 2 / PI)
        eta = (eta - step).mid()
        if abs(step) < abs(eta) * arb("1e-200"):
            break
    slack = eta * arb("1e-150")
    assert disk_tail(eta - slack) < target < disk_tail(eta + slack), p
    return eta + slack * arb(0, 1)


def tails():
    values = decades(-398, -1, 60) + between(0, 0.5, 70) + between(0.124, 0.126, 10) + beside(0.125) + beside(0.25)
    values += [1e-120, next_up(0.5, -1), next_up(0.5, -2)] + [0.5 - 2.0**-k for k in range(3, 54, 5)]
    return values


def disk():
    yield "angle_at_tail", 0.5, arb(0)
    yield "direction_at_tail cos", 0.5, arb(1)
    yield "direction_at_tail sin", 0.5, arb(0)
    for p in both(tails()):
        if not exact(p) < exact(0.5):
            continue
        eta = kepler(p)
        hi = p[0] if isinstance(p, tuple) else p
        yield "angle_at_tail", p, eta if hi < 0.125 else PI / 2 - eta
        c, s = eta.sin(), eta.cos()
        yield "direction_at_tail cos", p, c
        yield "direction_at_tail sin", p, s
    for t in angles():
        if t < 2.0**-130:
            continue
        for small in both([float(exact(t).sin()) * 0.70710678]):
            x = exact(small)
            large = pair_of((1 - x * x).sqrt())
            yield "tail_at_direction", small, disk_tail(x.asin()), large
            yield "tail_at_direction", large, arb(1) / 2 - (x.asin() + x * (1 - x * x).sqrt()) / PI, small
    yield "tail_at_direction", 1.0, arb(1) / 2, 0.0
    yield "tail_at_direction", 0.0, arb(0), 1.0


def two_arguments():
    for y, x in pairs():
        yield "atan2", y, atan2(exact(y), exact(x)), x


def row(function, argument, value, second=0.0):
    halves = [h for a in (argument, second) for h in (a if isinstance(a, tuple) else (a, 0.0))]
    fields = [bits(v) if v else "" for v in halves + split(value)]
    return ",".join([function] + fields).rstrip(",")


with open("tests/reference/double.csv", "w") as f:
    f.write("# Written by tools/double_reference.py (Arb): function, two arguments as hi,lo, value as three words; bits of f64 in hex.\n")
    for part in (roots, trigonometry, two_arguments, exponentials, logarithms, disk):
        for fields in part():
            f.write(row(*fields) + "\n")
