"""Δ̂ and the receptances in float64 for arrays of σ: quick, without proof.

Sums of residues at the p-roots; companion matrices for those σ at which two roots of one side nearly meet, where
residues cancel.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering, distances_of
from mpsolve.characteristic.follow import cancelled, followed, upper_first
from mpsolve.characteristic.receptance import by_companions
from mpsolve.characteristic.splitting import float_splitting, monic, upper_count
from mpsolve.characteristic.symbol import Coefficients, Symbols, Terms, horner
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Truths
from mpsolve.numbers.float64 import Float64, gaps, log_slope
from mpsolve.numbers.jets import U
from mpsolve.problem.reduced import Guide, Reduced

_K = Float64()
_AT_ONCE = 2**20  # entries of the matrices whose steps are taken at once
_LOST = 1e-13
"""What residues of close p-roots may lose in float64 before companion matrices take their place."""
_TIE = 1e-9  # how near the imaginary axis a p-root is whose side rounding may change, relative to the largest
_WRONG = 1e-6
"""Of G, or of the distance of a p-root to the next one: what is too much."""


@frozen
class Receptance:
    """Ĝ of a moving track (scaled units) on arrays of σ with Re σ ≥ 0, and as far below as no cut lies between."""

    guide: Guide

    @cached_property
    def symbols(self) -> Symbols:
        return Symbols.of(self.guide)

    @cached_property
    def upper(self) -> int:
        """n₊, proved."""
        return upper_count(self.symbols.D)

    def roots(self, sigma: Any) -> Complexes:
        """The p-roots, shape (len(σ), degree), upper ones first; quick where neighbours in σ are near each other."""
        z = followed(np.stack(self.symbols.at(_K, sigma).D, -1))
        return upper_first(z, self.upper, lambda rows, at: self.symbols.at(_K, sigma[rows, None]).drift(at))

    def _simple(self, sigma: Any) -> tuple[Coefficients, Complexes]:
        """What tells of simple p-roots, and these to the last digit."""
        local = self.symbols.at(_K, sigma[:, None])
        return local, local.newton(self.roots(sigma))

    def __call__(
        self, sigma: Any, xi: Sequence[Fraction], slope: bool = True
    ) -> tuple[list[Complexes], list[Complexes]]:
        """G(ξ, σ) for each exact ξ as arrays over σ, and where asked its slope in σ."""
        with np.errstate(all="ignore"):
            local, z = self._simple(sigma)
            found = Terms(z, local.weight(z), 0, 0) if not slope else local.terms(z)
            G, G_sigma = _sums(found, self.upper, [float(x) for x in xi], slope)
            near = cancelled(z, found.w, self.upper, slope, _LOST)
        if len(near):
            exact = self._together(sigma[near], z[near], xi, slope)
            for rows, better in zip((G, G_sigma), exact, strict=True):
                for row, values in zip(rows, better, strict=True):
                    row[near] = values
        return G, G_sigma

    def between(self, sigma: Any, places: Sequence[Fraction]) -> Any:
        """G between the places, shape (len(σ), places, places)."""
        distances, which = distances_of(places)
        return np.moveaxis(np.array(self(sigma, distances, slope=False)[0])[np.array(which)], -1, 0)

    def doubtful(self, sigma: Any, farthest: float) -> Truths:
        """Where p-roots may be off by so much that G is wrong in the sixth digit as far as `farthest`; an estimate.

        A root is known to what rounding D there does to it. Its side is not known where that reaches over the axis
        while a neighbour is near, and companion matrices lose what their largest coefficient is above 1.
        """
        with np.errstate(all="ignore"):
            local, z, up = self.symbols.at(_K, sigma[:, None]), self.roots(sigma), self.upper
            off = 16 * U * horner([abs(c) for c in local.D], abs(z)) / abs(horner(local.D_P, z))
            apart = gaps(z)
            beside = np.abs(z.real) <= 100 * off + _TIE * np.abs(z).max(-1, keepdims=True, initial=0)
            unclear = (beside & (off > _WRONG * apart.min(-1, initial=np.inf))).any(-1)
            sizes = [np.abs(c) for side in (z[:, :up], z[:, up:]) for c in monic(list(side.T))]
            together = 64 * U * max(1.0, farthest) * np.max([np.ones(len(z)), *sizes], 0) > _WRONG
            alone = (off * farthest > _WRONG).any(-1)
            meet = np.isin(np.arange(len(z)), cancelled(z, local.weight(z), up, False, _LOST))
            found: Truths = unclear | np.where(meet, together, alone) | ~np.isfinite(z).all(-1)
            return found

    def _together(
        self, sigma: Any, z: Any, xi: Sequence[Fraction], slope: bool
    ) -> tuple[list[Complexes], list[Complexes]]:
        """The same from the p-roots z, also where some of one side meet; slower."""
        local, numbers = self.symbols.at(_K, sigma), [_K.number(x) for x in xi]
        split = float_splitting(local.D, z, self.upper)
        return by_companions(_K, local, split, numbers, [x >= 0 for x in xi], slope)

    def terms(self, sigma: Any) -> Terms:
        """The terms of all p-roots, upper ones first, shape (len(σ), degree), where they are simple."""
        with np.errstate(all="ignore"):
            local, z = self._simple(sigma)
            return local.terms(z)

    def waves(self, sigma: Any) -> Complexes:
        """The p-roots, upper ones first, to the last digit where they are simple."""
        with np.errstate(all="ignore"):
            return self._simple(sigma)[1]


def _sums(terms: Terms, up: int, xi: Sequence[float], slope: bool) -> tuple[list[Complexes], list[Complexes]]:
    """The terms of the first `up` roots where ξ ≥ 0, and minus those of the others where ξ < 0."""
    G, G_sigma = [], []
    for x in xi:
        side, sign = (slice(0, up), 1) if x >= 0 else (slice(up, None), -1)
        wave = sign * np.exp(terms.z[:, side] * x)
        G.append((terms.w[:, side] * wave).sum(-1))
        if slope:
            G_sigma.append(((terms.a[:, side] + terms.b[:, side] * x) * wave).sum(-1))
    return G, G_sigma


@frozen
class Floats:
    """Δ̂ of a problem on arrays of σ."""

    reduced: Reduced

    @cached_property
    def receptance(self) -> Receptance:
        return Receptance(self.reduced.guide)

    @cached_property
    def border(self) -> Bordering:
        return Bordering.of(self.reduced)

    def matrices(self, sigma: Any) -> tuple[Any, Any]:
        """A(σ) and A'(σ), shape (len(σ), n, n)."""
        sigma = np.atleast_1d(np.asarray(sigma, complex))
        G, G_sigma = self.receptance(sigma, self.border.distances)
        return self.border.at(_K, sigma, G), self.border.slope_at(_K, sigma, G, G_sigma)

    def matrix(self, sigma: Any) -> Any:
        """A(σ) alone."""
        return self.border.at(_K, sigma, self.receptance(sigma, self.border.distances, slope=False)[0])

    def step(self, sigma: Any, known: Any) -> Any:
        """Newton's step to a zero of Δ̂, the known ones divided out. σ: an array; large matrices are few at a time."""
        most = max(1, _AT_ONCE // (self.reduced.bodies + self.reduced.contacts) ** 2)
        with np.errstate(all="ignore"):
            parts = [log_slope(*self.matrices(sigma[k : k + most])) for k in range(0, len(sigma), most)]
            slope = np.concatenate([sigma[:0], *parts])
            for zero in known:
                slope = slope - 1 / (sigma - zero)
            return -1 / slope

    def delta(self, sigma: Any) -> tuple[Complexes, Complexes]:
        """Δ̂ and dΔ̂/dσ on an array of σ."""
        return det_and_slope(*self.matrices(sigma))


def det_and_slope(A: Any, A_sigma: Any) -> tuple[Any, Any]:
    """Determinants of matrices and their slopes, where A is singular too, as at a root itself."""
    value, slope = np.linalg.det(A), np.empty(len(A), complex)
    regular = value != 0
    turned = np.linalg.solve(A[regular], A_sigma[regular]).trace(axis1=-2, axis2=-1)
    slope[regular] = value[regular] * turned
    slope[~regular] = (_adjugate(A[~regular]) @ A_sigma[~regular]).trace(axis1=-2, axis2=-1)
    return value, slope


def _adjugate(A: Complexes) -> Any:
    """For singular matrices too, from singular values."""
    left, sizes, right = np.linalg.svd(A)
    n = A.shape[-1]
    others = np.stack([np.delete(sizes, k, -1).prod(-1) for k in range(n)], -1)
    turn = np.linalg.det(left) * np.linalg.det(right)
    return turn[:, None, None] * (right.conj().swapaxes(-1, -2) * others[:, None, :]) @ left.conj().swapaxes(-1, -2)
