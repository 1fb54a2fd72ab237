#!/usr/bin/env python3
"""Writes tests/reference/angles.csv and tails.csv: true values with proven bounds.

Needs python-flint (PyPI), that is Arb: every value is a ball, and a value is written only if its
ball is narrower than 1e-33 relative. Run from the repository's root: python3 tools/reference.py

A row: law, operation, argument, value as an unevaluated sum hi + lo; numbers are the bits of an
f64 in hex. Arguments of tails.csv are nearer tails p <= 1/2; of angles.csv angles in [0, pi/2].
"""

import struct
from fractions import Fraction

from flint import arb, ctx, fmpq

ctx.prec = 3000
PI = arb.pi()


def bits(x):
    return f"{struct.unpack('<Q', struct.pack('<d', x))[0]:016x}"


def f64(b):
    return struct.unpack("<d", struct.pack("<Q", b))[0]


def f32(b):
    return struct.unpack("<f", struct.pack("<I", b))[0]


def exact(x):
    q = Fraction(x)
    return arb(fmpq(q.numerator, q.denominator))


def fraction(a):
    m, e = a.mid().man_exp()
    m, e = int(m), int(e)
    return Fraction(m) * (Fraction(2) ** e)


def to_float(q):
    """Nearest float; 0 below the subnormals."""
    return q.numerator / q.denominator if q else 0.0


def split(a):
    value = fraction(a)
    if value:
        width = fraction(arb(a.rad()))
        assert width < abs(value) * Fraction(1, 10**33), "ball too wide"
    hi = to_float(value)
    lo = to_float(value - Fraction(hi))
    return hi, lo


EXPONENTS = {"Disk": 2, "CircleShell": 1, "CircleArc": 0, "Ball": 3, "SphereShell": 2, "Lambert": 1}
PLANAR = {"Disk", "CircleShell", "CircleArc"}
POWERS = [0.5, 20.0, 1e6]


def laws():
    for name, k in EXPONENTS.items():
        yield name, arb(k)
    for k in POWERS:
        yield f"CosPower({k:g})", exact(k)


def density(name, k, c):
    if name == "Disk":
        return 2 * c**2 / PI
    if name == "CircleShell":
        return c / 2
    if name == "CircleArc":
        return 1 / PI
    return (k + 1) * c**k / (2 * PI)


def nearer(name, eta):
    """Tail of a planar law beyond the angle eta from its end."""
    if name == "Disk":
        return (2 * eta - (2 * eta).sin()) / (2 * PI)
    if name == "CircleShell":
        return (eta / 2).sin() ** 2
    return eta / PI


def angle_rows(theta):
    t = exact(theta)
    c, s = (PI / 2 - t).sin(), t.sin()
    for name, k in laws():
        d = density(name, k, c)
        if name in PLANAR:
            yield name, "pdf", d
            yield name, "ln_pdf", d.log()
            tail = nearer(name, PI / 2 - t)
            yield name, "sf", tail
            yield name, "cdf", 1 - tail
        else:
            yield name, "pdf", d * s
            if theta > 0:
                yield name, "ln_pdf", d.log() + s.log()
            yield name, "pdf_solid_angle", d
            power = c ** (k + 1)
            yield name, "sf", power
            yield name, "cdf", 1 - power


def kepler(p):
    """eta with nearer('Disk', eta) = p, as a ball whose ends bracket p."""
    target = exact(p)
    eta = (12 * PI * target).root(3) / 2
    if p > 0.2:
        eta = PI / 2 - (PI * (arb(1) / 2 - target)) / 2
    for _ in range(60):
        step = (nearer("Disk", eta) - target) / (2 * eta.sin() ** 2 / PI)
        eta = (eta - step).mid()
        if abs(step) < abs(eta) * arb("1e-60"):
            break
    slack = eta * arb("1e-45")
    if p < 0.5:
        assert nearer("Disk", eta - slack) < target < nearer("Disk", eta + slack), p
    return eta


def tail_rows(p):
    q = exact(p)
    for name, k in laws():
        if name == "Disk":
            if p == 0.5:
                continue
            eta = kepler(p)
            c, s = eta.sin(), eta.cos()
            # From the axis, so that sin theta has its own digits.
            yield name, "warp_sf: cos", c
            yield name, "warp_sf: sin", s
            yield name, "isf", PI / 2 - eta
        elif name == "CircleShell":
            c, s = (4 * q * (1 - q)).sqrt(), 1 - 2 * q
            yield name, "warp_sf: cos", c
            yield name, "warp_sf: sin", s
            yield name, "isf", s.asin()
        elif name == "CircleArc":
            yield name, "warp_sf: cos", (PI * q).sin()
            yield name, "warp_sf: sin", (PI * (arb(1) / 2 - q)).sin()
            yield name, "isf", PI * (arb(1) / 2 - q)
        else:
            for prefix, sf in (("warp_sf", q), ("warp", 1 - q)):
                c = sf ** (1 / (k + 1))
                s = (1 - c * c).sqrt()
                yield name, f"{prefix}: cos", c
                yield name, f"{prefix}: sin", s
                theta = s.asin() if c > s else PI / 2 - c.asin()
                yield name, "isf" if prefix == "warp_sf" else "quantile", theta


def angles():
    top64, top32 = 0x3FF921FB54442D18, 0x3FC90FDA
    values = [0.0, 5e-324, 2.2250738585072014e-308, 1e-300, 1e-160, 1e-100, 1e-30, 1e-9, 2.0**-27]
    values += [f64(top64 - n) for n in (0, 1, 2, 3, 4, 5, 100, 12345)]
    values += [f32(top32 - n) for n in (0, 1, 2, 3, 100, 12345)]
    values += [1.5707963267948966 - 2.0**-k for k in (50, 45, 40, 30, 20, 10)]
    values += [f32(b) for b in (1, 0x00800000, 0x3F490FDA, 0x3F490FDB, 0x3F490FDC)]
    values += [f64(b) for b in (0x3FE921FB54442D17, 0x3FE921FB54442D18, 0x3FE921FB54442D19)]
    values += [f32(0x3C000000 + i * 0x00110F37 % 0x03C90FDA) for i in range(24)]
    values += [(i + 0.37) * 1.5707963267948966 / 24 for i in range(24)]
    return sorted(set(values))


def tails():
    values = [5e-324, 2.2250738585072014e-308, 1e-300, 1e-200, 1e-100, 1e-45, 1e-30, 1e-20, 1e-16]
    values += [f32(b) for b in (1, 3, 0x00800000, 0x2F800000, 0x33800000)]
    values += [2.0**-k for k in (24, 25, 32, 53, 54, 64, 65, 128, 129)]
    values += [0.125, f64(0x3FBFFFFFFFFFFFFF), f64(0x3FC0000000000001), f32(0x3DFFFFFF), f32(0x3E000001)]
    values += [0.25, 0.5, f64(0x3FDFFFFFFFFFFFFF), f64(0x3FDFFFFFFFFFFFFE), f32(0x3EFFFFFF), f32(0x3EFFFFFE)]
    values += [0.5 - 2.0**-k for k in (50, 40, 30, 20, 10)]
    values += [10.0**-k * 3.7 for k in range(1, 300, 23)]
    values += [f32(0x38000000 + i * 0x0055F1B7 % 0x07000000) for i in range(24)]
    values += [(i + 0.37) / 48 for i in range(24)]
    return sorted(set(values))


def write(path, arguments, rows):
    with open(path, "w") as f:
        f.write("# Written by tools/reference.py (Arb): law,operation,argument,hi,lo; bits of f64 in hex.\n")
        for x in arguments:
            for law, operation, value in rows(x):
                hi, lo = split(value)
                f.write(f"{law},{operation},{bits(x)},{bits(hi)},{bits(lo)}\n")


def moment_rows():
    """Closed forms in Arb where they exist; the angle's second moment for real k by quadrature."""
    from mpmath import mp, mpf, quad, cos, pi, gamma, log, sqrt

    mp.dps = 50
    half = mpf(1) / 2
    fixed = {
        "Disk": (8 / (3 * pi), mpf(3) / 4, 0, pi**2 / 12 - half, log(2 * pi) - 1),
        "CircleShell": (pi / 4, mpf(2) / 3, 0, pi**2 / 4 - 2, mpf(1)),
        "CircleArc": (2 / pi, half, 0, pi**2 / 12, log(pi)),
    }
    powers = {"Ball": 3, "SphereShell": 2, "Lambert": 1}
    powers |= {f"CosPower({k:g})": k for k in (0.0, 0.5, 1.0, 7.3, 20.0, 35.5, 1e4, 1e6)}
    # Found by attack: mean_theta 11.7 ulp in f64, var_theta 29 ulp in f32; then numbers of f32 from 0.001 to 60.
    found = [float.fromhex("0x1.3366140e2c0c5p-10"), f32(0x3F6D4FDF)]
    found += [f32(0x3A83126F + i * 0x00220F37) for i in range(60)]
    powers |= {f"CosPower({k!r})": k for k in found}
    for name, k in powers.items():
        n = mpf(k) + 1
        mean = sqrt(pi) / 2 * gamma((n + 1) / 2) / gamma(n / 2 + 1)
        # cos^n has width 1/sqrt(n): cut the range there for the quadrature.
        cuts = [0] + [c / sqrt(n) for c in (1, 3, 6, 10, 20) if c / sqrt(n) < pi / 2] + [pi / 2]
        second = 2 * quad(lambda t: t * abs(cos(t)) ** n, cuts)
        fixed[name] = (n / (n + 1), n / (n + 2), mean, second, log(2 * pi / n) + (n - 1) / n)
    for name, (cos1, cos2, theta1, theta2, entropy) in fixed.items():
        yield name, "mean_cos", cos1
        yield name, "var_cos", cos2 - cos1**2
        yield name, "mean_theta", theta1
        yield name, "var_theta", theta2 - mpf(theta1) ** 2
        yield name, "entropy", entropy


if __name__ == "__main__":
    write("tests/reference/angles.csv", angles(), angle_rows)
    write("tests/reference/tails.csv", tails(), tail_rows)
    with open("tests/reference/moments.csv", "w") as f:
        f.write("# Written by tools/reference.py (mpmath, 50 digits): law,moment,value as the bits of an f64.\n")
        for law, moment, value in moment_rows():
            f.write(f"{law},{moment},{bits(float(value))}\n")
