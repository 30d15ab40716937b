"""All roots that reach a cut as the parameter of a family varies, scaled: where, from which side, which way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb

from mpsolve.cuts.balls import InPlane
from mpsolve.cuts.far import far_reach, wavenumber_of
from mpsolve.cuts.search import Found, Search
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, precision
from mpsolve.numbers.reduction import Reduction
from mpsolve.outcome import Reason
from mpsolve.problem.family import Family
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort


@dataclass(frozen=True)
class Reached:
    """At x̂ the roots q̂ (Re q > 0) and −q̄ are on the cut; side, appears: as in `CutPoint`.

    p: of the wave that is real there; drift: about dp/dx̂, Im p > 0 on the sheet; search: of the side of the cut.
    """

    x: arb
    q: Any
    side: str
    appears: bool
    p: arb
    drift: complex
    search: Search


@dataclass(frozen=True)
class AllReached:
    """Ascending in x̂; `reason` where the list may lack some. reach: it speaks of |Re q̂| < reach, None: of all q̂."""

    points: tuple[Reached, ...]
    reason: Reason | None
    reach: float | None


def all_reached(family: Family, digits: int, budget: Effort, progress: Progress) -> AllReached:
    """Over the range of the family and a little more."""
    far = far_reach(family)
    P, reach = wavenumber_of(family, far)
    searches = [Search(family, side, P, digits) for side in (-1, 1)]
    reasons = [_low(search, budget, progress) for search in searches]
    if not any(reasons):
        reasons = [search.high_wavenumbers(budget, progress) for search in searches]
    reason = reasons[0] or reasons[1]
    points: list[Reached] = []
    for search in searches:
        for zero in search.found:
            try:
                point = _described(search, zero, family)
            except PrecisionError as error:
                reason = reason or Reason("direction", str(error), {}, "ask for more digits")
                continue
            if point is not None and not (point.side == "gap" and search.balls.side > 0):
                points.append(point)
    points.sort(key=lambda point: float(point.x.mid()))
    return AllReached(tuple(points), reason, None if far else reach)


def _low(search: Search, budget: Effort, progress: Progress) -> Reason | None:
    """Of one side, with no more than its share of the effort, so that the other one has its turn."""
    most = None if budget.evaluations is None else max((budget.evaluations - budget.spent) // 2, 1)
    share = Effort(None if budget.seconds is None else budget.seconds / 2, most)
    reason = search.low_wavenumbers(share, progress)
    budget.spent += share.spent
    return reason


def _described(search: Search, zero: Found, family: Family) -> Reached | None:
    """None where it is one of the other side, or a mirror image."""
    balls, side = search.balls, search.balls.side
    with precision(max(int(zero.x.mid().bits()), 53) + 64):
        at = balls.edge(zero.p, zero.x)
        z, lean = at.z.value.real, at.lean.value.real
        if side * lean < 0 or z < 0:
            return None
        if not z > 0:
            raise PrecisionError("a root reaches the cut at Re q = 0, as far as can be told")
        gap = not side * lean > 0
        if gap and not _at_end(search, zero, family):
            raise PrecisionError("which side of the cut a root reaches cannot be told")
        f = InPlane(balls, Reduction.of(balls.matrices(zero.p, zero.x)[0], near_root=True))
        f_p, f_x = f.slopes(zero.p, zero.x)
        drift = -f_x / f_p  # of p, an upper root: on the sheet its Im p > 0
        if not (drift.imag > 0 or drift.imag < 0):
            raise PrecisionError("whether a root appears at the cut, or goes, cannot be told")
        name = "gap" if gap else "below" if side < 0 else "above"
        q = acb(z, -at.sigma.value.real)
        return Reached(zero.x, q, name, bool(drift.imag > 0), zero.p, complex(drift.mid()), search)


def _at_end(search: Search, zero: Found, family: Family) -> bool:
    """Whether the zero is proved to lie where the cut begins.

    Without losses complex conjugation exchanges p and the p-root b that it meets, so that b is a zero, too: if it
    lies in the box of p, it is p.
    """
    lossless = all(j % 2 == 0 for _, j in family.D_rest) and not any(map(any, family.S[1]))
    partner = search.balls.partner(zero.p, zero.x)
    return lossless and bool(zero.box[0].contains_interior(partner.real))
