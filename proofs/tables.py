"""The coefficients, read from the tables the crate compiles, so that a proof cannot drift from them."""

import re
import struct
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


class Format:
    def __init__(self, name, bits, gappa, half):
        self.name, self.bits, self.gappa = name, bits, gappa
        # Significand bits that `leading_half` keeps.
        self.half = half
        source = (ROOT / f"src/arithmetic/native/coefficients_{name}.rs").read_text()
        number = lambda text: self.rounded(float(text))
        self.poly = {
            m[1]: [number(c) for c in m[2].replace("\n", " ").split(",") if c.strip()]
            for m in re.finditer(r"^    (\w+): &\[([^\]P]*)\],", source, re.M)
        }
        pairs = r"^    (\w+): Pair \{\s*hi: ([-\d.e]+),\s*lo: ([-\d.e]+),?\s*\}"
        self.pair = {m[1]: (number(m[2]), number(m[3])) for m in re.finditer(pairs, source, re.M)}

    def rounded(self, x):
        """The nearest number of the format."""
        return x if self.bits == 53 else struct.unpack("f", struct.pack("f", x))[0]

    @property
    def u(self):
        """Half an ulp of 1."""
        return 2.0**-self.bits


def formats():
    return [
        Format("f64", 53, "float<ieee_64,ne>", 26),
        Format("f32", 24, "float<ieee_32,ne>", 12),
    ]


def exact(x):
    """A float as an exact number that both Sollya and Gappa read."""
    mantissa, exponent = float(x).hex().replace("0x", "").split("p")
    sign = "-" if mantissa.startswith("-") else ""
    whole, _, fraction = mantissa.lstrip("-").partition(".")
    return f"{sign}{int(whole + fraction, 16)}b{int(exponent) - 4 * len(fraction)}"


def claim(law, *operations):
    """The least of docs/bounds.md's cells of f64."""
    lines = (ROOT / "docs/bounds.md").read_text().split("## f64\n")[1].splitlines()
    rows = [[c.strip() for c in line.strip("|").split("|")] for line in lines[1:] if line.startswith("|")]
    column = rows[0].index(law)
    found = {}
    for row in rows[2:]:
        found.setdefault(row[0], row[column])
    return min(float(found[operation]) for operation in operations)
