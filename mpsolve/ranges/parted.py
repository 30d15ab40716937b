"""Ranges of velocities that hold speeds of short waves: they are proved in parts, with the speeds left out by name.

At such a speed the equations lose a solution. Each part ends as near to it as can be proved: on strings the
speed alone is left out where a theorem tells all (`on_string`), and from below by `last_strip`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from time import process_time
from typing import TYPE_CHECKING, Any

from mpsolve.errors import InputError
from mpsolve.numbers.balls import rational_ball
from mpsolve.outcome import Reason, Status
from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort, begun
from mpsolve.ranges.answer import Spent, joined_cost
from mpsolve.ranges.crossed import LeftOut, Speed, not_whole, shown, speeds_within
from mpsolve.ranges.last_strip import last_strip
from mpsolve.ranges.on_string import quiet

if TYPE_CHECKING:
    from mpsolve.ranges.crossed import Crossings

_SHARES = tuple(Fraction(1, n) for n in (8, 11, 16, 22, 32, 45, 64))
"""Of the speed: how far from it a part ends; each next strip is proved by itself, as faster waves need more boxes."""
_BOXES = 20_000  # for a strip
_FEW = 2_000  # for the last one, up to the speed itself
COMPLETE = "crossings complete up to q"
"""What is known where nothing bounds the frequencies at which roots cross."""

Find = Callable[[dict[str, Interval], Effort | None], Any]


def speeds_above(problem: Problem, over: Mapping[str, Interval]) -> list[Speed]:
    """The least known speed a little above a range of v, in which nothing may be provable for it; else none."""
    low, high = over.get("v", (Fraction(0), None))
    if high is None:
        return []
    return speeds_within(problem, {"v": (high, high * (1 + _SHARES[0]))})[:1] if low < high * (1 - _SHARES[0]) else []


def parted(
    problem: Problem,
    over: Mapping[str, Interval],
    speeds: list[Speed],
    find: Find,
    none: Callable[[dict[str, Interval], str], Any],
    effort: Effort | None,
) -> Any:
    """The parts of a range, each answered by `find`, or `none` where a theorem says that nothing grows, as one."""
    started, budget = process_time(), begun(effort)
    (low, high) = over["v"]
    edges: list[Speed | None] = [None, *speeds, None]
    parts = []
    for k, (left, right) in enumerate(pairwise(edges)):
        side = -1 if k == 0 else 1 if k == len(speeds) else None
        parts.append(_part(problem, (left, low), (right, high), side, find, none, lambda: effort and budget.left()))
    return _joined(over, speeds, parts, process_time() - started)


def _part(
    problem: Problem, left: Any, right: Any, side: int | None, find: Find, none: Any, effort: Callable[[], Any]
) -> tuple[tuple[Fraction | None, Fraction | None], Crossings] | None:
    """(the ends as far as proved, None for the speed itself; the answer), or None where there is nothing between."""
    (below, low), (above, high) = left, right
    start = low if below is None else below.beside(1)
    end = high if above is None else min(high, above.beside(-1))
    if start >= end:
        return None
    why = quiet(problem, {"v": (start, end)}, side)
    if why is not None:
        return ((None if below else low), (None if above else high)), none({"v": (start, end)}, why)
    ends = {
        share: (
            start if below is None else start * (1 + share),
            end if above is None else min(end, above.beside(-1) * (1 - share)),
        )
        for share in _SHARES
    }
    shares = [share for share in _SHARES if ends[share][0] < ends[share][1]]
    if not shares:
        return None
    found = find({"v": ends[shares[0]]}, effort())
    sides = [below is not None, above is not None] if found.proved else []
    closed = None
    for one, other in pairwise((shares[0], *shares)):
        for k, wanted in enumerate(sides):
            if wanted and one != other:
                near = sorted((ends[one][k], ends[other][k]))
                strip = _tried(find, (near[0], near[1]), effort())
                sides[k] = strip is not None
                found = found if strip is None else _adjoined(*((strip, found) if k == 0 else (found, strip)))
        if sides and sides[1] and closed is None and end == above.beside(-1):
            closed = _up_to(problem, found, above, effort())
            if closed is not None:
                found, sides[1] = closed, False
    begun, ended = next(iter(found.over.values()))
    return (begun, ended if closed is None else None), found


def _up_to(problem: Problem, found: Any, speed: Speed, effort: Effort | None) -> Any:
    """An answer with the rest of its range up to the speed, in which nothing crosses; None where that is open."""
    strip = (found.over["v"][1], speed.beside(1))
    budget = Effort(None if effort is None else effort.seconds, _FEW)
    proof = last_strip(problem, strip, speed.ball, budget)
    if proof is None:
        return None
    cost = Spent(0.0, 0.0, budget.spent)
    over = {"v": (strip[0], max(strip[0], speed.beside(-1)))}
    more = replace(
        found, over=over, crossings=(), counts=found.counts[-1:], proofs=(proof,), parts=(), cost=cost,
        status=Status.UNVERIFIED, certificate=None, note="no root is real up to the speed of the waves",
    )  # fmt: skip
    return _adjoined(found, more)


def _tried(find: Find, strip: Interval, effort: Effort | None) -> Crossings | None:
    seconds = None if effort is None else effort.seconds
    try:
        found = find({"v": strip}, Effort(seconds, _BOXES))
    except InputError as error:
        if error.key != "over":
            raise
        return None
    return found if found.proved else None


def _adjoined(one: Any, other: Any) -> Any:
    """Two proved neighbours as one; what they share is at their common end, where nothing crosses."""
    return replace(
        one,
        over={"v": (one.over["v"][0], other.over["v"][1])},
        crossings=one.crossings + other.crossings,
        counts=one.counts + other.counts[1:],
        proofs=one.proofs + other.proofs,
        parts=(*(one.parts or (one,)), *(other.parts or (other,))),
        cost=joined_cost(one.cost, other.cost),
        status=Status.UNVERIFIED,
        certificate=None,
        note="parts are proved by themselves, and there is no certificate of the whole",
    )


def _joined(over: Mapping[str, Interval], speeds: list[Speed], parts: list[Any], seconds: float) -> Any:
    known = [part for part in parts if part is not None]
    if not known:
        raise InputError("over", "holds a speed of short waves of the track and nothing else: give a wider range")
    # of a part of which nothing is proved all is left out, up to the speed or the end of the range behind it
    edges = [rational_ball(over["v"][0]), *(speed.ball for speed in speeds), rational_ball(over["v"][1])]
    left_out = []
    for k, speed in enumerate(speeds):
        start, end = (
            edge if part is None or not part[1].proved else _ball(part[0][side], speed)
            for part, side, edge in ((parts[k], 1, edges[k]), (parts[k + 1], 0, edges[k + 2]))
        )
        if not (speed.ball > edges[-1] and start >= end):  # all is proved below a speed above the range
            left_out.append(LeftOut(speed.name, speed.ball, start, end))
    found = [answer for _, answer in known]
    checked = sum(one.cost.verification for one in found)
    cost = Spent(seconds - checked, checked, sum(one.cost.boxes for one in found))
    first = found[0]
    begun = over["v"] if parts[0] is None else (first.over["v"][0], over["v"][1])  # which may be a little above rest
    reason = next((_told(one.reason, speeds) for one in found if not one.proved), None)
    if reason is None and not all(one.is_point for one in left_out):
        reason = not_whole(tuple(left_out))
    common: dict[str, Any] = {
        "over": {"v": begun}, "cost": cost, "parts": tuple(found), "left_out": tuple(left_out), "certificate": None,
        "crossings": tuple(c for one in found for c in one.crossings),
        "proofs": tuple(proof for one in found for proof in one.proofs),
    }  # fmt: skip
    if reason is not None:
        done: dict[str, Any] = {"proved": [list(one.over["v"]) for one in found if one.proved]}
        listed = [[*one.over["v"], one.known[COMPLETE]] for one in found if COMPLETE in one.known]
        done |= {COMPLETE: listed} if listed else {}
        return replace(first, status=Status.UNDECIDED, reason=reason, known=done, counts=None, note="", **common)
    told = f"left out: {'; '.join(map(shown, left_out))}. " if left_out else ""
    note = f"{told}There is no certificate of the whole"
    counts = tuple(n for one in found for n in one.counts)
    return replace(first, status=Status.UNVERIFIED, reason=None, counts=counts, note=note, **common)


def _told(reason: Reason, speeds: list[Speed]) -> Reason:
    names = ", ".join(f"{one.name} = {float(one.ball):.6g} m/s" for one in speeds)
    return replace(reason, message=f"{reason.message}, in a part of the range beside {names}")


def _ball(end: Fraction | None, speed: Speed) -> Any:
    return speed.ball if end is None else rational_ball(end)
