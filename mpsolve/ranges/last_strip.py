"""A strip of velocities up to the very speed of short waves: no root is real there, by what is left of the waves.

As v rises to the speed c₀ one p-root P₀ ahead of the contacts runs to −∞, where the leading coefficient a_n vanishes;
the others are analytic through c₀. Behind, and at the contact itself, they tell all: the residues N/D_P of all
p-roots add up to 0, as N falls by two powers of P below D, so that

    G(0) = −Σ over P behind,    G(ξ) = −Σ e^{Pξ} N/D_P over P behind  (ξ < 0),

and ahead G(ξ) = Σ e^{Pξ} N/D_P over the finite P ahead, less e^{P₀ξ} Σ N/D_P over all finite P. There |e^{P₀ξ}| is
bounded at real points: Re P₀ = −Re a_{n−1}/a_n − Re Σ P over the finite ones. The finite ones are found like any
roots, as many as there are on each side, each alone in its disc, and on its side at the middle of a box: as none is
imaginary for real q and v of a damped track, at all its real points, also beyond c₀, of which nothing is said.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_receptance import FreeReceptance, Receptances, residues
from mpsolve.characteristic.free_roots import roots_over
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import rational_ball
from mpsolve.numbers.jets import UP, U
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.problem.family import Interval, family_of
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import subdivide
from mpsolve.ranges.answer import Proof
from mpsolve.ranges.judge import OUTSIDE, Judge
from mpsolve.ranges.on_string import passive_beyond
from mpsolve.ranges.premises import require_stable_track


@dataclass(frozen=True)
class LastReceptance(FreeReceptance):
    """Over boxes that may hold the speed, for a family of velocities that begin below it."""

    @cached_property
    def sign(self) -> int:
        """Of the leading coefficient, below the speed."""
        return 1 if self.family.guide([low for low, _ in self.family.box]).D[self.family.degree, 0] > 0 else -1

    def __call__(self, boxes: Boxes) -> Receptances:
        with np.errstate(all="ignore"):
            y, rho = boxes.variables
            D, N = self.track.D(y, rho), self.track.N(y, rho)
            forms, _, which = self.distances
            xi, up = forms(y, rho), self.track.up
            z, _ = self.track.nodes(D)
            far = np.abs(z[:, :up]).argmax(1)
            z = z[np.arange(z.shape[1]) != far[:, None]].reshape(len(z), -1)
            roots, rows, front = roots_over(D, N, z, np.ones(len(z)), up - 1), np.arange(len(z)), xi.e.shape[1]
            ahead, upper = np.arange(front) > which[0, 0], np.arange(z.shape[1]) < up - 1
            k, e = np.zeros((len(xi.k), *xi.e.shape), complex), np.full(xi.e.shape, np.inf)
            part, turned = residues(roots, rows, ~upper, xi[:, ~ahead], forms.fixed)
            k[:, :, ~ahead], e[:, ~ahead] = -part.k, part.e
            strain = roots.strain + turned
            if ahead.any():
                part, turned = residues(roots, rows, upper, xi[:, ahead], forms.fixed)
                lost = roots.weight.sum(-1).size[:, None] * faded(D, roots.P, xi[:, ahead], self.sign)
                k[:, :, ahead], e[:, ahead] = part.k, (part.e + lost) * UP
                strain = strain + turned
            good = roots.good.all(1) & np.isfinite(e).all(1) & np.isfinite(k).all((0, 2))
            return Receptances(Quadratic(k, e, xi.m)[:, which], good, strain)


def faded(D: Quadratic, P: Quadratic, xi: Quadratic, sign: int) -> Reals:
    """A bound of |e^{P₀ξ}| at the real points of boxes where the leading coefficient has this sign; at most 1."""
    first, lead, others = D[:, -2], D[:, -1], P.sum(-1)
    real = sign * first.k.real
    least = (real[0] - np.abs(real[1:]).sum(0) - first.e) * (1 - 64 * U)
    ends = least / lead.size / UP, others.a.real, others.spread
    Re_P = -ends[0] - ends[1] + ends[2] + (UP - 1) * (ends[0] + np.abs(ends[1]) + ends[2])
    shown = ((least > 0) & (Re_P < 0))[:, None]
    gap = np.maximum(xi.a.real - xi.spread, 0)
    return np.where(shown, np.exp(np.where(shown, Re_P[:, None] * gap, 0)) * UP * UP, 1.0)


class LastMatrix(FreeMatrix):
    """The characteristic matrix by that receptance. Its models hold at real points only."""

    @cached_property
    def receptance(self) -> FreeReceptance:
        return LastReceptance(self.family)


@dataclass
class LastJudge(Judge):
    """Boxes from `beyond` on are not asked about."""

    beyond: float = np.inf

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        kind, axis = super().__call__(low, high)
        kind[low[1] >= self.beyond] = OUTSIDE
        return kind, axis


def last_strip(problem: Problem, strip: Interval, speed: arb, budget: Effort) -> Proof | None:
    """That no root is real at any velocity from the start of the strip to the speed, a ball in it; None if open."""
    over = {"v": strip}
    family = family_of(problem, over)
    require_stable_track(family)
    X = passive_beyond(family, up_to_waves=True)
    unit, (low, high) = family.units[0], family.box[0]
    if X is None or not rational_ball(family.ring.point[0] * unit) < speed:
        return None
    a, b = np.array([0.0, np.nextafter(float(low), -np.inf)]), np.array([X, np.nextafter(float(high), np.inf)])
    beyond = float((speed / rational_ball(unit)).upper()) * UP
    judge = LastJudge(LastMatrix(family), None, (b - a) / 2, beyond=beyond)
    cover = subdivide(a, b, judge, budget)
    return Proof(over, family.units, family.frequency_unit, X, cover) if cover.reason is None else None
