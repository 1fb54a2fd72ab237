"""kepler.rs: both directions of the disk's law, from the tail p to what is returned.

The domain is cut where the result or the cube root's operand passes a power of 2, and finer. On each piece the
error is that of the roundings (balls.py), of the cube root (bounds.csv, proved by cube.py) and of the
polynomials (certified on the same piece).
"""

import csv
import re

from balls import PRECISION, Exact, Nearest, Tape, arb, by_fours, ctx, exponents, fast_two_sum, horner, nearest, power
from cube import PLACES
from part import Proved
from tables import ROOT
from tools import LOCK, Missing, approximation, residuals

EDGE_PRECISION = 1600  # 2 eta - sin 2 eta loses 2/3 of p's 1074 bits at the far end


class Kernel:
    """One of direction_at_tail's results ("cos", "sin") or angle_at_tail's ("angle"), with all that is proved of its parts."""

    def __init__(self, form, result, poly):
        self.form, self.result, self.poly = form, result, poly
        self.sin, self.cos = approximation(form, "sin"), approximation(form, "cos")
        self.residuals = [residuals(name, poly[name]) for name in ("kepler_centre", "kepler_tail")]
        rows = {(r["kernel"], r["format"]): r for r in csv.DictReader((ROOT / "proofs/bounds.csv").open())}
        cbrt = [float(rows[f"cbrt {place}", form.name]["before_rounding"]) for place in PLACES]
        # Up to each place; below 1 the ulp is half.
        self.cbrt = [max(cbrt[-1] / 2, *cbrt[:i + 1]) for i in range(len(cbrt))]
        text = (ROOT / f"src/arithmetic/native/{form.name}.rs").read_text()
        self.negligible = 3 * int(re.search(r"const NEGLIGIBLE: f\d\d = power_of_two\((-\d+)\);", text)[1])

    def roots(self, tape, p, high):
        """cbrt.rs cbrt_times, p <= high: the root, or all that it may be. Scalings by powers of 8 are exact."""
        form, (hi, lo) = self.form, self.form.pair["twelve_pi"]
        k_hi, k_lo = tape.number(arb(hi)), tape.constant(12 * arb.pi() - arb(hi), lo)
        top = (high * arb(hi)).upper()
        a = tape.rounded(p.value * k_hi.value, ((p.at, k_hi.value),), tape.half_ulp(top))
        b = tape.rounded(p.value * k_lo.value, ((p.at, k_lo.value), (k_lo.at, p.value)), power(exponents(top)[1] - 2 * form.bits))
        # Rounding a + b is no worse than leaving out b.
        y = tape.rounded(a.value + b.value, ((a.at, 1), (b.at, 1)), b.value.abs_upper())
        root = y.value.root(3)
        # y is at most this, rounding being monotone; the root's bound is in ulps of the numbers below the next 2^k.
        top = (nearest(form, top) + (high * abs(arb(lo))).upper()).upper()
        top = nearest(form, top)
        k = -(-exponents(top)[1] // 3)
        bound = next(c for c, place in zip(self.cbrt, PLACES[1:] + [2.0]) if top <= arb(place) ** 3 * power(3 * k - 3))
        h = arb(bound) * power(k - form.bits)
        if isinstance(tape, Nearest):
            low, high = nearest(form, (root - h).lower()), nearest(form, (root + h).upper())
            return [tape.number(x) for x in ([low] if low == high else [low, high])]
        h += power(k - 1 - form.bits)  # the last rounding
        return [tape.number(root, ((y.at, 1 / (3 * root * root)),), h.upper())]

    def from_end_at(self, s):
        t = s * s
        bend = by_fours(t, self.poly["kepler_tail"])
        return fast_two_sum(s * 0.5, s * t * bend)

    def from_axis_at(self, tape, d):
        w = d * d
        hi, lo = self.form.pair["half_pi"]
        excess = tape.constant(arb.pi() / 2 - 1.5, self.form.rounded(hi - 1.5 + lo))  # f32: exact in f64
        bend = by_fours(w, self.poly["kepler_centre"])
        return d, d * 0.5 + (d * excess + d * w * bend)

    def small(self, tape, x):
        """trig.rs small: (cos, sin) as pairs."""
        hi, lo = x
        v = hi * hi
        v = tape.dropped(v, power(self.negligible))
        w, w_error = fast_two_sum(1.0, -(v * 0.5))
        rest = lo * w + hi * v * horner(v, self.poly["sin"])
        cos_rest = w_error + (v * v * horner(v, self.poly["cos"]) - hi * lo)
        return (w, cos_rest), (hi, rest)

    def results(self, tape, near_end, low, high):
        """[(the result before its last rounding, what the polynomials are off by)] of p, or of d = 1/2 - p, from low to high."""
        ball = low.union(high) if low is not high else low
        if near_end:
            angles = [self.from_end_at(s) for s in self.roots(tape, tape.number(ball), high)]
            variable = (12 * arb.pi() * ball).root(3) ** 2
        else:
            # d is exact from p = 1/4 on; below it a multiple of half its ulp is rounded.
            d = tape.number(ball) if high <= 0.25 else tape.rounded(ball, (), power(-2 - self.form.bits))
            angles, variable = [self.from_axis_at(tape, d)], ball * ball
        return [self.finish(tape, near_end, variable, *x) for x in angles]

    def finish(self, tape, near_end, variable, hi, lo):
        angle = hi.value + lo.value
        missed = (self.relative(near_end, variable, angle) * angle).abs_upper()
        if self.result == "angle":
            if near_end:
                end_hi, end_lo = self.form.pair["half_pi"]
                end_lo = tape.constant(arb.pi() / 2 - arb(end_hi), end_lo)
                theta = fast_two_sum(end_hi, -hi)
                hi, lo = theta[0], theta[1] + (end_lo - lo)
            return hi.plus(lo), missed
        cos, sin = self.small(tape, (hi, lo) if near_end else fast_two_sum(hi, lo))
        v = angle * angle
        if (self.result == "cos") == near_end:
            return sin[0].plus(sin[1]), missed * angle.cos().abs_upper() + (angle * v).abs_upper() * self.sin
        return cos[0].plus(cos[1]), missed * angle.sin().abs_upper() + (v * v).abs_upper() * self.cos

    def relative(self, near_end, variable, angle):
        """Bound of the polynomial's relative error of eta or theta: the residual's over the logarithmic slope."""
        bounds, end = self.residuals[near_end]
        first, last = (int(float(x) / end * len(bounds)) for x in (variable.lower(), variable.upper()))
        residual = max(bounds[max(0, first - 1):last + 2])
        # d ln(y - sin y)/d ln y >= 2 as tan x >= x; 0.999 is for what the slopes change over the error.
        slope = arb(2) if near_end else 2 * angle * angle.cos() ** 2 / (angle + angle.sin() * angle.cos())
        return arb(residual) / (slope.lower() * 0.999)


def tail(eta):
    return (2 * eta - (2 * eta).sin()) / (2 * arb.pi())


def distance(theta):
    return (2 * theta + (2 * theta).sin()) / (2 * arb.pi())


def edges(kernel, near_end):
    """[(p or d, k)] in rising order: the ends of the domain, where the cube root's operand or d passes a power of 2
    (k = None), and where the true result comes to lie in [2^k, 2^(k + 1)]."""
    form, result = kernel.form, kernel.result
    ctx.prec = EDGE_PRECISION
    least = -1074 if form.bits == 53 else -149
    unit = 12 * arb.pi() if near_end else arb(1)
    found = [(power(k) / unit, None) for k in range(least, 4)]
    first = -1
    if near_end and result == "angle":
        first = 0  # falls from pi/2
        found.append((tail(arb.pi() / 2 - 1), -1))
    elif result == "angle" or (result == "cos") == near_end:
        angle = power if result == "angle" else lambda k: power(k).asin()
        place = tail if near_end else distance
        passed = [(place(angle(k)), k) for k in range(least // 3 - 4 if near_end else -form.bits - 4, 0)]
        found += passed
    start, end = (power(least), power(-3)) if near_end else (power(-1 - form.bits), power(-3) * 3)
    assert all(x.rel_accuracy_bits() > 3 * form.bits for x, _ in found)
    if first == -1 and any(k is not None for _, k in found):
        first = max(k for x, k in found if k is not None and x <= start)
    inside = sorted((e for e in found if start < e[0] < end), key=lambda e: e[0].mid())
    return [(start, first), *inside, (end, None)]


def numbers_below(kernel, near_end, x):
    """The format's numbers on the side of smaller results of x, an exact number, nearest first: p, or d = 1/2 - p."""
    form = kernel.form
    place = x if near_end else arb(1) / 2 - x
    least, (binade, _) = -1074 if form.bits == 53 else -149, exponents(place.lower())
    step = power(max(binade + 1 - form.bits, least))
    n = (place / step).floor().unique_fmpz() + (0 if near_end else 1)
    while n > 0:
        p = arb(n) * step
        assert exponents(p)[0] == binade
        yield p if near_end else arb(1) / 2 - p
        n += -1 if near_end else 1


def beside(kernel, near_end, x, k, before):
    """The largest error, in ulps, of the numbers whose results a last rounding may carry past 2^(k + 1), at x.

    That needs a result before it beyond 2^(k + 1) by an ulp, hence a true one below by less than `before` - 1.
    """
    ulp, worst, form = power(k + 1 - kernel.form.bits), 0.0, kernel.form
    for n in numbers_below(kernel, near_end, x):
        [(true, missed)] = kernel.results(Exact(form), near_end, n, n)
        if true.value + missed < power(k + 1) - (arb(before) - 1) * ulp:
            return worst
        for found, _ in kernel.results(Nearest(form), near_end, n, n):
            y = found.tape.rounded(found.value, ()).value
            worst = max(worst, float(((abs(y - true.value) + missed) / ulp).upper()))
    return worst


def proof(form, cs, _, result, poly, sides):
    """One part a side (near the end or not) of the law; `cs` are those of `poly`, whose error is taken piece by piece."""
    if arb is None:
        raise Missing("python-flint is not installed")
    kernel = Kernel(form, result, {**form.poly, poly: cs})
    with LOCK:
        for near_end in sides:
            yield sweep(kernel, near_end)


def sweep(kernel, near_end):
    """The largest error over the pieces, before the last rounding and after it."""
    form, bits = kernel.form, kernel.form.bits
    cuts, worst = edges(kernel, near_end), [0.0, 0.0]
    ctx.prec = PRECISION
    binade = None
    for i, ((low, k), (high, _)) in enumerate(zip(cuts, cuts[1:])):
        binade = binade if k is None else k
        width = (high - low) / high
        n = 1 if width < 2.0**-20 else 48 if high > 2.0**-9 else 4
        step, parts = (high - low) / n, [low]
        parts += [low + step * j for j in range(1, n)] + [high]
        for a, b in zip(parts, parts[1:]):
            tape = Tape(form)
            [(found, missed)] = kernel.results(tape, near_end, a, b)
            before = (tape.off(found) + missed) / power(binade + 1 - bits)
            before = float(before.upper()) * (1 + 2.0**-40)
            after = before + 0.5
            if before > 1 and found.value.upper() > power(binade + 1):
                x = next((x for x, k in cuts[i + 1:] if k is not None), None)
                few = x is not None and before < 4
                after = max(after, beside(kernel, near_end, x, binade, before)) if few else before + 1
            worst = [max(worst[0], before), max(worst[1], after)]
    return Proved(*worst)
