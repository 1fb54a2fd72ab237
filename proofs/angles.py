"""What the laws read of an angle, in roundings, beside each its source.

Of an angle beyond pi/4 the distance from pi/2 counts, as pair (trig.rs fold): pieces halve it down to the last number.
"""

from balls import arb
from laws import pieces
from pairs import at_angle, constant, from_end
from sweep import Formula


def fold(form):
    return form.pair["half_pi"][0] / 2


def last(form):
    """HALF_PI_DOWN, the last number of the support."""
    hi, lo = form.pair["half_pi"]
    return hi if lo > 0 else hi - 4 * form.u


def beyond(form, low):
    """Pieces from `low` to the last number, each half as far from that."""
    ends, top = [arb(low)], arb(last(form))
    while top - ends[-1] > 8 * form.u:
        ends.append((ends[-1] + top) / 2)
    return list(zip(ends, [*ends[1:], top]))


def over_angles(form, result, true, degree=0, ends=None, turn=None):
    """The formulas of `result(tape, a, far)` from a to b = `ends`; `turn`: where `true` turns, to the last bit or so."""
    low, high = ends or (0, last(form))
    middle = fold(form)
    found = []
    for far, a, b in [(False, low, min(middle, high)), (True, max(low, middle), high)]:
        if not a < b:
            continue
        if far:
            parts = beyond(form, a) if b == last(form) else [(arb(a), arb(b))]
        else:
            parts = [(arb(a), arb(b))] if a else pieces(form, b, degree)
        if turn and a < turn < b:
            parts = [*((x, y if y < turn else arb(turn)) for x, y in parts if x < turn), (arb(turn), arb(b))]
        found.append(Formula(lambda tape, x, far=far: [result(tape, x, far)], true, parts))
    return found


def pdf(form, one, product, true, degree=0, turn=None):
    """A law's pdf: `product` of the pairs cos and sin and of a constant."""
    def result(tape, a, far):
        return product(tape, one, *at_angle(tape, a, far)).value()

    return over_angles(form, result, true, degree, turn=turn)


def held(tape, one, name, exact):
    hi, lo = tape.form.pair[name]
    return constant(tape, exact, (tape.form.rounded(hi * one), lo))


def disk_pdf(form, one):
    return pdf(form, one, lambda t, one, c, s: c.times(c).times(held(t, one, "two_over_pi", 2 / arb.pi())),
               lambda a: 2 * a.cos()**2 / arb.pi())


def shell_pdf(form, one):
    return pdf(form, one, lambda t, one, c, s: c.times(s).times(c).times(held(t, one, "three_over_two_pi", 3 / (2 * arb.pi()))),
               lambda a: 3 * a.cos()**2 * a.sin() / (2 * arb.pi()), 0, 0.6154797086703874)


def shell_solid(form, one):
    return pdf(form, one, lambda t, one, c, s: c.times(c).times(held(t, one, "three_over_two_pi", 3 / (2 * arb.pi()))),
               lambda a: 3 * a.cos()**2 / (2 * arb.pi()))


def lambert_solid(form, one):
    return pdf(form, one, lambda t, one, c, s: c.times(held(t, one, "recip_pi", 1 / arb.pi())), lambda a: a.cos() / arb.pi())


def planar(form, nearer, tail, true):
    """A planar law's tail beyond |theta| = a, and the farther tail."""
    return over_angles(form, lambda tape, a, far: tail(tape, a, far) if nearer else 1.0 - tail(tape, a, far),
                       true if nearer else lambda a: 1 - true(a))


def circle_tails(form, one, nearer):
    """circle_shell.rs nearer_tail."""
    def tail(tape, a, far):
        c, s = at_angle(tape, a, far)
        return c.times(c).value() * 0.5 / (tape.constant(arb(1), one) + s.value())

    def true(a):
        return (arb.pi() / 4 - a / 2).sin()**2

    return planar(form, nearer, tail, true)


def arc_tails(form, one, nearer):
    """circle_arc.rs tails."""
    def tail(tape, a, far):
        return from_end(tape, a, far).times(held(tape, one, "recip_pi", 1 / arb.pi())).value()

    return planar(form, nearer, tail, lambda a: (arb.pi() / 2 - a) / arb.pi())
