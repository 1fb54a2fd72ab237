"""kepler.rs: the disk's tail, and its inverse near the end for a rounded s (all of it: kepler.py)."""

import math

from part import P, Part, binades, head, polynomial_value, ulp
from tables import exact
from tools import by_fours, horner


def kepler_tail(form, cs, E):
    """kepler.rs from_end_at, p < 1/8: eta of the rounded s, without s's own error."""
    body = head(form) + f"""
s = fl(ss);
t fl= s * s;
st fl= s * t;
{by_fours("h", "t", cs, "fl")}
b fl= st * h;                       # s * t * bend
r = s * 0.5 + b;                    # fast_two_sum: exact
T = s * s;
{by_fours("P", "T", cs, "")}
R = s * 0.5 + s * T * P;
"""
    hints = "r - M -> (b - s * T * P) + ((R - M) / R) * R;\n"
    for low, high, k in binades(lambda s: s * (0.5 + s * s * polynomial_value(cs, s * s)), 1.6766):
        yield Part(body + f"{{ s in [{low!r}, {high!r}] /\\ |(R - M) / R| <= {exact(E)} -> |r - M| in ? }}\n"
                   + hints + "$ s in 16;\n", ["r - M"], ulp(form, k))


def tail_of_cos(form, cs, E):
    """kepler.rs tail_at_direction for cos <= sin."""
    hi, lo = form.pair["two_over_three_pi"]
    body = head(form) + f"""
c = fl(cc);
w fl= c * c;
{horner(form, "h", "w", "disk_tail_of_cos", cs)}
wh fl= w * h;
i2 fl= {exact(lo)} + wh;
i3 fl= {exact(hi)} + i2;
cw fl= c * w;
y fl= cw * i3; r = cw * i3;
W = c * c; P = {P(form, "disk_tail_of_cos", "W", cs)};
K = {exact(hi)} + {exact(lo)} + W * P;
N = K - (W * (P - Q) - D);
M = c * W * N;
"""
    hints = ("y - M -> (y - r) + (r - M);\nr - M -> (cw * i3 - c * W * K) + c * W * (W * (P - Q) - D);\n"
             "i3 - K -> (i3 - (%s + i2)) + (i2 - (%s + wh)) + (wh - W * P);\n" % (exact(hi), exact(lo)))
    value = lambda c: (math.asin(c) - c * math.sqrt(1 - c * c)) / math.pi if c > 1e-3 else 2 * c**3 / 3 / math.pi
    for low, high, k in binades(value, 0.70711, count=4):
        yield Part(body + f"{{ c in [{low!r}, {high!r}] /\\ |P - Q| <= {exact(E)} /\\ |D| <= {exact(form.u**2 / 4)} "
                   "-> |r - M| in ? /\\ |y - M| in ? }\n" + hints + "$ c in 10;\n", ["r - M", "y - M"], ulp(form, k))


def centre_of_sin(form, cs, E):
    """kepler.rs tail_at_direction for sin < cos."""
    hi, lo = form.pair["two_over_pi"]
    body = head(form) + f"""
s = fl(xx);
w fl= s * s;
lh fl= s * {exact(hi)};             # Pair::two_prod: hi
ll = s * {exact(hi)} - lh;          # and its exact low part
sl fl= s * {exact(lo)};
sw fl= s * w;
{horner(form, "h", "w", "disk_centre_of_sin", cs)}
swh fl= sw * h;
rest fl= sl + swh;
a fl= 0.5 - lh;
b fl= ll + rest;
y fl= a - b; r = a - b;
W = s * s; P = {P(form, "disk_centre_of_sin", "W", cs)};
M = 0.5 - s * ({exact(hi)} + {exact(lo)} + D) - s * W * Q;
"""
    hints = ("y - M -> (y - r) + (r - M);\nr - M -> (a - (0.5 - lh)) - (b - (ll + rest)) - (rest - (sl + swh)) "
             "- (sl - s * %s) - (swh - s * W * P) - s * W * (P - Q) + s * D;\n" % exact(lo))
    edges = [(1e-9, 0.405, -2), (0.4039, 0.70711, -3)]
    for low, high, k in edges:
        # p >= 1/4 up to sin = 0.4040, and p >= 0.0908 beyond: the last piece falls in two binades.
        cut = [(low, high, k)] if k == -2 else [(low, 0.6389, -3), (0.6329, high, -4)]
        for a, b, e in cut:
            yield Part(body + f"{{ s in [{a!r}, {b!r}] /\\ |P - Q| <= {exact(E)} /\\ |D| <= {exact(form.u**2)} "
                       "-> |r - M| in ? /\\ |y - M| in ? }\n" + hints + "$ s in 24;\n", ["r - M", "y - M"], ulp(form, e))
