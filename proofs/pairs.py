"""Kernels that the laws share, in roundings (balls.py): the cube root, angles, unevaluated pairs."""

import csv
import re
from functools import lru_cache

from balls import Nearest, arb, exponents, fast_two_sum, horner, nearest, power
from cube import PLACES
from tables import ROOT
from tools import approximation


@lru_cache
def proved(kernel, form):
    """The error before the last rounding that bounds.csv has of a kernel."""
    rows = csv.DictReader((ROOT / "proofs/bounds.csv").open())
    return next(float(r["before_rounding"]) for r in rows if (r["kernel"], r["format"]) == (kernel, form))


def cbrts(tape, y):
    """cbrt.rs cbrt; of one number both of the neighbours that its bound leaves."""
    form, root = tape.form, y.value.root(3)
    top = root.upper()
    k = exponents(top)[1]
    places = [proved(f"cbrt {place}", form.name) for place in PLACES]
    within = sum(top > arb(place) * power(k - 1) for place in PLACES)
    # Below the binade that top lies in the ulp is half.
    error = max(places[-1] / 2, *places[:max(within, 1)]) * power(k - form.bits)
    near = tape.unknown(root, ((y.at, 1 / (3 * root * root)),), error.upper())
    if isinstance(tape, Nearest):
        ends = nearest(form, near.value.lower()), nearest(form, near.value.upper())
        assert ends[1] - ends[0] <= power(k - form.bits)
        return [tape.number(x) for x in (ends if ends[0] < ends[1] else ends[:1])]
    return [tape.rounded(near.value, ((near.at, 1),))]


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
        d, rest = fast_two_sum(tape.number(arb(hi)), -a)
        rest = rest + end
    return Pair(*fast_two_sum(d, rest))


def small(tape, x):
    """trig.rs small: (cos, sin)."""
    form, v = tape.form, x.hi * x.hi
    v = tape.dropped(v, power(3 * negligible(form)))
    half = v * 0.5
    w, w_error = fast_two_sum(tape.number(arb(1)), -half)
    cube = (x.hi * v) * horner(v, form.poly["sin"])
    square = v.value.abs_upper()
    cube = off_by(tape, cube, x.hi.value.abs_upper() * square * missed(form, "sin"))
    rest = x.lo * w + cube
    fourth = off_by(tape, (v * v) * horner(v, form.poly["cos"]), square * square * missed(form, "cos"))
    return Pair(*fast_two_sum(w, w_error + (fourth - x.hi * x.lo))), Pair(*fast_two_sum(x.hi, rest))


def at_angle(tape, a, far):
    """trig.rs at_angle: (cos, sin)."""
    if far:
        return small(tape, from_end(tape, a, True))[::-1]
    return small(tape, Pair(a, tape.number(arb(0))))


@lru_cache
def negligible(form):
    text = (ROOT / f"src/arithmetic/native/{form.name}.rs").read_text()
    return int(re.search(r"const NEGLIGIBLE: f\d\d = power_of_two\((-\d+)\);", text)[1])


def missed(form, name):
    return arb(approximation(form, name))
