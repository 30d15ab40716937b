"""What blocks of wavenumber take at high frequencies, and what short waves give, over a box: parts of `far`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.affine import Affine, between, constant
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import UP
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.power import Terms, value
from mpsolve.passivity.subject import Subject, cells

_SIDE = 9  # of the mesh
_FINE = 4  # parts of each cell of the mesh
_LEVELS = 64  # of what is taken, at most
_ROUNDED = 2.0**-40  # more than what the ends of a run lose
_PRICE = 0.03  # of a further block, of all that is absorbed
MARGIN = 1 + 2.0**-20
"""Of what is taken over what is given: for the rounding of the sums."""


def given_from(envelope: Envelope, X: float, gap: float | None) -> float:
    """What short waves give at most at q = X."""
    p, alpha = X / envelope.fastest / UP, envelope.subject.power.alpha
    C = float(envelope.constants(np.array([p]))[0])
    sieve = 2 * np.pi / gap if gap is not None else 0.0
    return C * (p ** (1 - alpha) / (alpha - 1) + sieve * p**-alpha) * MARGIN


def layered(p: Reals, least: Any, sieve: float) -> float:
    """A lower bound of ∫ f |V|² dp for Σ|u|² = 1, where f ≥ `least` on the cells between the ends p.

    f is at least the sum of κ_n − κ_{n−1} over the n with f ≥ κ_n, for any 0 = κ_0 < κ_1 < …; and ∫ |V|² over an
    interval is at least its length less `sieve`, or 0. So runs of cells count at each level, which is more than what
    blocks of one level take.
    """
    if not sieve:
        return float((least * (p[1:] - p[:-1])).sum())
    levels = np.unique(least[least > 0])
    levels = levels[:: -(-len(levels) // _LEVELS) or 1]
    inside = least >= levels[:, None]
    edge = np.zeros((len(levels), 1), bool)
    turns = np.diff(np.concatenate([edge, inside, edge], 1).astype(np.int8), axis=1)
    rows, first = np.nonzero(turns > 0)
    last = np.nonzero(turns < 0)[1]
    length = (p[last] - p[first]) * (1 - _ROUNDED) - sieve - _ROUNDED * (np.abs(p[last]) + np.abs(p[first]))
    steps = np.diff(levels, prepend=0.0)
    return float((np.maximum(length, 0.0) * steps[rows]).sum())


def best_blocks(z: Reals, least: Reals, growth: float, sieve: float) -> tuple[tuple[float, float, float], ...]:
    """Disjoint runs of cells between the ends z, with the least value on each, that take most; few of them.

    What a run takes: (length·growth − sieve)·least value.
    """
    used = np.flatnonzero(least > 0)
    if not len(used):
        return ()
    z, least = z[used[0] : used[-1] + 2], least[used[0] : used[-1] + 1]
    n = len(z)
    later = np.arange(n - 1) >= np.arange(n - 1)[:, None]
    kappa = np.zeros((n, n))
    kappa[:-1, 1:] = np.where(later, np.minimum.accumulate(np.where(later, least, np.inf), axis=1), 0.0)
    value = np.maximum((z[None, :] - z[:, None]) * growth - sieve, 0.0) * kappa
    price = 0.0
    for _ in range(2):
        best, before, gain = np.zeros(n), np.full(n, -1), np.maximum(value - price, 0.0).T.copy()
        for j in range(1, n):
            sums = best[:j] + gain[j, :j]
            before[j] = k = sums.argmax()
            best[j] = sums[k]
        price = _PRICE * float(best[-1])  # of a block, so that few are taken
    blocks, j = [], n - 1
    while j > 0:
        i = int(before[j])
        if value[i, j] > price:
            blocks.append((float(z[i]), float(z[j]), float(kappa[i, j])))
        j = i
    return tuple(reversed(blocks))


@dataclass(frozen=True)
class FarChart:
    """w, D_r, D_i in z², ω² and (τ, parameters), each times a power of τ; e with W/|D|² of order q^−e."""

    gamma: Fraction
    w: Terms
    real: Terms
    imaginary: Terms
    e: Fraction

    @staticmethod
    def of(subject: Subject, gamma: Fraction) -> FarChart:
        k, m = gamma.numerator, gamma.denominator
        power = subject.power

        def top(terms: Terms) -> int:
            return max((2 * k * key[0] + 2 * m * key[1] for key in terms), default=0)

        whole = max(top(power.real), top(power.imaginary) + m)

        def lifted(terms: Terms, to: int) -> Terms:
            return {(i, j, to - 2 * k * i - 2 * m * j, *rest): c for (i, j, *rest), c in terms.items()}

        own = top(power.w)
        return FarChart(
            gamma,
            lifted(power.w, own),
            lifted(power.real, whole),
            lifted(power.imaginary, whole - m),
            Fraction(2 * whole - own - m, m),
        )

    def taken(self, envelope: Envelope, parameters: list[Affine], X: float, gap: float | None, alpha: int) -> float:
        """A lower bound of what blocks take at q = X, if its quotient by what is given does not fall; else 0."""
        if not alpha - 1 >= self.e - self.gamma:
            return 0.0
        growth, sieve = self._scales(X, gap)
        z = self._ends(envelope, X, growth)
        if (z[-1] - z[0]) * growth < sieve:
            return 0.0
        total = layered(z * growth, self._least(envelope, parameters, z, X), sieve)
        return float(total * X ** -float(self.e) / MARGIN)

    def of_blocks(self, blocks: Sequence[tuple[float, float, float]], X: float, gap: float | None) -> float:
        """What blocks take at q = X."""
        growth, sieve = self._scales(X, gap)
        total = sum(max((z2 - z1) * growth - sieve, 0.0) * kappa for z1, z2, kappa in blocks)
        return float(total * X ** -float(self.e) / MARGIN)

    def blocks(
        self, envelope: Envelope, parameters: list[Affine], X: float, gap: float | None
    ) -> tuple[tuple[float, float, float], ...]:
        """Intervals of z with a lower bound κ of what they take."""
        growth, sieve = self._scales(X, gap)
        z = self._ends(envelope, X, growth)
        least = self._least(envelope, parameters, z, X)
        return best_blocks(z, least, growth, sieve)

    def _scales(self, X: float, gap: float | None) -> tuple[float, float]:
        return X ** float(self.gamma), 2 * np.pi / gap if gap is not None else 0.0

    def _ends(self, envelope: Envelope, X: float, growth: float) -> Reals:
        low, high = np.array([envelope.low]), np.array([envelope.high])
        own = ((high - low) / np.maximum(np.abs(high + low), 1e-300)).max(1, initial=0.0)
        ends = np.unique(
            [cells(envelope.subject, np.array([X]), (low + high) / 2, spread, _SIDE)[0] / growth
             for spread in (np.array([0.2]), np.clip(own, 1e-4, 0.1))]
        )  # fmt: skip
        parts = np.arange(_FINE) / _FINE
        fine = ends[:-1, None] + (ends[1:] - ends[:-1])[:, None] * parts
        return np.unique(np.append(fine.ravel(), ends[-1]))

    def _least(self, envelope: Envelope, parameters: list[Affine], z: Reals, X: float) -> Reals:
        """Lower bounds of q^e W/|D|² on the cells of z, for all q ≥ X; 0 where it may give."""
        k, m = self.gamma.numerator, self.gamma.denominator
        with np.errstate(all="ignore"):
            at = between(z[:-1], z[1:], "p")
            tau = between(np.zeros(1), np.full(1, X ** (-1 / m) * MARGIN), "q")
            omega = at * envelope.subject.speed(parameters)
            for _ in range(m - k):
                omega = omega * tau
            omega = constant(Fraction(1)) - omega
            y, square = at.square(), omega.square()
            w, real, imaginary = (
                value(a, y, square, [tau, *parameters]) for a in (self.w, self.real, self.imaginary)
            )
            bottom = real.square() + square * imaginary.square()
            kappa = np.maximum(omega.low, 0) * np.maximum(w.low, 0) / bottom.high / UP
        return np.where(np.isfinite(kappa), kappa, 0.0) * np.ones(len(z) - 1)
