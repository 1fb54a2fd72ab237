#!/usr/bin/env python3
"""Writes the tables of coefficients: src/arithmetic/native/coefficients_f{32,64}.rs,
src/arithmetic/{double,fast}/coefficients.rs.

Needs Sollya (Debian: sollya) and mpmath (PyPI: mpmath). Run from the repository's root:

    python3 tools/coefficients.py

Each polynomial is the best one with coefficients of the format (Sollya's fpminimax), at the
least degree whose relative error is below the target. fpminimax gets an interpolant of the
function that is exact to 1e-30, so that functions known only through an equation (Kepler's)
need no closed form. The double-double series get leading coefficients of two and of one and a half
words, as their share of the result calls for.
"""

import struct
import subprocess

import fast_coefficients
import root_coefficients
import sollya
from mpmath import mp, mpf, asin, atan, atanh, cos, expm1, ln, log1p, pi, sin, sqrt

mp.dps = 110

# |theta| where the two branches of Kepler's equation meet: nearer tail 1/8.
SPLIT = mpf(1) / 8


def series_free(f, a, b, n=64):
    """Coefficients (lowest first) of the polynomial of degree n through f at Chebyshev nodes."""
    a, b = mpf(a), mpf(b)
    nodes = [cos(pi * (2 * i + 1) / (2 * n + 2)) for i in range(n + 1)]
    values = [f((a + b) / 2 + (b - a) / 2 * x) for x in nodes]
    cheb = []
    for k in range(n + 1):
        s = sum(v * cos(pi * k * (2 * i + 1) / (2 * n + 2)) for i, v in enumerate(values))
        cheb.append(s * 2 / (n + 1))
    cheb[0] /= 2
    # Chebyshev to monomials in x in [-1, 1], then to v in [a, b].
    t0, t1 = [mpf(1)], [mpf(0), mpf(1)]
    mono = [mpf(0)] * (n + 1)
    for k in range(n + 1):
        t = t0 if k == 0 else t1 if k == 1 else None
        if t is None:
            t = [mpf(0)] + [2 * c for c in t1]
            for i, c in enumerate(t0):
                t[i] -= c
            t0, t1 = t1, t
        for i, c in enumerate(t):
            mono[i] += cheb[k] * c
    scale, shift = 2 / (b - a), -(a + b) / (b - a)
    out, power = [mpf(0)] * (n + 1), [mpf(1)]
    for k in range(n + 1):
        for i, c in enumerate(power):
            out[i] += mono[k] * c
        grown = [mpf(0)] * (len(power) + 1)
        for i, c in enumerate(power):
            grown[i] += c * shift
            grown[i + 1] += c * scale
        power = grown
    return out


def newton(f, df, x):
    for _ in range(200):
        step = f(x) / df(x)
        x -= step
        if abs(step) <= abs(x) * mpf(10) ** (-mp.dps + 8):
            return x
    return x


def tail_angle(t):
    """(eta / s - 1/2) / t: the angle from the nearer end over s = cbrt(12 pi p), t = s^2."""
    s = sqrt(t)
    y = s + s**3 / 60 + s**5 / 1400
    y = newton(lambda y: y - sin(y) - s**3 / 6, lambda y: 1 - cos(y), y)
    return (y / 2 / s - mpf(1) / 2) / t


def centre_angle(w):
    """(theta / d - pi / 2) / w, w = d^2, d = 1/2 - p: theta + sin theta cos theta = pi d."""
    d = sqrt(w)
    x = newton(lambda x: x + sin(x) * cos(x) - pi * d, lambda x: 2 * cos(x) ** 2, pi * d / 2)
    return (x / d - pi / 2) / w


def tail_of_cos(w):
    """(p / cos^3 - 2 / (3 pi)) / w, w = cos^2."""
    c = sqrt(w)
    return ((asin(c) - c * sqrt(1 - w)) / pi / c**3 - 2 / (3 * pi)) / w


def centre_of_sin(w):
    """((asin s + s sqrt(1 - s^2)) / pi - 2 s / pi) / s^3, w = s^2."""
    s = sqrt(w)
    return ((asin(s) + s * sqrt(1 - w)) / pi - 2 * s / pi) / s**3


def tail_of_angle(h):
    """(p / eta^3 - 2 / (3 pi)) / h, h = eta^2, p the nearer tail of the disk's law at eta from its end."""
    y = 2 * sqrt(h)
    return ((y - sin(y)) / (2 * pi) / sqrt(h) ** 3 - 2 / (3 * pi)) / h


root = lambda f: (lambda v: f(sqrt(v)))
TAIL_TOP = (12 * pi * SPLIT) ** (mpf(2) / 3) * (1 + mpf(2) ** -20)
CENTRE_TOP = (mpf(1) / 2 - SPLIT) ** 2 * (1 + mpf(2) ** -20)

# name, function of v, top of the interval [0, top], share of the result that the polynomial makes, doc
POLYNOMIALS = [
    ("sin", root(lambda x: (sin(x) - x) / x**3), mpf("0.81"), mpf("0.14"),
     "(sin x - x) / x^3 in x^2, |x| <= 0.9"),
    ("cos", root(lambda x: (cos(x) - 1 + x**2 / 2) / x**4), mpf("0.81"), mpf("0.05"),
     "(cos x - 1 + x^2 / 2) / x^4 in x^2, |x| <= 0.9"),
    ("sin_turn", root(lambda x: (sin(2 * pi * x) / x - 2 * pi) / x**2), mpf(1) / 64, mpf("0.1"),
     "(sin 2 pi x / x - 2 pi) / x^2 in x^2, |x| <= 1/8"),
    ("cos_turn", root(lambda x: (cos(2 * pi * x) - 1) / x**2), mpf(1) / 64, mpf("0.42"),
     "(cos 2 pi x - 1) / x^2 in x^2, |x| <= 1/8"),
    ("kepler_tail", tail_angle, TAIL_TOP, mpf("0.04"),
     "(eta / s - 1/2) / s^2 in s^2, s = cbrt(12 pi p), p <= 1/8"),
    ("kepler_centre", centre_angle, CENTRE_TOP, mpf("0.15"),
     "(theta / d - pi/2) / d^2 in d^2, d = 1/2 - p, p >= 1/8"),
    ("disk_tail", tail_of_angle, (pi / 2) ** 2 * (1 + mpf(2) ** -20), mpf("0.3"),
     "(p / eta^3 - 2 / 3 pi) / eta^2 in eta^2, eta <= pi / 2"),
    ("disk_tail_of_cos", tail_of_cos, mpf(1) / 2 * (1 + mpf(2) ** -20), mpf("0.18"),
     "(p / c^3 - 2 / 3 pi) / c^2 in c^2, c <= sqrt 1/2"),
    ("disk_centre_of_sin", centre_of_sin, mpf(1) / 2 * (1 + mpf(2) ** -20), mpf("0.3"),
     "((asin s + s cos) / pi - 2 s / pi) / s^3 in s^2, s <= sqrt 1/2"),
    # Twice the share, for a term more: the proved error of f64 stays below 1 ulp (proofs/).
    ("atan", root(lambda x: (atan(x) - x) / x**3), mpf(1) / 4 * (1 + mpf(2) ** -20), mpf("0.2"),
     "(atan x - x) / x^3 in x^2, |x| <= 1/2"),
]

def limit(f, at_zero):
    """f, by its limit at 0, where its quotient is 0 / 0."""
    return lambda x: f(x) if abs(x) > mpf(10) ** -25 else mpf(at_zero)


def short(x, bits):
    """x cut to a multiple of 2^-bits."""
    return mp.ldexp(mp.nint(mp.ldexp(x, bits)), -bits)


# Factors that bring a significand to within LOG_SPAN of 1, each from the significand given.
LOG_PARTS = [(mpf("0.6484375"), mpf("1.40625")), (mpf("0.771"), mpf("1.1875")), (mpf("0.917"), mpf(1)),
             (mpf("1.0905"), mpf("0.84375"))]
LOG_SPAN = mpf("0.096")
THIRD_HEAD = mpf(5461) / 16384


def spanning(bits):
    """name, function of x, ends of the interval, log2 of the error wanted, doc"""
    atanh_rest = limit(lambda w: (atanh(sqrt(w)) - sqrt(w)) * 2 / sqrt(w) ** 3, mpf(2) / 3)
    # The terms whose rounding would count stay apart: log2.rs, trig.rs.
    f32 = bits == 24
    return [
        ("atanh", atanh_rest, mpf(0), (3 - 2 * sqrt(2)) ** 2 * (1 + mpf(2) ** -12), -20 if f32 else -50,
         "(2 atanh s - 2 s) / s^3 in s^2, |s| <= 3 - sqrt 8"),
        ("exp2_bend", limit(lambda r: (expm1(r * ln(2)) / r - ln(2)) / r, ln(2) ** 2 / 2), -mpf("0.502"), mpf("0.502"),
         -22 if f32 else -52, "(2^r - 1 - r ln 2) / r^2, |r| <= 1/2"),
        ("log_series", limit(lambda f: (log1p(f) - f + f**2 / 2 - f**3 / 3) / f**4, -mpf(1) / 4), -LOG_SPAN, LOG_SPAN,
         mpf("-22") if f32 else mpf("-53.3"), "(ln(1 + f) - its terms below f^4) / f^4, |f| <= 0.096"),
        ("sine_tail", limit(root(lambda x: (sin(x) - x + x**3 / 6 - x**5 / 120) / x**7), -mpf(1) / 5040), mpf(0), mpf("0.618"),
         mpf("-20") if f32 else mpf("-51.5"), "(sin x - its terms below x^7) / x^7 in x^2, x <= pi/4"),
    ]


# Exact constants, stored as hi + lo.
CONSTANTS = [
    ("half_pi", pi / 2, "pi / 2"),
    ("two_pi", 2 * pi, "2 pi"),
    ("pi", pi, "pi"),
    ("recip_pi", 1 / pi, "1 / pi"),
    ("two_over_pi", 2 / pi, "2 / pi"),
    ("recip_two_pi", 1 / (2 * pi), "1 / (2 pi)"),
    ("twelve_pi", 12 * pi, "12 pi"),
    ("three_over_two_pi", 3 / (2 * pi), "3 / 2 pi"),
    ("two_over_three_pi", 2 / (3 * pi), "2 / 3 pi"),
    ("ln_2", ln(2), "ln 2"),
    ("ln_two_pi", ln(2 * pi), "ln 2 pi"),
    ("ln_pi", ln(pi), "ln pi"),
    ("ln_two_over_pi", ln(2 / pi), "ln 2 / pi"),
    ("ln_three_over_two_pi", ln(3 / (2 * pi)), "ln 3 / 2 pi"),
]


def over_even_powers(n):
    """a_j of integral of cos^n = sqrt(pi/2t) sum a_j m^-2j, from ln Gamma(m + 1/4) - ln Gamma(m + 3/4)."""
    log = [mpf(0)] * (n + 1)
    for j in range(1, n + 1):
        i = 2 * j
        b = mp.bernpoly(i + 1, mpf(1) / 4) - mp.bernpoly(i + 1, mpf(3) / 4)
        log[j] = -b / (i * (i + 1))
    out = [mpf(1)]
    for j in range(1, n + 1):
        out.append(sum(k * log[k] * out[j - k] for k in range(1, j + 1)) / j)
    return out


def over_powers(n):
    """b_j of integral of theta cos^n = sum b_j n^-j, from n (n-1) J(n-2) = n^2 J(n) + 1."""
    b = [mpf(0), mpf(1)]
    for top in range(2, n + 1):
        # The coefficient of n^(1 - top); b_top enters through n^(2 - top) twice and cancels.
        def shifted(power):  # of n^-power in J(n-2)
            return sum(b[j] * mp.binomial(power - 1, power - j) * mpf(2) ** (power - j)
                       for j in range(1, min(power, len(b) - 1) + 1))
        # n^2 J(n-2) - n J(n-2) - n^2 J(n) - 1 at n^(1 - top) with b_top unknown:
        # from n^2 J(n-2): shifted(top + 1) has b_top * 2 top; from -n J(n-2): shifted(top) has b_top.
        known = shifted(top + 1) - shifted(top)
        b.append(-known / (2 * top - 1))
    return b[1:]


# 1 / n! with alternating sign, of sin x / x or cos x.
def factorial_series(odd, n):
    out, f = [], mpf(1)
    for j in range(1, n + 1):
        a = 2 * j if odd else 2 * j - 1
        f *= a * (a + 1)
        out.append((-1) ** j / f)
    return out


def round_to(x, bits):
    """The nearest number of the format, as an exact mpf (normal range)."""
    if x == 0:
        return mpf(0)
    m, e = mp.frexp(x)
    return mp.ldexp(mp.nint(m * mpf(2) ** bits), int(e) - bits)


def text(x, bits):
    """Shortest decimal that reads back as x in the format."""
    v = float(x)
    if v == 0:
        return "0.0"
    if bits == 53:
        s = repr(v)
    else:
        for digits in range(1, 12):
            s = f"{v:.{digits}g}"
            if struct.unpack("f", struct.pack("f", float(s)))[0] == v:
                break
        s = repr(float(s))
    mantissa, _, exponent = s.partition("e")
    return mantissa + ("" if "." in mantissa else ".0") + (f"e{int(exponent)}" if exponent else "")


def fit(coefficients, bottom, top, target, bits):
    """Sollya's polynomial of least degree with a relative error below the target."""
    script = f"""
prec = 400!;
f = {sollya.polynomial(coefficients)};
span = [{mp.nstr(bottom, 40)}; {mp.nstr(top, 40)}];
found = 0;
for n from 2 to {12 if bits == 24 else 34} do {{
  if (found == 0) then {{
    p = fpminimax(f, n, [|{"SG" if bits == 24 else "D"}...|], span, relative);
    e = dirtyinfnorm(p / f - 1, span);
    if (e < {mp.nstr(target, 20)}) then {{
      found = 1;
      for i from 0 to n do {{ print("C", coeff(p, i)); }};
      print("E", e);
    }};
  }};
}};
"""
    cs, [err] = sollya.printed(script)
    return cs, err


def reciprocal_root():
    """In integers: Sollya's polynomial, and where root_coefficients moves it."""
    script = """
p = fpminimax(1 / sqrt(1 + x), %d, [|16...|], [0; 1], fixed, relative);
for i from 0 to %d do { print("C", coeff(p, i)); };
""" % (root_coefficients.DEGREE, root_coefficients.DEGREE)
    return root_coefficients.improved([int(c * 2**16) for c in sollya.printed(script)[0]])


def pair(x, bits):
    hi = round_to(x, bits)
    lo = round_to(x - hi, bits)
    return hi, lo


def emit(bits, fits):
    ty = "f32" if bits == 24 else "f64"
    t = lambda x: text(x, bits)
    pr = lambda x: "Pair { hi: %s, lo: %s }" % tuple(t(v) for v in pair(x, bits))
    lines = [
        f"//! Constants and coefficients for {ty}, written by `python3 tools/coefficients.py`: do not edit.",
        "#![allow(clippy::approx_constant)] // the constants are the point",
        "",
        "use super::pair::Pair;",
        "use super::table::{Part, Table};",
        "use crate::arithmetic::constants::Constants;",
        "",
        f"pub(crate) const CONSTANTS: Constants<Pair<{ty}>> = Constants {{",
    ]
    for name, value, doc in CONSTANTS:
        lines += [f"    // {doc}", f"    {name}: {pr(value)},"]
    lines += ["};", "", f"pub(crate) const TABLE: Table<{ty}> = Table {{"]
    for name, cs, err, doc in fits:
        lines += [f"    // {doc}; relative error 2^{mp.nstr(err, 4)}", f"    {name}: &["]
        lines += [f"        {t(c)}," for c in cs] + ["    ],"]
    for name, cs, doc in [
        ("cosine_integral", over_even_powers(7), "integral of cos^n over its leading term, in m^-2, m = (2n + 1)/4"),
        ("angle_integral", over_powers(14)[2:], "n times the integral of theta cos^n less 1 - 2/3n, over 1/n^2, in 1/n"),
    ]:
        lines += [f"    // {doc}; asymptotic", f"    {name}: &["]
        lines += [f"        {t(round_to(c, bits))}," for c in cs] + ["    ],"]
    lines += ["    // significand from, factor, log2 of its inverse", "    log_parts: ["]
    for start, factor in LOG_PARTS:
        log = -ln(factor) / ln(2)
        head = short(log, 12 if bits == 24 else 30)
        lines += [f"        Part {{ from: {t(round_to(start, bits))}, factor: {t(factor)}, "
                  f"log: Pair {{ hi: {t(head)}, lo: {t(round_to(log - head, bits))} }} }},"]
    lines += ["    ],", f"    log_turn: {t(1 - LOG_PARTS[0][0])},"]
    for name, value, digits in [("log2_e", 1 / ln(2), 11 if bits == 24 else 25), ("ln_2", ln(2), 12 if bits == 24 else 26)]:
        head = short(value, digits)
        lines += [f"    // {name.replace('_', ' ')}, its first word half as long",
                  f"    {name}: Pair {{ hi: {t(head)}, lo: {t(round_to(value - head, bits))} }},"]
    lines += ["    // 1 / 3, its first word of 13 bits",
              f"    third: Pair {{ hi: {t(THIRD_HEAD)}, lo: {t(round_to(mpf(1) / 3 - THIRD_HEAD, bits))} }},"]
    rest = pi / 2 - sum(pair(pi / 2, bits))
    lines += ["    // what half_pi leaves", f"    half_pi_rest: {t(round_to(rest, bits))},"]
    lines += ["    // coefficients of x^3, x^5, ... in sin x, those that sine_tail leaves", "    sine_head: &["]
    lines += [f"        {pr(c)}," for c in factorial_series(True, 2)] + ["    ],"]
    lines += ["};", ""]
    if bits == 24:
        cs, spread = reciprocal_root()
        lines += [f"/// 1 / sqrt(1 + x) in units of 2^-16; the root of sqrt.rs errs by a spread of {spread:.2f} ulp before it is corrected",
                  f"pub(crate) const RECIPROCAL_ROOT: [i32; {len(cs)}] = {cs};", ""]
    path = f"src/arithmetic/native/coefficients_{ty}.rs"
    with open(path, "w") as f:
        f.write("\n".join(lines))
    subprocess.run(["rustfmt", "--edition", "2024", path], check=True)


# The double-double kernels: name, coefficients, top, share of the result that the series makes, doc.
DOUBLE_SERIES = [
    ("SIN", factorial_series(True, 40), mpf("0.81"), mpf("0.14"), "(sin x - x) / x^3 in x^2, |x| <= 0.9"),
    ("ATANH", [mpf(1) / (2 * j + 3) for j in range(80)], mpf("0.02945"), mpf("0.01"),
     "(atanh z - z) / z^3 in z^2, |z| <= 3 - sqrt 8"),
    ("COTH", [2 * mp.bernoulli(2 * j) / mp.factorial(2 * j) for j in range(1, 40)], mpf("0.1226"), mpf("0.0125"),
     "(r coth r/2 - 2) / r^2 in r^2, |r| <= 0.35"),
]

# name, value, words, bits of each but the last (0: all), doc
DOUBLE_CONSTANTS = [
    ("HALF_PI", pi / 2, 3, 0, "pi / 2"),
    ("QUARTER_PI", pi / 4, 2, 0, "pi / 4"),
    ("PI", pi, 2, 0, "pi"),
    ("TWO_PI", 2 * pi, 2, 0, "2 pi"),
    ("RECIP_PI", 1 / pi, 2, 0, "1 / pi"),
    ("LN_2", ln(2), 2, 0, "ln 2"),
    ("LN_2_SHORT", ln(2), 3, 32, "ln 2; the first two words of 32 bits, so that n times them is exact"),
]

# A coefficient of 53 bits may have this share of the result, a product good to 76 bits that share.
PLAIN_SHARE = mpf(2) ** -45
MIDDLE_SHARE = mpf(2) ** -21
DOUBLE_TARGET = mpf(2) ** -99


def fit_double(coefficients, top, share):
    """Sollya's polynomial with leading double-double coefficients, cut where each share begins."""
    shares = [share * abs(c / coefficients[0]) * top**i for i, c in enumerate(coefficients)]
    # A step of Horner's rule multiplies what is beyond its coefficient: the share of the next one.
    full = sum(s > MIDDLE_SHARE for s in shares[1:])
    pairs = sum(s > PLAIN_SHARE for s in shares)
    script = f"""
prec = 600!;
f = {sollya.polynomial(coefficients)};
top = {mp.nstr(top, 40)};
found = 0;
for n from {pairs + 2} to 30 do {{
  if (found == 0) then {{
    formats = [||];
    for i from 0 to n do {{ if (i < {pairs}) then formats = formats :. DD else formats = formats :. D; }};
    p = fpminimax(f, n, formats, [0; top], relative);
    e = dirtyinfnorm(p / f - 1, [0; top]) * {mp.nstr(share, 20)};
    if (e < {mp.nstr(DOUBLE_TARGET, 20)}) then {{
      found = 1;
      for i from 0 to n do {{ print("C", coeff(p, i)); }};
      print("E", e);
    }};
  }};
}};
"""
    cs, [err] = sollya.printed(script)
    return cs[:full], cs[full:pairs], cs[pairs:], err


def words(x, n, bits):
    out = []
    for i in range(n):
        out.append(round_to(x, bits if bits and i < n - 1 else 53))
        x -= out[-1]
    return out


def emit_double():
    t = lambda x: text(x, 53)
    pr = lambda x: "Double { hi: %s, lo: %s }" % tuple(t(v) for v in pair(x, 53))
    lines = [
        "//! Constants and series of the double-double kernels, written by `python3 tools/coefficients.py`: do not edit.",
        "#![allow(clippy::approx_constant)] // the constants are the point",
        "",
        "use super::arith::Double;",
        "use super::series::Series;",
        "",
    ]
    for name, value, n, bits, doc in DOUBLE_CONSTANTS:
        ws = words(value, n, bits)
        lines += [f"// {doc}"]
        if n == 2:
            lines += [f"pub(crate) const {name}: Double = {pr(value)};"]
        else:
            lines += [f"pub(crate) const {name}: [f64; {n}] = [{', '.join(t(w) for w in ws)}];"]
    for name, coefficients, top, share, doc in DOUBLE_SERIES:
        full, middle, plain, err = fit_double(coefficients, top, share)
        print(f"double: {name}: {len(full)} + {len(middle)} + {len(plain)} coefficients, "
              f"error 2^{mp.nstr(err, 4)} of the result", flush=True)
        lines += ["", f"// {doc}; error 2^{mp.nstr(err, 4)} of the result", f"pub(crate) const {name}: Series = Series {{"]
        for field, cs, form in (("full", full, pr), ("middle", middle, pr), ("plain", plain, t)):
            lines += [f"    {field}: &["] + [f"        {form(c)}," for c in cs] + ["    ],"]
        lines += ["};"]
    path = "src/arithmetic/double/coefficients.rs"
    with open(path, "w") as f:
        f.write("\n".join(lines + [""]))
    subprocess.run(["rustfmt", "--edition", "2024", path], check=True)


def main():
    proxies = [(n, series_free(f, 0, top), top, share, doc) for n, f, top, share, doc in POLYNOMIALS]
    for bits in (24, 53):
        specs = [(name, proxy, mpf(0), top, mpf(2) ** -(bits + 2) / share, doc) for name, proxy, top, share, doc in proxies]
        specs += [(name, series_free(f, lo, hi, 40), lo, hi, mpf(2) ** error, doc)
                  for name, f, lo, hi, error, doc in spanning(bits)]
        fits = []
        for name, proxy, lo, hi, target, doc in specs:
            cs, err = fit(proxy, lo, hi, target, bits)
            print(f"{bits} bits: {name}: degree {len(cs) - 1}, relative error 2^{mp.nstr(err, 4)}", flush=True)
            fits.append((name, cs, err, doc))
        emit(bits, fits)
    emit_double()
    fast_coefficients.write(series_free, newton, text)


if __name__ == "__main__":
    main()
