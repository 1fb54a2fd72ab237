"""The coefficients, read from the tables the crate compiles, so that a proof cannot drift from them."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


class Format:
    def __init__(self, name, bits, gappa, half):
        self.name, self.bits, self.gappa = name, bits, gappa
        # Significand bits that `leading_half` keeps.
        self.half = half
        source = (ROOT / f"src/kernel/table_{name}.rs").read_text()
        number = lambda text: float(text)
        self.poly = {
            m[1]: [number(c) for c in m[2].replace("\n", " ").split(",") if c.strip()]
            for m in re.finditer(r"^    (\w+): &\[([^\]]*)\],", source, re.M)
        }
        if bits == 24:
            # Decimals of f32 are read as the nearest f32.
            import struct

            number = lambda text: struct.unpack("f", struct.pack("f", float(text)))[0]
            self.poly = {k: [number(repr(c)) for c in cs] for k, cs in self.poly.items()}
        pairs = r"^    (\w+): Pair \{\s*hi: ([-\d.e]+),\s*lo: ([-\d.e]+),?\s*\}"
        self.pair = {m[1]: (number(m[2]), number(m[3])) for m in re.finditer(pairs, source, re.M)}

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
