"""Sollya and Gappa as functions: a script in, a bound out."""

import re
import subprocess
import tempfile
from threading import Lock

from tables import exact


LIMIT = 600  # seconds for one call; the longest takes 30 on an idle machine


class Missing(Exception):
    pass


def call(command, text):
    try:
        done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=LIMIT)
    except FileNotFoundError:
        raise Missing(f"{command[0]} is not installed")
    except subprocess.TimeoutExpired:
        return ""  # no answer is no proof
    return done.stdout + done.stderr


def number(x):
    """A float for Sollya, without rounding."""
    mantissa, exponent = exact(x).split("b")
    return f"({mantissa}*2^({exponent}))"


def polynomial(coefficients, v, read):
    text = read(coefficients[-1])
    for c in reversed(coefficients[:-1]):
        text = f"({text}*{v}+{read(c)})"
    return text


SERIES = {
    # (sin x - x)/x^3, (cos x - 1 + x^2/2)/x^4 in v = x^2: alternating, so less off than the next term.
    "sin": "c=1; T=0; for k from 1 to 26 do { c=-c/(2*k)/(2*k+1); T=T+c*x^(k-1); };",
    "cos": "c=-1/2; T=0; for k from 2 to 27 do { c=-c/(2*k)/(2*k-1); T=T+c*x^(k-2); };",
    "sin_turn": "c=2*pi; T=0; for k from 1 to 26 do { c=-c*4*pi^2/(2*k)/(2*k+1); T=T+c*x^(k-1); };",
    "cos_turn": "c=1; T=0; for k from 1 to 26 do { c=-c*4*pi^2/(2*k)/(2*k-1); T=T+c*x^(k-1); };",
    "atan": "T=0; for k from 1 to 60 do { T=T+(-1)^k/(2*k+1)*x^(k-1); };",
    # (y - sin y)/(2 pi eta^3) = sum (-1)^k 2^(2k+3) h^k/(2k+3)!/(2 pi), alternating.
    "disk_tail": "c=2/(3*pi); T=0; for k from 1 to 30 do { c=-c*4/(2*k+2)/(2*k+3); T=T+c*x^(k-1); };",
    # asin c - c sqrt(1 - c^2) = sum 2 j b_j/(2j - 1)... : all terms positive, tail below a geometric one.
    "disk_tail_of_cos": "b=1; T=0; for j from 1 to 72 do { a=b; b=b*(2*j-1)/(2*j); "
    "if (j>1) then { T=T+(b/(2*j+1)+b/(2*j-1))/pi*x^(j-2); }; };",
    "disk_centre_of_sin": "b=1; T=0; for j from 1 to 72 do { b=b*(2*j-1)/(2*j); "
    "T=T+(b/(2*j+1)-b/(2*j-1))/pi*x^(j-1); };",
}
TOPS = {
    "sin": "0.8101", "cos": "0.8101", "sin_turn": "1/64", "cos_turn": "1/64", "atan": "1/4*(1+2^(-20))",
    "disk_tail": "2.46741", "disk_tail_of_cos": "0.500001", "disk_centre_of_sin": "0.500001",
}


KNOWN = {}


def approximation(form, name, coefficients=None):
    """Certified max |P - f| of a polynomial of the table, with the remainder of f's series."""
    cs = form.poly[name] if coefficients is None else coefficients
    key = form.name, name, tuple(cs)
    if key not in KNOWN:
        KNOWN[key] = certified(name, cs)
    return KNOWN[key]


def certified(name, cs):
    if name.startswith("kepler"):
        return max(residuals(name, cs)[0])
    p = polynomial(cs, "x", number)
    body = f"{SERIES[name]} e=supnorm({p},horner(T),[0;{TOPS[name]}],absolute,2^(-8));"
    text = f"display=powers!; prec=250!; {body} round(sup(e),20,RU);\n"
    out = call(["sollya"], text)
    m = re.search(r"^(\d+)(?: \* 2\^\((-?\d+)\))?\s*$", out, re.M)
    if not m:
        return None
    # The series' remainders are below 2^-70 on these intervals.
    return int(m[1]) * 2.0 ** int(m[2] or 0) + 2.0**-70


LOCK = Lock()  # flint's precision is one for all threads


def residuals(poly, cs):
    """Bounds of |residual| on as many equal parts of the variable's range, and that range's end, by Arb.

    Kepler's equation with the polynomial put in: (y - sin y)/(s^3/6) - 1 at y = s + 2 s t P(t), t = s^2, and
    (theta + sin theta cos theta)/(pi d) - 1 at theta = d pi/2 + d w P(w), w = d^2. Sollya's supnorm does not end on
    the latter. Taylor models of order n: the coefficients at the middle, the n-th over the whole part.
    """
    try:
        from flint import arb, arb_series, ctx
    except ImportError:
        raise Missing("python-flint is not installed")
    n, parts, end = 12, 200, {"kepler_tail": 2.811, "kepler_centre": 0.1407}[poly]

    def residual(v):
        x, p, g = arb_series([v, 1]), arb_series([0]), arb_series([0])
        for c in reversed(cs):
            p = p * x + arb(c)
        centre = poly == "kepler_centre"
        y = arb.pi() / 2 + x * p if centre else 1 + 2 * x * p
        t, c, series = x * y * y, arb(1), []
        for k in range(1, 16):
            c = -c * (4 if centre else 1) / (2 * k) / (2 * k + 1)
            series.append(c)
        for c in reversed(series):
            g = (g + c) * t if centre else g * t - c
        # sin's series alternates: what is left out is below 2^-70.
        r = y * (2 + g) / arb.pi() - 1 if centre else 6 * y * y * y * g - 1
        return [r[i] for i in range(n + 1)]

    def bound(i):
        middle = h * (2 * i + 1)
        near, wide = residual(middle), residual(middle + arb(0, h.upper()))
        total = sum((abs(near[k]) * h**k for k in range(n)), arb(0)) + abs(wide[n]) * h**n
        return float(total.upper()) * (1 + 2.0**-40) + 2.0**-70

    with LOCK:
        ctx.prec, ctx.cap = 200, n + 1
        h = arb(end) / (2 * parts)
        return [bound(i) for i in range(parts)], end


def horner(form, out, v, name, coefficients):
    """Gappa lines of poly.rs's horner: sum = sum * x + k from the last coefficient down."""
    lines, last = [], exact(coefficients[-1])
    for i, k in reversed(list(enumerate(coefficients[:-1]))):
        lines += [f"{out}m{i} fl= {last} * {v};", f"{out}{i if i else ''} fl= {out}m{i} + {exact(k)};"]
        last = f"{out}{i}"
    return "\n".join(lines)


def by_fours(out, v, coefficients, rounding):
    """Gappa lines of poly.rs's by_fours, rounded or (rounding = "") exact: four Horner sums in v^4."""
    lines = [f"{out}x2 {rounding}= {v} * {v};", f"{out}x4 {rounding}= {out}x2 * {out}x2;"]
    for part in range(4):
        *rest, last = coefficients[part::4]
        last = exact(last)
        for i, k in reversed(list(enumerate(rest))):
            lines += [f"{out}m{part}_{i} {rounding}= {last} * {out}x4;",
                      f"{out}s{part}_{i} {rounding}= {out}m{part}_{i} + {exact(k)};"]
            last = f"{out}s{part}_{i}"
        lines.append(f"{out}{part} = {last};")
    for name, left, sign, right in [
        ("a", "x2", "*", "2"), ("b", "0", "+", "a"), ("c", "x2", "*", "3"), ("e", "1", "+", "c"),
        ("f", v, "*", "e"), ("", "b", "+", "f"),
    ]:
        left = left if left == v else out + left
        lines.append(f"{out}{name} {rounding}= {left} {sign} {out}{right};")
    return "\n".join(lines)


def gappa(script, goals):
    """The proved upper bounds of |goal|, one a goal, or None for one that has no proof."""
    with tempfile.NamedTemporaryFile("w", suffix=".g") as f:
        f.write(script)
        f.flush()
        out = call(["gappa", f.name], "")
    bounds = []
    for goal in goals:
        m = re.search(re.escape(goal) + r"\|? in \[([^,]*), ([^\]]*)\]", out)
        bounds.append(max(abs(value(t)) for t in m.groups()) if m else None)
    return bounds, out


def value(text):
    m = re.match(r"\s*(-?[\d.]+)(?:b(-?\d+))?(?:e(-?\d+))?", text)
    return float(m[1]) * 2.0 ** int(m[2] or 0) * 10.0 ** int(m[3] or 0)
