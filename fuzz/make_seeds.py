#!/usr/bin/env python3
"""Writes the committed seed corpus, seeds/<target>/: the edges of both formats.

Every input is a run of little-endian 64-bit words; the checks read a word as an f64, its low half
as an f32, and the whole as a fraction of 2^64. Run from anywhere; python3 and nothing else.
"""

import itertools
import math
import struct
from pathlib import Path

SEEDS = Path(__file__).parent / "seeds"


def f64(x):
    return struct.unpack("<Q", struct.pack("<d", x))[0]


def f32(x):
    return struct.unpack("<I", struct.pack("<f", x))[0]


FORMATS = {"f32": (f32, 1 << 31, 2.0**-126, 2.0**-149), "f64": (f64, 1 << 63, 2.0**-1022, 5e-324)}

ENDS = {"inf": math.inf, "nan": math.nan, "zero": 0.0, "one": 1.0}


def angles():
    for name, (bits, sign, normal, least) in FORMATS.items():
        values = {k: bits(v) for k, v in ENDS.items()}
        end = bits(math.pi / 2)
        values |= {f"end{n:+}": end + n for n in (-2, -1, 0, 1)}
        values |= {"least": bits(least), "subnormal": bits(normal / 3), "normal": bits(normal)}
        values |= {"eighth": bits(math.pi / 4), "tiny": bits(1e-300 if name == "f64" else 1e-30)}
        for key, word in values.items():
            yield f"{name}-{key}", word
            yield f"{name}-minus-{key}", word | sign


def probabilities():
    for name, (bits, sign, normal, least) in FORMATS.items():
        half, one = bits(0.5), bits(1.0)
        values = {k: bits(v) for k, v in ENDS.items()}
        values |= {f"half{n:+}": half + n for n in (-1, 0, 1)}
        values |= {f"one{n:+}": one + n for n in (-2, -1, 1)}
        values |= {"least": bits(least), "normal": bits(normal), "subnormal": bits(normal / 3)}
        values |= {f"eighth{n:+}": bits(0.125) + n for n in (-1, 0)}
        values |= {"tiny": bits(1e-300 if name == "f64" else 1e-30), "minus-zero": sign}
        for key, word in values.items():
            yield f"{name}-{key}", word


def radii():
    for name, (bits, sign, normal, least) in FORMATS.items():
        largest = bits(math.inf) - 1
        quarter = bits((2.0**126 - 2.0**102) if name == "f32" else math.ldexp(1 - 2.0**-53, 1022))
        values = {k: bits(v) for k, v in ENDS.items()}
        values |= {"normal": bits(normal), "below-normal": bits(normal) - 1, "least": bits(least)}
        values |= {"quarter": quarter, "above-quarter": quarter + 1, "largest": largest}
        values |= {"minus-one": bits(1.0) | sign, "minus-zero": sign}
        for key, word in values.items():
            yield f"{name}-{key}", word


# Generators: constant words, alternating bits and words, counters, single bits.
STUCK = {
    "empty": b"",
    "zeros": bytes(8),
    "ones": b"\xff" * 8,
    "alternating-bits": b"\xaa" * 8,
    "alternating-bits-other": b"\x55" * 8,
    "alternating-words": bytes(8) + b"\xff" * 8,
    "counting": bytes(range(64)),
    "counting-words": b"".join(struct.pack("<Q", n) for n in range(8)),
    "counting-down": b"".join(struct.pack("<Q", 2**64 - 1 - n) for n in range(8)),
    "lowest-bit": struct.pack("<Q", 1),
    "highest-bit": struct.pack("<Q", 1 << 63),
    "all-but-highest": struct.pack("<Q", (1 << 63) - 1),
    "odd-length": b"\xff\x00\x80",
    "quarter-turns": b"".join(struct.pack("<Q", n << 62) for n in range(4)),
    "eighth-turns": b"".join(struct.pack("<Q", (2 * n + 1) << 61) for n in range(4)),
}


def write(target, name, words, tail=b""):
    folder = SEEDS / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(b"".join(struct.pack("<Q", w) for w in words) + tail)


def main():
    for old in SEEDS.glob("*/*"):
        if not old.parent.is_symlink():  # the shipped scenes
            old.unlink()
    for (name, word), (_, other) in zip(angles(), itertools.cycle(probabilities())):
        write("densities", name, [word, other])
    for name, word in probabilities():
        up = (word + 1) % 2**64
        write("quantiles", name, [word, up])
        write("warps", name, [word, up])
        write("warps", f"{name}-turn", [f64(0.5) + word % 7, word])
    for name, (bits, sign, normal, least) in FORMATS.items():
        # Just below the seam of the azimuth, where a turn rounds up to 1.
        for key, z in {"least": least, "normal": normal, "axis": 0.0}.items():
            write("warps", f"{name}-seam-{key}", [bits(0.5), bits(1.0), bits(z) | sign])
    for name, data in STUCK.items():
        write("samples", name, [], data)
        write("points", f"stuck-{name}", [f64(1.0), 1 << 62, 3 << 61, f64(0.5)], data)
        write("fixed", f"stuck-{name}", [], data)
    # Corners of words: ends, middles, the quarter and eighth turns, √½, and one unit to either side.
    for word in (0, 1 << 29, 1 << 30, 0x5A82799A, 1 << 31, 3 << 30, 0xE0000000):
        for n in (-1, 0, 1):
            w = (word + n) % 2**32
            write("fixed", f"{word:08x}{n:+}", [w << 32 | w, (2**32 - 1 - w) << 32 | w, w])
    for (name, word), (_, r) in zip(radii(), itertools.cycle(probabilities())):
        write("points", name, [word, 1 << 60, 1 << 63, r], b"\xff" * 8)
    for name, (bits, sign, normal, least) in FORMATS.items():
        one, zero, small = bits(1.0), bits(0.0), bits(least)
        for axis, minus in itertools.product(range(3), (0, sign)):
            label = f"{name}-{'-' if minus else '+'}{'xyz'[axis]}"
            for kind, other in (("axis", zero), ("minus-zeros", sign), ("tilted", small)):
                normal_words = [other] * 3
                normal_words[axis] = one | minus
                write("frames", f"{label}-{kind}", normal_words, STUCK["counting"])
        extremes = {"zero": [zero] * 3, "least": [small] * 3, "nan": [one, bits(math.nan), one]}
        extremes |= {"inf": [bits(math.inf), one, one], "largest": [bits(math.inf) - 1] * 3}
        # z just above −1, where a frame without a sign would divide by zero.
        extremes["south"] = [bits(normal), small, (one - 1) | sign]
        for key, words in extremes.items():
            write("frames", f"{name}-{key}", words)
        exponents = {"zero": 0.0, "half": 0.5, "one": 1.0, "two": 2.0, "three": 3.0, "phong": 64.0}
        exponents |= {"large": 1e30, "least": least, "minus-one": -1.0, "inf": math.inf}
        words = {k: bits(v) for k, v in exponents.items()}
        words |= {"minus-zero": sign, "nan": bits(math.nan), "largest": bits(math.inf) - 1}
        for key, word in words.items():
            write("cos_power", f"{name}-{key}-end", [word, bits(math.pi / 2), bits(least), bits(0.5)])
            write("cos_power", f"{name}-{key}-axis", [word, bits(least), bits(1.0), bits(1.0) - 1])
        densities = [zero, small, one, bits(math.inf), bits(math.inf) - 1, bits(math.nan)]
        densities += [one | sign, sign]
        for (i, a), (j, b) in itertools.product(enumerate(densities), repeat=2):
            if i <= j:
                write("weights", f"{name}-{i}{j}", [a, b])


if __name__ == "__main__":
    main()
