"""Where the first passage of a range may be: Newton's method in float64 from many points at once. Heuristic.

It only tells the proof how far it need go: nothing that is proved rests on it.
"""

from __future__ import annotations

import numpy as np

from mpsolve.fields import Float64
from mpsolve.model.branch import ALONG_Q
from mpsolve.model.characteristic import characteristic_rates
from mpsolve.stability.family import Family

_STEPS = 25


def guess_first(family: Family, low: float, high: float) -> float | None:
    """The smallest t in [low, high] at which a root seems to cross the line with growing t downwards, or None."""
    x, t = (a.ravel() for a in np.meshgrid(np.geomspace(0.03, 1.5, 24), np.linspace(low, high, 26)[1:]))
    field, height = Float64(), float(family.height)
    with np.errstate(all="ignore"):
        for _ in range(_STEPS):
            model = family.at(field, t)
            f, (fx, ft) = characteristic_rates(model, x + 1j * height, (ALONG_Q, family.motion(len(model.eta_m))))
            det = (fx.conj() * ft).imag
            dx, dt = (f.real * ft.imag - f.imag * ft.real) / det, (fx.real * f.imag - fx.imag * f.real) / det
            size = np.maximum(np.abs(dx) / (0.1 + 0.2 * np.abs(x)), np.abs(dt) / (0.05 * (high - low)))
            x, t = x - dx / np.maximum(size, 1), t - dt / np.maximum(size, 1)
    settled = (np.abs(dx) + np.abs(dt) < 1e-9) & (x > 1e-6) & (t > low) & (t < high) & (det > 0)
    return float(t[settled].min()) if settled.any() else None
