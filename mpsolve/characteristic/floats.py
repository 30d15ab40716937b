"""Δ̂ and the receptances in float64 for arrays of σ: quick, without proof.

Sums of residues at the p-roots; companion matrices for those σ at which two roots of one side nearly meet, where
residues cancel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.follow import eigenvalues, followed
from mpsolve.characteristic.receptance import Coefficients, by_companions
from mpsolve.characteristic.splitting import Splitting, monic, sharpened, upper_count
from mpsolve.characteristic.symbol import Symbols, horner, slope_in_P
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Truths
from mpsolve.numbers.float64 import Float64
from mpsolve.numbers.jets import U
from mpsolve.problem.reduced import Guide, Reduced

_K = Float64()
_NEAR = 0.15
"""Roots of one side that are nearer than this, relative to the larger, are taken together."""
_TIE = 1e-9
_AHEAD = 1e-7
_LOST = 1e-6
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

    def roots(self, sigma: Any, along: bool = False) -> Complexes:
        """The p-roots, shape (len(σ), degree), upper ones first. along: neighbours in σ are near each other."""
        D = np.stack([np.broadcast_to(c, sigma.shape) for c in self.symbols.D.at(_K, sigma)], -1)
        z = followed(D) if along else eigenvalues(D)
        n = z.shape[1]
        key = z.real.copy()
        ranks = np.sort(key, -1)
        if 0 < self.upper < n:  # on the real axis, waves: those count that decay for Re σ > 0
            tie = ranks[:, self.upper] - ranks[:, self.upper - 1] < _TIE * np.abs(z).max(-1)
            if tie.any():
                key[tie] += _AHEAD * self._drift(sigma[tie], z[tie]).real
        elif n:
            return z
        return np.take_along_axis(z, np.argsort(key, -1), -1)

    def _drift(self, sigma: Any, z: Any) -> Any:
        """dP/dσ at the roots."""
        local = self._local(sigma)
        with np.errstate(all="ignore"):
            return np.nan_to_num(-horner(local.D_sigma, z) / horner(slope_in_P(local.D), z))

    def _local(self, sigma: Any) -> Coefficients:
        s = self.symbols
        return Coefficients(
            *([np.asarray(c)[..., None] for c in x.at(_K, sigma)] for x in (s.D, s.N, s.D_sigma, s.N_sigma))
        )

    def __call__(
        self, sigma: Any, xi: Sequence[Fraction], slope: bool = True
    ) -> tuple[list[Complexes], list[Complexes]]:
        """G(ξ, σ) for each exact ξ as arrays over σ, and where asked its slope in σ."""
        z = self.roots(sigma)
        near = self._meet(z)
        with np.errstate(all="ignore"):
            G, G_sigma = self._residues(sigma, z, xi, slope)
        if near.any():
            exact = self.together(sigma[near], z[near], xi, slope)
            for rows, better in zip((G, G_sigma), exact, strict=True):
                for row, values in zip(rows, better, strict=True):
                    row[near] = values
        return G, G_sigma

    def doubtful(self, sigma: Any, farthest: float) -> Truths:
        """Where p-roots may be off by so much that G is wrong in the sixth digit as far as `farthest`; an estimate.

        A root is known to what rounding D there does to it. Its side is not known where that reaches over the axis
        while a neighbour is near, and companion matrices lose what their largest coefficient is above 1.
        """
        z, local = self.roots(sigma), self._local(sigma)
        with np.errstate(all="ignore"):
            off = 16 * U * horner([abs(c) for c in local.D], abs(z)) / abs(horner(slope_in_P(local.D), z))
            apart = np.abs(z[:, :, None] - z[:, None, :]) + np.where(np.eye(z.shape[1]), np.inf, 0)
            beside = np.abs(z.real) <= 100 * off + _TIE * np.abs(z).max(-1, keepdims=True, initial=0)
            unclear = (beside & (off > _LOST * apart.min(-1, initial=np.inf))).any(-1)
            sizes = [np.abs(c) for side in self._sides(z) for c in monic([side[:, k] for k in range(side.shape[1])])]
            together = 64 * U * max(1.0, farthest) * np.max([np.ones(len(z)), *sizes], 0) > _LOST
            alone = (off * farthest > _LOST).any(-1)
            lost: Truths = unclear | np.where(self._meet(z), together, alone) | ~np.isfinite(z).all(-1)
            return lost

    def together(
        self, sigma: Any, z: Any, xi: Sequence[Fraction], slope: bool
    ) -> tuple[list[Complexes], list[Complexes]]:
        """The same from the p-roots z, also where some of one side meet; slower."""
        D = [np.broadcast_to(c, sigma.shape) for c in self.symbols.D.at(_K, sigma)]
        U, L = (list(monic([side[:, k] for k in range(side.shape[1])])) for side in self._sides(z))
        for _ in range(2):
            U, L = sharpened(_K, D, U, L)
        return by_companions(_K, self.symbols, Splitting(D[-1], tuple(U), tuple(L)), sigma, xi, slope)

    def waves(self, sigma: Any) -> tuple[Complexes, Complexes]:
        """The p-roots z, upper ones first, and the residues w of N/D there, where they are simple.

        G(ξ ≥ 0) is the sum of w e^{zξ} over the `upper` first, G(ξ < 0) minus that over the others.
        """
        local, z = self._local(sigma), self.roots(sigma, along=True)
        with np.errstate(all="ignore"):
            slope = slope_in_P(local.D)
            z = z - horner(local.D, z) / horner(slope, z)
            return z, horner(local.N, z) / horner(slope, z)

    def _sides(self, z: Any) -> tuple[Complexes, Complexes]:
        return z[:, : self.upper], z[:, self.upper :]

    def _meet(self, z: Any) -> Truths:
        """Where two roots of one side are near."""
        near = np.zeros(len(z), bool)
        for side in self._sides(z):
            one, other = side[:, :, None], side[:, None, :]
            reach = _NEAR * np.maximum(np.abs(one), np.abs(other))
            near |= (np.abs(one - other) < reach * (1 - np.eye(side.shape[1]))).any((1, 2))
        return near

    def _residues(
        self, sigma: Any, z: Any, xi: Sequence[Fraction], slope: bool
    ) -> tuple[list[Complexes], list[Complexes]]:
        local = self._local(sigma)
        z = z - horner(local.D, z) / horner(slope_in_P(local.D), z)
        terms = local.terms(z)
        ahead, behind = (
            replace(terms, z=z[:, part], w=terms.w[:, part], a=terms.a[:, part], b=terms.b[:, part])
            for part in (slice(0, self.upper), slice(self.upper, None))
        )
        G, G_sigma = [], []
        for x in map(float, xi):
            side, sign = (ahead, 1) if x >= 0 else (behind, -1)
            wave = sign * np.exp(side.z * x)
            G.append((side.w * wave).sum(-1))
            if slope:
                G_sigma.append(((side.a + side.b * x) * wave).sum(-1))
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
