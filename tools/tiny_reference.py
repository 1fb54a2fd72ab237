#!/usr/bin/env python3
"""Writes tests/reference/tiny.csv: true values where arguments, results or steps between them underflow.

Needs python-flint (PyPI), that is Arb, as tools/reference.py, whose formulas it shares: a value is
written only if its ball is narrower than 1e-33 relative. Run from the repository's root:
python3 tools/tiny_reference.py

A row: law, operation, first argument, second argument or nothing, the f64 nearest to the value, and the
rest of the value in ulps of that f64. Numbers are the bits of an f64 in hex.
"""

import math
import random
from fractions import Fraction

from flint import arb

from reference import PI, PLANAR, angle_rows, bits, density, exact, f64, fraction, kepler, nearer
import reference

LOBES = [1e-310, 0.5, 20.0, 1e6, 1e300]
reference.POWERS = LOBES
LAWS = list(reference.laws())
LN_2 = math.log(2)
rng = random.Random(3)

# The ends of the format, the exponents where some arithmetic changes its way, and what lies between.
EXPONENTS = [1074, 1073, 1071, 1060, 1040, 1024, 1023, 1022, 1021, 1000, 960, 930, 902, 901, 900, 899]
EXPONENTS += [850, 800, 720, 600, 538, 500, 450, 400, 302, 299, 260, 241, 239, 200, 150, 121, 119, 90]
EXPONENTS += [62, 60, 59, 55]
# Of results: subnormal ones, and a few to both sides.
RESULTS = [1077, 1075.5, 1074.5, 1073, 1068, 1055, 1040, 1025, 1023.5, 1022.5, 1020]


def near_power(n):
    """Some f64 from 2^-n up to twice that; of subnormals, on their grid."""
    return (1 + rng.random()) * 2.0**-n if n < 1074 else 2.0**-n


def rounded(value):
    """(nearest f64, rest in its ulps)."""
    m, e = value.mid().man_exp()
    infinity = math.inf if m > 0 else -math.inf
    size = int(e) + int(m).bit_length() if m else 0
    if m and size < -5000:
        return 0.0, Fraction(0)
    if size > 1100:
        return infinity, Fraction(0)
    q = fraction(value)
    assert fraction(arb(value.rad())) <= abs(q) * Fraction(1, 10**33), "ball too wide"
    try:
        near = q.numerator / q.denominator
    except OverflowError:
        return infinity, Fraction(0)
    return near, (q - Fraction(near)) / Fraction(math.ulp(near))


def tail_rows(name, k, p):
    """Both warps and quantiles at the tail p."""
    q = exact(p)
    if name in PLANAR:
        if name == "Disk":
            eta = kepler(p)
        elif name == "CircleShell":
            eta = 2 * q.sqrt().asin()
        else:
            eta = PI * q
        for prefix, inverse, sign in (("warp", "quantile", -1), ("warp_sf", "isf", 1)):
            yield f"{prefix}: cos", eta.sin()
            yield f"{prefix}: sin", sign * eta.cos()
            yield inverse, sign * (PI / 2 - eta)
        return
    for prefix, inverse, log in (("warp", "quantile", (-q).log1p()), ("warp_sf", "isf", q.log())):
        a = log / (k + 1)
        c, s = a.exp(), (-(2 * a).expm1()).sqrt()
        yield f"{prefix}: cos", c
        yield f"{prefix}: sin", s
        yield inverse, s.asin() if c > s else PI / 2 - c.asin()


def pair_rows(name, k, cos, sin):
    """At the direction whose smaller component is exact."""
    small = exact(min(cos, sin))
    log = (-small * small).log1p() / 2  # ln of the larger one
    if cos < sin:
        c, log_c, eta = small, small.log(), small.asin()
    else:
        c, log_c, eta = log.exp(), log, PI / 2 - small.asin()
    # The fixed laws read cos theta alone.
    given = exact(cos)
    if name in PLANAR:
        yield "density", density(name, k, given)
        yield "unwarp", 1 - nearer(name, eta)
        yield "unwarp_sf", nearer(name, eta)
        yield "lambert_weight", given / 2 / density(name, k, given)
        return
    if not name.startswith("CosPower"):
        log_c = given.log()
    scale = (k + 1) / (2 * PI)
    yield "density", scale * (k * log_c).exp()
    yield "lambert_weight", 2 / (k + 1) * ((1 - k) * log_c).exp()
    a = (k + 1) * (small.log() if cos < sin else log)
    yield "unwarp", -a.expm1()
    yield "unwarp_sf", a.exp()


def single_rows(name, k):
    for n in EXPONENTS:
        theta, p = near_power(n), near_power(n)
        for law, operation, value in angle_rows(theta):
            if law == name:
                yield operation, theta, None, value
        for operation, value in tail_rows(name, k, p):
            yield operation, p, None, value
        for cos, sin in ((near_power(n), 1.0), (1.0, near_power(n))):
            for operation, value in pair_rows(name, k, cos, sin):
                yield operation, cos, sin, value


def underflowing_rows(name, k):
    """Arguments whose results are subnormal or nearly so: power·log2(cos) = -target."""
    exponent = float(k.mid())
    for target in RESULTS:
        # Of the density, of the tail, and (overflowing) of the weight.
        for power in (exponent, exponent + 1, 1 - exponent):
            at = target / abs(power) if power else 2000
            if 1 < at < 1074:
                cos = 2.0 ** -(at - rng.random() / 8)
                for operation, value in pair_rows(name, k, cos, 1.0):
                    yield operation, cos, 1.0, value
        if exponent > 1000:
            theta = math.sqrt(2 * target / exponent * LN_2)
            for law, operation, value in angle_rows(theta):
                if law == name:
                    yield operation, theta, None, value
            sin = math.sin(theta)
            for operation, value in pair_rows(name, k, 1.0, sin):
                yield operation, 1.0, sin, value
    for below in range(4):
        theta = f64(0x3FF921FB54442D18 - below)
        for law, operation, value in angle_rows(theta):
            if law == name:
                yield operation, theta, None, value


def turn_rows():
    """Azimuths: of a number of turns, and back from two components of any size."""
    for n in EXPONENTS:
        u = near_power(n)
        yield "turn: cos", u, None, (2 * PI * exact(u)).cos()
        yield "turn: sin", u, None, (2 * PI * exact(u)).sin()
        for m in (0, 3, 54, 118, 122, 700, -1000):
            if 0 <= n - m <= 1074:
                z, x = near_power(n), near_power(n - m)
                yield "turn", z, x, (exact(z) / exact(x)).atan() / (2 * PI)
                yield "turn", x, z, (exact(x) / exact(z)).atan() / (2 * PI)
                yield "turn", z, -x, arb(1) / 2 - (exact(z) / exact(x)).atan() / (2 * PI)
    for z, x in ((1e308, 1.7e308), (1e308, 1e-308), (1e-308, 1.7e308), (1.3e300, 1.0)):
        yield "turn", z, x, arb.atan2(exact(z), exact(x)) / (2 * PI)


def write(f, name, rows):
    for operation, first, second, value in rows:
        near, rest = rounded(value)
        other = "" if second is None else bits(second)
        f.write(f"{name},{operation},{bits(first)},{other},{bits(near)},{float(rest):.8f}\n")


if __name__ == "__main__":
    with open("tests/reference/tiny.csv", "w") as f:
        f.write("# Written by tools/tiny_reference.py (Arb): law,operation,argument,argument,nearest f64,rest in ulps\n")
        for name, k in LAWS:
            write(f, name, single_rows(name, k))
            write(f, name, underflowing_rows(name, k))
        write(f, "Lambert", turn_rows())
