"""atan.rs."""

import math
import struct

from part import P, Part, binades, head, ulp
from tables import exact
from tools import horner


def atan(form, cs, E):
    """atan.rs place: q + rest about the multiples 0, 1, 2 (3 and 4: larger, hence fewer ulps)."""
    hi, lo = (form.pair["half_pi"][0] / 2, form.pair["half_pi"][1] / 2)
    drop = form.bits - form.half
    scaled = math.floor(math.ldexp(hi, form.bits))
    lead = math.ldexp(scaled >> drop << drop, -form.bits)
    def rounded(x):
        return x if form.bits == 53 else struct.unpack("f", struct.pack("f", x))[0]
    trail = rounded((hi - lead) + lo)
    for eighths, sign, low, high, k in atan_pieces():
        if eighths == 0:  # 0 + q, the low part and the multiple's trail are exact: q + rest remains.
            yield Part(head(form) + f"""
q = fl(qq);
v fl= q * q;
{horner(form, "h", "v", "atan", cs)}
qv fl= q * v;
qvh fl= qv * h;                     # q * v * horner(v, atan)
rest0 = fl(rr);                     # residual / (bottom + bottom v)
rest fl= rest0 + qvh;
r = q + rest;
y fl= q + rest;
V = q * q; P = {P(form, "atan", "V", cs)};
M = q + q * V * Q + rest0 - err;
{{ q in [{low!r}, {high!r}] /\\ |rest0| <= {exact(ulp(form, k) / 2)} /\\ |P - Q| <= {exact(E)}
   /\\ |err| <= {exact(form.u * 2.0 ** -(form.half - 5) * high)} -> |r - M| in ? /\\ |y - M| in ? }}
y - M -> (y - r) + (r - M);
r - M -> (rest - (rest0 + qvh)) + (qvh - q * V * P) + q * V * (P - Q) + err;
$ q in 20;
""", ["r - M", "y - M"], ulp(form, k))
            continue
        base = f"{eighths} * {exact(lead)}"
        add = "+" if sign > 0 else "-"
        yield Part(head(form) + f"""
q = fl(qq);
v fl= q * q;
{horner(form, "h", "v", "atan", cs)}
qv fl= q * v;
qvh fl= qv * h;                     # q * v * horner(v, atan)
rest0 = fl(rr);                     # residual / (bottom + bottom v)
rest fl= rest0 + qvh;
hi fl= {base} {add} q;
low = ({base} {add} q) - hi;        # fast_two_sum: exact
kt fl= {eighths} * {exact(trail)};
a fl= kt {add} rest;
b fl= low + a;
y fl= hi + b; r = hi + b;
V = q * q; P = {P(form, "atan", "V", cs)};
M = {eighths} * ({exact(lead)} + {exact(trail)} + D) {add} (q + q * V * Q + rest0 - err);
{{ q in [{low!r}, {high!r}] /\\ |rest0| <= {exact(form.u * high)} /\\ |P - Q| <= {exact(E)} /\\ |D| <= {exact(lead * 2.0 ** (-form.bits - form.half + 3))}
   /\\ |err| <= {exact(form.u * 2.0 ** -(form.half - 5) * high)} -> |r - M| in ? /\\ |y - M| in ? }}
y - M -> (y - r) + (r - M);
r - M -> (b - (low + a)) + (a - (kt {add} rest)) + (kt - {eighths} * {exact(trail)}) - {eighths} * D
  {add} ((rest - (rest0 + qvh)) + (qvh - q * V * P) + q * V * (P - Q) + err);
$ q in 24;
""", ["r - M", "y - M"], ulp(form, k))


def atan_pieces():
    """(eighths of a turn/8, sign of q, q from, q to, binade of the angle)."""
    for low, high, k in binades(math.atan, 0.5000001):
        # The largest errors are beside q = 1/2: its end of the binade apart, to be bisected finer.
        for a, b in [(low, 0.45), (0.45, high)] if high > 0.45 else [(low, high)]:
            yield 0, 1, a, b, k
    # pi/4 - atan q, q <= 1/3: from 0.4636; pi/4 + atan q: to 1.107; pi/2 - atan q: from 1.107.
    yield 1, -1, 0.29321, 0.3334, -2
    yield 1, -1, 1e-9, 0.29343, -1
    yield 1, 1, 1e-9, 0.2181, -1
    yield 1, 1, 0.2179, 0.3334, 0
    yield 2, -1, 1e-9, 0.5000001, 0
