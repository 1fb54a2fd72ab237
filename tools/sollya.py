"""Sollya, as the writers of coefficients run it."""

import subprocess
import sys

from mpmath import mp, mpf


def polynomial(coefficients):
    """In Sollya's words, lowest coefficient first."""
    return "horner(" + "+".join(f"({mp.nstr(c, 60)})*x^{i}" for i, c in enumerate(coefficients)) + ")"


def printed(script):
    """The numbers that a script prints after "C", and the binary logarithms of those after "E"."""
    script = "display = dyadic!;\n" + script
    out = subprocess.run(["sollya"], input=script, capture_output=True, text=True).stdout
    coefficients, errors = [], []
    for line in out.splitlines():
        if line[:2] in ("C ", "E "):
            m, _, e = line[2:].strip().partition("b")
            value = mpf(int(m)) * mpf(2) ** int(e or 0)
            if line[0] == "C":
                coefficients.append(value)
            else:
                errors.append(mp.log(value, 2))
    if not coefficients:
        sys.exit("sollya found no polynomial:\n" + out[:2000])
    return coefficients, errors
