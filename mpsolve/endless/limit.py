"""To what long finite trains tend: where the two middle roots z have one modulus. Computed in float64, not proved.

A train of N vehicles has a root where T^N carries what decays behind of it into what decays ahead of it, T the map of
one cell with the eigenvalues z_1, …, z_n by modulus. As N → ∞ the n − n₊ largest win, unless |z_{n₊}| = |z_{n₊+1}|:
so the roots of long trains gather on that set (Schmidt and Spitzer, Widom, Day; the absolute spectrum of Sandstede
and Scheel), apart from single ones that belong to an end of the train. The set ends where the two roots meet,
z_{n₊} = z_{n₊+1}: there (z_{n₊} − z_{n₊+1})² is analytic in σ with a simple zero, which Newton's method finds.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.endless.axis import closest
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.row import Row

_STEPS = 40
_TINY = 1e-13


@dataclass(frozen=True)
class Meeting:
    """The two middle roots are both z at σ (scaled): the frequency of the slowest decay, or fastest growth, of long
    trains. Computed."""

    sigma: complex
    z: complex


def meeting(row: Row, near: complex) -> Meeting | None:
    """The place next to σ = near where the middle roots meet; None where Newton's method does not end."""
    bloch = Bloch(row)

    def square(sigma: complex) -> tuple[complex, complex]:
        a, b = bloch.middle(np.array([sigma]))
        return complex(((a - b) ** 2)[0]), complex(((a + b) / 2)[0])

    before, here = near, near * (1 + 1e-5)
    f0, f1 = square(before)[0], square(here)[0]
    for _ in range(_STEPS):
        if f1 == f0:
            break
        step = f1 * (here - before) / (f1 - f0)
        limit = 0.1 * abs(here)
        step *= min(1.0, limit / abs(step)) if step else 1.0
        before, f0, here = here, f1, here - step
        if here.real < -0.2 * abs(here):
            return None
        f1 = square(here)[0]
        if abs(step) < _TINY * abs(here):
            break
    value, z = square(here)
    return Meeting(here, z) if abs(value) < 1e-8 * abs(z) ** 2 else None


def of_long_trains(row: Row, most: float) -> Meeting | None:
    """The meeting of the middle roots that is reached from the real frequency where they are closest."""
    _, q = closest(Bloch(row), most)
    return meeting(row, 1j * q)


def roots_of_long_trains(row: Row, count: int, most: float, modes: int = 4) -> Any:
    """The first roots σ of a train of `count` vehicles for large counts: z_{n₊+1}/z_{n₊} = e^{2πij/count}."""
    bloch, end = Bloch(row), of_long_trains(row, most)
    if end is None:
        return np.zeros(0, complex)
    scale, out = 1e-3 * abs(end.sigma), []
    for j in range(1, modes + 1):
        wanted = 2 * np.cos(2 * np.pi * j / count)  # of z/z' + z'/z, which is analytic at the meeting
        guess = end.sigma + scale * 1e-2

        def miss(sigma: complex, wanted: float = wanted) -> complex:
            a, b = bloch.middle(np.array([sigma]))
            return complex((a / b + b / a)[0]) - wanted

        before, here = end.sigma, guess
        f0, f1 = 2 - wanted, miss(guess)
        for _ in range(60):
            if f1 == f0:
                break
            step = f1 * (here - before) / (f1 - f0)
            step *= min(1.0, 20 * scale / abs(step)) if step else 1.0
            before, f0, here = here, f1, here - step
            f1 = miss(here)
            if abs(step) < 1e-12 * abs(here):
                break
        out.append(here)
    return np.array(out)
