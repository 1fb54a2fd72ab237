"""The polynomial of src/arithmetic/native/sqrt.rs: 1 / sqrt(1 + x) in units of 2^-16.

Sollya's fpminimax knows nothing of what is cut off between the steps, nor of the step that follows. So its
coefficients are moved, one or two at a time, for as long as the error of the root before its last
correction spreads less. That the root is right is shown by the unit tests, on every significand.
"""

from itertools import combinations, product
from math import sqrt

SIGNIFICANDS = [0x3F800000 + i * 0x800000 // 1999 for i in range(2 * 1999)]
DEGREE = 4


def pieces(bits):
    """As sqrt.rs: the radicand, the argument of the polynomial, 2^(15, 14 1/2), and the true root."""
    odd = bits >> 23 & 1
    square = (bits << 8 & 0xFFFFFFFF | 1 << 31) >> odd
    return square, (bits << 9 & 0xFFFFFFFF) >> 16, 23171 + 9597 * odd, sqrt(square) * 256


PIECES = [pieces(bits) for bits in SIGNIFICANDS]


def spread(coefficients):
    """From the least to the largest error of the root before its correction, in units in the last place."""
    least, most = 0.0, -1.0
    for square, x, part, true in PIECES:
        reciprocal = 0
        for c in reversed(coefficients):
            reciprocal = (reciprocal * x >> 16) + c
        reciprocal = reciprocal * part >> 15
        root = (square >> 16) * reciprocal >> 15
        rest = square - root * root
        error = root * 256 + (rest >> 5) * reciprocal / 2**19 - true
        least, most = min(least, error), max(most, error)
    return most - least


def moves():
    for i in range(DEGREE + 1):
        yield from ([(i, d)] for d in (-4, -2, -1, 1, 2, 4))
    for pair in combinations(range(DEGREE + 1), 2):
        yield from ([*zip(pair, by)] for by in product((-2, -1, 1, 2), repeat=2))


def improved(coefficients):
    """Sollya's coefficients, moved to where no move makes the spread smaller; and that spread."""
    best = spread(coefficients), coefficients
    while True:
        tried = []
        for move in moves():
            moved = list(best[1])
            for i, by in move:
                moved[i] += by
            tried.append((spread(moved), moved))
        if min(tried) >= best:
            return best[::-1]
        best = min(tried)
