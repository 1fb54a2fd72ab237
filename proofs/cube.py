"""cbrt.rs: how near the iterates are to 1/cbrt y and cbrt y, and the last step's roundings.

r = (1 + e)/cbrt y; every bound below is of |e|. y runs over [1, 8): beyond, all is scaled by powers of 8.
"""

import re
import struct

from part import Part, head, ulp
from tables import ROOT, exact


def source(form):
    """(guess's constant, CBRT_STEPS, CBRT_RAISE - 1), as the crate has them."""
    text = (ROOT / f"src/arithmetic/native/{form.name}.rs").read_text()
    find = lambda pattern: re.search(pattern, text)[1].replace("_", "")
    guess = find(r"from_bits\((0x[0-9A-F_]+)(?:_u\d\d)?\.wrapping_sub\(self\.to_bits\(\) / 3\)\)")
    steps = find(r"CBRT_STEPS: usize = (\d+);")
    return int(guess, 16), int(steps), 2.0 ** int(find(r"CBRT_RAISE: f\d\d = 1\.0 \+ power_of_two\((-\d+)\);"))


def guess(form, constant):
    """max |guess cbrt y - 1|: the guess falls as the bits of y grow, so ends bound each piece."""
    big, small = ("d", "Q") if form.bits == 53 else ("f", "I")
    to = lambda x: struct.unpack(small, struct.pack(big, x))[0]
    of = lambda b: struct.unpack(big, struct.pack(small, b))[0]
    first, last, n, worst = to(1.0), to(8.0), 6000, 0.0
    edges = [first + (last - first) * i // n for i in range(n + 1)]
    for low, high in zip(edges, edges[1:]):
        r_high, r_low = of(constant - low // 3), of(constant - high // 3)
        worst = max(worst, r_high * of(high) ** (1 / 3) - 1, 1 - r_low * of(low) ** (1 / 3))
    return worst * (1 + 1e-6)


def iterates(form, planted):
    """(bound of r's error, bound of |t/cbrt y - 1|); `planted` has 0 for 14/81."""
    constant, steps, raised = source(form)
    assert raised == 2.0**-form.half
    e, noise = guess(form, constant), 8 * form.u
    # f = 1 - y r^3: what the series of (1 - f)^(-1/3) leaves has coefficients below its first.
    f = (1 + e) ** 3 - 1
    left = 35 / 243 * f**4 / (1 - f) + (14 / 81 * f**3 if planted else 0)
    e = (1 + e) * left + noise
    for _ in range(steps):
        e = 2 * e**2 + 4 / 3 * e**3 + e**4 / 3 + noise
    # y raised r^2, three roundings; cutting what is raised by half a place errs by half a place.
    t = (1 + e) ** 2 * (1 + 4 * form.u) * (1 + raised * (1 + 4 * raised)) - 1
    return e, t


# Where the root, scaled into [1, 2], is cut: what is left of its error grows with it.
PLACES = [1, 1.125, 1.25, 1.5]


def cbrt(form, cs, E, low):
    """The last step: t is cut to half its digits, r and its square are off by what `iterates` says."""
    e, t = E
    high = (PLACES + [2])[PLACES.index(low) + 1]
    C = exact(1 / 3 if form.bits == 53 else 11184811 / 2**25)
    yield Part(head(form) + f"""
@cut = float<{form.half},-2000,zr>;
y = M * M * M;                      # a float; nothing here needs that
t = cut(tt);                        # leading_half(): t * t is exact
r = fl(rr);
q fl= r * r;                        # square
p = t * t * t;                      # in halves of t * t: exact but for the last difference
d fl= y - p;
k fl= q * {C};                # square * third
s fl= d * k;
s2 fl= s * s;
w fl= s2 * r;
v fl= s + w;
z fl= t + v; r1 = t + v;
D = (t - M) / M; H = r * M - 1;
G = D * (3 + D * (3 + D));          # y - t^3 = -M^3 G
S = -M * G / 3;                     # (y - t^3)/(3 M^2): t + S + S^2/M is M + F
F = M * D * D * D * (5 + D * (5 + D * (2 + D / 3))) / 3;
{{ M in [{low!r}, {high!r}] /\ |D| <= {exact(t)} /\ |H| <= {exact(e)} -> |r1 - M| in ? /\ |z - M| in ? }}
z - M -> (z - r1) + (r1 - M);
t -> M * (1 + D);
r -> (1 + H) / M;
r1 - M -> (v - (s + w)) + (s - S) + (w - S * S / M) + F;
s - S -> (s - d * k) + (d + M * M * M * G) * k - M * M * M * G * (k - 1 / (3 * M * M));
d + M * M * M * G -> d - (y - p);
d -> (d + M * M * M * G) - M * M * M * G;
k - 1 / (3 * M * M) -> (k - q * {C}) + (q - r * r) * {C} + (H * (2 + H) * {C} + ({C} - 1 / 3)) / (M * M);
w - S * S / M -> (w - s2 * r) + (s2 - s * s) * r + (s - S) * (s + S) * r + S * S * H / M;
s -> (s - S) + S;
$ M in 16;
""", ["r1 - M", "z - M"], ulp(form, 0))
