"""What a pole adds to a motion: û e^{σt} round a circle, by the trapezoidal rule with a proved bound of its error.

Where the function is at most M in the ring r/2 ≤ |σ − c| ≤ 2r, the mean over n points of (σ − c) û e^{σt} is off from
the residue by 2M/(2ⁿ − 1) at most: the terms of Laurent's series that alias are that small.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, log
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, square
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.image import BallImage, Cell

_ARCS, _DEPTH = 24, 9
_HALVINGS = 8
_SHARE = 0.3
_LONGEST = 4.0
_SPARE = 12
"""Binary digits, so that one decimal more is right."""


def radius_round(root: acb, others: Sequence[acb], room: float, last: float) -> float:
    """Of a circle round a root away from other poles and from the cuts, in which e^{σt} does not grow too far."""
    gaps = [float(abs(acb(root.mid()) - acb(z.mid())).lower()) for z in others]
    return _SHARE * min([*gaps, room, *([_LONGEST / (last * _SHARE)] if last else [])])


def residues(
    image: BallImage, root: acb, others: Sequence[acb], radius: float, times: list[Any], bits: int, effort: Effort
) -> list[list[acb]]:
    """The residue of û e^{σt} within the circle, by channels and times; `bits`: of it that are wanted.

    root: a ball that holds all poles within; others: balls of all other poles. PrecisionError where that is open.
    """
    for _ in range(_HALVINGS):
        try:
            return _round(image, root, others, arb(radius), times, bits, effort)
        except _WideCircleError as error:
            radius, found = radius / 2, error
    raise found


class _WideCircleError(PrecisionError):
    """The circle has to be smaller."""


def _round(
    image: BallImage, root: acb, others: Sequence[acb], r: arb, times: list[Any], bits: int, effort: Effort
) -> list[list[acb]]:
    centre = acb(root.mid())
    if not abs(root - centre) < r / 2:
        raise PrecisionError("a root is not sharp enough for balls: certify with more digits")
    if not all(abs(z - centre) > 2 * r for z in others):
        raise _WideCircleError("two poles are too close for balls: certify with more digits, or change a parameter")
    largest = _largest(image, centre, r, effort)
    last = max(times, key=float)
    n = bits + _SPARE + ceil(3 * float(r * last) / log(2))
    sums = [[acb(0)] * len(times) for _ in largest]
    for k in range(n):
        turn = r * (acb(0, 2 * arb.pi() * (2 * k + 1)) / (2 * n)).exp()
        sigma = centre + turn
        effort.spend(1)
        values = image.values(image.start(sigma))
        waves = [(sigma * t).exp() * turn / n for t in times]
        sums = [
            [x + value * wave for x, wave in zip(row, waves, strict=True)]
            for row, value in zip(sums, values, strict=True)
        ]
    out = []
    for row, M in zip(sums, largest, strict=True):
        missed = [(2 * M * 2 * r * ((centre.real + 2 * r) * t).exp() / (arb(2) ** n - 1)).upper() for t in times]
        out.append([x + acb(arb(0, off), arb(0, off)) for x, off in zip(row, missed, strict=True)])
    return out


def _largest(image: BallImage, centre: acb, r: arb, effort: Effort) -> list[arb]:
    """Bounds of |û| in the ring by channels: no cut meets the disc, so that it is largest on the two circles."""
    try:
        disc = image.clear(centre + square(2 * r), centre)
    except PrecisionError as error:
        raise _WideCircleError(str(error)) from None
    out: list[Any] = []
    for size in (r / 2, 2 * r):
        for k in range(_ARCS):
            out = _larger(out, _over(image, disc, (centre, size), (k / _ARCS, (k + 1) / _ARCS), effort, _DEPTH))
    return out


def _over(
    image: BallImage, disc: Cell, circle: tuple[acb, arb], turns: tuple[float, float], effort: Effort, depth: int
) -> list[arb]:
    """The same over an arc; arcs where the equations may be singular are halved."""
    a, b = turns
    effort.spend(1)
    centre, size = circle
    ball = centre + size * acb(0, 2 * arb.pi() * arb(a).union(arb(b))).exp()
    try:
        return image.sizes(image.beside(ball, acb(ball.mid()), disc))
    except PrecisionError as error:
        if not depth:
            raise _WideCircleError(str(error)) from None
    middle = (a + b) / 2
    sides = (_over(image, disc, circle, part, effort, depth - 1) for part in ((a, middle), (middle, b)))
    return _larger(*sides)


def _larger(some: list[arb], other: list[arb]) -> list[arb]:
    return [x.max(y) for x, y in zip(some, other, strict=True)] if some else other
