"""Where in a range a root seems to lie lowest, in floats: heuristic, proofs start from it and do not rest on it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.arrays import Complexes
from mpsolve.problem.family import Family
from mpsolve.spectrum.candidates import Area, search

_POINTS = 17
_SEARCHED = 8  # of as many points one is searched without hints


@dataclass(frozen=True)
class Seen:
    """A root q̂ at x̂, and the distance of the points that were looked at."""

    x: float
    q: complex
    step: float


def least_seen(family: Family, low: float, high: float, area: Area) -> Seen | None:
    """The lowest root that is met at points of [low, high] (of x̂), Re q̂ ≥ 0; None where none is met."""
    x = np.linspace(low, high, _POINTS)
    ends = family.box[0]
    roots: list[Any] = [np.zeros(0, complex)] * len(x)
    for k in range(0, len(x), _SEARCHED):
        roots[k] = _roots(family, x[k], ends, area, roots[k], 1)
    for k in range(1, len(x)):  # followed from point to point, and back where one point has more than the next
        if len(roots[k]) < len(roots[k - 1]):
            roots[k] = _roots(family, x[k], ends, area, np.concatenate([roots[k], roots[k - 1]]), 0)
    for k in range(len(x) - 2, -1, -1):
        if len(roots[k]) < len(roots[k + 1]):
            roots[k] = _roots(family, x[k], ends, area, np.concatenate([roots[k], roots[k + 1]]), 0)
    best = [(float(q.imag), float(x[k]), complex(q)) for k, row in enumerate(roots) for q in row]
    if not best:
        return None
    _, at, q = min(best)
    return Seen(at, q, float(x[1] - x[0]))


def _roots(
    family: Family, x: float, ends: tuple[Fraction, Fraction], area: Area, hints: Complexes, levels: int
) -> Any:
    if not len(hints) and not levels:
        return hints
    at = min(max(Fraction(x), ends[0]), ends[1])
    try:
        return search(family.reduced([at]), area, hints, levels)
    except (InputError, PrecisionError):
        return hints[:0]
