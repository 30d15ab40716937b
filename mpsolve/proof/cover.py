"""Covering a path by pieces that each pass a test: all open pieces are tried at once, those that fail are halved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.proof.effort import Effort

Test = Callable[[Any, Any], tuple[Any, Any, Any]]
"""(starts, ends) → (passed, value, error), one of each for every piece."""


@dataclass(frozen=True)
class Cover:
    """The break points of a covered path in order, the sum of the pieces' values, and a bound of its error."""

    points: Any
    value: float
    error: float

    @property
    def pieces(self) -> int:
        return len(self.points) - 1


class OpenPieceError(PrecisionError):
    """A piece passes its test at no length; `place` is its middle."""

    def __init__(self, place: complex, length: float) -> None:
        super().__init__(f"pieces of the path shorter than {length:.2g} do not pass near {place:.6g}")
        self.place = place


def cover(points: Any, test: Test, effort: Effort, smallest: float = 2.0**-40) -> Cover:
    """Cover the polyline through `points` (complex); `smallest` is relative to its length.

    Raises OpenPieceError where halving does not help, EffortError where the effort is spent.
    """
    points = np.asarray(points, complex)
    a, b = points[:-1], points[1:]
    length = float(np.abs(b - a).sum())
    done: list[tuple[Any, ...]] = []
    while len(a):
        effort.spend(len(a))
        passed, value, error = test(a, b)
        done.append((a[passed], b[passed], value[passed], error[passed]))
        a, b = a[~passed], b[~passed]
        if not len(a):
            break
        short = np.abs(b - a) < smallest * length
        if short.any():
            place = (a[short][0] + b[short][0]) / 2
            raise OpenPieceError(complex(place), smallest * length)
        middle = (a + b) / 2
        a, b = np.concatenate([a, middle]), np.concatenate([middle, b])
    starts, ends, values, errors = (np.concatenate(part) for part in zip(*done, strict=True))
    return Cover(_chain(points, starts, ends), float(values.sum()), float(errors.sum() + 1e-12 * len(values)))


def _chain(points: Any, starts: Any, ends: Any) -> Any:
    """The break points in the order of the path."""
    following = {complex(s): complex(e) for s, e in zip(starts, ends, strict=True)}
    out = [complex(points[0])]
    while out[-1] in following:
        out.append(following.pop(out[-1]))
    return np.array(out)
