"""−Im G(0, q) > 0 for one contact, for all q > 0 and all velocities of an interval: boxes of (q, v), halved in turn.

Boxes that hold q = 0 are of −Im G/q. The waves of the track decide nearly all. As v → 0 some tracks lose a wave, that
runs to infinity: boxes that reach there are decided by integrals over cells of wavenumber. So are those where a part
of the track vibrates without damping, and does not move the rail: there waves meet at p = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.passivity.blocks import passive_on
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far import far
from mpsolve.passivity.germ import Germ, germ
from mpsolve.passivity.near import Near
from mpsolve.passivity.subject import Subject
from mpsolve.passivity.waves import Waves
from mpsolve.problem.reduced import Guide
from mpsolve.proof.effort import Effort

_COARSE, _FINE = 12, 384  # cells on each side of a wave: twice as many after every second halving
_SLOW = 8  # halvings after which all boxes are looked at by integrals over wavenumber, and from which some are
_DEEPEST = 30


@dataclass(frozen=True)
class Moving:
    """A track at rest, scaled, with one contact and the velocity free; upper: how many p-roots lie ahead."""

    guide: Guide
    upper: int

    @cached_property
    def subject(self) -> Subject:
        return Subject.of_guide(self.guide, free_velocity=True)

    @cached_property
    def waves(self) -> Waves:
        """Its p-roots over boxes of (q, v)."""
        return Waves(self.guide, self.upper)

    @property
    def loses_a_wave(self) -> bool:
        """Whether D is of a lower degree in P at rest."""
        return max(i for i, _ in self.guide.D_rest) < max(i + j for i, j in self.guide.D_rest)

    def germ(self, sigma: Any, v: Any, order: int) -> Germ:
        """The germ of G(0, σ) at balls of σ and of the scaled velocity."""
        return germ(self.guide.D_rest, self.guide.N_rest, self.upper, sigma, v, order)


@dataclass(frozen=True)
class Strip:
    """The velocities low ≤ v ≤ high (scaled floats), and X, beyond which all q are proved; None: nowhere."""

    moving: Moving
    low: float
    high: float

    @cached_property
    def envelope(self) -> Envelope:
        return Envelope(self.moving.subject, (self.low,), (self.high,))

    @cached_property
    def X(self) -> float | None:
        return far(self.envelope, least=0.25)


def cover(strip: Strip, first: float, effort: Effort) -> Reals:
    """The boxes (q, q', v, v') with q ≥ first that stay open: none where −Im G(0, q) > 0 is proved for q > first.

    first = 0: for all q > 0, with the limit of −Im G/q at 0 positive too.
    """
    if strip.X is None:
        return np.array([[first, np.inf, strip.low, strip.high]])
    start = first if first else 0.1
    near = Near(strip.moving.subject, (strip.low,), (strip.high,), max(start, 0.1))
    count = max(1, int(np.ceil(np.log2(max(strip.X / start, 1.0)))))
    ends = np.geomspace(start, max(strip.X, start * 1.01), count + 1)
    if not first:
        ends = np.concatenate([[0.0], ends])
    boxes = np.array([[a, b, strip.low, strip.high] for a, b in pairwise(ends.tolist())])
    for level in range(_DEEPEST):
        if not len(boxes):
            break
        effort.spend(len(boxes))
        boxes = _halved(boxes[~_passed(strip, near, boxes, level)], strip.high)
    return boxes


def _passed(strip: Strip, near: Near, boxes: Reals, level: int) -> Any:
    low, high = boxes[:, [0, 2]], boxes[:, [1, 3]]
    passed = strip.moving.waves.passes(low.T, high.T)
    slow = ~passed & (2 * boxes[:, 2] <= boxes[:, 3] if strip.moving.loses_a_wave else level == _SLOW)
    if level < _SLOW or not slow.any():
        return passed
    side = min(_COARSE * 2 ** (level // 2), _FINE)
    below = slow & (boxes[:, 1] <= near.reach)
    passed[below] = near.passes(low[below], high[below], side)
    rest = slow & ~passed & (boxes[:, 0] > 0)
    passed[rest] = passive_on(strip.envelope, low[rest], high[rest], side)
    return passed


def _halved(boxes: Reals, high: float) -> Reals:
    """Each in two: in q or in v, whichever moves q − vp more at wavenumbers about 1 (scaled), and at q/v beyond."""
    if not len(boxes):
        return boxes
    a, b, c, d = boxes.T
    by_q = (b - a) * high > 2 * (d - c) * np.maximum(b, 1.0)
    between = np.where(by_q, np.where(a > 0, np.sqrt(a * b), b / 2), c / 2 + d / 2)
    first, second = boxes.copy(), boxes.copy()
    rows = np.arange(len(boxes))
    first[rows, np.where(by_q, 1, 3)] = between
    second[rows, np.where(by_q, 0, 2)] = between
    return np.concatenate([first, second])
