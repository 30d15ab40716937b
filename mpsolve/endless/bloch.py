"""The endless row in float64: Δ̂(z, σ) and its roots z, the factors by which a motion changes from vehicle to vehicle.

Without proof. For a given σ the roots z are found from one cell as a scatterer: amplitudes a of the decaying waves
enter from the rear, b of the growing ones from the front, and A [y; λ] = [0; f] is the vehicle alone on its track:

    a' = e^{Pd} a − w e^{P(d−x)} λ,    b' = e^{−Pd} b + w e^{−Px} λ,    f = e^{Px} a + e^{−P(d−x)} b.

A Bloch motion has a' = z a and b = z b'. No entry grows, so neither long vehicles nor high frequencies do harm.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.floats import Receptance, det_and_slope
from mpsolve.characteristic.symbol import Terms
from mpsolve.endless.lattice import Lattice
from mpsolve.endless.row import Row
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.float64 import Float64

_K = Float64()
_TURN = np.exp(0.7j)


@dataclass(frozen=True)
class Bloch:
    """A row in float64, on arrays of scaled σ with Re σ ≥ 0."""

    row: Row

    @cached_property
    def receptance(self) -> Receptance:
        return Receptance(self.row.reduced.guide)

    @cached_property
    def border(self) -> Bordering:
        return Bordering.of(self.row.reduced, eliminate=False)

    @property
    def upper(self) -> int:
        """n₊: so many roots z belong to waves that run ahead of what shakes, as Re σ → ∞."""
        return self.receptance.upper

    def terms(self, sigma: Any) -> list[Terms]:
        """The terms of all p-roots, the upper ones first; arrays over σ."""
        found = self.receptance.terms(sigma)
        parts = (found.z, found.w, found.a, found.b)
        return [Terms(*(part[:, k] for part in parts)) for k in range(found.z.shape[1])]

    def delta(self, sigma: Any, z: Complexes) -> tuple[Complexes, Complexes]:
        """Δ̂(z, σ) and its slope in σ; σ and z arrays of one shape."""
        sigma, z = np.atleast_1d(np.asarray(sigma, complex)), np.atleast_1d(np.asarray(z, complex))
        lattice = Lattice(self.border.distances, self.row.step)
        with np.errstate(all="ignore"):
            G, slopes = lattice.sums(self.terms(sigma), self.upper, z, float, np.exp)
            return det_and_slope(self.border.at(_K, sigma, G), self.border.slope_at(_K, sigma, G, slopes))

    def scatterer(self, sigma: Any) -> Complexes:
        """S with [a'; b'] = S [a; b], shape (len(σ), n, n), n p-roots, the upper ones first."""
        waves = [(term.z, term.w) for term in self.terms(sigma)]
        G = self.receptance(sigma, self.border.distances, slope=False)[0]
        A = self.border.at(_K, sigma, G)
        return _K.matrix(scattered(_K, self.row, A, waves, self.upper, np.exp))

    def multipliers(self, sigma: Any) -> Complexes:
        """The roots z of Δ̂(·, σ), ascending in modulus, shape (len(σ), n).

        Those of modulus far from 1, beyond 1e±12, are known to be so, but not to many digits.
        """
        sigma = np.atleast_1d(np.asarray(sigma, complex))
        S, up = self.scatterer(sigma), self.upper
        n = S.shape[-1]
        left, right = np.zeros_like(S), np.zeros_like(S)  # (left − z right)[a; b] = 0
        left[:, :up], right[:, up:] = S[:, :up], S[:, up:]
        left[:, range(up, n), range(up, n)] = 1
        right[:, range(up), range(up)] = 1
        # (z − t)/(z + t) is bounded for all z but −t, a point off the circle
        t = 0.9 * _TURN
        m = np.linalg.eigvals(np.linalg.solve(left + t * right, left - t * right))
        with np.errstate(all="ignore"):
            z = t * (1 + m) / (1 - m)
        return np.take_along_axis(z, np.argsort(np.abs(z), -1), -1)

    def middle(self, sigma: Any) -> tuple[Complexes, Complexes]:
        """The two middle roots by modulus, z_{n₊} and z_{n₊+1}: what runs ahead, and what runs back."""
        z = self.multipliers(sigma)
        return z[:, self.upper - 1], z[:, self.upper]


def scattered(
    K: Arithmetic, row: Row, A: Any, waves: Sequence[tuple[Any, Any]], upper: int, exp: Callable[[Any], Any]
) -> list[list[Any]]:
    """S with [a'; b'] = S [a; b], rows of scalars.

    waves: (P, N/D_P) of the p-roots, the upper ones first. A: the matrix of the vehicle alone, with all contacts.
    """
    places, d, bodies = [row.reduced.places[k] for k in row.reduced.index], row.step, row.reduced.bodies
    x = [place - places[0] + (d - (places[-1] - places[0])) / 2 for place in places]
    n, zero = len(waves), [waves[0][0] * 0]

    def wave(k: int, xi: Fraction) -> Any:
        return exp(waves[k][0] * K.number(xi))

    # the field of each wave at each contact, and what a force at each contact gives to each wave at its exit
    field = [[wave(k, at if k < upper else at - d) for k in range(n)] for at in x]
    ahead = [[-waves[k][1] * wave(k, d - at) for at in x] for k in range(upper)]
    back = [[waves[k][1] * wave(k, -at) for at in x] for k in range(upper, n)]
    forces = K.solve(A, K.matrix([zero * n] * bodies + field))
    S = K.product(K.matrix([zero * bodies + given for given in ahead + back]), forces)
    own = [wave(k, d if k < upper else -d) for k in range(n)]
    return [[K.entry(S, i, j) + own[i] if i == j else K.entry(S, i, j) for j in range(n)] for i in range(n)]
