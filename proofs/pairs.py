"""Kernels that the laws share, in roundings (balls.py): the cube root, angles, unevaluated pairs."""

import csv
from functools import lru_cache

from balls import Nearest, arb, exponents, fast_sum, horner, nearest, power
from cube import PLACES
from tables import ROOT
from tools import approximation


@lru_cache
def proved(kernel, form):
    """The error before the last rounding that bounds.csv has of a kernel."""
    rows = csv.DictReader((ROOT / "proofs/bounds.csv").open())
    return next(float(r["before_rounding"]) for r in rows if (r["kernel"], r["format"]) == (kernel, form))


def cbrt(tape, y):
    """cbrt.rs cbrt."""
    form, root = tape.form, y.value.root(3)
    top = root.upper()
    k = exponents(top)[1]
    places = [proved(f"cbrt {place}", form.name) for place in PLACES]
    within = sum(top > arb(place) * power(k - 1) for place in PLACES)
    # Below the binade that top lies in the ulp is half.
    error = max(places[-1] / 2, *places[:max(within, 1)]) * power(k - form.bits)
    near = tape.number(root, ((y.at, 1 / (3 * root * root)),), error.upper())
    return tape.rounded(near.value, ((near.at, 1),))


class Pair:
    """pair.rs Pair; its value is hi + lo."""

    def __init__(self, hi, lo):
        self.hi, self.lo = hi, lo

    def times(self, b):
        return Pair(self.hi * b.hi, self.hi * b.lo + self.lo * b.hi)

    def sum(self):
        """value() before its rounding."""
        return self.hi.plus(self.lo)

    def value(self):
        return self.hi + self.lo


def constant(tape, exact, held):
    """A pair of the table."""
    hi, lo = held
    return Pair(tape.number(arb(hi)), tape.constant(exact - arb(hi), lo))


def off_by(tape, x, bound):
    """x, which stands for what is off by `bound` at most."""
    return tape.number(x.value, ((x.at, 1),), bound.upper())


def from_end(tape, a, far):
    """trig.rs from_end; `far`: a >= pi/4, where the first difference is exact."""
    hi, lo = tape.form.pair["half_pi"]
    end = tape.constant(arb.pi() / 2 - arb(hi), lo)
    if far:
        d, rest = tape.number(arb(hi) - a.value, ((a.at, -1),)), end
        if d.value == 0:
            return Pair(rest, tape.number(arb(0)))
    else:
        d, rest = fast_sum(tape.number(arb(hi)), -a)
        rest = rest + end
    return Pair(*fast_sum(d, rest))


def small(tape, x, sin_of, cos_of):
    """trig.rs small: (cos, sin)."""
    form, v = tape.form, x.hi * x.hi
    v = tape.dropped(v, power(3 * negligible(form)))
    half = v * 0.5
    w, w_error = fast_sum(tape.number(arb(1)), -half)
    cube = (x.hi * v) * horner(v, sin_of)
    square = v.value.abs_upper()
    cube = off_by(tape, cube, x.hi.value.abs_upper() * square * missed(form, "sin", sin_of))
    rest = x.lo * w + cube
    fourth = off_by(tape, (v * v) * horner(v, cos_of), square * square * missed(form, "cos", cos_of))
    return Pair(*fast_sum(w, w_error + (fourth - x.hi * x.lo))), Pair(*fast_sum(x.hi, rest))


@lru_cache
def negligible(form):
    import re
    text = (ROOT / f"src/number/{form.name}.rs").read_text()
    return int(re.search(r"const NEGLIGIBLE: f\d\d = power_of_two\((-\d+)\);", text)[1])


KNOWN = {}


def missed(form, name, cs):
    """approximation() of each polynomial once."""
    key = form.name, name, tuple(cs)
    if key not in KNOWN:
        KNOWN[key] = approximation(form, name, cs)
    return arb(KNOWN[key])


def angle(tape, cos, sin):
    """atan.rs of_pair, before its last rounding: the pair's angle is off by what bounds.csv has."""
    c, s = cos.value, sin.value
    square = c * c + s * s
    theta = arb.atan2(s, c)
    ulp = power(exponents(theta.upper())[0] + 1 - tape.form.bits)
    error = (arb(proved("atan", tape.form.name)) * ulp).upper()
    return tape.number(theta, ((sin.at, c / square), (cos.at, -s / square)), error)
