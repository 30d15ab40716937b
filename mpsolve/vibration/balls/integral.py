"""Gauss–Legendre panels along the path, each with a proved bound of what its nodes leave out.

On a panel of half length h whose integrand is at most M on the ellipse of Bernstein with parameter ρ, n nodes miss at
most 8hMρ^(1 − 2n)/(ρ − 1): they are exact up to the degree 2n − 1, and Chebyshev's series cut there is off by
2Mρ^(1 − 2n)/(ρ − 1) at most. They never miss more than 4h times the largest value on the panel, which serves late
times, whose waves have decayed there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, log
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, bits_now
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.image import BallImage, Cell
from mpsolve.vibration.path import Leg

_RHO = 3
_REAL, _IMAGINARY = 5 / 3, 4 / 3
"""(ρ ± 1/ρ)/2."""
_MOST_NODES = 64
_STEP = 4
"""Numbers of nodes are multiples of this, so that few rules are needed."""
_GROWS, _FULL, _LEAST = 1.6, 44, 2.0**-40


@dataclass(frozen=True)
class Panel:
    """Where û was computed: σ and û dσ at each node, and by channels and times a bound of what the nodes miss."""

    nodes: tuple[tuple[acb, tuple[acb, ...]], ...]
    missed: tuple[tuple[Any, ...], ...]


def panels(
    image: BallImage, leg: Leg, straight: bool, times: list[Any], goals: list[Any], effort: Effort
) -> Iterator[Panel]:
    """Panels that cover the leg in order; goals: by channels, of one panel. straight: to the right of the cuts.

    PrecisionError where a pole, or a point where p-roots meet, lies on the path or next to it.
    """
    here, size = leg.first, (leg.last - leg.first) / 8
    cell = image.start(leg.place(acb(here)))
    while here < leg.last:
        there = min(here + size, leg.last)
        effort.spend(1)
        try:
            wide, found = _panel(image, leg, (here, there), None if straight else cell, (times, goals), effort)
        except PrecisionError as error:
            if size < _LEAST * max(1.0, leg.last) or not isinstance(error, _WidePanelError):
                raise
            size = (there - here) / 2
            continue
        yield found
        size = (_GROWS if len(found.nodes) < _FULL else 1.0) * (there - here)
        here = there
        if not straight and here < leg.last:
            cell = image.within(wide, leg.place(acb(here)))


class _WidePanelError(PrecisionError):
    """The panel has to be halved."""


def _panel(
    image: BallImage,
    leg: Leg,
    ends: tuple[float, float],
    begin: Cell | None,
    asked: tuple[list[arb], list[arb]],
    effort: Effort,
) -> tuple[Cell, Panel]:
    a, b = (arb(x) for x in ends)
    middle, half = (a + b) / 2, (b - a) / 2
    ellipse = acb(middle + arb(0, half * _REAL * 1.0001), arb(0, half * _IMAGINARY * 1.0001))
    ball, slope = leg.place(ellipse), leg.slope(ellipse)
    try:
        if begin is None:
            cell = image.cell(ball, leg.place(acb(middle)))
        else:
            cell = image.beside(ball, leg.place(acb(a)), begin)
        largest = [(x * abs(slope)).upper() for x in image.sizes(cell)]
    except PrecisionError as error:
        raise _WidePanelError(str(error)) from None
    times, goals = asked
    growth = [(t * ball.real).exp().upper() for t in times]
    plain = [4 * half * (t * leg.place(acb(a.union(b))).real).exp().upper() for t in times]
    n = _number(largest, list(zip(growth, plain, strict=True)), half, goals)
    share = 8 * half * arb(_RHO) ** (1 - 2 * n) / (_RHO - 1) if n else None
    errors = [one if share is None else one.min(grown * share) for grown, one in zip(growth, plain, strict=True)]
    missed = tuple(tuple((M * error).upper() for error in errors) for M in largest)
    nodes = []
    for x, weight in rule(n, bits_now()) if n else ():
        at = acb(middle + half * x)
        sigma, factor = leg.place(at), leg.slope(at) * half * weight
        effort.spend(1)
        values = image.values(image.within(cell, sigma))
        nodes.append((sigma, tuple(value * factor for value in values)))
    return cell, Panel(tuple(nodes), missed)


def _number(largest: list[arb], growth: list[tuple[arb, arb]], half: arb, goals: list[arb]) -> int:
    """How many nodes miss no more than the goals; 0 where the panel itself is below them at all times."""
    felt = max(_log(M / goal) for M, goal in zip(largest, goals, strict=True))
    over = [_log(grown) for grown, plain in growth if felt + _log(plain) > 0]
    if not over:
        return 0
    n = ceil((felt + max(over) + _log(half) + log(8 / (_RHO - 1)) + log(_RHO)) / (2 * log(_RHO)))
    n = _STEP * max(1, ceil(n / _STEP))
    if n > _MOST_NODES:
        raise _WidePanelError("the motion turns too often over a panel: halve it")
    return n


def _log(x: Any) -> float:
    """About; also of what float64 does not hold."""
    return float(x.log().mid()) if x > 0 else -1e9


@lru_cache(maxsize=64)
def rule(n: int, bits: int) -> tuple[tuple[arb, arb], ...]:  # noqa: ARG001 — part of the key
    """Nodes and weights on [−1, 1] in balls, at the precision that is set."""
    return tuple(arb.legendre_p_root(n, k, weight=True) for k in range(n))
