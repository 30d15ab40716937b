"""Taylor models that know (e^f − 1)/f, closed under the operations that `entries` takes."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic, constant

ROUNDING = 1e-13
"""Above the roundings of (eʷ − 1)/w and its slopes, relative to max(1, |eʷ|).

For |w| < 1 they are sums of 24 terms, together below e, each of some 50 roundings at most, and 1/25! is left out:
below 150 u. For |w| ≥ 1 three quotients follow each other, each a few u of |eʷ| + 1 and twice the one before: below
100 u. u = 2⁻⁵³, so that both are below 2e-14.
"""
_TERMS = 24


class Model(Quadratic):
    """A Taylor model of two variables or more."""

    def __neg__(self) -> Model:
        return model_of(super().__neg__())

    def __add__(self, other: Quadratic) -> Model:
        return model_of(super().__add__(other))

    def __mul__(self, other: Quadratic) -> Model:
        return model_of(super().__mul__(other))

    def times(self, factor: Any) -> Model:
        return model_of(super().times(factor))

    def inverse(self) -> Model:
        return model_of(super().inverse())

    def exp(self) -> Model:
        return model_of(super().exp())

    def quotient(self) -> Model:
        """(e^f − 1)/f, f = w + δ: as it stands, or by its slopes at w, the third one at most max(1, e^Re)/4."""
        with np.errstate(all="ignore"):
            value, first, second = _quotient(self.a)
            moved = self.k.copy()
            moved[0] = 0
            delta = Model(moved, self.e, self.m)
            y = self.spread
            most = np.maximum(1.0, np.exp(np.minimum(self.a.real + y, 700.0))) * (1 + 1e-12)
            total = constant(0.0, len(self.e), self.m) + delta.times(first) + (delta * delta).times(second / 2)
            k = total.k.copy()
            k[0] += value
            e = total.e + (y**3 / 24 + ROUNDING * (1 + y + y * y)) * most * UP + 4 * U * np.abs(value) + TINY
            e = np.where(y < 20, e, np.inf)
            far = (self.exp() + constant(-1.0, len(self.e), self.m)) * self.inverse()  # sharper where |w| is large
            better = far.e < e
            return Model(np.where(better, far.k, k), np.where(better, far.e, e), self.m)


def model_of(f: Quadratic) -> Model:
    return Model(f.k, f.e, f.m)


def _quotient(w: Complexes) -> tuple[Complexes, Complexes, Complexes]:
    """E, E′, E″ at complex floats."""
    small = np.abs(w) < 1
    far = np.where(small, 1.0, w)
    grown = np.exp(far)
    E = (grown - 1) / far
    E1 = (grown - E) / far
    closed = (E, E1, (grown - 2 * E1) / far)
    near = np.where(small, w, 0.0)
    sums = [np.zeros(w.shape, complex) for _ in range(3)]
    power, factor = np.ones(w.shape, complex), 1.0
    for n in range(_TERMS):
        factor /= n + 1  # 1/(n + 1)!
        sums[0] += power * factor
        sums[1] += power * factor * (n + 1) / (n + 2)
        sums[2] += power * factor * (n + 1) / (n + 3)
        power = power * near
    return tuple(np.where(small, a, b) for a, b in zip(sums, closed, strict=True))  # type: ignore[return-value]
