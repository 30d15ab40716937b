"""All chains of a region: from the roots at one value both ways, and from each passing of the border inwards."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import EffortError
from mpsolve.loci.border import Passing
from mpsolve.loci.chain import Chain, follow
from mpsolve.loci.gate import Gate
from mpsolve.loci.meeting import Meeting, beyond, meeting_of
from mpsolve.loci.room import GAP, Room
from mpsolve.loci.tube import Tubes
from mpsolve.numbers.arrays import Complexes
from mpsolve.outcome import Reason
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort


@dataclass(frozen=True)
class Start:
    """A root at x̂ = x: a disc that holds it, and whether it is proved to lie on the imaginary axis."""

    x: float
    q: complex
    radius: float
    on_axis: bool


@dataclass
class Strand:
    """A line as tubes, ascending in x̂; first, last: a `Passing`, "range" or "stuck"."""

    tubes: Tubes
    on_axis: bool
    first: Any
    last: Any
    crossings: list[Passing] = field(default_factory=list)

    @property
    def low(self) -> tuple[float, float]:
        """Floats between which it begins."""
        return _ends(self.first) or (float(self.tubes.low[0]),) * 2

    @property
    def high(self) -> tuple[float, float]:
        """Floats between which it ends."""
        return _ends(self.last) or (float(self.tubes.high[-1]),) * 2

    @property
    def gates(self) -> tuple[Gate | None, Gate | None]:
        """Those beyond which it goes on to its begin, and to its end."""
        first, last = (end.gate if isinstance(end, Passing) else None for end in (self.first, self.last))
        return first, last

    def holds(self, passing: Passing) -> bool:
        """Whether the root of the passing is the one of this line."""
        return bool(holding(self.tubes, passing).any())

    def tube_at(self, x: float) -> Tubes | None:
        """One row of the tubes, at a float."""
        rows = np.flatnonzero((self.tubes.low <= x) & (self.tubes.high >= x))
        return self.tubes.take(rows[:1]) if len(rows) else None


def _ends(end: Any) -> tuple[float, float] | None:
    if isinstance(end, Passing):
        return end.ends
    return (end.low, end.high) if isinstance(end, Meeting) else None


def holding(tubes: Tubes, passing: Passing) -> Any:
    """Which tubes hold the root of the passing."""
    if passing.side:
        rows = np.flatnonzero(tubes.kind == passing.kind)
        out = np.zeros(len(tubes.low), bool)
        out[rows] = _holding(tubes.take(rows), passing)
        return out
    return _holding(tubes, passing)


def _holding(tubes: Tubes, passing: Passing) -> Any:
    if passing.side == "gap":
        gate = passing.gate
        if gate is None:
            return np.zeros(len(tubes.low), bool)
        return (tubes.low <= gate.x) & (gate.x <= tubes.high) & tubes.holds(gate.q, gate.radius, gate.x)
    low, high = passing.ends
    q, radius = passing.disc
    inside = (tubes.low <= low) & (high <= tubes.high)
    return inside & tubes.holds(q, radius, low) & tubes.holds(q, radius, high)


def strands(
    matrix: FreeMatrix,
    room: Room,
    base: float,
    starts: list[Start],
    passings: tuple[Passing, ...],
    budget: Effort,
    tell: Progress,
) -> tuple[list[Strand], Reason | None]:
    """(the lines that the starts, all at x̂ = base, and the passings make, why they were left as they are)."""
    ends = room.low, room.high
    chains: list[Chain] = []
    begun: list[Start | Passing | Meeting] = []
    for start in starts:
        for way in (1, -1):
            kind = room.kind_of(start.q, start.radius, start.x)
            chains.append(Chain(start.x, start.q, start.radius, way, on_axis=start.on_axis, kind=kind))
            begun.append(start)
    for passing in passings:
        way = 1 if passing.ends[0] > base else -1
        if (passing.gained or 0) * way > 0 and not (passing.side == "gap" and passing.gate is None):
            chains.append(_from(passing, way))
            begun.append(passing)

    def stop(chain: Chain) -> Passing | None:
        return next((one for one in passings if (one.gained or 0) * chain.way < 0 and _met(chain, one)), None)

    def share(x: float) -> None:
        tell("lines", min(max((x - ends[0]) / (ends[1] - ends[0]), 0.0), 1.0))

    meetings: list[tuple[Meeting, int]] = []
    reason, more = None, True
    try:
        while more:
            follow(matrix, chains, room, budget, stop, share)
            new = _through(matrix, chains, meetings, room)
            chains += [chain for chain, _ in new]
            begun += [begin for _, begin in new]
            more = bool(new)
    except EffortError as error:
        reason = error.reason
    return _joined(chains, begun), reason


def _through(
    matrix: FreeMatrix, chains: list[Chain], meetings: list[tuple[Meeting, int]], room: Room
) -> list[tuple[Chain, Meeting]]:
    """New chains from the far ends of meetings at which chains are stuck, each with what it begins at."""
    out: list[tuple[Chain, Any]] = []
    for chain in [chain for chain in chains if chain.end == "stuck"]:
        known = next((one for one, way in meetings if way == chain.way and one.holds(chain)), None)
        if known is not None:
            chain.end = known
            continue
        meeting = meeting_of(matrix, chain, room)
        ahead = [] if meeting is None else beyond(matrix, meeting, chain, room)
        if meeting is not None and ahead:
            chain.end = meeting
            meetings.append((meeting, chain.way))
            out += [(one, replace(meeting)) for one in ahead]
    return out


def _from(passing: Passing, way: int) -> Chain:
    if passing.gate is not None:
        return Chain(passing.gate.x, passing.gate.q, passing.gate.radius, way, kind=GAP)
    low, high = passing.ends
    q, radius = passing.disc
    x, ahead = (low, high) if way > 0 else (high, low)
    return Chain(x, q, radius, way, ahead=ahead, on_axis=bool(passing.q.real.is_zero()), kind=passing.kind)


def _met(chain: Chain, passing: Passing) -> bool:
    return bool(holding(chain.tubes[-1], passing).any())


def _joined(chains: list[Chain], begun: list[Any]) -> list[Strand]:
    out: list[Strand] = []
    up: dict[int, Chain] = {}
    down: dict[int, Chain] = {}
    for chain, begin in zip(chains, begun, strict=True):
        (up if chain.way > 0 else down)[id(begin)] = chain
    for begin in {id(one): one for one in begun}.values():
        ahead, back = up.get(id(begin)), down.get(id(begin))
        rows = [*(reversed(back.tubes) if back else ()), *(ahead.tubes if ahead else ())]
        if not rows:
            continue
        own = None if isinstance(begin, Start) else begin
        first, last = _end_of(back, own), _end_of(ahead, own)
        on_axis = any(chain.on_axis for chain in (ahead, back) if chain is not None)
        out.append(Strand(_side_by_side(rows), on_axis, first, last))
    return out


def _end_of(chain: Chain | None, own: Any) -> Any:
    if chain is None:
        return own
    return "stuck" if chain.end is None else chain.end


def _side_by_side(rows: list[Tubes]) -> Tubes:
    def joined(name: str) -> Any:
        return np.concatenate([getattr(row, name) for row in rows])

    def both(name: str) -> tuple[Complexes, Complexes]:
        return tuple(np.concatenate([getattr(row, name)[k] for row in rows]) for k in (0, 1))  # type: ignore[return-value]

    names = ("low", "high", "middle", "slope", "outer", "inner", "good")
    low, high, middle, slope, outer, inner, good = map(joined, names)
    return Tubes(low, high, middle, slope, outer, inner, good, both("near"), both("speed"), joined("kind"))
