"""What is proved of a box of (q, parameters): no root is real there, or one at most, which is known.

Kinds of leaves: the determinant does not vanish; the contacts are passive, so that no passive vehicle has a real
root, as cells of wavenumber tell or the receptance itself, which takes a verifier least; the box lies where the
only real root has been enclosed, or outside of what is asked; or, in charts, its real roots are a part of one arc
(`arcs`). Masses without end have corners next to q = 0 (`heavy`), lines of questions what is not asked (`asked`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_receptance import Receptances
from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.numbers.jets import UP
from mpsolve.passivity.blocks import passive_on
from mpsolve.passivity.envelope import Envelope
from mpsolve.proof.definite import positive_definite
from mpsolve.proof.sheared import upright
from mpsolve.proof.vanishing import Scalar, Verdict, guess, nonzero, one_at_most, scalar

NONZERO, PASSIVE, ABSORBING, KNOWN, OUTSIDE, ARC, CORNER, NOT_ASKED = range(1, 9)
_SHARES = 2.0 ** -np.arange(0.0, 21.0, 1.5)  # of the size of a box round a zero that are tried, side by side
_SMALL = 2.0**-6  # of the whole: boxes in which zeros are looked for in any case
_TRIED = 8  # of a batch
_CELLS = 7  # on each side of a wave: few, as a verifier's forms are wider than those of the cells here
_AROUND = 1.2  # of half a box: how far off its middle a zero is taken for one of the box
Found = Callable[[Any, Any], bool]
"""What is done about a point (q̂, x̂) where the determinant seems to vanish, and half the box that shows it: True where
a zero was enclosed there.
"""


def boxes_of(low: Reals, high: Reals, origin: complex = 0.0, way: complex = 1j, slope: Reals | None = None) -> Boxes:
    """Boxes that hold those between the corners, middles rounded."""
    m = low / 2 + high / 2
    return Boxes(m, np.maximum(high - m, m - low) * UP + 2.0**-1000, origin, way, slope)


@dataclass
class Judge:
    """Judges boxes of one family.

    envelope: that of the contacts, None where their passivity tells nothing. width: half of the whole; known: boxes
    (low, high) whose only zero has been enclosed, of two variables. origin, way: of the line, see `Boxes`; begins:
    the least value on it that is asked.
    """

    matrix: FreeMatrix
    envelope: Envelope | None
    width: Reals
    found: Found | None = None
    known: list[tuple[Any, Any]] = field(default_factory=list)
    origin: complex = 0.0
    way: complex = 1j
    begins: float = 0.0

    @cached_property
    def variables(self) -> int:
        return self.matrix.variables

    @cached_property
    def felt(self) -> Truths:
        """Of q̂ and each parameter whether the track and its contacts' places know it: passivity is told by these."""
        return np.array([True, *self.matrix.family.felt])

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        """(kind of each box, the variable along which to halve it)."""
        return self.judged(low, high)[:2]

    def judged(self, low: Reals, high: Reals) -> tuple[Any, Any, Scalar]:
        """The same, and the reduced determinant."""
        kind, boxes = np.zeros(low.shape[1], np.int8), self.boxes(low, high)
        if boxes.slope is not None:
            low, high = upright(low, high)
            kind[(high[0] < self.begins) | (low[0] > self.begins + 2 * self.width[0] * UP)] = OUTSIDE
        kind[self._in_known(low, high)] = KNOWN
        A, G = self.matrix(boxes)
        s = scalar(A, G.good)
        verdict = nonzero(s.s)
        upright_ = True if boxes.slope is None else boxes.slope == 0
        passive = (low[0] > 0) & upright_  # may be told to be
        if self.envelope is not None:
            rest = np.flatnonzero((kind == 0) & passive & _seems_passive(G))
            kind[rest[positive_definite(*G.take(rest).absorbed)]] = ABSORBING
        kind[(kind == 0) & s.good & verdict.nonzero] = NONZERO
        if self.envelope is not None:
            kind[self._passive(self.envelope, boxes, G, low, high, (kind == 0) & passive)] = PASSIVE
        if self.found is not None and (kind == 0).any():
            self._look(boxes, s, kind)
        return kind, self._axis(boxes, G, s, verdict), s

    def boxes(self, low: Reals, high: Reals) -> Boxes:
        """Those between the corners, which may have a row of slopes below."""
        m = self.variables
        slope = low[m] if len(low) > m else None
        return boxes_of(low[:m], high[:m], self.origin, self.way, slope)

    def _passive(self, envelope: Envelope, boxes: Boxes, G: Receptances, low: Reals, high: Reals, rest: Any) -> Any:
        rest = np.flatnonzero(rest)
        if len(rest):
            seems, unknown = _seems_passive(G)[rest], ~G.good[rest]
            if unknown.any():
                middles = Boxes(boxes.m[:, rest[unknown]], 0 * boxes.r[:, rest[unknown]])
                seems[unknown] = _seems_passive(self.matrix.receptance(middles))
            rest = rest[seems]
        if not len(rest):
            return rest
        sides = np.concatenate([low, high])[:, rest]
        own = np.concatenate([self.felt, self.felt])
        _, first, which = np.unique(np.where(own[:, None], sides, 0), axis=1, return_index=True, return_inverse=True)
        a, b = np.split(sides[:, first].T, 2, axis=1)
        return rest[passive_on(envelope, a, b, _CELLS)[which.ravel()]]

    def _in_known(self, low: Reals, high: Reals) -> Truths:
        inside = np.zeros(low.shape[1], bool)
        for a, b in self.known:
            inside |= ((low >= a[:, None]) & (high <= b[:, None])).all(0)
        return inside

    def _look(self, boxes: Boxes, s: Scalar, kind: Any) -> None:
        """Zeros that open boxes show are enclosed."""
        u = guess(s.s)
        small = (boxes.r < _SMALL * self.width[:, None]).all(0)
        near = (kind == 0) & s.good & (np.abs(u) < _AROUND).all(0) & (one_at_most(s.s) | small)
        for n in np.flatnonzero(near)[:_TRIED]:
            m, r = boxes.m[:, n].copy(), boxes.r[:, n].copy()
            point = m + r * u[:, n]
            if boxes.slope is not None:  # in the plane of (q̂, x̂)
                point[0], m[0] = point[0] + boxes.slope[n] * point[1], m[0] + boxes.slope[n] * m[1]
                r[0] += abs(boxes.slope[n]) * r[1]
            shown = any(
                ((point >= a) & (point <= b)).all() or (np.abs((a + b) / 2 - m) < _AROUND * r).all()
                for a, b in self.known
            )  # the zero of the box is a known one, as far as can be told: its halves will tell more
            if not shown and self.found is not None:
                self.found(point, r)

    def room(self, point: Any, size: Any) -> tuple[Any, Any] | None:
        """A box round the point, of half-widths a share of `size`, in which one zero at most is proved."""
        one, other = np.meshgrid(_SHARES, _SHARES)
        shares = np.stack([one.ravel(), other.ravel()])
        for least in (1.0, _SHARES[-1]):  # bogies far apart have crossings so close together that both are needed
            halves = size[:, None] * least * shares
            boxes = Boxes(np.repeat(point[:, None], shares.shape[1], 1), halves, self.origin, self.way)
            A, G = self.matrix(boxes)
            s = scalar(A, G.good)
            area = np.where(s.good & one_at_most(s.s), shares.prod(0), 0.0)
            best = area.argmax()
            if area[best]:
                half = boxes.r[:, best] * 0.49
                return point - half, point + half
        return None

    def _axis(self, boxes: Boxes, G: Receptances, s: Scalar, verdict: Verdict) -> Any:
        """Where the determinant is bounded, what stands most against the test; else what moves the p-roots most."""
        with np.errstate(all="ignore"):
            bounded = G.good & np.isfinite(s.strain).all(0)
            strain = np.where(bounded, s.strain, 0) + G.strain
            share = strain / strain.sum(0)
            weight = verdict.weight + s.s.e * np.where(np.isfinite(share), share, 0)
            weight = np.where(s.good & np.isfinite(weight).all(0), weight, strain)
            width = boxes.r / np.where(self.width > 0, self.width, np.inf)[:, None]
            usable = np.isfinite(weight).all(0) & (weight > 0).any(0)
            weight = np.where(usable, weight / weight.max(0), 1.0) * (width > 0) + width * 1e-9
        return weight.argmax(0).astype(np.int8)


def _seems_passive(G: Receptances) -> Any:
    """In floats: −Im G at the middle is positive definite."""
    with np.errstate(all="ignore"):
        middle = G.G.k[0]
        finite = G.good & np.isfinite(middle).all((1, 2))
        middle = np.where(finite[:, None, None], middle, 0)
        H = (middle - np.swapaxes(middle.conj(), 1, 2)) * 0.5j
        return finite & (np.linalg.eigvalsh(H)[:, 0] > 0)
