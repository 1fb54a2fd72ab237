"""All proofs, in the order they are printed."""

from functools import partial

from angle import atan
from circle import cosine, sine, turn_cos, turn_sin
from cube import PLACES, cbrt
from disk import centre_of_sin, kepler_tail, tail_of_cos
from kepler import proof
from roots import ball_sin, shell_density

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
]

