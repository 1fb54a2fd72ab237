#!/usr/bin/env python3
"""Compares SciPy's inverse of the disk's law with coslobe's, and writes docs/measured/scipy.csv.

    python3 -m venv venv && venv/bin/pip install scipy numpy mpmath
    cargo build --release -p accuracy_cost
    venv/bin/python tools/scipy_peer.py

The law is SciPy's `cosine` (x = 2θ) and, in sin θ, its `semicircular`. Timed are the distributions'
ppf, and the ufunc under cosine.ppf without the distribution's checks: the fair comparison.
Each round times SciPy and coslobe one after the other over the same array on one core, and the
quickest round of each makes the ratio. Errors are worst relative ones of θ and of cos θ = cos(x/2)
or √(1 − x²), by decade of u, against mpmath; u below ½ alone, as the law is symmetric.
"""

import argparse
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import mpmath
import numpy as np
import scipy
from scipy.special import _ufuncs
from scipy.stats import cosine, semicircular

ROOT = pathlib.Path(__file__).resolve().parent.parent
OURS = "coslobe Disk f64"


def ufunc_pair(u):
    x = _ufuncs._cosine_invcdf(u)
    return x / 2, np.cos(x / 2)


def cosine_pair(u):
    x = cosine.ppf(u)
    return x / 2, np.cos(x / 2)


def semicircular_pair(u):
    x = semicircular.ppf(u)
    return np.arcsin(x), np.sqrt(1 - x * x)


FUNCTIONS = {
    "scipy.special._ufuncs._cosine_invcdf": (_ufuncs._cosine_invcdf, ufunc_pair),
    "scipy.stats.cosine.ppf": (cosine.ppf, cosine_pair),
    "scipy.stats.semicircular.ppf": (semicircular.ppf, semicircular_pair),
}


def ours(program, u, folder, values=False):
    """Nanoseconds an element of Disk.quantile, and (θ, cos θ) if asked for."""
    data, out = folder / "u.bin", folder / "values.bin"
    u.tofile(data)
    command = [program, "disk-quantile", data] + (["--values", out] if values else [])
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    pairs = np.fromfile(out).reshape(-1, 2).T if values else None
    return float(done.stdout), pairs


def reference(u):
    """(θ, cos θ) at u ≤ ½: y − sin y = 2πu for y = π + 2θ, by Newton's method from above."""
    with mpmath.workdps(40 + 2 * int(-mpmath.log10(u) / 3 + 1)):
        target = 2 * mpmath.pi * mpmath.mpf(u)
        y = mpmath.pi if u > 0.1 else mpmath.cbrt(6 * target) * mpmath.mpf("1.1")
        for _ in range(200):
            # Kepler's residual cancels; the working precision pays for that.
            step = (y - mpmath.sin(y) - target) / (1 - mpmath.cos(y))
            y -= step
            if abs(step) < y * mpmath.mpf(10) ** -35:
                break
        else:
            sys.exit(f"no convergence of the reference at u = {u!r}")
        return y / 2 - mpmath.pi / 2, mpmath.sin(y / 2)


def worst(got, want):
    errors = [abs((mpmath.mpf(float(g)) - w) / w) for g, w in zip(got, want)]
    return max((mpmath.inf if mpmath.isnan(e) else e for e in errors), default=mpmath.mpf(0))


def decades(deepest, n, rng):
    """n numbers u in each decade [10^d, 10^(d+1)), but below ½."""
    for d in range(-1, deepest - 1, -1):
        top = np.log10(0.5) if d == -1 else d + 1
        yield d, np.clip(10 ** rng.uniform(d, top, n), 10.0**d, np.nextafter(0.5, 0))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "target/release/accuracy_cost")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/measured/scipy.csv")
    parser.add_argument("--elements", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--per-decade", type=int, default=200)
    parser.add_argument("--deepest", type=int, default=-40, help="exponent of the last decade of u")
    args = parser.parse_args()
    if not args.program.exists():
        sys.exit(f"{args.program}: not there; build it by `cargo build --release -p accuracy_cost`")
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

    rng = np.random.default_rng(1)
    u = rng.random(args.elements)
    rows = [("version", "scipy", "", scipy.__version__), ("elements", "", "", args.elements)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for function, (call, _) in FUNCTIONS.items():
            # A method of root finding on each element takes its time: fewer elements for it.
            start = time.perf_counter()
            call(u[:1000])
            slow = time.perf_counter() - start > 0.02
            part = u[: args.elements // 50] if slow else u
            theirs, mine = [], []
            for _ in range(args.rounds):
                start = time.perf_counter()
                call(part)
                theirs.append((time.perf_counter() - start) * 1e9 / part.size)
                mine.append(ours(args.program, part, folder)[0])
            ratio = min(theirs) / min(mine)
            print(f"{function}: {min(theirs):.1f} ns, coslobe {min(mine):.1f} ns: {ratio:.2f}", file=sys.stderr)
            rows.append(("time_ratio", function, "", f"{ratio:.3f}"))
        for decade, u in decades(args.deepest, args.per_decade, rng):
            truth = list(zip(*(reference(float(x)) for x in u)))
            found = {OURS: ours(args.program, u, folder, values=True)[1]}
            found |= {function: pair(u) for function, (_, pair) in FUNCTIONS.items()}
            for function, pair in found.items():
                for quantity, got, want in zip(("relative_theta", "relative_cos"), pair, truth):
                    rows.append((quantity, function, decade, mpmath.nstr(worst(got, want), 4)))

    partial = args.out.with_suffix(".partial")
    with open(partial, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("quantity", "function", "decade", "value"))
        writer.writerows(rows)
    os.replace(partial, args.out)


if __name__ == "__main__":
    main()
