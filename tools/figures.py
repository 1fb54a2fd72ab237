#!/usr/bin/env python3
"""Writes the README's tables of figures from docs/measured, between their markers.

python3 tools/figures.py [--check]     --check: exits with 1 where README.md is not what it would write

A figure is measured by one command and stands in docs/measured; the README repeats a few.
"""

import csv
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIX = ["Disk", "CircleShell", "CircleArc", "Ball", "SphereShell", "Lambert"]


def rows(name):
    with open(ROOT / "docs/measured" / name, newline="") as file:
        return list(csv.DictReader(file))


HOST, FIRMWARE = rows("accuracy_cost.csv"), rows("firmware_cost.csv")
SEARCHED = json.loads((ROOT / "docs/measured/worst_inputs.json").read_text())


def one(table, **wanted):
    found = [r for r in table if all(r[k] == v for k, v in wanted.items())]
    if len(found) != 1:
        sys.exit(f"{len(found)} rows of {wanted} in docs/measured; expected 1")
    return found[0]


def firmware(board, name, law="Lambert"):
    return one(FIRMWARE, board=board, law=law, operation="sample", name=name)


def count(text):
    return f"{float(text):.0f}"


def largest(name):
    """The largest error of the operations of the six laws that are judged in ulps, and how surely."""
    rows = [r for r in HOST
            if r["name"] == name and r["law"] in SIX and r["max_ulp"] and not r["vectors"]]
    worst = max(rows, key=lambda r: float(r["max_ulp"]))
    if worst["exhaustive"] == "true":
        whole = sum(r["exhaustive"] == "true" for r in rows)
        how = "exhaustive" if whole == len(rows) else f"exhaustive in {whole} of {len(rows)} cells, else observed"
        return f"{float(worst['max_ulp']):.2f} ulp, {how}"
    found = max(r["error"] for r in SEARCHED if r["type"] == name and r["law"] in SIX)
    return f"{found:.2f} ulp, searched"


def absolute(name, unit):
    worst = max(float(r["max_absolute"]) for r in FIRMWARE
                if r["name"] == name and r["law"] in SIX and r["operation"].startswith("warp")
                and r["max_absolute"])
    return f"{worst * 2.0 ** unit:.2f} · 2⁻{'³¹' if unit == 31 else '¹⁵'} in a component"


def relative(name):
    worst = max((r for r in HOST if r["name"] == name and r["law"] in SIX and r["max_relative"]),
                key=lambda r: float(r["max_relative"]))
    how = "exhaustive" if worst["exhaustive"] == "true" else "observed"
    return f"relative {float(worst['max_relative']):.1e}, {how}"


TYPES = [
    ("f32", "rendering; firmware with or without an FPU", lambda: largest("f32")),
    ("f64", "simulation", lambda: largest("f64")),
    ("Precise<f32>", "references: the nearest `f32`, whoever computes it",
     lambda: largest("Precise<f32>")),
    ("Precise<f64>", "tables, checks of other code", lambda: largest("Precise<f64>")),
    ("Fast<f32>", "half the digits: processors without an FPU, the Phong lobe",
     lambda: relative("Fast<f32>")),
    ("Fixed", "no FPU at all: integers alone", lambda: absolute("Fixed", 31)),
    ("Fixed16", "the same in 16 bits", lambda: absolute("Fixed16", 15)),
]


# as docs/measured/firmware_cost.csv and accuracy_cost.csv call them
PEERS = [
    ("textbook, libm f32", "polar form, libm f32", "polar form with `libm`"),
    ("textbook, micromath f32", "polar form, micromath f32", "polar form with `micromath`"),
    ("idsp and integer roots", "", "`idsp` and integer roots"),
]


def host(name):
    found = [r for r in HOST if (r["law"], r["operation"], r["name"]) == ("Lambert", "sample", name)]
    return count(found[0]["instructions"]) if found else ""


def types():
    lines = ["| type | take it for | largest error | x86-64 | Cortex-M0 | M4F | flash, M0 |",
             "|---|---|---|---|---|---|---|"]

    def line(title, use, error, on_host, name, flash):
        boards = [count(firmware(board, name)["instructions_mean"]) for board in ("M0", "M4F")]
        lines.append("| " + " | ".join([title, use, error, host(on_host), *boards, flash]) + " |")

    for name, use, error in TYPES:
        title = f"`{name}(Lambert)`" if "Fixed" in name else f"`{name}`"
        line(title, use, error(), name, name, firmware("M0", name)["flash_bytes"])
    for name, on_host, title in PEERS:
        row = firmware("M0", name)
        error = float(row["max_absolute"] or row["max_relative"])
        line(title, "", f"{error:.0e} in a component", on_host, name, "")
    return lines


def main():
    path = ROOT / "README.md"
    text = path.read_text()
    start, end = "<!-- figures: types -->", "<!-- end -->"
    if start not in text:
        sys.exit(f"README.md has no line {start}")
    text = re.sub(f"{start}\n.*?{end}", lambda _: "\n".join([start, *types(), end]), text,
                  flags=re.S)
    if text == path.read_text():
        return
    if "--check" in sys.argv:
        sys.exit("README.md: its figures are not those of docs/measured: python3 tools/figures.py")
    path.write_text(text)


main()
