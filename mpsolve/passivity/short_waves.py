"""How fast the short waves of a track run, in floats: where contacts are as fast, nothing bounds what it gives."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from mpsolve.numbers.several import multiply, plus
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import halves


def overtakes(guide: Guide, v: Fraction | float) -> bool:
    """Some short wave of the track runs at a speed up to v."""
    return slowest_short_wave(guide) <= float(v)


def slowest_short_wave(guide: Guide) -> float:
    """The least speed of the waves as they become short; infinite where there is none.

    They are real roots of the terms of |D|², at P = ip and s = iΩ, of the highest degree in p and Ω together.
    """
    even, odd = halves(guide.D_rest)
    square = plus(multiply(even, even), {(i, j + 1): c for (i, j), c in multiply(odd, odd).items()})
    top, by_p = max(i + j for i, j in square), max(i for i, _ in square)
    speeds = np.zeros(2 * by_p + 1)
    for (i, j), c in square.items():
        if i + j == top:
            speeds[2 * i] = float(c)  # of (Ω/p)^(2 (by_p − i)), descending
    roots = np.roots(speeds)
    real = roots[(np.abs(roots.imag) < 1e-6 * np.abs(roots)) & (roots.real > 0)].real
    return float(real.min(initial=np.inf))
