"""All proofs, in the order they are printed."""

from functools import partial

import angles
import laws
from angle import atan
from circle import cosine, sine, turn_cos, turn_sin
from cube import PLACES, cbrt
from disk import centre_of_sin, kepler_tail, tail_of_cos
from kepler import proof
from roots import ball_sin, shell_density
from sweep import swept
from tables import claim

def law(name, law, operations, formulas, source, domain, poly=None, **options):
    """A law's formula, bisected until it is below what docs/bounds.md claims."""
    script = partial(swept, formulas=partial(formulas, **options), goal=claim(law, *operations), poly=poly)
    return name, poly, script, source, domain


WARP = ["warp: cos", "warp: sin", "warp_sf: cos", "warp_sf: sin"]

# name, polynomial, script, source, domain
KERNELS = [
    ("small sin", "sin", sine, "trig.rs", "(0, 0.9]"),
    ("small cos", "cos", cosine, "trig.rs", "[0, 0.9]"),
    ("turn sin", "sin_turn", turn_sin, "turn.rs", "(0, 1/8]"),
    ("turn cos", "cos_turn", turn_cos, "turn.rs", "[0, 1/8]"),
    *((f"cbrt {low}", None, partial(cbrt, low=low), "cbrt.rs", f"r >= {low}") for low in PLACES),
    ("kepler tail", "kepler_tail", kepler_tail, "kepler.rs", "p < 1/8"),
    ("kepler centre", "kepler_centre", partial(proof, result="angle", poly="kepler_centre", sides=[False]), "kepler.rs", "p >= 1/8"),
    ("disk angle", "kepler_tail", partial(proof, result="angle", poly="kepler_tail", sides=[True]), "kepler.rs", "p < 1/8"),
    ("disk warp cos", "kepler_centre", partial(proof, result="cos", poly="kepler_centre", sides=[False, True]), "kepler.rs", "(0, 1/2]"),
    ("disk warp sin", "kepler_centre", partial(proof, result="sin", poly="kepler_centre", sides=[False, True]), "kepler.rs", "(0, 1/2]"),
    ("disk tail of cos", "disk_tail_of_cos", tail_of_cos, "kepler.rs", "(0, 0.7071]"),
    ("disk tail of sin", "disk_centre_of_sin", centre_of_sin, "kepler.rs", "[0, 0.7071]"),
    ("atan", "atan", atan, "atan.rs", "[0, inf]"),
    ("ball sin", None, ball_sin, "ball.rs", "[0, 1]"),
    ("shell density", None, shell_density, "sphere_shell.rs", "[0, 1]"),
    law("shell sin of u", "SphereShell", ["warp: sin"], laws.shell_sin, "sphere_shell.rs", "(0, 1/2]", of_lower=True),
    law("shell sin of q", "SphereShell", ["warp_sf: sin"], laws.shell_sin, "sphere_shell.rs", "(0, 1/2]", of_lower=False),
    law("disk density", "Disk", ["density"], laws.power_density, "disk.rs", "(0, 1]", k=2),
    law("ball density", "Ball", ["density"], laws.power_density, "ball.rs", "(0, 1]", k=3),
    law("ball sin of q", "Ball", ["warp_sf: sin"], laws.ball_sin_sf, "ball.rs", "(0, 1/2]"),
    law("ball unwarp", "Ball", ["unwarp"], laws.ball_unwarp, "ball.rs", "all", upper=False),
    law("ball unwarp_sf", "Ball", ["unwarp_sf"], laws.ball_unwarp, "ball.rs", "all", upper=True),
    law("half turn sin", "CircleArc", WARP, laws.half_turn, "turn.rs", "(0, 1/4]", "sin_turn", of_sin=True),
    law("half turn cos", "CircleArc", WARP, laws.half_turn, "turn.rs", "(0, 1/4]", "cos_turn", of_sin=False),
    law("disk unwarp", "Disk", ["unwarp", "unwarp_sf"], laws.disk_unwarp, "kepler.rs", "all", nearer=True),
    law("disk unwarp far", "Disk", ["unwarp", "unwarp_sf"], laws.disk_unwarp, "kepler.rs", "all", nearer=False),
    law("disk pdf", "Disk", ["pdf"], angles.disk_pdf, "disk.rs", "[0, pi/2]"),
    law("lambert pdf_solid_angle", "Lambert", ["pdf_solid_angle"], angles.lambert_solid, "lambert.rs", "[0, pi/2]"),
    law("shell pdf", "SphereShell", ["pdf"], angles.shell_pdf, "sphere_shell.rs", "[0, pi/2]"),
    law("shell pdf_solid_angle", "SphereShell", ["pdf_solid_angle"], angles.shell_solid, "sphere_shell.rs", "[0, pi/2]"),
    law("arc tail", "CircleArc", ["cdf", "sf"], angles.arc_tails, "circle_arc.rs", "[0, pi/2]", nearer=True),
    law("arc tail far", "CircleArc", ["cdf", "sf"], angles.arc_tails, "circle_arc.rs", "[0, pi/2]", nearer=False),
    law("circle tail", "CircleShell", ["cdf", "sf"], angles.circle_tails, "circle_shell.rs", "[0, pi/2]", nearer=True),
    law("circle tail far", "CircleShell", ["cdf", "sf"], angles.circle_tails, "circle_shell.rs", "[0, pi/2]", nearer=False),
]

