#!/usr/bin/env python3
"""Compares Mitsuba 3's cosine-weighted hemisphere with coslobe's Lambert, and writes docs/measured/mitsuba.csv.

    python3 -m venv venv && venv/bin/pip install mitsuba numpy
    apt install libllvm19
    cargo build --release -p accuracy_cost
    DRJIT_LIBLLVM_PATH=/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1 venv/bin/python tools/mitsuba_peer.py

Mitsuba's side is mi.warp.square_to_cosine_hemisphere in the variant llvm_ad_rgb, compiled by Dr.Jit, on one thread
and one core, evaluated and synchronised; ours is Lambert.warp_direction_slice (feature simd). Both map
the same 2^20 points in f32 at the processor's widest vectors. Each round times one after the other, and the
quickest round of each makes the ratio.

Errors are worst ones against f64, of each program's own map of the square: of a component, and relative
of cos theta.
"""

import argparse
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import drjit as dr
import mitsuba as mi
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
OURS = "coslobe Lambert.warp_direction_slice f32"
THEIRS = "mitsuba warp.square_to_cosine_hemisphere llvm_ad_rgb"


def ours(program, points, folder):
    """(ns a direction, width, [x, y, z]) with the axis last, as Mitsuba has it."""
    data, out = folder / "points.bin", folder / "directions.bin"
    points.tofile(data)
    command = [program, "lambert-directions", data, "--values", out]
    ns, width = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    x, y, z = np.fromfile(out, dtype=np.float32).reshape(3, -1)
    return float(ns), width, np.array([x, z, y])


def theirs(points, passes):
    """(ns a direction, [x, y, z])."""
    sample = mi.Point2f(points[0], points[1])
    dr.eval(sample)
    dr.sync_thread()
    best = float("inf")
    for _ in range(passes):
        start = time.perf_counter()
        direction = mi.warp.square_to_cosine_hemisphere(sample)
        dr.eval(direction)
        dr.sync_thread()
        best = min(best, time.perf_counter() - start)
    return best * 1e9 / points.shape[1], np.array(direction).reshape(3, -1)


def polar(u, v):
    """Our map in f64: u is the cdf of theta, v the azimuth in turns."""
    sin, phi = np.sqrt(u), 2 * np.pi * v
    return np.array([sin * np.cos(phi), sin * np.sin(phi), np.sqrt(1 - u)])


def concentric(u, v):
    """Mitsuba's map in f64 (Shirley and Chiu)."""
    a, b = 2 * u - 1, 2 * v - 1
    steep = np.abs(a) < np.abs(b)
    r = np.where(steep, b, a)
    ratio = np.divide(np.where(steep, a, b), r, out=np.zeros_like(r), where=r != 0) * np.pi / 4
    phi = np.where(steep, np.pi / 2 - ratio, ratio)
    return np.array([r * np.cos(phi), r * np.sin(phi), np.sqrt((1 - r) * (1 + r))])


def errors(got, want):
    off = np.abs(got - want)
    seen = want[2] > 0
    return off.max(), (off[2][seen] / want[2][seen]).max()


def lanes():
    """Lanes of the vectors in the code that Dr.Jit generates here."""
    program = (
        "import drjit as dr; from drjit.llvm import Float; dr.set_flag(dr.JitFlag.PrintIR, True);"
        "dr.eval(dr.arange(Float, 64) + 1)"
    )
    done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True)
    return re.search(r"<(\d+) x float>", done.stdout + done.stderr)[1]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "target/release/accuracy_cost")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/measured/mitsuba.csv")
    parser.add_argument("--rounds", type=int, default=25)
    args = parser.parse_args()
    if "DRJIT_LIBLLVM_PATH" not in os.environ:
        sys.exit("DRJIT_LIBLLVM_PATH is not set; expected the path of LLVM's shared library")
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(0)
    n = 1 << 20
    points = np.random.default_rng(1).random((2, n), dtype=np.float32)
    exact = points.astype(np.float64)
    own, other = [], []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(args.rounds):
            ns, width, directions = ours(args.program, points, pathlib.Path(folder))
            own.append(ns)
            ns, others = theirs(points, 30)
            other.append(ns)
    rows = [
        ("version", "mitsuba", mi.__version__),
        ("version", "drjit", dr.__version__),
        ("elements", "", n),
        ("width", OURS, width),
        ("width", THEIRS, f"{lanes()} lanes"),
        ("time_ratio", OURS, f"{min(own) / min(other):.3f}"),
    ]
    for name, got, want in [(OURS, directions, polar(*exact)), (THEIRS, others, concentric(*exact))]:
        component, cos = errors(got, want)
        rows += [("worst_component", name, f"{component:.2e}"), ("worst_relative_cos", name, f"{cos:.2e}")]
    with open(args.out, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("quantity", "function", "value"))
        writer.writerows(rows)
    for row in rows:
        print(*row)


if __name__ == "__main__":
    main()
