"""How near cbrt.rs's iterate is to the cube root before its last step, and what that step leaves."""

import struct


def cube_root_step(e, noise):
    """|t'/c - 1| of a Halley step from |t/c - 1| <= e: e^3 (2 + e)/(1 + 2 (1 + e)^3) exactly."""
    return e**3 * (2 + e) / (1 + 2 * (1 - e) ** 3) + noise


def guess(form):
    """max |guess/cbrt y - 1| over y in [1, 8): the guess grows with the bits of y, so ends bound each piece."""
    big, small = ("d", "Q") if form.bits == 53 else ("f", "I")
    constant = 715_094_163 << 32 if form.bits == 53 else 0x2A51_19F2
    to = lambda x: struct.unpack(small, struct.pack(big, x))[0]
    of = lambda b: struct.unpack(big, struct.pack(small, b))[0]
    first, last, n, worst = to(1.0), to(8.0), 6000, 0.0
    edges = [first + (last - first) * i // n for i in range(n + 1)]
    for low, high in zip(edges, edges[1:]):
        t_low, t_high = of(low // 3 + constant), of(high // 3 + constant)
        worst = max(worst, t_high / of(low) ** (1 / 3) - 1, 1 - t_low / of(high) ** (1 / 3))
    return worst * (1 + 1e-6)


def halley(form, planted):
    """Relative error of the last step in exact arithmetic; `planted` leaves out a step before it."""
    e = guess(form)
    for _ in range((2 if form.bits == 53 else 1) - planted):
        e = cube_root_step(e, 8 * form.u)
    e += 2.0 ** (1 - form.half)  # leading_half
    return cube_root_step(e, 0.0) if e <= 2.0 ** (1.1 - form.half) else None
