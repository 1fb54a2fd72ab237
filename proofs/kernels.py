"""All proofs, in the order they are printed."""

from angle import atan
from circle import cosine, sine, turn_cos, turn_sin
from cube import cbrt
from disk import centre_of_sin, kepler_tail, tail_of_cos
from roots import ball_sin, shell_density

# name, polynomial, script, source, domain
KERNELS = [
    ("small sin", "sin", sine, "trig.rs", "(0, 0.9]"),
    ("small cos", "cos", cosine, "trig.rs", "[0, 0.9]"),
    ("turn sin", "sin_turn", turn_sin, "turn.rs", "(0, 1/8]"),
    ("turn cos", "cos_turn", turn_cos, "turn.rs", "[0, 1/8]"),
    ("cbrt", None, cbrt, "cbrt.rs", "(0, inf)"),
    ("kepler tail", "kepler_tail", kepler_tail, "kepler.rs", "p < 1/8"),
    ("disk tail of cos", "disk_tail_of_cos", tail_of_cos, "kepler.rs", "(0, 0.7071]"),
    ("disk tail of sin", "disk_centre_of_sin", centre_of_sin, "kepler.rs", "[0, 0.7071]"),
    ("atan", "atan", atan, "atan.rs", "[0, inf]"),
    ("ball sin", None, ball_sin, "ball.rs", "[0, 1]"),
    ("shell density", None, shell_density, "sphere_shell.rs", "[0, 1]"),
]

