#!/usr/bin/env python3
"""Inputs of a numeric fuzz target, one a line in hex, from and to the folder of files that libFuzzer reads.

    fuzz/seeds.py unpack TARGET [FOLDER]       # seeds/TARGET.hex to FOLDER, by default corpus/TARGET
    fuzz/seeds.py pack TARGET [FOLDER]         # FOLDER, once minimised, to seeds/TARGET.hex; lines that start it stay

To minimise: `corpus/TARGET.run -set_cover_merge=1 -use_counters=0 -max_len=64 SMALL corpus/TARGET`.
"""

import hashlib
import sys
from pathlib import Path

HERE = Path(__file__).parent


def main():
    what, target, *folder = sys.argv[1:]
    folder = Path(folder[0]) if folder else HERE / "corpus" / target
    seeds = HERE / "seeds" / f"{target}.hex"
    lines = seeds.read_text().splitlines() if seeds.exists() else []
    if what == "unpack":
        folder.mkdir(parents=True, exist_ok=True)
        for line in lines:
            data = bytes.fromhex(line.partition("#")[0])
            (folder / hashlib.sha1(data).hexdigest()).write_bytes(data)
    else:
        kept = [line for line in lines if "#" in line]
        found = sorted((path.read_bytes() for path in folder.iterdir()), key=lambda data: (len(data), data))
        seeds.write_text("".join(f"{line}\n" for line in kept + [data.hex() for data in found]))


if __name__ == "__main__":
    main()
