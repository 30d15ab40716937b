"""Covering a path by pieces on each of which a function is proved to stay in one open half-plane.

No derivative is needed: a piece is good when its image ball, times the conjugate of the ball's own midpoint,
has positive real part. The midpoints m_k then carry the whole change of argument, because the path from m_k
to m_{k+1} through the shared end stays within two half-planes: it turns by Arg(m_{k+1}/m_k).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import flint

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.sheet import reasons

Values = tuple[Any, ...]
Evaluate = Callable[[Any], Values]
Accept = Callable[[Any, Any], bool]
"""Of a piece, and of the same a little wider."""

MARGIN = 0.9  # of the midpoint's modulus that an image ball may reach

SLACK = 2.0**-16  # of a piece by which the checker must confirm more than it: another FLINT rounds otherwise
GROWTH = 0.3  # a piece is at most this part of its distance from 0, or the first step


@dataclass(frozen=True)
class Path:
    """Breakpoints (dyadic floats, exact as they stand) and, a piece, the midpoints of the image balls."""

    breaks: tuple[float, ...]
    middles: tuple[Values, ...]
    evaluations: int


def cover(
    evaluate: Evaluate,
    start: float,
    stop: float,
    step: float,
    limit: int,
    meter: Callable[[float], None] | None = None,
    accept: Accept | None = None,
) -> Path:
    """Pieces from `start` to `stop` (start < stop), found by marching with a step that adapts.

    `evaluate` takes a real ball and returns the image balls of one or more functions. `accept` may refuse a
    piece that a checker with enclosures of its own could not confirm. Raises
    `PrecisionError` when a piece shrinks below the resolution of the path (a zero on it or next to it), and
    `EffortError` after `limit` evaluations.
    """
    breaks, middles, count, here, widest = [start], [], 0, start, step
    while here < stop:
        there = _dyadic_sum(here, step, stop)
        count += 1
        if count > limit:
            raise EffortError(reasons.pieces(limit))
        values = _try(evaluate, flint.arb(here).union(flint.arb(there)), accept)
        if values is None:
            step = (there - here) * 0.625
            if step < 2.0**-44 * max(abs(here), abs(stop) * 2.0**-20):
                raise PrecisionError(reasons.root_on_contour(here))
            continue
        breaks.append(there)
        middles.append(tuple(v.mid() for v in values))
        here, step = there, min(1.25 * step, max(widest, GROWTH * abs(there)))
        if meter and len(middles) % 64 == 0:
            meter(here)
    return Path(tuple(breaks), tuple(middles), count)


def _dyadic_sum(here: float, step: float, stop: float) -> float:
    """here + step, to eight bits of the step, and not beyond `stop` (nor leaving a sliver before it)."""
    there = here + step
    if there + step / 2 >= stop:
        return stop
    unit = 2.0 ** (math.frexp(step)[1] - 8)
    rounded = there // unit * unit  # short numbers on disk; any value between here and stop is as good
    return rounded if rounded > here else there


def _try(evaluate: Evaluate, ball: Any, accept: Accept | None) -> Values | None:
    try:
        values = evaluate(ball)
    except PrecisionError:
        return None
    if not all(in_half_plane(v) for v in values):
        return None
    wider = ball + flint.arb(0, (SLACK * ball.rad()).upper())
    return values if accept is None or accept(ball, wider) else None


def in_half_plane(value: Any) -> bool:
    """True when the ball is proved to stay within MARGIN of its midpoint's modulus, hence in a half-plane."""
    middle = value.mid()
    return bool((value - middle).abs_upper() < MARGIN * middle.abs_lower())


def turning(path: Path, index: int, first: Any, last: Any) -> Any:
    """The change of argument of function number `index` along the path, as a real ball.

    `first` and `last` are the function's balls at the two ends.
    """
    middles = [values[index] for values in path.middles]
    total = (middles[0] / first).arg() + (last / middles[-1]).arg()
    for a, b in pairwise(middles):
        total += (b / a).arg()
    if not total.is_finite():
        raise PrecisionError("an end of the contour is too close to a root to have an argument")
    return total
