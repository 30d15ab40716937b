"""Where roots come into a region or leave it as the parameter grows: all events of its border, proved complete."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb

from mpsolve.loci.gate import Gate
from mpsolve.loci.region import Side
from mpsolve.loci.room import ABOVE, BELOW, GAP
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import acb, precision
from mpsolve.numbers.plain import disc_of, outward
from mpsolve.outcome import Reason
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import Covered
from mpsolve.ranges.enclosed import REAL_AXIS, Edge
from mpsolve.ranges.enclosed import Crossing as Scaled
from mpsolve.ranges.scope import Scope
from mpsolve.ranges.search import Search

ON_AXIS = Side(REAL_AXIS, 0.0, 0.0, "the real axis")


@dataclass(frozen=True)
class Passing:
    """A root on an edge, scaled: balls q̂ and x̂; gained: by how much the number on the side Im y < 0 grows.

    side: of a cut, on which the root is, "" for the border of a region. gate: near an end of the gap the point at
    which a line to there is known by a disc; None where none is proved.
    """

    q: Any
    x: arb
    gained: int | None
    side: str = ""
    gate: Gate | None = None

    @property
    def ends(self) -> tuple[float, float]:
        """Floats that hold x̂ between them."""
        return outward(self.x, up=False), outward(self.x, up=True)

    @property
    def span(self) -> tuple[float, float]:
        """From the gate to x̂, where no chain begins but from the gate."""
        at = [self.gate.x] if self.gate is not None else []
        return min(*self.ends, *at), max(*self.ends, *at)

    @property
    def kind(self) -> int:
        """Of the tubes by which a line comes here."""
        return {"above": ABOVE, "gap": GAP}.get(self.side, BELOW)

    @property
    def disc(self) -> tuple[complex, float]:
        """A disc that holds q̂."""
        return disc_of(self.q)


@dataclass(frozen=True)
class Border:
    """All passings of the edges that were looked at, by x̂; `reason` where the list may lack some."""

    passings: tuple[Passing, ...]
    covers: tuple[Covered, ...]
    known: tuple[Any, ...]
    reason: Reason | None


def border_of(scope: Scope, sides: tuple[Side, ...], digits: int, budget: Effort, tell: Progress) -> Border:
    """The passings of these sides."""
    found: list[Passing] = []
    covers, known, reason = [], [], None
    for k, side in enumerate(sides):
        search = Search(scope, digits, (side.edge, *_corners(scope, side)))

        def share(stage: str, part: float, k: int = k) -> None:
            tell(stage, (k + part) / len(sides))

        cover = search.cover(budget, share)
        covers.append(cover)
        known += search.judge.known
        reason = reason or cover.reason
        found += [_passing(one, side.edge, digits) for one in search.found if _on_side(one, side)]
    if reason is None and any(one.gained is None for one in found):
        remedy = "ask for more digits"
        reason = Reason("direction", "a root touches the border as far as can be told", {}, remedy)
    found.sort(key=lambda one: float(one.x.mid()))
    return Border(tuple(found), tuple(covers), tuple(known), reason)


def _corners(scope: Scope, side: Side) -> tuple[Reals, Reals]:
    """Of the box in (y, x̂)."""
    return np.concatenate([[side.low], scope.low]), np.concatenate([[side.high], scope.high])


def _on_side(one: Scaled, side: Side) -> bool:
    """Whether the zero is not proved to lie beyond the ends of the side."""
    return side.edge.mirrored or not bool(one.q < side.low or one.q > side.high)


def _passing(one: Scaled, edge: Edge, digits: int) -> Passing:
    with precision(max(int(one.x.mid().bits()), 4 * digits) + 64):
        sigma = edge.sigma(one.q)
        return Passing(acb(sigma.imag, -sigma.real), one.x, one.gained)
