#!/usr/bin/env python3
"""Writes src/integers/q31/coefficients.rs and src/integers/q15/coefficients.rs: the integer polynomials of the fixed-point laws.

Needs Sollya (Debian: sollya) and mpmath (PyPI: mpmath). Run from the repository's root:

    python3 tools/fixed_coefficients.py

A polynomial in x (Q32, signed, below 1/2 in size) has all its coefficients in one format Qk and is evaluated by
Horner's rule in 32-bit words. While the sum fits 15 bits a step is a single 32-bit product (`small`), from there on
the high half of a 64-bit one (`large`). That nothing leaves 31 bits and a sign is checked here by intervals. The error is that of the
polynomial with its stored coefficients, from Sollya's supnorm against an interpolant exact to 1e-20.

Those of the 16-bit type have small sums alone: every product is one of 16 by 16 bits.
"""

import subprocess
import textwrap

import sollya
from coefficients import newton, series_free
from mpmath import mp, mpf, asin, atanh, cbrt, cos, expm1, ln, pi, sin, sqrt

mp.dps = 60


def of_square(f):
    """f(sqrt v), by its limit at 0, where the quotients below are 0 / 0."""
    return lambda v: f(sqrt(v) if v > mpf(10) ** -36 else mpf(10) ** -18)


def centred(f):
    """f of t in [0, 1/2] as a function of 2 t - 1/2: smaller coefficients."""
    return lambda x: f((x + mpf(1) / 2) / 2)


# Three quarters of (1/2)^(2/3) in Q32. Powers of 3/2 z^2 - 0.47 have coefficients below 1/2, and keep the partial sums small.
KEPLER_MIDDLE = 2029244888
MIDDLE = ["", "/// 3/4 of (1/2)^(2/3), in Q32.", f"pub(crate) const KEPLER_MIDDLE: u32 = {KEPLER_MIDDLE};"]


def kepler(x):
    """eta / z - 1 in x = 3/2 z^2 - KEPLER_MIDDLE, z = cbrt p: eta is the angle from the end in quarter turns."""
    v = (x + mpf(KEPLER_MIDDLE) / 2**32) / mpf(1.5)
    z = sqrt(v) if v > mpf(10) ** -36 else mpf(10) ** -18
    s = cbrt(12 * pi) * z
    y = s + s**3 / 60 + s**5 / 1400
    y = newton(lambda y: y - sin(y) - s**3 / 6, lambda y: 1 - cos(y), y)
    return y / pi / z - 1


# name, function, interval, log2 of the absolute error wanted, k, degree or None, what it is
SPECS = [
    ("TURN_COS", of_square(lambda y: (1 - cos(pi / 4 * y)) / y**2), (0, 1), -34.0, 32, "(1 - cos(pi y / 4)) / y^2 in y^2"),
    ("TURN_SIN", of_square(lambda y: sin(pi / 4 * y) / y), (0, 1), -34.0, 32, "sin(pi y / 4) / y in y^2"),
    ("RECIP_SQRT", lambda t: 1 / sqrt(1 - t), (0, mpf(1) / 2), -10, 14, "1 / sqrt(1 - t)"),
    ("CBRT", centred(lambda t: (1 - cbrt(1 - t)) / t if t > mpf(10) ** -30 else mpf(1) / 3), (-mpf(1) / 2, mpf(1) / 2), -32.5, 32,
     "(1 - cbrt(1 - t)) / t in 2 t - 1/2"),
    ("RECIP", centred(lambda t: 1 / (1 - t)), (-mpf(1) / 2, mpf(1) / 2), -10.5, 14, "1 / (1 - t) in 2 t - 1/2"),
    ("ASIN", of_square(lambda s: asin(s) / s / (2 * pi)), (0, sin(pi / 8) ** 2 + mpf(2) ** -20), -32.5, 32, "asin s / (2 pi s) in s^2"),
    ("KEPLER", kepler, (-mpf(KEPLER_MIDDLE) / 2**32, mpf(KEPLER_MIDDLE) / 2**32 + mpf(2) ** -20), -32, 32,
     "eta / z - 1 in 3/2 z^2 - KEPLER_MIDDLE, z = cbrt p"),
    ("LOG2", centred(lambda t: (-ln(1 - t) / ln(2) / t if t > mpf(10) ** -36 else 1 / ln(2)) - mpf(3) / 2), (-mpf(1) / 2, mpf(1) / 2), -31.4, 31,
     "-log2(1 - t) / t - 3/2 in 2 t - 1/2"),
    ("EXP2", lambda g: mpf(2) ** (-mpf(1) / 2 - g) - mpf(1) / 2, (-mpf(1) / 2, mpf(1) / 2), -31.6, 31, "2^-(1/2 + g) - 1/2"),
    ("EXP2_M1", lambda x: -expm1(-x * ln(2)) / x if x > mpf(10) ** -36 else ln(2), (0, mpf(1) / 2), -31.6, 31, "(1 - 2^-x) / x"),
]
# name, function, interval, log2 of the absolute error wanted, k, what it is
SHORT_SPECS = [
    ("TURN_COS", of_square(lambda y: (1 - cos(pi / 4 * y)) / y**2), (0, 1), -18.5, 17, "(1 - cos(pi y / 4)) / y^2 in y^2"),
    ("TURN_SIN", of_square(lambda y: sin(pi / 4 * y) / y), (0, 1), -17.5, 16, "sin(pi y / 4) / y in y^2"),
    ("SQRT", lambda w: 1 / (1 + sqrt((1 + w) / 2)), (0, 1), -16.5, 16, "(1 - sqrt m) / (1 - m) in 2 m - 1"),
    ("CBRT", lambda w: 1 / (1 + cbrt((1 + w) / 2) + cbrt((1 + w) / 2) ** 2), (0, 1), -16.5, 16, "(1 - cbrt m) / (1 - m) in 2 m - 1"),
    ("RECIP", lambda w: 1 / (1 + w), (0, 1), -17, 16, "1 / 2 m in 2 m - 1"),
    ("ASIN", of_square(lambda s: asin(s) / s / (2 * pi)), (0, sin(pi / 8) ** 2 + mpf(2) ** -12), -18.5, 17, "asin s / (2 pi s) in s^2"),
    ("KEPLER", kepler, (-mpf(KEPLER_MIDDLE) / 2**32, mpf(KEPLER_MIDDLE) / 2**32 + mpf(2) ** -12), -18.5, 17,
     "eta / z - 1 in 3/2 z^2 - KEPLER_MIDDLE, z = cbrt p"),
]
# Evaluated with unsigned words in x from 0 to 1 and signs that alternate.
ALTERNATING = ("TURN_COS", "TURN_SIN")
# In Q14, by single products alone; x below 1/2 leaves 15 bits of it.
SHORT = ("RECIP_SQRT", "RECIP")


def fit(proxy, interval, wanted, k):
    """Sollya's polynomial of least degree with an absolute error below 2^wanted."""
    lo, hi = (mp.nstr(mpf(v), 40) for v in interval)
    coefficients, [error] = sollya.printed(f"""
prec = 300!;
f = {sollya.polynomial(proxy)}; lo = {lo}; hi = {hi}; found = 0;
procedure kinds(n) {{ var l, i; l = [|{k}|]; for i from 1 to n do {{ l = l :. {k}; }}; return l; }};
for n from 2 to 16 do {{
  if (found == 0) then {{
    p = fpminimax(f, n, kinds(n), [lo; hi], fixed, absolute);
    if (dirtyinfnorm(p - f, [lo; hi]) < 2^({wanted})) then {{
      found = 1;
      for i from 0 to n do {{ print("C", coeff(p, i)); }};
      print("E", sup(supnorm(p, f, [lo; hi], absolute, 2^(-10))));
    }};
  }};
}};
""")
    return coefficients, error


def sums(c, interval, k):
    """[least, largest] of each of Horner's partial sums in units of Qk, the leading coefficient first."""
    points = [interval[0] + (interval[1] - interval[0]) * mpf(i) / 4096 for i in range(4097)]
    totals, out = [mpf(c[-1])] * len(points), []
    for i in range(len(c) - 1, -1, -1):
        if i < len(c) - 1:
            totals = [t * x + c[i] for t, x in zip(totals, points)]
        out.append((min(totals) * 2**k, max(totals) * 2**k))
    return out


def documented(doc, interval, k, error):
    lo, hi = (mp.nstr(mpf(v), 6) for v in interval)
    text = f"{doc}; x from {lo} to {hi}; Q{k}; error 2^{mp.nstr(error, 4)}"
    return [f"/// {line}" for line in textwrap.wrap(text, 95)]


def write(path, lines):
    with open(path, "w") as out:
        out.write("\n".join(lines) + "\n")
    subprocess.run(["rustfmt", "--edition", "2024", path], check=True)


def short():
    lines = [
        "//! Coefficients, written by `python3 tools/fixed_coefficients.py`: do not edit.",
        "//!",
        "//! Each error is absolute, certified by Sollya's `supnorm`, of the polynomial as stored; rounding",
        "//! comes on top.",
        "",
        "use crate::integers::kernel::poly::Polynomial;",
        *MIDDLE,
    ]
    for name, f, interval, wanted, k, doc in SHORT_SPECS:
        c, error = fit(series_free(f, *interval, n=36), interval, wanted, k)
        print(f"{name}, short: degree {len(c) - 1}, error 2^{mp.nstr(error, 4)}", flush=True)
        whole = [int(v * 2**k) for v in c]
        steps = sums(c, interval, k)
        if interval[0] == 0 and all((v > 0) == (i % 2 == 0) for i, v in enumerate(whole)):
            kind, limit, whole = "u32", 2**16, [abs(v) for v in whole]
        else:
            kind, limit = "i32", 2**15 - 2 * len(c)
            assert -0.5 <= interval[0] and interval[1] <= 0.5, name
        # The last sum is multiplied too, by its user and without a sign.
        assert all(abs(v) < limit for s in steps[:-1] for v in s), (name, whole)
        assert all(0 < v < 2**16 + 1 for v in steps[-1]), (name, whole)
        lines += ["", *documented(doc, interval, k, error),
                  f"pub(crate) const {name}: Polynomial<{kind}, {len(c)}, 0> = Polynomial {{ small: {whole[::-1]}, large: [] }};"]
    write("src/integers/q15/coefficients.rs", lines)


def main():
    short()
    lines = [
        "//! Coefficients, written by `python3 tools/fixed_coefficients.py`: do not edit.",
        "//!",
        "//! Each error is absolute, certified by Sollya's `supnorm`, of the polynomial as stored; rounding",
        "//! comes on top.",
        "",
        "use crate::integers::kernel::poly::Polynomial;",
        *MIDDLE,
    ]
    for name, f, interval, wanted, k, doc in SPECS:
        c, error = fit(series_free(f, *interval, n=36), interval, wanted, k)
        print(f"{name}: degree {len(c) - 1}, error 2^{mp.nstr(error, 4)}", flush=True)
        whole = [int(v * 2**k) for v in c]
        steps = sums(c, interval, k)
        if name in ALTERNATING:
            assert all((v > 0) == (i % 2 == 0) for i, v in enumerate(whole)), (name, whole)
            assert all(0 < abs(v) < 2**32 for s in steps for v in s), (name, steps)
            whole = [abs(v) for v in whole]
            limit = 2**16
        else:
            limit = 2**15
        if name in SHORT:
            assert all(abs(v) * 2**15 < 2**31 for s in steps for v in s), (name, steps)
            kind, split = "i32", len(whole)
        else:
            split = 0
            while max(abs(v) for v in steps[split]) < limit - 2:
                split += 1
            # The step after the last small sum still multiplies that one.
            split += 1
            top = 2**32 if name in ALTERNATING else 2**31
            assert all(abs(v) < top - 2**8 for s in steps for v in s), (name, steps)
            kind = "u32" if name in ALTERNATING else "i32"
        top = whole[::-1]
        lines += ["", *documented(doc, interval, k, error),
                  f"pub(crate) const {name}: Polynomial<{kind}, {split}, {len(top) - split}> = "
                  f"Polynomial {{ small: {top[:split]}, large: {top[split:]} }};"]
    write("src/integers/q31/coefficients.rs", lines)


if __name__ == "__main__":
    main()
