"""−Im G(0, q) > 0 for one contact, for all q > 0 and all velocities of an interval: boxes of (q, v), halved in turn.

Boxes that hold q = 0 are of −Im G/q. Integrals over cells of wavenumber decide most of them, many at once; where what
is taken and what is given nearly balance, the germ of G does, box by box.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import acb, arb, precision
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
_GERMS = 11  # halvings from which single boxes are looked at by the germ
_SLOW = 14  # halvings from which boxes that the waves leave open are looked at by integrals over wavenumber
_DEEPEST = 26
_BITS = 80


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
        passed = _passed(strip, near, boxes, level)
        if level >= _GERMS:
            for k in np.flatnonzero(~passed):
                effort.spend(1)
                passed[k] = positive_by_germ(strip.moving, *boxes[k].tolist())
        boxes = _halved(boxes[~passed], level, strip.high)
    return boxes


def _passed(strip: Strip, near: Near, boxes: Reals, level: int) -> Any:
    side = min(_COARSE * 2 ** (level // 2), _FINE)
    low, high = boxes[:, [0, 2]], boxes[:, [1, 3]]
    passed = strip.moving.waves.passes(low.T, high.T)
    if level < _SLOW:
        return passed
    below = ~passed & (boxes[:, 1] <= near.reach)
    passed[below] = near.passes(low[below], high[below], side)
    rest = ~passed & (boxes[:, 0] > 0)
    passed[rest] = passive_on(strip.envelope, low[rest], high[rest], side)
    return passed


def _halved(boxes: Reals, level: int, high: float) -> Reals:
    """Each in two: in q or in v, whichever is relatively longer (v against `high`); boxes at q = 0 in turn."""
    if not len(boxes):
        return boxes
    a, b, c, d = boxes.T
    touching = a == 0
    with np.errstate(all="ignore"):
        by_q = np.where(touching, level % 2 == 0, np.log(b / a) > 2 * (d - c) / high)
        middle = np.where(touching, b / 2, np.sqrt(a * b))
    between = np.where(by_q, middle, c / 2 + d / 2)
    first, second = boxes.copy(), boxes.copy()
    rows = np.arange(len(boxes))
    first[rows, np.where(by_q, 1, 3)] = between
    second[rows, np.where(by_q, 0, 2)] = between
    return np.concatenate([first, second])


def positive_by_germ(moving: Moving, a: float, b: float, c: float, d: float) -> bool:
    """Whether −Im G(0, q) > 0, or −Im G/q where a = 0, is proved for a ≤ q ≤ b, c ≤ v ≤ d, by a first-order form."""
    with precision(_BITS):
        v0, q0 = arb(c / 2 + d / 2), arb(a / 2 + b / 2)
        v, q = v0.union(arb(c)).union(arb(d)), q0.union(arb(a)).union(arb(b))
        rv, rq = abs(v - v0).upper(), abs(q - q0).upper()
        try:
            wide = moving.germ(acb(0, q), v, 3 if a == 0 else 1)
            if a == 0:
                at, along = moving.germ(acb(0), v0, 1), moving.germ(acb(0), v, 1)
                bend = 6 * wide.value[3].real  # of −Re G_σ(iq), which is even in q
                lost = arb(b) ** 2 / 2 * bend
                rest = lost.min(arb(0)) - rv * abs(along.by_velocity[1].real)
                return bool(-at.value[1].real + rest > 0)
            at = moving.germ(acb(0, q0), v0, 0)
            rest = rq * abs(wide.value[1].real) + rv * abs(wide.by_velocity[0].imag)
            return bool(-at.value[0].imag - rest > 0)
        except PrecisionError:
            return False
