"""A formula of roundings (balls.py) against a closed form, over its whole domain.

The domain is bisected until a piece's bound is below the goal. A piece that has come down to a few numbers is
settled by rounding those, operation by operation.
"""

from copy import copy
from heapq import heappop, heappush

from balls import PRECISION, Nearest, Tape, arb, ctx, exponents, nearest, power
from part import Proved
from tools import LOCK, Missing

FEW = 4  # numbers that are rounded one by one
NARROW = 2.0**-70
HOPELESS = 256  # ulps


class Formula:
    """`result(tape, x)`: a list of what may come out, rounded; `true(x)`: the closed form.

    `pieces`: ends of intervals of x on which `true` is monotone, and is computed, not just bounded, from both ends.
    """

    def __init__(self, result, true, pieces):
        self.result, self.true, self.pieces = result, true, pieces


class Sweep:
    def __init__(self, form, formula, goal):
        self.form, self.formula, self.goal = form, formula, goal
        self.least = power(-1074 if form.bits == 53 else -149)
        self.worst = [0.0, 0.0]
        self.count = 0

    def ulp(self, low):
        """ulp of the smallest magnitude of a piece's true values."""
        if not low > self.least:
            return self.least
        return max(self.least, power(exponents(low)[0] + 1 - self.form.bits))

    def keep(self, before, after):
        self.worst = [max(self.worst[0], before), max(self.worst[1], after)]

    def whole(self, low, high):
        """(before, after) of a piece, in ulps."""
        self.count += 1
        tape = Tape(self.form)
        truth = self.formula.true(low).union(self.formula.true(high))
        size = abs(truth)
        ulp = self.ulp(size.abs_lower())
        x = tape.number(low.union(high))
        before = after = 0.0
        for y in self.formula.result(tape, x):
            error = tape.off(tape.before(y))
            e = float((error / ulp).upper()) * (1 + 2.0**-40)
            before = max(before, e)
            # Of results that a rounding carries over the next power of 2 only those an ulp beyond it are off by more.
            top = ulp * power(self.form.bits)
            over = e > 1 and not (size.abs_upper() + error < top + ulp)
            after = max(after, e + (1.0 if over else 0.5))
        return before, after

    def numbers(self, low, high):
        """The format's numbers from low to high, or None if they are many."""
        step = max(self.least, power(exponents(low)[0] + 1 - self.form.bits)) if low > 0 else self.least
        first, last = ((v / step) for v in (low, high))
        first, last = first.floor().unique_fmpz(), last.ceil().unique_fmpz()
        if first is None or last is None or last - first > FEW:
            return None
        return [x for n in range(int(first), int(last) + 1) if low <= (x := arb(n) * step) <= high and nearest(self.form, x) == x]

    def one(self, x):
        truth = self.formula.true(x)
        ulp = self.ulp(truth.abs_lower())
        tape = Nearest(self.form)
        for y in self.formula.result(tape, tape.number(x)):
            before, after = (float((abs(v.value - truth) / ulp).upper()) for v in (tape.before(y), y))
            self.keep(before, after)

    def run(self):
        """The largest error: the worst piece is halved until it is below the goal or as narrow as makes no difference."""
        heap = []

        def push(low, high):
            if high > 2 * low:
                push(low, middle := self.middle(low, high))
                push(middle, high)
                return
            few = self.numbers(low, high)
            if few is not None:
                for x in few:
                    self.one(x)
                return
            if high > low * 1.5:
                self.one(nearest(self.form, low.mid()))  # a formula that is not the closed form's would show
            before, after = self.whole(low, high)
            heappush(heap, (-after, -before, self.count, low, high))

        for low, high in self.formula.pieces:
            push(arb(low), arb(high))
        while heap:
            after, before, _, low, high = heap[0]
            width = (high - low) / high
            if not -after > self.goal or width < NARROW or -before > HOPELESS and width < 2.0**-8:
                break
            heappop(heap)
            middle = self.middle(low, high)
            push(low, middle)
            push(middle, high)
        for after, before, *_ in heap:
            self.keep(-before, -after)
        return Proved(*self.worst)

    def middle(self, low, high):
        """A number between; far apart: a power of 2."""
        first, last = exponents(low)[1], exponents(high)[0]
        if high > 2 * low and first <= last:
            return power((first + last + 1) // 2)
        return ((low + high) / 2).mid()


def swept(form, cs, _, formulas, goal, poly=None):
    """A part a formula of `formulas(form, one)`; `one` is 1, or what a planted fault puts for it."""
    if arb is None:
        raise Missing("python-flint is not installed")
    form, one = (spoiled(form, poly, cs), 1.0) if poly else (form, 1 + cs[0] if cs else 1.0)
    with LOCK:
        ctx.prec = PRECISION
        for formula in formulas(form, one):
            yield Sweep(form, formula, goal).run()


def spoiled(form, poly, cs):
    form = copy(form)
    form.poly = {**form.poly, poly: cs}
    return form
