"""The largest ratio of two contact forces over a band of real frequencies, enclosed by branch and bound in discs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.path import discs
from mpsolve.characteristic.residues import waves
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.jets import UP, Jet
from mpsolve.outcome import Reason
from mpsolve.proof.effort import Effort
from mpsolve.proof.turning import solution

_PIECES = 256
_SMALLEST = 2.0**-28
FLOOR = 1e-6
"""Ratios below are not told apart from it: where all are, `high` is at most this, and `low` may be far below."""


@dataclass(frozen=True)
class Largest:
    """low ≤ max ≤ high; the ratio is at least `low` at the frequency q (scaled). reason: why they are not as near to
    each other as was asked, with `high` infinite where nothing is known.
    """

    low: float
    high: float
    q: float
    reason: Reason | None = None


@dataclass(frozen=True)
class Ratio:
    """|λ_target/λ_source| of a problem whose contact `source` is shaken, at real frequencies q̂ (scaled)."""

    arrays: Arrays
    up: int
    source: int
    target: int

    def jets(self, a: Any, b: Any) -> tuple[Jet, Truths]:
        """The ratio as jets over discs that hold the pieces from a to b, and where it is proved."""
        m, r = discs(a, b)
        with np.errstate(all="ignore"):
            _, G, good = self.arrays.evaluate(m, r, self.up)
            y, regular = solution(self.arrays.matrix(G, m), self.arrays.shaken(self.source, m, r))
            force = self.arrays.first_force
            ratio = y[:, force + self.target, 0] * y[:, force + self.source, 0].inverse()
        fine = good & regular & self._on_their_sides(m, r) & np.isfinite(ratio.a) & np.isfinite(ratio.e)
        return ratio, fine

    def _on_their_sides(self, m: Complexes, r: Reals) -> Any:
        """Whether the p-roots of U are proved to decay ahead, and those of L to grow, so that U and L are what they
        are to be: no p-root is real for Re σ ≥ 0 (the premise), and so none has changed sides."""
        _, P, good = waves(self.arrays.N, self.arrays.D, split(self.arrays.D, m, r, self.up))
        with np.errstate(all="ignore"):
            size = np.abs(P.b) * r[:, None] + P.e
            off = P.a.real * np.where(np.arange(P.a.shape[1]) < self.up, -1.0, 1.0)
            return good & (off > size * UP).all(1)

    def largest(self, low: float, high: float, tolerance: float, effort: Effort) -> Largest:
        """The largest |ratio| for low ≤ q ≤ high, enclosed to the relative tolerance, or as far as the effort goes.

        On a real piece |a + b t| is convex, so its largest value is at an end. PrecisionError where the ratio is not
        bounded.
        """
        points = np.linspace(low, high, _PIECES + 1)
        a, b, above = points[:-1], points[1:], np.full(_PIECES, np.inf)
        best, at, ceiling = 0.0, low, 0.0
        while len(a):
            try:
                effort.spend(len(a))
            except EffortError as error:
                return Largest(best, max(ceiling, best, float(above.max())), at, error.reason)
            ratio, fine = self.jets(a + 0j, b + 0j)
            with np.errstate(all="ignore"):
                step = 1j * ratio.b * ratio.r
                upper = (np.maximum(np.abs(ratio.a + step), np.abs(ratio.a - step)) + ratio.e) * UP
                lower = np.where(fine, np.abs(ratio.a) / UP - ratio.e, -np.inf)
            upper = np.where(fine, upper, np.inf)
            k = int(np.argmax(lower))
            if lower[k] > best:
                best, at = float(lower[k]), float((a[k] + b[k]) / 2)
            done = upper <= max(best * (1 + tolerance), FLOOR)
            ceiling = max(ceiling, float(upper[done].max(initial=0.0)))
            a, b, above = a[~done], b[~done], upper[~done]
            if len(a) and (b - a).min() < _SMALLEST * (high - low):
                raise PrecisionError(f"the ratio of forces is not bounded near q = {a[0]:.6g} (scaled)")
            middle = (a + b) / 2
            a, b, above = np.concatenate([a, middle]), np.concatenate([middle, b]), np.tile(above, 2)
        return Largest(best, max(ceiling, best), at)
