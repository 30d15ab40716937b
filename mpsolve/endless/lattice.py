"""The receptance of an endless row: Σ_k G(a + kd) z^{−k}, closed as one geometric series for each p-root.

Forces λ z^n at the places x + nd, z = e^{iκd}, move the rail at x + a as −Ĝ(a, z) λ, Ĝ(a, z) = Σ_k G(a + kd) z^{−k}.
G(ξ ≥ 0) = Σ w e^{Pξ} over the roots with Re P < 0, G(ξ < 0) = −Σ w e^{Pξ} over those with Re P > 0, w = N/D_P. For
|z| = 1 the series converge, and with 0 ≤ a < d either kind of root gives the same term w e^{Pa}/(1 − e^{Pd}/z):

    k ≥ 0:  w e^{Pa} Σ (e^{Pd}/z)^k,      k < 0:  −w e^{Pa} Σ_{m ≥ 1} (z e^{−Pd})^m = w e^{Pa}/(1 − e^{Pd}/z).

So Ĝ(a, z) = Σ over all roots; nothing depends on which are upper. For −d < a < 0, Ĝ(a, z) = Ĝ(a + d, z)/z. Below,
the side of a root only decides which of two equal expressions is computed, so that no power overflows.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from mpsolve.characteristic.symbol import Terms

if TYPE_CHECKING:
    from mpsolve.numbers.arrays import Complexes


@dataclass(frozen=True)
class Lattice:
    """Sums over the distances of one cell: exact distances a with |a| < d, and the spacing d (scaled)."""

    distances: tuple[Fraction, ...]
    spacing: Fraction

    def sums(
        self, terms: Sequence[Terms], upper: int, z: Any, number: Callable[[Fraction], Any], exp: Callable[[Any], Any]
    ) -> tuple[list[Any], list[Any]]:
        """Ĝ and its slope in σ at each distance, from the terms of all p-roots, the `upper` ones first.

        number and exp belong to the arithmetic of the terms: float64 arrays, mpmath or balls.
        """
        parts = [self._root(term, k < upper, z, number, exp) for k, term in enumerate(terms)]
        G = [sum((part[j][0] for part in parts[1:]), parts[0][j][0]) for j in range(len(self.distances))]
        slopes = [sum((part[j][1] for part in parts[1:]), parts[0][j][1]) for j in range(len(self.distances))]
        return G, slopes

    def _root(self, term: Terms, ahead: bool, z: Any, number: Any, exp: Any) -> list[tuple[Complexes, Complexes]]:
        """What one root gives to each sum and its slope: forces behind of a place, or ahead of it."""
        step = self.spacing if ahead else -self.spacing
        ratio = exp(term.z * number(step)) * (1 / z if ahead else z)
        over = 1 / (1 - ratio)
        more = ratio * over * over * number(step)
        out = []
        for a in self.distances:
            first, factor = first_force(a, self.spacing, ahead)
            xi = number(first)
            wave = exp(term.z * xi) * {0: 1, 1: z, -1: 1 / z}[factor] * (1 if ahead else -1)
            out.append((term.w * wave * over, ((term.a + term.b * xi) * over + term.b * more) * wave))
        return out


def first_force(a: Fraction, d: Fraction, ahead: bool) -> tuple[Fraction, int]:
    """(ξ, m) of the first term w e^{Pξ} z^m of a series: ξ ≥ 0 for roots that decay ahead, else ξ < 0."""
    if ahead:
        return (a, 0) if a >= 0 else (a + d, -1)
    return (a - d, 1) if a >= 0 else (a, 0)
