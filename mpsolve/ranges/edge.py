"""A straight line of frequencies on which roots are looked for: the real axis, or a side of a region."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from mpsolve.characteristic.boxes import Boxes
from mpsolve.numbers.balls import acb, arb, rational_ball


@dataclass(frozen=True)
class Edge:
    """The points q̂ = re + i·im + way·y with real y. way: 1, to the right, or −1j, down: the region lies on the
    side of Im y < 0.

    mirrored: y and −y go together, as q and −q̄ are roots together (way = 1, re = 0).
    """

    re: Fraction = Fraction(0)
    im: Fraction = Fraction(0)
    way: complex = 1.0
    mirrored: bool = True

    def placed(self, boxes: Boxes) -> Boxes:
        """Boxes in (y, x̂) as boxes in (q̂, x̂)."""
        if self == REAL_AXIS:
            return boxes
        m, r = boxes.m.astype(complex), boxes.r.astype(complex)
        m[0] = complex(float(self.re), float(self.im)) + self.way * m[0]
        r[0] = self.way * r[0]
        return replace(boxes, m=m, r=r)

    def sigma(self, y: Any) -> Any:
        """σ̂ = iq̂ at a ball y, at the precision that is set."""
        re, im = rational_ball(self.re), rational_ball(self.im)
        along = acb(0, y) if self.way == 1 else acb(arb(y), 0)
        return acb(-im, re) + along

    @property
    def turn(self) -> Any:
        """dσ̂/dy."""
        return acb(0, 1) if self.way == 1 else acb(1)


REAL_AXIS = Edge()
