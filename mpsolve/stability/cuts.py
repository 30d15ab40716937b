"""The velocity ratios at which a frequency line ends: a root of Δ, eq. (26), reaches the branch cut.

Without damping and below α_C the root can only reach the end q_lm of the gap: one real equation in α (gapend.py). In
all other cases it reaches an edge of the cut, Im q = η_b: two real equations in two unknowns (rim.py). All cut points
of the range are found with proof; what stays open is returned as strips.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, overload

import flint

from mpsolve.fields import ball_arithmetic
from mpsolve.model.limits import critical_velocity_ratio, require_cuts_on_line
from mpsolve.numbers.exact import Exact, Number
from mpsolve.numbers.ranges import checked_range
from mpsolve.outcome import Status
from mpsolve.problem.case import Case
from mpsolve.stability.gapend import gap_ends
from mpsolve.stability.masses import checked_digits
from mpsolve.stability.rimsearch import edge_zeros
from mpsolve.stability.search import Strip

acb, arb = flint.acb, flint.arb
_BUDGET = 2_000_000  # boxes
_AT_REST = 2.0**-10  # how close to rest, with N ≥ 0, the edge is looked at
_JOINT = 2.0**-6  # how close to α_C without damping


@dataclass(frozen=True)
class CutPoint:
    """At the velocity ratio `alpha` (flint.arb ball) the roots `q` (flint.acb ball, Re q ≥ 0) and −q̄ are on the cut.

    side: "gap" (at its end q_lm, without damping), "below" or "above" the cut: where the root is on the sheet.
    appears: True where the line begins there, as α grows, False where it ends.
    """

    alpha: Any
    q: Any
    side: str
    appears: bool


@dataclass(frozen=True)
class CutPoints(Sequence[CutPoint]):
    """The cut points by ascending α: all of the range if `proved`, else all outside of `strips`."""

    start: Exact
    end: Exact
    points: tuple[CutPoint, ...]
    strips: tuple[Strip, ...]
    status: Status
    reason: str
    digits: int
    evaluations: int = 0

    @property
    def proved(self) -> bool:
        return self.status.holds

    def __len__(self) -> int:
        return len(self.points)

    @overload
    def __getitem__(self, index: int) -> CutPoint: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[CutPoint, ...]: ...
    def __getitem__(self, index: int | slice) -> CutPoint | tuple[CutPoint, ...]:
        return self.points[index]


def cut_points(
    eta_b: Number,
    eta_m: Number | Iterable[Number],
    positions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    alpha: tuple[Number, Number] = ("0.01", "1.4"),
    digits: int = 30,
) -> CutPoints:
    """Every velocity ratio in [lo, hi] at which a root of Δ, eq. (26), reaches the branch cut, proved.

    digits: 15 to 10,000 proved digits of each alpha. Raises InputError, also where η_b ≥ 1 or N ≥ √(1 − η_b²): then
    the cuts leave the line Im q = η_b.

    >>> points = cut_points(0, (40, 40), (0, "0.5"), alpha=("0.01", "0.99"))
    >>> [(point.alpha.str(12, radius=False), point.side, point.appears) for point in points]
    [('0.740466753424', 'gap', False)]
    """
    low, high = checked_range(alpha, "alpha")
    case = Case(alpha=low, eta_b=eta_b, eta_m=eta_m, positions=positions, eta_n=eta_n, eta_s=eta_s)
    require_cuts_on_line(case)
    digits = checked_digits(digits)
    points: list[CutPoint] = []
    strips: list[Strip] = []
    start = float(low)
    if not case.eta_b:
        start = _in_gap(case, low, high, digits, points, strips)
    elif case.axial.sign >= 0 and start < _AT_REST:
        reason = "at rest two pairs of p-roots meet: start from alpha = 0.001"
        strips.append(Strip(start, min(_AT_REST, float(high)), reason))
        start = _AT_REST
    evaluations = 0
    if start < float(high):
        found = edge_zeros(case, _outward(start, -math.inf), _outward(float(high), math.inf), digits, _BUDGET)
        evaluations = found.evaluations
        strips += found.strips
        with ball_arithmetic(math.ceil(digits * math.log2(10)) + 64):
            height = case.eta_b.ball()
            kept = [z for z in found.zeros if not (z.alpha < low.ball() or z.alpha > high.ball())]
            points += [CutPoint(z.alpha, acb(z.r, height), z.side, z.appears) for z in kept]
    points.sort(key=lambda point: float(point.alpha.mid()))
    strips.sort(key=lambda strip: strip.start)
    reason = strips[0].reason if strips else ""
    status = Status.UNDECIDED if strips else Status.UNVERIFIED
    return CutPoints(low, high, tuple(points), tuple(strips), status, reason, digits, evaluations)


def _outward(x: float, way: float) -> float:
    """The next float, so that no rounding shortens the range; 0 stays."""
    return math.nextafter(x, way) if x else x


def _in_gap(case: Case, low: Exact, high: Exact, digits: int, points: list[CutPoint], strips: list[Strip]) -> float:
    """Adds what happens below α_C; returns from where on the edge is to be looked at."""
    ends, open_parts = gap_ends(case, low, high, digits)
    points += [CutPoint(end.alpha, acb(end.q), "gap", end.appears) for end in ends]
    strips += open_parts
    with ball_arithmetic(128) as field:
        critical = critical_velocity_ratio(case, field)
        if high.ball() < critical:
            return float(high)
        clear = float(critical.upper()) + _JOINT
    if float(low) < clear:
        end = min(clear, float(high))
        strips.append(
            Strip(max(float(low), float(critical.lower())), end, "at alpha_C the cuts join: start above it")
        )
    return max(float(low), clear)
