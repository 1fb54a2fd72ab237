#!/usr/bin/env python3
"""Counts instructions and stack of every fixed-point operation, and the bytes of each.

Needs rustup's targets, PyPI's unicorn and pyelftools. Run from the repository's root:

    python3 tools/fixed_cost.py

Builds tests/fixed_cost for each target and runs its functions on random words in an emulator, one
instruction at a time. Instructions are those of the call, from its first to its return, its generator's included.
"""

import random
import subprocess
import sys

from elftools.elf.elffile import ELFFile
from unicorn import UC_ARCH_ARM, UC_HOOK_CODE, UC_MODE_MCLASS, UC_MODE_THUMB, Uc
from unicorn.arm_const import UC_ARM_REG_LR, UC_ARM_REG_R0, UC_ARM_REG_R1, UC_ARM_REG_SP, UC_CPU_ARM_CORTEX_M0, UC_CPU_ARM_CORTEX_M3, UC_CPU_ARM_CORTEX_M4

TARGETS = {
    "thumbv6m-none-eabi": UC_CPU_ARM_CORTEX_M0,
    "thumbv7m-none-eabi": UC_CPU_ARM_CORTEX_M3,
    "thumbv7em-none-eabihf": UC_CPU_ARM_CORTEX_M4,
}
RAM, STACK, RETURN = 0x20000000, 0x2000F000, 0x30000000
RUNS = 400


def build(target):
    subprocess.run(["cargo", "build", "--release", "--quiet", "--manifest-path", "tests/fixed_cost/Cargo.toml", "--target", target,
                    "--target-dir", "target/fixed_cost"], check=True)
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
            for symbol in elf.get_section_by_name(".symtab").iter_symbols():
                if symbol["st_info"]["type"] == "STT_FUNC":
                    self.functions[symbol.name] = (symbol["st_value"], symbol["st_size"])
        self.uc.mem_map(RAM, 0x10000)
        self.uc.mem_map(RETURN, 0x1000)
        self.count, self.least = 0, STACK
        self.uc.hook_add(UC_HOOK_CODE, self.step)

    def step(self, uc, _address, _size, _data):
        self.count += 1
        self.least = min(self.least, uc.reg_read(UC_ARM_REG_SP))

    def call(self, name, a, b):
        self.count, self.least = 0, STACK
        self.uc.reg_write(UC_ARM_REG_SP, STACK)
        self.uc.reg_write(UC_ARM_REG_LR, RETURN | 1)
        self.uc.reg_write(UC_ARM_REG_R0, a)
        self.uc.reg_write(UC_ARM_REG_R1, b)
        self.uc.emu_start(self.functions[name][0] | 1, RETURN)
        return self.count, STACK - self.least


def main():
    words = random.Random(1)
    only = sys.argv[1] if len(sys.argv) > 1 else ""
    print("target,function,min,avg,max,stack,bytes")
    for target, cpu in TARGETS.items():
        image = Image(build(target), cpu)
        for name, (_, size) in sorted(image.functions.items()):
            if name.startswith(("_", "$")) or only not in name:
                continue
            counts, stack = [], 0
            for _ in range(RUNS):
                a, b = words.getrandbits(32), RAM + 16
                if "sample" in name or "word" in name:
                    image.uc.mem_write(RAM, words.getrandbits(64).to_bytes(8, "little"))
                    a = RAM
                elif "density" in name or "unwarp" in name:
                    a, b = words.getrandbits(31), words.getrandbits(31)
                elif "cdf" in name or "pdf" in name:
                    a >>= 2
                count, used = image.call(name, a, b)
                counts.append(count)
                stack = max(stack, used)
            print(f"{target},{name},{min(counts)},{sum(counts) / RUNS:.1f},{max(counts)},{stack},{size}", flush=True)


if __name__ == "__main__":
    main()
