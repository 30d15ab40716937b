"""Break points that make the pieces of a path equally hard: fewer of them than halving leaves."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

_SPARE = 1.02  # of the pieces that are needed by what each of them costs


def evened(points: Any, hardness: Any) -> Any:
    """Points on the same polyline so that each piece would have a hardness of about 1, were it its length.

    hardness: one number > 0 for each piece. Corners are kept; straight parts that are not parallel to an axis are
    left as they are, since points on them would be rounded off the line.
    """
    out = [points[:1]]
    for first, last in _straight(points):
        part, cost = points[first : last + 1], hardness[first:last]
        count = int(np.ceil(cost.sum() * _SPARE))
        if (part.real == part[0].real).all() | (part.imag == part[0].imag).all():
            at = np.concatenate([[0.0], np.cumsum(cost)])
            where = np.linspace(0, at[-1], count + 1)
            inner = np.interp(where, at, part.real) + 1j * np.interp(where, at, part.imag)
            part = np.concatenate([part[:1], inner[1:-1], part[-1:]])
        out.append(part[1:])
    return np.concatenate(out)


def _straight(points: Any) -> list[tuple[int, int]]:
    """(first, last) of the parts along which both coordinates go one way, one of them not at all."""
    way = np.sign(np.diff(points).real) + 3 * np.sign(np.diff(points).imag)
    cuts = [0, *(np.flatnonzero(np.diff(way)) + 1).tolist(), len(points) - 1]
    return list(pairwise(cuts))
