"""The endless row over boxes (σ on a disc, z on an arc of the unit circle): rigorous, in float64 arrays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import distances_of
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import Splittings, split
from mpsolve.characteristic.path import discs
from mpsolve.characteristic.residues import at_distances, waves
from mpsolve.endless.lattice import first_force
from mpsolve.endless.row import Row
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.jets import Jet, U, nearest
from mpsolve.proof.definite import positive
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import subdivide
from mpsolve.proof.turning import regular

ROUND = 3.1416
"""The arcs from −ROUND to ROUND are the whole circle, and a little more."""
_SMALLEST = 2.0**-22


@frozen
class LatticeArrays(Arrays):
    """The reduced problem of one vehicle of a row, whose receptance between places is the sum over the row.

    `evaluate` gives it at z = 1: all vehicles move alike.
    """

    step: Fraction = Fraction(0)

    @staticmethod
    def of(row: Row) -> LatticeArrays:
        return LatticeArrays(row.reduced, row.step)

    def evaluate(self, m: Complexes, r: Reals, up: int, nodes: Any = None) -> tuple[Splittings, Jet, Truths]:
        """(splittings, Ĝ(1, σ) between the places as jets, where it is bounded)."""
        s = split(self.D, m, r, up, nodes)
        G, good, _ = self.on_arcs(s, np.ones(len(m), complex), np.zeros(len(m)))
        return s, G, good

    def on_arcs(self, s: Splittings, z: Complexes, off: Reals) -> tuple[Jet, Truths, Truths]:
        """(Ĝ for all z of the circle within `off` of the given ones, where bounded, where p-roots are told apart)."""
        with np.errstate(all="ignore"):
            weight, P, told = waves(self.N, self.D, s)
            jet = self._sums(weight, P, s.up, z, off + 8 * U)
        good = told & np.isfinite(jet.e).all(1) & np.isfinite(jet.a).all(1)
        return jet[:, self.distances[1]], good, told

    def _sums(self, weight: Jet, P: Jet, up: int, z: Complexes, off: Reals) -> Jet:
        """Ĝ at each distance (lattice.py), shape (discs, distances)."""
        exact, sides = distances_of(self.reduced.places)[0], []
        for part, ahead in ((slice(0, up), True), (slice(up, None), False)):
            step, p = nearest(self.step if ahead else -self.step), P[:, part]
            ratio = (p * step).exp() * _power(z, off, [-1 if ahead else 1], P.r)
            over = (-ratio + 1.0).inverse()
            xi, powers = zip(*(first_force(a, self.step, ahead) for a in exact), strict=True)
            sums = at_distances(p, weight[:, part] * over, np.array([nearest(x) for x in xi]))
            sides.append(sums * _power(z, off, powers, P.r))
        return sides[0] + -sides[1]


def _power(z: Complexes, off: Reals, powers: Sequence[int], r: Reals) -> Jet:
    """z^m, m = −1, 0 or 1, shape (discs, len(powers)), for z on the unit circle within `off`."""
    m, point = np.array(powers), z[:, None]
    a = np.where(m > 0, point, np.where(m < 0, point.conj(), 1.0 + 0j))
    return Jet(a, 0 * a, np.where(m != 0, np.asarray(off)[:, None], 0.0), r)


Test = Callable[[Any, Any], tuple[Any, Any]]
"""(low, high) of boxes in (τ, θ), shape (2, boxes) → (which pass, the variable along which to halve them)."""


def covered(test: Test, effort: Effort) -> int:
    """The number of boxes that pass and are the whole of 0 ≤ τ ≤ 1 and of the circle together.

    PrecisionError with the place where no box passes at the smallest size; a spent effort raises EffortError.
    """
    whole = np.array([1.0, 2 * ROUND])

    def judge(low: Reals, high: Reals) -> tuple[Any, Integers]:
        passed, axis = test(low, high)
        narrow = (high - low <= _SMALLEST * whole[:, None])[axis, np.arange(len(axis))]
        for k in np.flatnonzero(~passed & narrow)[:1]:
            tau, theta = (low[:, k] + high[:, k]) / 2
            raise PrecisionError(f"the smallest boxes do not pass near τ = {tau:.6g}, θ = {theta:.6g}")
        return passed.astype(np.int8), axis

    found = subdivide([0.0, -ROUND], [1.0, ROUND], judge, effort, _SMALLEST)
    if found.reason is not None:
        raise EffortError(found.reason)
    return int((found.tree.kind > 0).sum())


@frozen
class Boxes:
    """Tests for boxes in (τ, θ): q̂ = start + τ·(end − start), 0 ≤ τ ≤ 1, a piece of a path; z = e^{iθ}."""

    arrays: LatticeArrays
    up: int

    def _test(self, start: complex, end: complex, judged: Callable[..., tuple[Any, Any, Any]]) -> Test:
        """judged(m, r, G, piece) → (which pass, how much σ moves, what the rest is); piece: from start to end."""
        way = end - start

        def test(low: Reals, high: Reals) -> tuple[Truths, Integers]:
            a, b = start + low[0] * way, start + high[0] * way
            m, r = discs(a, b)
            middle, half = (low[1] + high[1]) / 2, (high[1] - low[1]) / 2
            off = half * (1 + 8 * U) + 16 * U  # a chord is shorter than its arc; θ and its cosine are rounded
            with np.errstate(all="ignore"):
                G, good, told = self.arrays.on_arcs(split(self.arrays.D, m, r, self.up), np.exp(1j * middle), off)
                fine, by_sigma, by_rest = judged(m, r, G, b - a)
            return good & fine, _axis(low, high, by_sigma, by_rest, told)

        return test

    def regular(self, start: complex, end: complex) -> Test:
        """A test: Δ̂(z, σ) ≠ 0 on the whole box."""

        def judged(m: Complexes, r: Reals, G: Jet, _: Complexes) -> tuple[Truths, Reals, Reals]:
            A = self.arrays.matrix(G, m)
            found = regular(A)
            by_sigma = (np.abs(found.R @ A.b) * r[:, None, None]).sum((1, 2))
            return found.good, by_sigma, (np.abs(found.R) @ A.e).sum((1, 2))

        return self._test(start, end, judged)

    def passive(self, start: complex, end: complex) -> Test:
        """A test: σĜ has a positive definite Hermitian part on the whole box."""

        def judged(m: Complexes, r: Reals, G: Jet, piece: Complexes) -> tuple[Truths, Reals, Reals]:
            sigma = Jet(m[:, None, None], np.ones((len(m), 1, 1), complex), np.zeros((len(m), 1, 1)), r)
            V = sigma * G
            fine = positive(V, 1j * piece / np.abs(piece), 64 * U * (np.abs(m) + r))
            return fine, (np.abs(V.b) * r[:, None, None]).sum((1, 2)), V.e.sum((1, 2))

        return self._test(start, end, judged)


def _axis(low: Reals, high: Reals, by_sigma: Reals, by_rest: Reals, told: Truths) -> Integers:
    """Along what to halve: θ where the rest is larger than what σ moves, and arcs are not already the finer part.

    Where the p-roots are not told apart only shorter pieces help.
    """
    long_ = (high[1] - low[1]) / (2 * ROUND) > (high[0] - low[0]) / 16
    with np.errstate(all="ignore"):
        rest = ~(by_sigma > by_rest)
    return np.where(rest & long_ & told, 1, 0)
