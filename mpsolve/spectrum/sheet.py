"""How many roots the whole physical sheet of a beam holds, whose cuts lie on one line (SPEC2, the whole sheet).

z = q − iη, scaled. The lower half is counted along the lower edge of the cut: from a point in the gap (or 0, where
the cuts are joined) below the branch points to ρ; a theorem tells how Δ̂ turns beyond, where no root is. In the
upper half vehicle and track are passive where |z| is large, so that pivots tell the argument at one point, and Δ̂ is
followed to there. A loop round each branch point shows that no root is next to it; of loads that stand still a
variable without branch points does (`edge_at_rest`).
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.path import Path, Proved
from mpsolve.characteristic.paths import ROOM, Paths
from mpsolve.characteristic.start import Start, start
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.balls import precision
from mpsolve.problem.line import Line
from mpsolve.proof.effort import Effort
from mpsolve.proof.winding import number_of_zeros
from mpsolve.spectrum.branch_loops import Loop, edge_points, find_loops
from mpsolve.spectrum.closing import pivot_sum
from mpsolve.spectrum.edge_at_rest import Rest, past_branch_points
from mpsolve.spectrum.far_line import FarLine, prove_far, turn_beyond
from mpsolve.spectrum.regions import Sheet

_STRIDE = 0.5  # of the phase √z·(span of the places) that a first piece of the edge goes through
_GROWTH = 1.6


@frozen
class Half:
    """What is walked for one half of the sheet: a link to the begin, then turns between the loops."""

    paths: tuple[Path, ...] = ()
    loops: tuple[Loop, ...] = ()

    @property
    def pieces(self) -> int:
        return sum(path.pieces for path in self.paths) + sum(loop.pieces for loop in self.loops)


@frozen
class SheetCount:
    """The proved number of roots, with all that the proof rests on (points are z in scaled units).

    lower: from `begin` round the lower half; upper: from the same point to `end`, where it closes, or nothing where
    the two are one. far: None without damping: then the halves are mirror images, and `lower` leads to `end`.
    rest: of loads that stand still, the way on both halves from the gap to `begin`, beyond the branch points.
    """

    line: Line
    total: int
    start: Start
    begin: float
    end: float
    lower: Half
    upper: Half
    far: FarLine | None
    evaluations: int
    rest: Rest | None = None

    @property
    def begins(self) -> Fraction:
        """Where Δ̂ begins to be followed, exactly: between `begin` and the first branch point at the latest."""
        if self.rest is not None:
            return self.rest.z[0]
        return self.lower.loops[0].begin if self.begin else Fraction(0)

    @property
    def first(self) -> float:
        """A little before the first branch point, or 0."""
        if self.rest is not None:
            return float(self.rest.z[0]) * (1 - 2.0**-10)
        return self.lower.loops[0].first if self.lower.loops else 0.0

    @property
    def region(self) -> Sheet:
        return Sheet()

    @property
    def why(self) -> str:
        """Nothing is left out."""
        return ""

    @property
    def pieces(self) -> int:
        return self.lower.pieces + self.upper.pieces + (self.rest.pieces if self.rest is not None else 0)


def count_sheet(line: Line, effort: Effort, room: float = ROOM) -> SheetCount:
    """The number of roots; PrecisionError or EffortError where it stays open.

    The vehicle is one for which the upper half closes: that of `Line.upper` is passive, and on a damped track it is
    made of tight masses (`open_on_sheet`).
    """
    joined = line.joined
    if joined is None:
        raise PrecisionError("the velocity is exactly the one at which the cuts join, so that they touch at Re q = 0")
    first = start(line.lower.guide)
    below, above = (Paths(Arrays(half), first, room) for half in (line.lower, line.upper))
    far = prove_far(line) if line.height else None
    rest = _rest(line, effort, room)
    if rest is not None:
        at = float(rest.z[-1])
        way = _way(line, at, far.reach if far else at, [])
        along = _proved(below, _link(below, way[0], effort), way, [], effort)
        total = _total(line, first, at, far, [*along.turns, *rest.turns])
        return SheetCount(line, total, first, at, at, Half(along.paths), Half(), far, effort.spent, rest)
    end = _passive_end(line)
    points = edge_points(line)
    inner = [point for point in points if point.z < end] if joined else points[:1]  # up to where a half closes
    count = len(inner) if far and joined else 0  # branch points on the way on both halves
    loops = [find_loops(line, (below, above), point, effort) for point in points[:count]]
    loops += [find_loops(line, (below,), point, effort) for point in (points if far else inner)[count:]]
    round_below, round_above = [one[0] for one in loops], [one[1] for one in loops[:count]]
    begin = 0.0 if joined else round_below[0].first
    end = max([end, begin, *(loop.last for loop in (round_above if far else round_below))])
    ways = [_way(line, begin, far.reach if far else end, round_below)]
    if far and end > begin:
        ways.append(_way(line, begin, end, round_above))
    rounds, link = (round_below, round_above), _link(below, ways[0][0], effort)
    proved = [
        _proved(paths, link, way, loops, effort)
        for paths, way, loops in zip((below, above), ways, rounds, strict=False)
    ]
    turns = [turn for one in proved for turn in one.turns]
    turns += [loop.half for loops in rounds[: len(proved)] for loop in loops]
    total = _total(line, first, end, far, turns)
    lower = Half(proved[0].paths, tuple(round_below))
    upper = Half(proved[1].paths, tuple(round_above)) if len(proved) > 1 else Half()
    return SheetCount(line, total, first, begin, end, lower, upper, far, effort.spent)


def _rest(line: Line, effort: Effort, room: float) -> Rest | None:
    """The way past the branch points under loads that stand still, where one is found."""
    if line.lower.guide.v:
        return None
    try:
        return past_branch_points(line, effort, room)
    except PrecisionError:
        return None


def _total(line: Line, first: Start, end: float, far: FarLine | None, turns: list[tuple[float, float]]) -> int:
    """The number of roots from all turns of arg Δ̂; the upper half closes at `end`, without damping both do."""
    with precision(64):
        closing = pivot_sum(line.upper, first.up, end) + (line.upper.bodies - line.upper.contacts) * arb.pi() / 2
        turned = sum((arb(*turn) for turn in turns), turn_beyond(line, first.up, far) if far else arb(0))
        return number_of_zeros(
            (closing - turned) / arb.pi() * (1 if line.height else 2), "the characteristic function"
        )


def _passive_end(line: Line) -> float:
    """0, or a float e with e² > ρ₋² exactly: beyond it the mobility is passive."""
    squared = line.passive_from
    if not squared:
        return 0.0
    e = float(np.float32(math.sqrt(float(squared)) * 1.01))
    if not Fraction(e) ** 2 > squared:
        raise PrecisionError("the radius of passivity is out of range")
    return e


def _way(line: Line, begin: float, end: float, loops: list[Loop]) -> list[Complexes]:
    """From begin along the edge to `end`, without what loops go round."""
    ways, at = [], begin
    for loop in loops:
        ways.append(_edge(line, at, loop.first))
        at = loop.last
    return [*ways, _edge(line, at, end)]


def _edge(line: Line, a: float, b: float) -> Any:
    """From a to b on the real axis, in steps that grow with the distance from a until waves turn fast."""
    if b <= a:
        return np.array([a + 0j])
    EI, _, _, m = (float(x) for x in line.beam)
    span = float(line.lower.places[-1] - line.lower.places[0]) + 1
    widest = _STRIDE / span / (m / EI) ** 0.25  # in √z
    step, out, x = min((b - a) / 2, 0.15 * a + 0.02 * (b - a)), [a], a
    while x < b:
        x = x + step
        step = min(_GROWTH * step, 2 * widest * math.sqrt(x) + widest**2)
        out.append(x if x + step / 2 < b else b)
        x = out[-1]
    short = np.array(out, np.float32).astype(float)
    short[0], short[-1] = a, b
    return short[np.concatenate([[True], np.diff(short) > 0])] + 0j


def _link(paths: Paths, end: Complexes, effort: Effort) -> Path:
    """From the start to the begin of a way; it tells of the track alone."""
    link = np.linspace(complex(0, -paths.start.depth), end[0], 7)
    return paths.plan("link", np.concatenate([link[:-1].astype(np.complex64).astype(complex), end[:1]]), effort)


def _proved(paths: Paths, link: Path, way: list[Complexes], loops: list[Loop], effort: Effort) -> Proved:
    """The link to the begin of the way, and the turns along its parts, between which are loops."""
    reached = tuple(complex(loop.last) for loop in loops)
    return paths.prove((link, *paths.plan_turns(way, effort)), effort, reached)
