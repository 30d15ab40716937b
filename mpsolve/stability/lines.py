"""Frequency lines: the induced frequencies along a grid of velocity ratios, joined where one is proved to continue.

The roots at each velocity ratio come from `certify`. Two of neighbouring velocities are joined only if a chain of
tubes proves that the one continues to the other (tube.py): no line is swapped for another where two come close.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, overload

import flint

from mpsolve.certificate.sheet import SheetSpectrum, certify_sheet
from mpsolve.errors import InputError
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.exact import Exact, Number
from mpsolve.numbers.rootball import RootBall
from mpsolve.problem.case import Case
from mpsolve.stability.cuts import CutPoint, CutPoints, cut_points
from mpsolve.stability.masses import checked_digits
from mpsolve.stability.tube import follow

arb = flint.arb


@dataclass(frozen=True)
class LineEnd:
    """How a line ends.

    kind: "range" at the end of the grid; "cut" where it is proved to reach the branch cut within the next step, at a
    velocity ratio in the ball `alpha`; "open" where the continuation is not proved.
    """

    kind: str
    alpha: Any | None = None


@dataclass(frozen=True)
class FrequencyLine:
    """One branch of roots, Re q ≥ 0: at alpha[k] the root ball q[k] (flint.acb); `ends`: its first and last end."""

    alpha: tuple[Exact, ...]
    q: tuple[Any, ...]
    ends: tuple[LineEnd, LineEnd]


@dataclass(frozen=True)
class FrequencyLines(Sequence[FrequencyLine]):
    """The lines by their first velocity ratio and Re q.

    counts: for each velocity ratio of `alpha` the number of induced frequencies on the whole sheet (q and −q̄ both
    counted), None where it is undecided, with the reason in `reasons`.
    """

    alpha: tuple[Exact, ...]
    lines: tuple[FrequencyLine, ...]
    counts: tuple[int | None, ...]
    reasons: tuple[str, ...]
    digits: int

    def __len__(self) -> int:
        return len(self.lines)

    @overload
    def __getitem__(self, index: int) -> FrequencyLine: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[FrequencyLine, ...]: ...
    def __getitem__(self, index: int | slice) -> FrequencyLine | tuple[FrequencyLine, ...]:
        return self.lines[index]


def frequency_lines(
    eta_b: Number,
    eta_m: Number | Iterable[Number],
    positions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    alpha: Iterable[Number] = (),
    digits: int = 15,
    cuts: bool = True,
) -> FrequencyLines:
    """The frequency lines over an ascending grid `alpha` of two or more rational velocity ratios, proved.

    digits: 15 to 10,000 certified digits of each root. cuts: whether to prove which ends reach the branch cut; if
    not, they are "open", which saves much time for three and more masses. Raises InputError.

    >>> lines = frequency_lines("0.05", (10, 10), (0, "1.5"), alpha=["0.6", "0.65", "0.7"])
    >>> [len(line.q) for line in lines], lines.counts
    ([3, 3], (4, 4, 4))
    """
    grid = _checked(alpha)
    digits = checked_digits(digits)
    masses = list(eta_m) if isinstance(eta_m, Iterable) and not isinstance(eta_m, str) else [eta_m]
    places = list(positions) if isinstance(positions, Iterable) and not isinstance(positions, str) else positions
    rest: dict[str, Any] = {"eta_b": eta_b, "eta_m": masses, "positions": places, "eta_n": eta_n, "eta_s": eta_s}
    cases = [Case(alpha=a, **rest) for a in grid]
    found = [certify_sheet(case, digits) for case in cases]
    levels = [_half(spectrum) for spectrum in found]
    followed = iter(_followed(cases[0], grid, levels))
    complete = [spectrum.certificate is not None for spectrum in found]  # no root is missing, even if a sign is open
    steps = [_Step(grid[k : k + 2], levels[k : k + 2], followed, complete[k + 1]) for k in range(len(grid) - 1)]
    for k, step in enumerate(steps):
        if cuts and found[k].proved and found[k + 1].proved:
            step.name_cuts(rest, digits)
    lines = _joined(grid, levels, steps)
    counts = tuple(s.count if s.proved else None for s in found)
    return FrequencyLines(tuple(grid), tuple(lines), counts, tuple(s.reason for s in found), digits)


def _checked(alpha: Iterable[Number]) -> list[Exact]:
    grid = [Exact.parse(a, f"alpha[{k}]") for k, a in enumerate(alpha, 1)]
    if len(grid) < 2:
        raise InputError("alpha", f"has {len(grid)} values: give a grid of two or more velocity ratios")
    for k, (a, b) in enumerate(pairwise(grid), 2):
        if not a < b:
            raise InputError(
                f"alpha[{k}]", f"is {b.short()}, not above the {a.short()} before it: list them ascending"
            )
    for k, a in enumerate(grid, 1):
        if not a.is_rational:
            raise InputError(f"alpha[{k}]", "is irrational: give decimals or ratios p/q")
    return grid


def _half(spectrum: SheetSpectrum) -> list[RootBall]:
    """One of q and −q̄: the roots with Re q ≥ 0."""
    return [root for root in spectrum.roots if not root.q.real < 0]


def _followed(case: Case, grid: list[Exact], levels: list[list[RootBall]]) -> list[Any | None]:
    """Where each root of each level but the last is proved to be one step later: balls, in this order."""
    tasks = [(k, root.q) for k, level in enumerate(levels[:-1]) for root in level]
    return follow(case, [grid[k] for k, _ in tasks], [grid[k + 1] for k, _ in tasks], [q for _, q in tasks])


class _Step:
    """From one velocity ratio to the next: which root is proved to continue to which, and what the others do."""

    def __init__(
        self, ends: list[Exact], levels: list[list[RootBall]], followed: Iterator[Any | None], complete: bool
    ) -> None:
        self.ends, self.left, self.right = ends, levels[0], levels[1]
        self.links = self._linked(followed, complete)
        self.leaves: dict[int, LineEnd] = {}
        self.enters: dict[int, LineEnd] = {}

    def _linked(self, followed: Iterator[Any | None], complete: bool) -> dict[int, int]:
        """Left to right. A branch that ends in a ball that meets one root ball of the right only is that root.

        complete: whether the right has all roots; if not, the branch may end in one that is missing.
        """
        links: dict[int, int] = {}
        for k, root in enumerate(self.left):
            end = next(followed)
            if root.multiplicity != 1 or not complete:
                continue
            met = [] if end is None else [j for j, other in enumerate(self.right) if other.q.overlaps(end)]
            if len(met) == 1 and self.right[met[0]].multiplicity == 1:
                links[k] = met[0]
        twice = {j for j in links.values() if list(links.values()).count(j) > 1}
        return {k: j for k, j in links.items() if j not in twice}

    def name_cuts(self, rest: dict[str, Any], digits: int) -> None:
        """Ends at the cut, where the proved cut points of the step account for every root that is left over.

        All roots of both sides are known. Those left over meet no branch that is joined; counted on the whole sheet,
        their number changes at cut points only. If none begins before the last one has ended, and as many are left
        over on the left as end, then none of them is there in between: each has ended at one of the cut points.
        """
        lost = [k for k in range(len(self.left)) if k not in self.links]
        new = [j for j in range(len(self.right)) if j not in self.links.values()]
        if not (lost or new):
            return
        points = self._points(rest, digits)
        if points is None or not points.proved:
            return
        ending = [point for point in points if not point.appears]
        beginning = [point for point in points if point.appears]
        ordered = not (ending and beginning) or ending[-1].alpha < beginning[0].alpha
        balanced = _weight([self.left[k].q for k in lost]) == _weight([point.q for point in ending])
        balanced &= _weight([self.right[j].q for j in new]) == _weight([point.q for point in beginning])
        if ordered and balanced and (len(lost), len(new)) == (len(ending), len(beginning)):
            self.leaves = {k: _at_cut(ending) for k in lost}
            self.enters = {j: _at_cut(beginning) for j in new}

    def _points(self, rest: dict[str, Any], digits: int) -> CutPoints | None:
        low, high = self.ends
        try:
            return cut_points(**rest, alpha=(low, high), digits=digits)
        except InputError:  # the cuts are not on one line
            return None


def _weight(balls: list[Any]) -> int:
    """How many roots these stand for on the whole sheet: two each, but one on the imaginary axis."""
    return sum(1 if q.real.contains(0) else 2 for q in balls)


def _at_cut(points: list[CutPoint]) -> LineEnd:
    """The ball of the cut point; of several, one that holds them all."""
    with ball_arithmetic(128):
        alpha = points[0].alpha
        for point in points[1:]:
            alpha = alpha.union(point.alpha)
    return LineEnd("cut", alpha)


def _joined(grid: list[Exact], levels: list[list[RootBall]], steps: list[_Step]) -> list[FrequencyLine]:
    lines = []
    for k, level in enumerate(levels):
        for j, root in enumerate(level):
            if k and j in steps[k - 1].links.values():
                continue
            first = LineEnd("range") if not k else steps[k - 1].enters.get(j, LineEnd("open"))
            balls, at, here = [root.q], k, j
            while at < len(steps) and here in steps[at].links:
                here = steps[at].links[here]
                at += 1
                balls.append(levels[at][here].q)
            last = LineEnd("range") if at == len(steps) else steps[at].leaves.get(here, LineEnd("open"))
            lines.append(FrequencyLine(tuple(grid[k : at + 1]), tuple(balls), (first, last)))
    return lines
