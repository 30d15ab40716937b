"""What a pole adds to a motion: û e^{σt} round a circle, by the trapezoidal rule with a proved bound of its error.

Where the function is at most M in the ring r/2 ≤ |σ − c| ≤ 2r, the mean over n points of (σ − c) û e^{σt} is off from
the residue by 2M/(2ⁿ − 1) at most: the terms of Laurent's series that alias are that small.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import ceil, log
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.image import BallImage

_SECTORS, _RINGS, _DEPTH = 24, (0.5, 0.8, 1.3, 2.0), 4
_HALVINGS = 8
_SHARE = 0.3
_LONGEST = 4.0
_SPARE = 12
"""Binary digits, so that one decimal more is right."""


def radius_round(middle: complex, others: Sequence[complex], room: float, last: float) -> float:
    """Of a circle round `middle` away from other poles and from the cuts, in which e^{σt} does not grow too far."""
    gaps = [abs(middle - z) for z in others]
    return _SHARE * min([*gaps, room, _LONGEST / (last * _SHARE)])


def residues(
    image: BallImage, root: Any, others: Sequence[Any], radius: float, times: list[Any], bits: int, effort: Effort
) -> list[list[Any]]:
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
    image: BallImage, root: Any, others: Sequence[Any], r: Any, times: list[Any], bits: int, effort: Effort
) -> list[list[Any]]:
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


def _largest(image: BallImage, centre: Any, r: Any, effort: Effort) -> list[Any]:
    """Bounds of |û| in the ring by channels."""
    out: list[Any] = []
    for low, high in pairwise(_RINGS):
        for k in range(_SECTORS):
            piece = (low, high, k / _SECTORS, (k + 1) / _SECTORS)
            sizes = _over(image, centre, r, piece, effort, _DEPTH)
            out = _larger(out, sizes)
    return out


def _over(
    image: BallImage, centre: Any, r: Any, piece: tuple[float, float, float, float], effort: Effort, depth: int
) -> list[Any]:
    """The same over radii and turns; pieces where the equations may be singular are split in four."""
    low, high, a, b = piece
    effort.spend(1)
    size, angle = r * arb(low).union(arb(high)), 2 * arb.pi() * arb(a).union(arb(b))
    ball = centre + size * (acb(0, 1) * angle).exp()
    middle = acb((centre + r * (low + high) / 2 * (acb(0, a + b) * arb.pi()).exp()).mid())
    try:
        return image.sizes(image.cell(ball, middle))
    except PrecisionError as error:
        if not depth:
            raise _WideCircleError(str(error)) from None
    x, y = (low + high) / 2, (a + b) / 2
    out: list[Any] = []
    for one in ((low, x, a, y), (low, x, y, b), (x, high, a, y), (x, high, y, b)):
        out = _larger(out, _over(image, centre, r, one, effort, depth - 1))
    return out


def _larger(some: list[Any], other: list[Any]) -> list[Any]:
    return [max(x, y, key=float) for x, y in zip(some, other, strict=True)] if some else other
