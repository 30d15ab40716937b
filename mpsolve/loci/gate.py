"""A line that ends where a cut begins, without damping, known by a disc a little before its end.

The branch point, at which q moves with the square root of what is left of the way, is no singularity of the root's
real wavenumber p there: a tube in (p, x̂) holds it from before the end to beyond it. Where in that tube Im p > 0, and
the other p-roots are not real, the p-roots of q(p) are those of the sheet: p and a′ above, b′ and then b below. A cut
point is a real p, and there is only one, so that the root is on the sheet up to there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.cuts.boxes import EdgeMatrix
from mpsolve.cuts.reached import Reached
from mpsolve.loci.tube import Tubes, tubes
from mpsolve.numbers.balls import arb, precision
from mpsolve.numbers.plain import outward

if TYPE_CHECKING:
    from mpsolve.characteristic.free_receptance import Receptances
    from mpsolve.numbers.quadratic import Quadratic

_RADII = 2.0 ** -np.arange(2.0, 12.0)  # of |p|
_LEAN = 3.0  # of the way of p, in its disc
_SHARPER = 3
_LOST = 1 + 2.0**-40


@dataclass(frozen=True)
class _Along:
    """The matrix along the cut as a function of a complex p."""

    matrix: EdgeMatrix

    def __call__(self, boxes: Boxes) -> tuple[Quadratic, Receptances]:
        return self.matrix(Boxes(boxes.m, boxes.r, 0.0, 1.0))


@dataclass(frozen=True)
class Gate:
    """At x̂ = x, scaled, the line's root lies within `radius` of q, in the gap.

    pipe: the tube in (p, x̂), which holds the line from x to its end.
    """

    x: float
    q: complex
    radius: float
    pipe: Tubes
    matrix: EdgeMatrix

    def at(self, low: float, high: float) -> Gate | None:
        """The same where low ≤ x̂ ≤ high, nearer to the end; None where the root is not proved to be on the sheet."""
        return _gate(self.matrix, self.pipe, low, high)


def gate_of(one: Reached, low: float, high: float) -> Gate | None:
    """Nearer to the end than to the ends of the range from low to high; None where none is proved."""
    matrix = EdgeMatrix(one.search.matrix.family, one.search.matrix.side, meeting=False)
    ends = outward(one.x, up=False), outward(one.x, up=True)
    with precision(64):
        p = float(one.p.mid())
        off = outward(arb(abs(one.p - p).upper()), up=True)
    way = 1.0 if one.appears else -1.0
    for radius in (_RADII * abs(p)).tolist():
        x = (ends[0] if way < 0 else ends[1]) + way * radius / _LEAN / abs(one.drift)
        if not (low + ends[0]) / 2 < x < (high + ends[1]) / 2:
            continue
        first, last = np.array([min(x, *ends)]), np.array([max(x, *ends)])
        pipe = tubes(_Along(matrix), first, last, np.array([p + 0j]), np.array([radius]))  # type: ignore[arg-type]
        if all(bool(pipe.holds(p, off, end)[0]) for end in ends):
            gate = _gate(matrix, pipe, x, x)
            if gate is not None:
                return gate
    return None


def _gate(matrix: EdgeMatrix, pipe: Tubes, low: float, high: float) -> Gate | None:
    """The disc of q(p) for the root in the pipe where low ≤ x̂ ≤ high; None unless it is proved to be on the sheet."""
    if not (pipe.low[0] <= low <= high <= pipe.high[0]):
        return None
    ends, p = (np.array([low]), np.array([high])), pipe.guess(low)
    size = p.imag / 2
    for _ in range(_SHARPER):  # a smaller disc in which the one of before has its only zero
        point = tubes(_Along(matrix), *ends, p, size)  # type: ignore[arg-type]
        p, size = point.near[1], point.inner * 2
    centre, inner = complex(point.middle[0]), float(point.inner[0] + abs(point.slope[0]) * (high - low)) * _LOST
    if not (point.good[0] and all(pipe.holds(centre, inner, x)[0] for x in (low, high)) and centre.imag > inner):
        return None
    boxes = Boxes(np.array([[centre], [low]]), np.array([[inner], [(high - low) * _LOST]]) + 2.0**-1000, 0.0, 1.0)
    with np.errstate(all="ignore"):
        at, apart = matrix.edge(boxes)[0], matrix.apart(boxes)
        q = at.sigma.times(-1j)
    if not (apart[0] and np.isfinite(q.spread[0])):
        return None
    return Gate(low, complex(q.a[0]), float(q.spread[0]) * _LOST, pipe, matrix)
