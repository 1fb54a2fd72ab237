#!/usr/bin/env python3
"""Counts instructions and stack of every fixed-point operation, and the bytes of each.

Needs rustup's targets, binutils, PyPI's unicorn and pyelftools. Run from the repository's root:

    python3 tools/fixed_cost.py

Builds tests/fixed_cost for each target and runs its functions on random words in an emulator, one
instruction at a time. Instructions are those of the call, from its first to its return, its generator's included.
"""

import math
import os
import random
import re
import subprocess
import sys

from elftools.elf.elffile import ELFFile
from unicorn import UC_ARCH_ARM, UC_HOOK_CODE, UC_MODE_MCLASS, UC_MODE_THUMB, Uc
from unicorn.arm_const import UC_ARM_REG_LR, UC_ARM_REG_R0, UC_ARM_REG_R1, UC_ARM_REG_R2, UC_ARM_REG_SP, UC_CPU_ARM_CORTEX_M0, UC_CPU_ARM_CORTEX_M3, UC_CPU_ARM_CORTEX_M4

TARGETS = {
    "thumbv6m-none-eabi": UC_CPU_ARM_CORTEX_M0,
    "thumbv7m-none-eabi": UC_CPU_ARM_CORTEX_M3,
    "thumbv7em-none-eabihf": UC_CPU_ARM_CORTEX_M4,
}
RAM, STACK, RETURN = 0x20000000, 0x2000F000, 0x30000000
RUNS = 400


# The law's state, the generator's, a pair and what an operation writes.
LAW, RNG, PAIR, OUT = RAM, RAM + 64, RAM + 128, RAM + 192
# Of k for CosPower.
EXPONENT = 64 << 16


def build(target):
    # The new mangling names the type parameters.
    flags = os.environ | {"RUSTFLAGS": "-C symbol-mangling-version=v0"}
    subprocess.run(["cargo", "build", "--release", "--quiet", "--manifest-path", "tests/fixed_cost/Cargo.toml", "--target", target,
                    "--target-dir", "target/fixed_cost"], check=True, env=flags)
    return f"target/fixed_cost/{target}/release/fixed_cost"


class Image:
    def __init__(self, path, cpu):
        self.uc = Uc(UC_ARCH_ARM, UC_MODE_THUMB | UC_MODE_MCLASS)
        self.uc.ctl_set_cpu_model(cpu)
        self.functions = {}
        with open(path, "rb") as file:
            elf = ELFFile(file)
            self.uc.mem_map(0, 0x100000)
            for segment in elf.iter_segments():
                if segment["p_type"] == "PT_LOAD" and segment["p_filesz"]:
                    self.uc.mem_write(segment["p_vaddr"], segment.data())
        names = subprocess.run(["nm", "-C", "-S", path], capture_output=True, text=True, check=True).stdout
        for line in names.splitlines():
            if found := re.fullmatch(r"(\w+) (\w+) \w (fixed_cost::.*)", line):
                name = re.sub(r"(\w+::)+(?=\w)", "", found[3]).replace("::<", "<")
                self.functions[name] = (int(found[1], 16), int(found[2], 16))
        self.uc.mem_map(RAM, 0x10000)
        self.uc.mem_map(RETURN, 0x1000)
        self.count, self.least = 0, STACK
        self.uc.hook_add(UC_HOOK_CODE, self.step)

    def step(self, uc, _address, _size, _data):
        self.count += 1
        self.least = min(self.least, uc.reg_read(UC_ARM_REG_SP))

    def call(self, name, *arguments):
        self.count, self.least = 0, STACK
        self.uc.reg_write(UC_ARM_REG_SP, STACK)
        self.uc.reg_write(UC_ARM_REG_LR, RETURN | 1)
        for register, value in zip((UC_ARM_REG_R0, UC_ARM_REG_R1, UC_ARM_REG_R2), arguments):
            self.uc.reg_write(register, value)
        self.uc.emu_start(self.functions[name][0] | 1, RETURN)
        return self.count, STACK - self.least


def unit_pair(words, bits):
    angle = words.random() * math.pi / 2
    one = (1 << (bits - 1)) - 1
    return b"".join(int(x * one).to_bytes(bits // 8, "little") for x in (math.cos(angle), math.sin(angle)))


def measure(image, name, words):
    counts, stack = [], 0
    bits = 16 if "16" in name else 32
    for _ in range(RUNS):
        second = words.getrandbits(bits)
        image.uc.mem_write(RNG, (words.getrandbits(64) | 1).to_bytes(8, "little"))
        image.uc.mem_write(PAIR, unit_pair(words, bits))
        operation = name.split("<")[0]
        if operation in ("sample", "word"):
            second = RNG
        elif operation in ("density", "unwarp", "unwarp_sf"):
            second = PAIR
        elif operation in ("cdf", "sf", "pdf"):
            second >>= 2
        first = RNG if operation == "word" else LAW
        count, used = image.call(name, first, EXPONENT if operation == "new_cos_power" else second, OUT)
        counts.append(count)
        stack = max(stack, used)
    return counts, stack


def main():
    words = random.Random(1)
    only = sys.argv[1] if len(sys.argv) > 1 else ""
    print("target,function,min,avg,max,stack,bytes")
    for target, cpu in TARGETS.items():
        image = Image(build(target), cpu)
        image.call("new_cos_power", LAW, EXPONENT)
        for name, (_, size) in sorted(image.functions.items()):
            if not name.startswith("keep") and only in name:
                counts, stack = measure(image, name, words)
                average = sum(counts) / RUNS
                print(f'{target},"{name}",{min(counts)},{average:.1f},{max(counts)},{stack},{size}', flush=True)


if __name__ == "__main__":
    main()
