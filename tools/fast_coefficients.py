"""Polynomials of the `Fast<f32>` kernels: what `tools/coefficients.py` writes to src/arithmetic/fast/coefficients.rs.

Two kinds. A float polynomial has f32 coefficients. A fixed-point one is evaluated in 32-bit
integers: x in Q16, the leading coefficient in Qk, the others in Q(k + 16), and no step of
Horner's rule leaves 32 bits (checked here). Where |x| <= 1/2 both factors of each product have 16
bits: vectors multiply them in one instruction, if the compiler sees it. It does not of a positive
sum with a negative term, hence the choice of some arguments and signs. The error is that of the
polynomial with its stored coefficients, certified by Sollya's supnorm against an interpolant exact
to 1e-30.
"""

import subprocess

import sollya
from mpmath import mp, mpf, asin, atan, atanh, cbrt, cos, pi, sin, sqrt


# Such that all polynomials of either side have one degree, and their values are in one binade.
KEPLER_SPLIT = mpf(11) / 64


def of_square(f):
    """f(sqrt v), by its limit at 0, where the quotients below are 0 / 0."""
    return lambda v: f(sqrt(v) if v > mpf(10) ** -50 else mpf(10) ** -25)


def kepler_angle(z, newton):
    """eta with 2 eta - sin 2 eta = 2 pi z^3."""
    s = cbrt(12 * pi) * z
    y = s + s**3 / 60 + s**5 / 1400
    return newton(lambda y: y - sin(y) - s**3 / 6, lambda y: 1 - cos(y), y) / 2


def specs(newton):
    grown = lambda x: x * (1 + mpf(2) ** -12)
    eta = lambda z: kepler_angle(z, newton)
    # The angle from the axis at the tail 1/2 - w / 2.
    theta = lambda w: pi / 2 - eta(cbrt((1 - w) / 2))
    # What is squared is cut off to Q16, and so is its square: at the split by so much on average.
    cut = lambda f, q: (lambda v: of_square(f)(v + (q + mpf(1) / 2) / 65536))
    tops = (cbrt(KEPLER_SPLIT), 1 - 2 * KEPLER_SPLIT)
    at_end, at_centre = (lambda f: cut(f, tops[0])), (lambda f: cut(f, tops[1]))
    end, centre = ((0, grown(top**2)) for top in tops)
    tail = lambda s: mpf(1) / 2 - (asin(s) + s * sqrt(1 - s * s)) / pi
    of_sine = lambda s: (tail(s) / (1 - s * s) ** mpf("1.5") if s < 1 - mpf(10) ** -30 else 2 / (3 * pi))
    of_twice = lambda f: (lambda x: f(2 * x if abs(x) > mpf(10) ** -60 else mpf(10) ** -60))
    sinc = of_square(lambda x: sin(x) / x)
    # name, function, interval, log2 of the error wanted, None or k, what it is
    return [
        ("CBRT", lambda x: cbrt(1 - x), (0, 0.5), -15, 16, "cbrt(1 - x), less 1"),
        ("TURN_SIN", of_square(lambda y: sin(pi / 4 * y) / y * 2), (0, 1), -13.5, 15, "2 sin(pi y / 4) / y in y^2"),
        ("TURN_COS", of_square(lambda y: cos(pi / 4 * y)), (0, 1), -13.5, 15, "cos(pi y / 4) in y^2"),
        ("END_COS", at_end(lambda z: sin(eta(z)) / z), end, -14.5, 15,
         "cos theta / z in z^2 as cut off, z = cbrt p, p < KEPLER_SPLIT"),
        ("END_SIN", at_end(lambda z: cos(eta(z))), end, -14.5, 14, "sin theta in the same"),
        ("END_ANGLE", at_end(lambda z: eta(z) / z), end, -14.8, 15, "(pi/2 - theta) / z in the same"),
        ("CENTRE_SIN", at_centre(lambda w: 2 * sin(theta(w)) / w), centre, -14.8, 15,
         "2 sin theta / w in w^2 as cut off, w = 1 - 2 p"),
        ("CENTRE_COS", at_centre(lambda w: cos(theta(w))), centre, -14.5, 14, "cos theta in the same"),
        ("CENTRE_ANGLE", at_centre(lambda w: 2 * theta(w) / w), centre, -14.8, 15, "2 theta / w in the same"),
        ("EXP2", lambda g: mpf(4) ** g - 2 * g, (0, 0.5), -15, 14, "4^x - 2x, less 1"),
        ("EXP2_M1", of_twice(lambda y: -mp.expm1(-y * mp.log(2)) / y), (0, 0.1875), -13.7, 16, "(1 - 2^-y) / y, y = 2x"),
        ("SIN", sinc, (0, grown(pi**2 / 4)), -12.9, None, "sin x / x in x^2, |x| <= pi / 2"),
        ("COS", sinc, (0, grown(pi**2 / 4)), -15, None, "the same, finer: cosines are raised to powers"),
        ("HALF_TURN", of_square(lambda x: sin(pi * x) / x), (0, 0.25), -12.9, None, "sin(pi x) / x in x^2, x <= 1/2"),
        ("ATAN", of_square(lambda x: atan(x) / x), (0, 1), -13.1, None, "atan x / x in x^2, |x| <= 1"),
        ("LN", of_square(lambda z: 2 * atanh(z) / z), (0, grown(3 - 2 * sqrt(2)) ** 2), -21, None,
         "2 atanh z / z in z^2, |z| <= 3 - 2 sqrt 2"),
        ("LN_SHORT", of_square(lambda z: 2 * atanh(z) / z), (0, grown(3 - 2 * sqrt(2)) ** 2), -15, None,
         "2 atanh z / z in z^2, shorter: for roots of probabilities"),
        ("TAIL_OF_ANGLE", of_square(lambda x: (2 * x - sin(2 * x)) / (2 * pi * x**3)), (0, grown(pi**2 / 4)), -13.1, None,
         "p / eta^3 in eta^2, eta <= pi / 2"),
        ("TAIL_OF_SINE", of_sine, (0, 1), -13.1, None, "p / cos^3 in sin"),
    ]


# Exactly 1 at 0, and stored less 1; the error is that of the whole.
ONE_AT_ZERO = ("CBRT", "EXP2")


def azimuth(series_free):
    """Sine and cosine of 2 pi u by one product of s = u (1/2 - u), u <= 1/2.

    cos is (1/4 - u) (c0 + c1 T) and sin is s (q0 + 16 s + q1 T), T = s (s + k): k as a polynomial of
    degree 2 wants it for the cosine, 16 for what is left of the sine's then. Where either is 1 it is
    exact, less what rounding may add.
    """
    at = lambda s: sqrt(mpf(1) / 16 - s)
    cosine = series_free(lambda s: sin(2 * pi * at(s)) / at(s), 0, mpf(1) / 16, n=28)
    sine = series_free(lambda s: cos(2 * pi * at(s)) / s, 0, mpf(1) / 16, n=28)
    c, errors = sollya.printed(f"""
prec = 300!;
c = {sollya.polynomial(cosine)}; s = {sollya.polynomial(sine)}; hi = 1/16; one = 1 - 1b-20; c0 = 4 * one;
free = fpminimax(c, [|1, 2|], [|SG...|], [hi / 32; hi], floating, relative, c0);
k = round(coeff(free, 1) / coeff(free, 2), SG, RN);
p = fpminimax(c, [|x^2 + k * x|], [|SG...|], [hi / 32; hi], floating, relative, c0);
t = hi * (hi + k);
q1 = coeff(fpminimax(s, [|x^2 + k * x - t|], [|SG...|], [0; hi - hi / 32], floating, relative, 16 * one - 1 + 16 * x), 2);
q0 = round(16 * one - 1 - q1 * t, SG, RD);
print("C", k); print("C", c0); print("C", coeff(p, 2)); print("C", q0); print("C", q1);
print("E", sup(supnorm(p, c, [0; hi], relative, 2^(-10))));
print("E", sup(supnorm(q0 + 16 * x + q1 * (x^2 + k * x), s, [0; hi], relative, 2^(-10))));
""")
    print(f"fast: azimuth: relative errors 2^{mp.nstr(errors[0], 4)} and 2^{mp.nstr(errors[1], 4)}", flush=True)
    return c, errors


def fit(proxy, interval, wanted, k, one_at_zero):
    """Sollya's polynomial of least degree with a relative error below 2^wanted."""
    lo, hi = (mp.nstr(mpf(v), 40) for v in interval)
    form = "[|SG...|], [lo; hi], floating, relative" if k is None else "kinds(n), [lo; hi], fixed, relative"
    powers, part, start = "n", "", "lo"
    if one_at_zero:
        # Beside 0 there is no choice left, which Remez's exchange does not bear.
        form = form.replace("kinds(n)", "kinds(n - 1)")
        powers, part, start = "[|1,...,n|]", ", 1", "lo + (hi - lo) / 32"
    coefficients, errors = sollya.printed(f"""
prec = 300!;
f = {sollya.polynomial(proxy)}; lo = {lo}; hi = {hi}; found = 0;
procedure kinds(n) {{ var l, i; l = [|{(k or 0) + 16}|]; for i from 2 to n do {{ l = l :. {(k or 0) + 16}; }}; return l :. {k or 0}; }};
for n from {1 if not one_at_zero else 2} to 9 do {{
  if (found == 0) then {{
    p = fpminimax(f, {powers}, {form.replace("lo;", start + ";")}{part});
    if (dirtyinfnorm(p / f - 1, [lo; hi]) < 2^({wanted})) then {{
      found = 1;
      for i from 0 to n do {{ print("C", coeff(p, i)); }};
      print("E", sup(supnorm(p, f, [lo; hi], relative, 2^(-10))));
    }};
  }};
}};
""")
    return coefficients, errors[0]


def check_range(name, c, interval, k):
    """Every step of Horner's rule fits a signed 32-bit word, a last sum that is never 0 an unsigned one."""
    for i in range(257):
        x = interval[0] + (interval[1] - interval[0]) * mpf(i) / 256
        total = c[-1]
        for a in reversed(c[:-1]):
            product, total = total * x, total * x + a
            assert abs(product) * 2 ** (k + 16) < 2**31, (name, k)
            assert a is c[0] or abs(total) * 2 ** (k + 16) < 2**31 - 2**16, (name, k)
        assert abs(total) < 2 ** ((16 if c[0] else 15) - k), (name, k)


def write(series_free, newton, text):
    lines = [
        "//! Coefficients of the fast kernels, written by `python3 tools/coefficients.py`: do not edit.",
        "//!",
        "//! `FixedPoint`: argument in Q16, `last` in Qk, the others in Q(k + 16), `inner` with half a unit of Qk added. Each error is relative,",
        "//! certified by Sollya's `supnorm`, of the polynomial as stored; rounding comes on top.",
        "#![allow(clippy::approx_constant, clippy::excessive_precision)] // the constants are the point",
        "",
        "use super::fixed::FixedPoint;",
        "",
        "/// Tail of the disk's law below which a direction is measured from the end, else from the axis.",
        f"pub(crate) const KEPLER_SPLIT: f32 = {mp.nstr(KEPLER_SPLIT, 10)};",
    ]
    for name, f, interval, wanted, k, doc in specs(newton):
        c, error = fit(series_free(f, *interval, n=28), interval, wanted, k, name in ONE_AT_ZERO)
        print(f"fast: {name}: degree {len(c) - 1}, relative error 2^{mp.nstr(error, 4)}", flush=True)
        lines += ["", f"/// {doc}; relative error 2^{mp.nstr(error, 4)}" + ("" if k is None else f"; k = {k}")]
        if k is None:
            values = ", ".join(text(v, 24) for v in c)
            lines += [f"pub(crate) const {name}: [f32; {len(c)}] = [{values}];"]
        else:
            if name in ONE_AT_ZERO:
                c[0] = mpf(0)
            check_range(name, c, interval, k)
            whole = [int(v * 2 ** (k + 16)) for v in c]
            whole[0] %= 2**32
            # Half a unit of what a step cuts off rounds it at no cost.
            inner = ", ".join(str(v + 2**15) for v in whole[1:-1])
            lines += [f"pub(crate) const {name}: FixedPoint<{len(c) - 2}> = FixedPoint {{ "
                      f"first: {whole[0]}, inner: [{inner}], last: {int(c[-1] * 2**k)} }};"]
    (k, *pairs), errors = azimuth(series_free)
    lines += ["", "/// Sine and cosine of 2 pi u are of T = s (s + AZIMUTH_SHIFT), s = u (1/2 - u), u <= 1/2.",
              f"pub(crate) const AZIMUTH_SHIFT: f32 = {text(k, 24)};"]
    for name, doc, pair, error in (
        ("AZIMUTH_COS", "cos(2 pi u) / (1/4 - u) in T", pairs[:2], errors[0]),
        ("AZIMUTH_SIN", "sin(2 pi u) / s - 16 s in T", pairs[2:], errors[1]),
    ):
        lines += ["", f"/// {doc}; relative error 2^{mp.nstr(error, 4)}",
                  f"pub(crate) const {name}: [f32; 2] = [{text(pair[0], 24)}, {text(pair[1], 24)}];"]
    path = "src/arithmetic/fast/coefficients.rs"
    with open(path, "w") as out:
        out.write("\n".join(lines) + "\n")
    subprocess.run(["rustfmt", "--edition", "2024", path], check=True)
