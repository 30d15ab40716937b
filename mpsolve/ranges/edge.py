"""A straight line of frequencies on which roots are looked for: the real axis, or a side of a region."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.numbers.balls import acb, arb, rational_ball


@dataclass(frozen=True)
class Edge:
    """The points q̂ = re + i·im + y, or − i·y where it goes down, with real y; the region lies where Im y < 0.

    mirrored: y and −y go together, as q and −q̄ are roots together (re = 0, not down).
    """

    re: Fraction = Fraction(0)
    im: Fraction = Fraction(0)
    down: bool = False

    @property
    def mirrored(self) -> bool:
        return not self.re and not self.down

    @property
    def origin(self) -> complex:
        """σ̂ = iq̂ at y = 0."""
        return complex(-float(self.im), float(self.re))

    @property
    def way(self) -> complex:
        """dσ̂/dy."""
        return 1.0 + 0j if self.down else 1j

    def sigma(self, y: Any) -> acb:
        """σ̂ at a ball y, at the precision that is set."""
        along = acb(arb(y), 0) if self.down else acb(0, y)
        return acb(-rational_ball(self.im), rational_ball(self.re)) + along


REAL_AXIS = Edge()
