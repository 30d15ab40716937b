"""The receptance of a family over boxes: residues where p-roots stay apart, circles where some of one side meet."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import distances_of
from mpsolve.characteristic.boxes import Boxes, FreeTrack, Wave
from mpsolve.characteristic.circles import by_circles
from mpsolve.characteristic.free_roots import Roots, roots_over
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.float64 import gaps
from mpsolve.numbers.forms import Forms
from mpsolve.numbers.jets import TINY, UP
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.problem.family import Family

_TOGETHER = 0.3  # two roots of one side that are closer than this share of their distance to others may meet
_FAINT = 2.0**-16  # of the strongest wave at the force: of which no more may be said than a bound
_FOLLOWED = (
    2.0**-6
)  # of the bound: a model that leaves out less is kept, so that small boxes tell what long trains need


@dataclass(frozen=True)
class Receptances:
    """G at each distance as models of shape (boxes, distances), where it is bounded.

    strain[v]: how far variable v moves p-roots, relative to the distance of the next one, and turns waves.
    """

    G: Quadratic
    good: Truths
    strain: Reals

    @property
    def absorbed(self) -> tuple[Complexes, Reals]:
        """(coefficients of −Im Ĝ along the variables, a bound of what they leave out), see `positive_definite`."""
        with np.errstate(all="ignore"):
            H = (self.G.k - np.swapaxes(self.G.k.conj(), 2, 3)) * 0.5j
            E = (self.G.e + np.swapaxes(self.G.e, 1, 2)) / 2 * UP
            return np.swapaxes(H, 0, 1), E

    def take(self, rows: Integers) -> Receptances:
        """Those of some boxes."""
        return Receptances(self.G[rows], self.good[rows], self.strain[:, rows])


@dataclass(frozen=True)
class FreeReceptance:
    """G between the places of a family over boxes."""

    family: Family

    @cached_property
    def track(self) -> FreeTrack:
        return FreeTrack(self.family)

    @cached_property
    def distances(self) -> tuple[Forms, Truths, Integers]:
        """(the different distances as forms, which are at least 0, for each pair of places the number of its own)."""
        exact, which = distances_of(self.family.places)
        forms = Forms.of([{(0, *e): c for e, c in x} for x in exact], self.track.variables)
        return forms, np.arange(len(exact)) >= which[0][0], np.array(which)

    def __call__(self, boxes: Boxes) -> Receptances:
        """Over each box."""
        with np.errstate(all="ignore"):
            y, rho = boxes.variables
            D, N = self.track.D(y, rho), self.track.N(y, rho)
            forms, ahead, which = self.distances
            xi = forms(y, rho)
            z, low = self.track.nodes(D)
            roots = roots_over(D, N, z, low, self.track.up)
            strain = roots.strain.copy()
            k = np.zeros((len(xi.k), boxes.count, len(ahead)), complex)
            e = np.full((boxes.count, len(ahead)), np.inf)
            sides = [(mask, upper) for mask, upper in ((ahead, True), (~ahead, False)) if mask.any()]
            for mask, upper in sides:
                own = (np.arange(z.shape[1]) < self.track.up) == upper
                rows = np.flatnonzero(roots.good[:, own].all(1) & (low > 0))
                part, turned = residues(roots, rows, own, xi[rows][:, mask], self.distances[0].fixed)
                strain[:, rows] += turned
                _put(k, e, rows, mask, part if upper else -part)
            good = np.isfinite(e).all(1) & np.isfinite(k).all((0, 2))
            rest = np.flatnonzero(~good & may_meet(z, self.track.up))
            if len(rest):
                whole = self.track.split(boxes.take(rest))
                inside = np.flatnonzero(whole.good)
                strain[:, rest] = whole.strain
                rows = rest[inside]
                self._circled(whole.take(inside), N[rows], xi[rows], sides, rows, k, e)
                good[rows] = np.isfinite(e[rows]).all(1) & np.isfinite(k[:, rows]).all((0, 2))
            return Receptances(Quadratic(k, e, xi.m)[:, which], good, strain)

    def _circled(
        self,
        wave: Wave,
        N: Quadratic,
        xi: Quadratic,
        sides: list[tuple[Truths, bool]],
        rows: Integers,
        k: Any,
        e: Reals,
    ) -> None:
        if len(rows):
            for mask, upper in sides:
                _put(k, e, rows, mask, by_circles(wave, N, xi[:, mask], upper, self.distances[0].fixed))


def _put(k: Any, e: Reals, rows: Integers, mask: Truths, part: Quadratic) -> None:
    at = np.ix_(rows, np.flatnonzero(mask))
    k[:, at[0], at[1]], e[at] = part.k, part.e


def residues(roots: Roots, rows: Integers, own: Truths, xi: Quadratic, fixed: bool) -> tuple[Quadratic, Any]:
    """(Σ e^{Pξ} N/D_P over the roots of one side, shape (boxes, distances), how each variable turns the waves)."""
    if not own.any():
        return Quadratic(np.zeros(xi.k.shape, complex), np.zeros(xi.e.shape), xi.m), 0.0
    P, weight = (f[rows][:, own][:, :, None] for f in (roots.P, roots.weight))
    x = Quadratic(xi.k[:, :, None, :], xi.e[:, None, :], xi.m)
    phase = P.times(xi.a[:, None, :]) if fixed else P * x
    turned = (np.abs(phase.b) * np.exp(np.minimum(phase.a.real, 0.0))).max((2, 3))
    return grown(phase, weight).sum(-2), turned


def grown(phase: Quadratic, weight: Quadratic) -> Quadratic:
    """weight e^phase; a wave that has all but died away is bounded only, where it turns too fast to be followed."""
    model = phase.exp() * weight
    most = phase.a.real + phase.spread
    bound = np.exp(np.minimum(most, 700.0)) * (1 + 1e-12) * weight.size + TINY
    faint = (most < 0) & (bound < _FAINT * np.abs(weight.a).max(1, keepdims=True)) & ~(model.e < _FOLLOWED * bound)
    return Quadratic(np.where(faint, 0, model.k), np.where(faint, bound, model.e), model.m)


def may_meet(z: Any, up: int) -> Any:
    """Boxes with two roots of one side so close that they may meet, in floats."""
    gap, upper = gaps(z), np.arange(z.shape[1]) < up
    same = upper[:, None] == upper[None, :]
    other = np.where(upper[:, None] != upper[None, :], gap, np.inf).min(2)
    near = gap < _TOGETHER * np.minimum(other[:, :, None], other[:, None, :])
    return (near & same).any((1, 2))
