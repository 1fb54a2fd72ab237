"""What the laws make of square roots and powers."""

import math

from part import Part, head, ulp
from tables import exact


def ball_sin(form, cs, E):
    """ball.rs warp: sqrt(u / (1 + sqrt(1 - u))); sqrt_scaled scales by powers of 4."""
    K = f"({exact(1 + cs[0])})" if cs else "1"
    # sin = 2^-j at u = 2 s - s^2, s = 4^-j; 1 - u is exact from u = 1/2 on.
    cuts = [2 * 0.25**j - 0.0625**j for j in range(5)]
    pieces = [(0.5, 1.0, -1), (cuts[1] - 1e-9, 0.5, -1)]
    pieces += [(cuts[j + 1] - 1e-9, cuts[j] - 1e-9 + 1e-12, -1 - j) for j in range(1, 4)]
    for low, high, k in pieces:
        farther = "up = 1 - x;" if low == 0.5 else "up fl= 1 - x;"
        yield Part(head(form) + f"""
x = fl(xx);
{farther}                           # Tails: the farther tail
c2 fl= sqrt(up);
den fl= {K} + c2;
q fl= x / den;
r = sqrt(q);
y fl= sqrt(q);
M = sqrt(x / (1 + sqrt(1 - x)));
{{ x in [{low!r}, {high!r}] -> |r - M| in ? /\\ |y - M| in ? }}
$ x in 48;
""", ["r - M", "y - M"], ulp(form, k))


def shell_density(form, cs, E):
    """sphere_shell.rs density: cos cos 3/(2 pi), cos scaled into [1, 2)."""
    hi, lo = form.pair["three_over_two_pi"]
    top = hi * (1 + cs[0]) if cs else hi
    edges = [1.0, math.sqrt(0.5 / hi), math.sqrt(1 / hi), 2.0]
    for i, (low, high) in enumerate(zip(edges, edges[1:])):
        low = low * (1 - 1e-9) if i else low
        yield Part(head(form) + f"""
c = fl(cc);
c2 fl= c * c;
r = c2 * {exact(top)};
y fl= c2 * {exact(top)};
M = c * c * ({exact(hi)} + {exact(lo)} + D);
{{ c in [{low!r}, {high!r}] /\\ |D| <= {exact(form.u**2)} -> |r - M| in ? /\\ |y - M| in ? }}
r - M -> (c2 - c * c) * {exact(hi)} - c * c * ({exact(lo)} + D){" + c2 * (%s - %s)" % (exact(top), exact(hi)) if cs else ""};
y - M -> (y - r) + (r - M);
$ c in 16;
""", ["r - M", "y - M"], ulp(form, i - 2))
