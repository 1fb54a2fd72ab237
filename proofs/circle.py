"""trig.rs and turn.rs: sine and cosine."""

import math

from part import P, Part, binades, head, ulp
from tables import exact
from tools import horner


def sine(form, cs, E):
    """trig.rs small: sin of the pair (x, l)."""
    u = form.u
    body = head(form) + f"""
x = fl(xx); l = fl(ll);
v fl= x * x;                        # let v = x.hi * x.hi
w fl= 1 - v * 0.5;                  # let w = ONE - half_v, half_v exact
lw fl= l * w;                       # x.lo * w
xv fl= x * v;                       # x.hi * v
{horner(form, "h", "v", "sin", cs)}
xvh fl= xv * h;                     # * horner(v, sin)
rest fl= lw + xvh;
r = x + rest;                       # fast_two_sum: exact
y fl= x + rest;                     # value()
V = x * x; P = {P(form, "sin", "V", cs)};
M = x + x * V * Q + l * C;        # sin x + l cos x; l^2/2 is beyond
"""
    hints = """
r - M -> (rest - (lw + xvh)) + (xvh - x * V * P) + (lw - l * C) + x * V * (P - Q);
lw - l * C -> (lw - l * w) + l * (w - C);
w - C -> (w - (1 - 0.5 * V)) - (C - (1 - 0.5 * V));
y - M -> (y - r) + (r - M);
"""
    for lo, hi, k in binades(math.sin, 0.9):
        logic = (f"{{ x in [{lo!r}, {hi!r}] /\\ |l| <= {u * hi!r} /\\ |P - Q| <= {exact(E)} /\\ "
                 f"C - (1 - 0.5 * V) in [0, {hi**4 / 24!r}] -> |r - M| in ? /\\ |y - M| in ? }}\n")
        yield Part(body + logic + hints + "$ x in 16;\n", ["r - M", "y - M"], ulp(form, k))


def cosine(form, cs, E):
    """trig.rs small: cos of the pair (x, l)."""
    script = head(form) + f"""
x = fl(xx); l = fl(ll);
v fl= x * x;                        # let v = x.hi * x.hi
hv = v * 0.5;                       # exact
w fl= 1 - hv;
e = (1 - hv) - w;                   # (ONE - w) - half_v: Fast2Sum's error term, exact
vv fl= v * v;
{horner(form, "h", "v", "cos", cs)}
vvh fl= vv * h;                     # v * v * horner(v, cos)
xl fl= x * l;                       # x.hi * x.lo
a fl= vvh - xl;
rest fl= e + a;
r = w + rest;                       # fast_two_sum: exact
y fl= w + rest;
V = x * x; P = {P(form, "cos", "V", cs)};
M = 1 - V * 0.5 + V * V * Q - l * S;
T = 1 - V * 0.5 + V * V * P - x * l;
{{ x in [1b-30, 0.9] /\\ |l| <= {0.9 * form.u!r} /\\ |P - Q| <= {exact(E)} /\\ x - S in [0, 0.1215]
  -> |r - M| in ? /\\ |y - M| in ? }}
r - M -> (r - (w + (e + (vvh - xl)))) + (w + (e + (vvh - xl)) - T) + (T - M);
w + (e + (vvh - xl)) - T -> (V - v) * 0.5 + (vvh - V * V * P) + (x * l - xl);
r - (w + (e + (vvh - xl))) -> rest - (e + (vvh - xl));
T - M -> V * V * (P - Q) - l * (x - S);
y - M -> (y - r) + (r - M);
$ x in 16;
"""
    yield Part(script, ["r - M", "y - M"], ulp(form, -1))


def turn_cos(form, cs, E):
    """turn.rs eighth: ONE + v * horner(v, cos_turn)."""
    yield Part(head(form) + f"""
x = fl(xx);
v fl= x * x;
{horner(form, "h", "v", "cos_turn", cs)}
vh fl= v * h;
y fl= 1 + vh; r = 1 + vh;
V = x * x; P = {P(form, "cos_turn", "V", cs)};
M = 1 + V * Q;
{{ x in [1b-100, 0.125] /\\ |P - Q| <= {exact(E)} -> |r - M| in ? /\\ |y - M| in ? }}
y - M -> (y - r) + (r - M);
r - M -> (vh - V * P) + V * (P - Q);
$ x in 16;
""", ["r - M", "y - M"], ulp(form, -1))


def turn_sin(form, cs, E):
    """turn.rs eighth with slope 2 pi: arg * slope.hi + arg * (slope.lo + bend)."""
    hi, lo = form.pair["two_pi"]
    body = head(form) + f"""
x = fl(xx);
v fl= x * x;
{horner(form, "h", "v", "sin_turn", cs)}
bend fl= v * h;                     # v * share * horner, share a power of two
inner fl= {exact(lo)} + bend;       # slope.lo + bend
b fl= x * inner;
a fl= x * {exact(hi)};
y fl= a + b; r = a + b;
V = x * x; P = {P(form, "sin_turn", "V", cs)};
M = x * (({exact(hi)} + {exact(lo)} + D) + V * Q);
"""
    hints = "y - M -> (y - r) + (r - M);\nr - M -> (a - x * %s) + (b - x * (%s + V * P)) + x * (V * (P - Q) - D);\n" % (
        exact(hi), exact(lo))
    for low, high, k in binades(lambda x: math.sin(2 * math.pi * x), 0.125):
        yield Part(body + f"{{ x in [{low!r}, {high!r}] /\\ |P - Q| <= {exact(E)} /\\ |D| <= {exact(form.u**2 * 4)} "
                   "-> |r - M| in ? /\\ |y - M| in ? }\n" + hints + "$ x in 16;\n", ["r - M", "y - M"], ulp(form, k))
