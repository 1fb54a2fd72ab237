"""Rounded arithmetic on a piece of a kernel's domain, in Arb's balls: what every rounding adds to the result.

A kernel written with `Number`s in the source's order is a function of its roundings, one error each. By the mean
value theorem it is off by at most the sum of |d result / d rounding| times that rounding's bound, with the
derivatives taken over balls that hold every value on the way from no rounding to all of them: no term of
second order is left out. The derivatives are those of one backward sweep, so what is rounded once
and used twice counts once, with its sign. Of one number instead of a piece, the roundings can be done (`Nearest`)
or left out (`Exact`).
"""

try:
    from flint import arb, ctx
except ImportError:
    arb = None

PRECISION = 160


def power(k):
    return arb((1, k))


def exponents(x):
    """(floor log2, ceil log2) of an exact positive number."""
    man, exp = (int(i) for i in x.man_exp())
    return man.bit_length() - 1 + exp, (man - 1).bit_length() + exp


def nearest(form, x, least=None):
    """An exact number rounded to the format's digits, and no finer than 2^least, to even where two are equally near."""
    man, exp = (int(i) for i in x.man_exp())
    cut = max(0, man.bit_length() - form.bits, 0 if least is None else least - exp)
    whole, rest = divmod(abs(man), 1 << cut)
    up = 2 * rest > 1 << cut or 2 * rest == 1 << cut and whole % 2
    return arb(((whole + bool(up)) * (1 if man > 0 else -1), exp + cut))


class Tape:
    """The operations of one kernel on one piece."""

    def __init__(self, form):
        self.form = form
        self.least = power(-1075 if form.bits == 53 else -150)  # half the least subnormal number
        self.terms, self.noises = [], []

    def number(self, value, terms=(), noise=None):
        """A number that may be off by `noise`, besides what `terms`, its derivatives, say."""
        self.terms.append(terms)
        self.noises.append(noise)
        return Number(self, len(self.terms) - 1, value if noise is None else value + arb(0, noise))

    def half_ulp(self, top):
        """Bound of one rounding of |x| <= top, an exact number; just above a power of 2 all round down to it."""
        if top == 0:
            return top
        k, _ = exponents(top)
        below, over = power(k - 1 - self.form.bits), top - power(k)
        return max(below, min(over, power(k - self.form.bits)).upper())

    def unknown(self, value, terms, bound):
        """A kernel's result before its last rounding, of which only a bound of its error is known."""
        return self.number(value, terms, bound)

    def rounding(self, value):
        """half_ulp, and no more than what is between `value` and a power of 2."""
        low, top = value.abs_lower(), value.abs_upper()
        most = self.half_ulp(top)
        if low > 0:
            whole = power(exponents(low)[1])
            most = min(most, max((whole - low).upper(), (top - whole).upper()))
        return most

    def rounded(self, value, terms, most=None):
        """A rounded result; `most` bounds the rounding where underflow is far and more is known."""
        if most is None:
            most = min(max(self.rounding(value), self.least), value.abs_upper())  # 0 is a number, too
        return self.number(value, terms, most)

    def summed(self, a, b, terms):
        """a + b rounded: exact among subnormal numbers, and no farther off than a or b, which are numbers too."""
        most = self.rounding(a + b)
        return self.rounded(a + b, terms, min(most, a.abs_upper(), b.abs_upper()))

    def constant(self, true, held):
        """A number of the table that stands for another."""
        return self.number(true, (), abs(arb(held) - true).upper())

    def dropped(self, v, least):
        """v, or 0 for what is below `least`."""
        if v.value > least:
            return v
        return self.number(v.value, ((v.at, 1),), min(v.value.abs_upper(), least))

    def fast_two_sum(self, total, terms, second=None):
        most = self.half_ulp(total.abs_upper())
        error = self.number(arb(0), (), most if second is None else min(most, second.abs_upper()))
        return self.number(total + error.value, (*terms, (error.at, 1))), -error

    def before(self, result):
        """`result` without its rounding."""
        return self.number(result.value, self.terms[result.at])

    def off(self, result):
        """Bound of |result - what it is without roundings|."""
        by = [None] * len(self.terms)
        by[result.at] = arb(1)
        total = arb(0)
        for i in range(result.at, -1, -1):
            if by[i] is None:
                continue
            if self.noises[i] is not None:
                total += by[i].abs_upper() * self.noises[i]
            for j, slope in self.terms[i]:
                by[j] = by[i] * slope if by[j] is None else by[j] + by[i] * slope
        return total.upper()


    def exact_product(self, a, k):
        """pair.rs product by a constant: (hi, lo), lo the exact error of hi."""
        total = a.value * arb(k)
        error = self.number(arb(0), (), self.rounding(total))
        return self.number(total + error.value, ((a.at, arb(k)), (error.at, 1))), -error


class Exact(Tape):
    """No rounding, and the constants that are meant."""

    def number(self, value, terms=(), noise=None):
        return Number(self, None, value)

    def rounded(self, value, terms, most=None):
        return self.number(value)

    def fast_two_sum(self, total, terms, second=None):
        return self.number(total), self.number(arb(0))


class Nearest(Exact):
    """Every rounding done, and the constants that are held."""

    def rounded(self, value, terms, most=None):
        # Rounding is monotone: the ends of a ball that is not exact hold what it rounds to.
        least = (-1074 if self.form.bits == 53 else -149) if most is None else None
        low, high = (nearest(self.form, x, least) for x in (value.lower(), value.upper()))
        result = self.number(low if low == high else low.union(high))
        result.raw = value
        return result

    def constant(self, true, held):
        return self.number(arb(held))

    def before(self, result):
        return self.number(result.raw)

    def unknown(self, value, terms, bound):
        return self.number(value + arb(0, bound))

    def exact_product(self, a, k):
        total = a.value * arb(k)
        hi = self.rounded(total, ())
        return hi, self.number(total - hi.value)

    def dropped(self, v, least):
        return self.number(arb(0)) if v.value < least else v

    def fast_two_sum(self, total, terms, second=None):
        hi = self.rounded(total, terms)
        return hi, self.number(total - hi.value)


class Number:
    """A number of the format; + - * round. Floats are constants of the source."""

    __slots__ = "tape", "at", "value", "raw"

    def __init__(self, tape, at, value):
        self.tape, self.at, self.value = tape, at, value

    def __mul__(self, b):
        if isinstance(b, Number):
            return self.tape.rounded(self.value * b.value, ((self.at, b.value), (b.at, self.value)))
        b = arb(b)
        if abs(int(b.man_exp()[0])) == 1:
            return self.tape.number(self.value * b, ((self.at, b),))  # a power of 2: exact
        return self.tape.rounded(self.value * b, ((self.at, b),))

    def __add__(self, b):
        if isinstance(b, Number):
            return self.tape.summed(self.value, b.value, ((self.at, 1), (b.at, 1)))
        return self.tape.summed(self.value, arb(b), ((self.at, 1),))

    __rmul__, __radd__ = __mul__, __add__

    def __sub__(self, b):
        return self.tape.summed(self.value, -b.value, ((self.at, 1), (b.at, -1)))

    def __rsub__(self, b):
        return self.tape.summed(arb(b), -self.value, ((self.at, -1),))

    def __truediv__(self, b):
        y = self.value / b.value
        return self.tape.rounded(y, ((self.at, 1 / b.value), (b.at, -y / b.value)))

    def share_of(self, whole):
        """self / whole where self <= whole: at most 1 before its rounding and after."""
        y = self.value / whole.value
        return self.tape.rounded(y, ((self.at, 1 / whole.value), (whole.at, -y / whole.value)),
                                 self.tape.half_ulp(min(y.abs_upper(), arb(1))))

    def sqrt(self):
        y = self.value.sqrt()
        return self.tape.rounded(y, ((self.at, 1 / (2 * y)),))

    def __neg__(self):
        return self.tape.number(-self.value, ((self.at, -1),))

    def sqrt_times(self, b):
        """root.rs sqrt_scaled of a b: scaled by a power of 4, so that the product does not underflow."""
        product = self.value * b.value
        most = self.tape.half_ulp(product.abs_upper())
        return self.tape.rounded(product, ((self.at, b.value), (b.at, self.value)), most).sqrt()

    def sqrt_over(self, b):
        """sqrt_scaled of a / b."""
        ratio = self.value / b.value
        most = self.tape.half_ulp(ratio.abs_upper())
        return self.tape.rounded(ratio, ((self.at, 1 / b.value), (b.at, -ratio / b.value)), most).sqrt()

    def plus(self, b):
        """a + b as it is before a rounding."""
        return self.tape.number(self.value + b.value, ((self.at, 1), (b.at, 1)))


def fast_two_sum(a, b):
    """Pair::fast_two_sum: (hi, lo), lo the exact error of hi as |a| >= |b|, which is checked."""
    terms = ((b.at, 1), (a.at, 1)) if isinstance(a, Number) else ((b.at, 1),)
    first = a.value if isinstance(a, Number) else arb(a)
    if not first.abs_lower() >= b.value.abs_upper():
        raise ValueError(f"fast_two_sum of {first} and {b.value}")
    return b.tape.fast_two_sum(first + b.value, terms, b.value)


def horner(x, c):
    """poly.rs horner."""
    total = c[-1]
    for k in reversed(c[:-1]):
        total = x * total + k  # a product's order does not matter
    return total


def by_fours(x, c):
    """poly.rs by_fours."""
    x2 = x * x
    x4 = x2 * x2
    s = [horner(x4, c[i::4]) for i in range(4)]
    return (s[0] + x2 * s[2]) + x * (s[1] + x2 * s[3])
