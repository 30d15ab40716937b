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


def gathering(row: Row, end: Meeting, angles: Any) -> Any:
    """σ on the set on which roots of long trains gather, from its end on: where z_{n₊+1}/z_{n₊} = e^{iφ}.

    angles: φ ascending from near 0, in steps small enough to follow the curve. Roots of a train of N vehicles lie
    near those of φ = 2πj/N.
    """
    bloch, out = Bloch(row), []

    def miss(sigma: complex, wanted: float) -> complex:
        a, b = bloch.middle(np.array([sigma]))
        return complex((a / b + b / a)[0]) - wanted  # analytic at the end too

    before, here = end.sigma, end.sigma * (1 + 1e-6)
    for angle in np.asarray(angles, float):
        wanted = 2 * float(np.cos(angle))
        x, y = 2 * here - before, here  # along the curve, from the last point
        before = here
        f, g = miss(x, wanted), miss(y, wanted)
        for _ in range(_STEPS):
            if f == g or abs(x - y) < _TINY * abs(x):
                break
            step = f * (x - y) / (f - g)
            step *= min(1.0, 0.02 * abs(x) / abs(step)) if step else 1.0
            y, g, x = x, f, x - step
            f = miss(x, wanted)
        here = x
        out.append(here)
    return np.array(out)
