#!/usr/bin/env python3
"""Writes the C interface: the header, its Rust functions and the list that the C test calls.

python3 tools/c_api.py [--check]      --check: exits with 1 if a file differs from what it would write

One table of laws, operations and number types makes all of them, so that they cannot disagree.
Needs rustfmt.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
HERE = ROOT / "examples/c_api"
MADE = "made by tools/c_api.py, not by hand"

# name in C, name in Rust, components of a direction, what it is
LAWS = [
    ("disk", "Disk", 2, "uniform by area in a disk: 2 cos^2(theta) / pi per radian"),
    ("circle_shell", "CircleShell", 2, "radial shell on a circle: cos(theta) / 2 per radian"),
    ("circle_arc", "CircleArc", 2, "uniform by arc length on a circle: 1 / pi per radian"),
    ("ball", "Ball", 3, "uniform by volume in a ball: 2 cos^3(theta) / pi per steradian"),
    ("sphere_shell", "SphereShell", 3,
     "radial shell on a sphere: 3 cos^2(theta) / (2 pi) per steradian"),
    ("lambert", "Lambert", 3,
     "uniform by area on a sphere: cos(theta) / pi per steradian, Lambert's law"),
    ("cos_power", "CosPower", 3,
     "the Phong lobe: (k + 1) cos^k(theta) / (2 pi) per steradian, k >= 0"),
]


class Number:
    """A number type: its C types by role, and how Rust's value is made of C's and back."""

    def __init__(self, name, title, types, rust, new, get, handle_words):
        self.name, self.title, self.types, self.rust = name, title, types, rust
        self.new, self.get, self.handle_words = new, get, handle_words

    is_integer = property(lambda self: self.name in ("q31", "q15"))
    base = property(lambda self: "f32" if self.name == "fast" else self.name)
    pair = property(lambda self: f"coslobe_cos_sin_{self.base}")
    laws = property(lambda self: [x for x in LAWS if self.handle_words or x[0] != "cos_power"])

    def role(self, role, law):
        """cos_power's density is wider than the others'."""
        if role == "density" and self.name == "q31" and law == "cos_power":
            return "coslobe_density_q16_16"
        return self.types[role]


def floats(name, title, new, get):
    roles = ("component", "probability", "angle", "density", "weight", "radius", "exponent")
    return Number(name, title, dict.fromkeys(roles, "float"), dict.fromkeys(roles, "f32"),
                  dict.fromkeys(roles, new), get, 24)


NUMBERS = [
    floats("f32", "float: at most 4 units in the last place off", "{}", "{}"),
    floats("fast", "float to half its digits (relative error 2^-12): cheaper without an FPU",
           "Fast({})", "{}.0"),
    Number("q31", "32-bit integers: no floating-point instruction or routine is linked",
           {"component": "coslobe_q31", "probability": "coslobe_probability_q32",
            "angle": "coslobe_turn_q32", "density": "coslobe_density_q32",
            "exponent": "coslobe_exponent_q16_16"},
           {"component": "i32", "probability": "u32", "angle": "i32", "density": "u32",
            "exponent": "u32"},
           {"component": "I1F31::from_bits({})", "probability": "U0F32::from_bits({})",
            "angle": "I0F32::from_bits({})", "exponent": "U16F16::from_bits({})"},
           "{}.to_bits()", 10),
    Number("q15", "16-bit integers: a third of the instructions on a Cortex-M0",
           {"component": "coslobe_q15", "probability": "coslobe_probability_q16",
            "angle": "coslobe_turn_q16", "density": "coslobe_density_q16"},
           {"component": "i16", "probability": "u16", "angle": "i16", "density": "u16"},
           {"component": "I1F15::from_bits({})", "probability": "U0F16::from_bits({})",
            "angle": "I0F16::from_bits({})"},
           "{}.to_bits()", 0),
]

# operation: roles of argument and result; "pair" is a coslobe_cos_sin_*
VALUES = [
    ("pdf", "angle", "density"), ("ln_pdf", "angle", "density"),
    ("pdf_solid_angle", "angle", "density"),
    ("cdf", "angle", "probability"), ("sf", "angle", "probability"),
    ("quantile", "probability", "angle"), ("isf", "probability", "angle"),
    ("warp", "probability", "pair"), ("warp_sf", "probability", "pair"),
    ("unwarp", "pair", "probability"), ("unwarp_sf", "pair", "probability"),
    ("density", "pair", "density"), ("lambert_weight", "pair", "weight"),
]
ARGUMENTS = {"angle": "theta", "pair": "at", "probability": "p"}


def offered(op, number, law, size):
    if op in ("pdf_solid_angle", "sample_around", "warp_direction"):
        return size == 3
    if op in ("ln_pdf", "lambert_weight"):
        return not number.is_integer
    if op == "point":
        return law != "cos_power" and not number.is_integer
    return True


class Function:
    """One function: its C prototype, its Rust text, and how the test calls it."""

    def __init__(self, number, law, size, op, arguments, result, rust, kind):
        self.name = f"coslobe_{law}_{op}_{number.name}"
        self.handle = f"coslobe_cos_power_{number.name}" if law == "cos_power" else None
        self.arguments, self.result, self.rust, self.kind = arguments, result, rust, kind
        self.number, self.size = number, size

    def c_arguments(self):
        own = [f"const {self.handle} *law"] if self.handle else []
        return own + [c for c, _ in self.arguments]

    def prototype(self):
        arguments = self.c_arguments()
        pointers = [i for i, c in enumerate(arguments, 1)
                    if ("*" in c or "[" in c) and not c.endswith(("*filled", "*fault"))]
        attributes = "COSLOBE_CHECKED " if self.result[0] == "int" else ""
        attributes += (f"COSLOBE_NONNULL(({', '.join(map(str, pointers))})) " if pointers
                       else "COSLOBE_CONST ")
        return f"{attributes}{self.result[0]} {self.name}({', '.join(arguments)});"

    def rust_text(self):
        own = [f"law: *const Lobe"] if self.handle else []
        arguments = ", ".join(own + [r for _, r in self.arguments])
        unsafe = "unsafe " if "*" in arguments else ""
        result = f" -> {self.result[1]}"
        body = f"unsafe {{ {self.rust} }}" if unsafe else self.rust
        return (f"#[unsafe(no_mangle)]\npub {unsafe}extern \"C\" fn {self.name}({arguments})"
                f"{result} {{ {body} }}\n")


def rust_law(number, law, rust):
    if law == "cos_power":
        return "law"
    return {"q31": f"Fixed({rust})", "q15": f"Fixed16({rust})"}.get(number.name, rust)


def value(number, law, rust, size, op, takes, gives):
    def c_type(role):
        return number.pair if role == "pair" else number.role(role, law)

    def r_type(role):
        return f"Pair<{number.rust['component']}>" if role == "pair" else number.rust[role]

    name = ARGUMENTS[takes]
    argument = f"pair({name})" if takes == "pair" else number.new[takes].format(name)
    subject = rust_law(number, law, rust)
    trait = "Spatial" if op == "pdf_solid_angle" else "Law"
    call = (f"{subject}.{op}({argument})" if number.is_integer
            else f"{trait}::{op}(&{subject}, {argument})")
    call = f"plain({call})" if gives == "pair" else number.get.format(call)
    if law == "cos_power":
        missing = {"pair": "NO_PAIR"}.get(gives, "NONE")
        call = f"with(law, {missing}, |law| {call})"
    kind = f"{gives}_of_{takes}_{number.base}"
    return Function(number, law, size, op, [(f"{c_type(takes)} {name}", f"{name}: {r_type(takes)}")],
                    (c_type(gives), r_type(gives)), call, kind)


def drawing(number, law, rust, size, op):
    component, r = number.types["component"], number.rust["component"]
    rng = ("const coslobe_rng *rng", "rng: *const Generator")
    direction = (f"{component} direction[{size}]", f"direction: *mut [{r}; {size}]")
    trait = "Planar" if size == 2 else "Spatial"
    subject = rust_law(number, law, rust)

    def traits(method, more=""):
        if number.is_integer:
            return f"{subject}.{method}({more}words)"
        return f"{trait}::{method}(&{subject}, {more}words)"

    def as_bits(call):
        if number.name == "f32":
            return call
        typed = "x: Fast<f32>" if number.name == "fast" else "x"
        return f"{call}.map(|{typed}| {number.get.format('x')})"

    if op == "sample":
        arguments = [rng, direction]
        body = f"draw(rng, direction, |words| {as_bits(traits('sample'))})"
    elif op == "sample_around":
        arguments = [(f"const {component} normal[3]", f"normal: *const [{r}; 3]"), rng, direction]
        normal = "normal" if number.name == "f32" else (
            f"normal.map({number.new['component'].removesuffix('({})')})")
        around = as_bits(traits("sample_around", f"{normal}, "))
        body = f"around(normal, rng, direction, |normal, words| {around})"
    elif op == "fill":
        arguments = [rng, (f"{component} *directions", f"directions: *mut [{r}; {size}]"),
                     ("size_t n", "n: usize"), ("size_t *filled", "filled: *mut usize")]
        body = f"fill(rng, directions, n, filled, |words| {as_bits(traits('sample'))})"
    elif op == "warp_direction":
        arguments = [(f"{number.types['probability']} {x}", f"{x}: {number.rust['probability']}")
                     for x in ("p", "turn")] + [direction]
        u = ", ".join(number.new["probability"].format(x) for x in ("p", "turn"))
        call = (f"{subject}.warp_direction([{u}])" if number.is_integer
                else f"Spatial::warp_direction(&{subject}, [{u}])")
        body = f"put(direction, {as_bits(call)})"
    elif op == "point":
        arguments = [("float radius", "radius: f32"), rng,
                     (f"{component} point[{size}]", f"point: *mut [{r}; {size}]")]
        radius = number.new["radius"].format("radius")
        kind = "PlanarPoint" if size == 2 else "SpatialPoint"
        call = as_bits(f"{kind}::sample_point(&{rust}, radius, words)")
        body = (f"match Radius::new({radius}) {{ Ok(radius) => "
                f"draw(rng, point, |words| {call}), Err(_) => RADIUS }}")
    else:  # self_test
        arguments = [rng, ("coslobe_fault *fault", "fault: *mut CFault")]
        real = "f32" if number.name == "f32" else "Fast<f32>"
        test = "fixed" if number.is_integer else f"{trait.lower()}::<{real}, _>"
        body = f"judge(rng, fault, self_test::{test}({subject}))"
    if law == "cos_power":
        body = f"with(law, NULL_POINTER, |law| {{ {body} }})"
    kind = f"{op}{size}_{number.base}" if op != "self_test" else "self_test"
    return Function(number, law, size, op, arguments, ("int", "c_int"), body, kind)


DRAWS = ["sample", "sample_around", "fill", "warp_direction", "point", "self_test"]


def functions(number, law, rust, size):
    draws = [drawing(number, law, rust, size, op) for op in DRAWS
             if offered(op, number, law, size)]
    values = [value(number, law, rust, size, *row) for row in VALUES
              if offered(row[0], number, law, size)]
    return draws + values


def all_functions(number):
    return [f for law, rust, size, _ in number.laws for f in functions(number, law, rust, size)]


def init(number):
    return wrapped(f"COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_cos_power_init_{number.name}"
                   f"(coslobe_cos_power_{number.name} *law, {number.types['exponent']} exponent);")


def wrapped(prototype):
    """At most 96 columns."""
    if len(prototype) <= 96:
        return prototype
    start = prototype.index("(", prototype.index(" coslobe_"))
    head, rest = prototype[:start], prototype[start + 1:]
    lines, line = [], "    "
    for piece in re.split(r"(?<=,) ", rest):
        if len(line) + len(piece) > 92:
            lines.append(line.rstrip())
            line = "    "
        line += piece + " "
    return "\n".join([head + "(", *lines, line.rstrip()])


def header():
    text = (HERE / "header/top.h").read_text()
    version = re.search(r'^version = "(\d+)\.(\d+)\.(\d+)"', (ROOT / "Cargo.toml").read_text(), re.M)
    for part, number in zip(("MAJOR", "MINOR", "PATCH"), version.groups()):
        text = text.replace(f"@{part}@", number)
    for number in NUMBERS:
        text += f"\n/* ---- {number.name}: {number.title} ---- */\n"
        if number.handle_words:
            text += (f"\n/* The law cos_power with its constants: coslobe_cos_power_init_{number.name} "
                     "fills it in. */\n"
                     f"typedef struct coslobe_cos_power_{number.name} {{\n"
                     f"    uint32_t state[{number.handle_words}];\n"
                     f"}} coslobe_cos_power_{number.name};\n")
        for law, rust, size, what in number.laws:
            text += f"\n/* {law}, {what}. */\n"
            if law == "cos_power":
                text += init(number) + "\n"
            text += "".join(wrapped(f.prototype()) + "\n" for f in functions(number, law, rust, size))
    return text + (HERE / "header/end.h").read_text()


def rust_file(number):
    own = {"q31": "use coslobe::Fixed;\nuse coslobe::integers::CosPower;\n"
                  "use fixed::types::{I0F32, I1F31, U0F32, U16F16};\n",
           "q15": "use coslobe::Fixed16;\nuse fixed::types::{I0F16, I1F15, U0F16};\n"}
    common = ("use crate::boundary::*;\nuse core::ffi::c_int;\n"
              "use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Lambert, SphereShell};\n"
              "use coslobe::self_test;\n")
    real = ("use coslobe::{CosPower, Law, Planar, PlanarPoint, Radius, Spatial, SpatialPoint};\n")
    fast = "use coslobe::Fast;\n" if number.name == "fast" else ""
    text = f"//! {number.title[0].upper()}{number.title[1:]}; {MADE}.\n\n{common}"
    text += own.get(number.name, real + fast)
    r, get, new = number.rust["component"], number.get, number.new["component"]
    inner = {"f32": "f32", "fast": "Fast<f32>", "q31": "I1F31", "q15": "I1F15"}[number.name]
    as_is = number.name == "f32"
    cos, sin = (f"at.{x}" if as_is else get.format(f"at.{x}") for x in ("cos", "sin"))
    text += (f"\nfn plain(at: CosSin<{inner}>) -> Pair<{r}> {{ "
             f"Pair {{ cos: {cos}, sin: {sin} }} }}\n")
    cos, sin = (f"at.{x}" if as_is else new.format(f"at.{x}") for x in ("cos", "sin"))
    text += (f"\nfn pair(at: Pair<{r}>) -> CosSin<{inner}> {{ "
             f"CosSin {{ cos: {cos}, sin: {sin} }} }}\n")
    if number.handle_words:
        law = "CosPower" if number.is_integer else f"CosPower<{inner}>"
        lobe = "Fixed<CosPower>" if number.is_integer else law
        none = "0" if number.is_integer else "f32::NAN"
        exponent = number.new["exponent"].format("exponent")
        made = (f"Some(Fixed(CosPower::new({exponent})))" if number.is_integer
                else f"CosPower::new({exponent}).ok()")
        text += (f"\n/// `coslobe_cos_power_{number.name}` of the header.\n"
                 f"pub type Lobe = Handle<{lobe}, {number.handle_words}>;\n"
                 + (f"const NONE: {'u32' if number.is_integer else 'f32'} = {none};\n"
                    if not number.is_integer else "")
                 + f"const NO_PAIR: Pair<{r}> = Pair {{ cos: {none}, sin: {none} }};\n"
                 f"\n#[unsafe(no_mangle)]\npub unsafe extern \"C\" fn coslobe_cos_power_init_"
                 f"{number.name}(law: *mut Lobe, exponent: {number.rust['exponent']}) -> c_int "
                 f"{{ unsafe {{ init(law, {made}) }} }}\n")
    body = "\n".join(f.rust_text() for f in all_functions(number))
    if number.is_integer:
        body = body.replace("NONE", "0")
    return text + "\n" + body


def calls():
    """What the C test runs: CALL(kind, function, name); a handle is passed by a function of its own."""
    text = f"/* {MADE} */\n#ifdef WRAPPERS\n"
    lines = ""
    for number in NUMBERS:
        for f in all_functions(number):
            if not f.handle:
                lines += f"CALL({f.kind}, {f.name}, \"{f.name}\")\n"
                continue
            short = f.name.replace("coslobe_", "")
            arguments = [c for c, _ in f.arguments]
            names = [re.sub(r"\[\d\]", "", c).split("*")[-1].split()[-1] for c in arguments]
            passed = ", ".join([f"&lobe_{number.name}"] + names)
            text += (f"static {f.result[0]} {short}({', '.join(arguments)})\n"
                     f"{{\n    return {f.name}({passed});\n}}\n")
            lines += f"CALL({f.kind}, {short}, \"{f.name}\")\n"
    return text + "#else\n" + lines + "#endif\n"


def formatted(rust):
    done = subprocess.run(["rustfmt", "--edition", "2024", "--emit", "stdout"], input=rust,
                          capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"rustfmt: {done.stderr}")
    return done.stdout


def main():
    files = {HERE / "include/coslobe.h": header(), HERE / "test/calls.h": calls()}
    for number in NUMBERS:
        files[HERE / f"src/generated/{number.name}.rs"] = formatted(rust_file(number))
    stale = 0
    for path, text in files.items():
        if not path.exists() or path.read_text() != text:
            stale += 1
            if "--check" in sys.argv:
                print(f"{path.relative_to(ROOT)} is out of date: python3 tools/c_api.py")
            else:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
    sys.exit(1 if stale and "--check" in sys.argv else 0)


main()
