"""What the Gappa scripts share.

In each script `fl` rounds to the format and every rounding stands in the order of the Rust source,
named beside it. M is the exact value, P the table's polynomial in exact arithmetic, Q the function it
stands for (|P - Q| <= E, certified). Goals: the error before the last rounding, and after it.
"""

import math

from tables import exact
from tools import gappa, polynomial


class Part:
    """A piece of a kernel's domain: the script and the unit its goals are measured in."""

    def __init__(self, script, goals, unit):
        self.script, self.goals, self.unit = script, goals, unit

    def proved(self):
        """(error before the last rounding, error) in units, or None."""
        bounds, _ = gappa(self.script, self.goals)
        if None in bounds:
            return None
        before = bounds[0] / self.unit
        # Beside a power of 2 the last rounding adds no more than half an ulp while before <= 1: README.
        return before, before + 0.5 if before <= 1 else bounds[1] / self.unit if len(bounds) > 1 else math.inf


class Proved:
    """A piece whose errors need no script."""

    def __init__(self, before, after):
        self.errors = before, after

    def proved(self):
        return self.errors


def head(form):
    return f"@fl = {form.gappa};\n"


def P(form, name, v, cs):
    return polynomial(cs, v, exact)


def ulp(form, binade):
    """ulp of a result in [2^binade, 2^(binade + 1))."""
    return 2.0 ** (binade + 1 - form.bits)


def binades(f, top, start=1e-12, count=5):
    """(low, high, binade) with f(low..high) covering one binade of an increasing f, from the top down."""
    def inverse(y):
        lo, hi = start, top
        for _ in range(80):
            mid = (lo + hi) / 2
            lo, hi = (mid, hi) if f(mid) < y else (lo, mid)
        return lo
    e, high, out = math.ceil(math.log2(f(top))) - 1, top, []
    for k in range(e, e - count, -1):
        low = inverse(2.0**k) * (1 - 1e-6)
        out.append((low, high, k))
        high = low * (1 + 4e-6)
    return out


def polynomial_value(cs, v):
    total = 0.0
    for c in reversed(cs):
        total = total * v + c
    return total
