"""How many roots seem to grow at a point of the parameters, in floats: heuristic, to choose where to prove."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.floats import Floats
from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import precision
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.closing import closing_argument

_STEP = 0.7  # radians that the argument may turn between neighbours
_ROUNDS = 16


def count_seen(reduced: Reduced, X: float) -> int | None:
    """The count that passivity beyond X̂ closes; None where floats do not tell."""
    function = Floats(reduced)
    q = np.unique(np.concatenate([np.linspace(0, X, 97), np.geomspace(1e-4, 1, 33) * X]))
    q[0] = 1e-9 * X
    with np.errstate(all="ignore"):
        values = _dets(function, q)
        for _ in range(_ROUNDS):
            steps = np.angle(values[1:] / values[:-1])
            wide = ~(np.abs(steps) < _STEP)
            if not wide.any():
                break
            between = (q[:-1][wide] + q[1:][wide]) / 2
            at = np.flatnonzero(wide) + 1
            values = np.insert(values, at, _dets(function, between))
            q = np.insert(q, at, between)
        else:
            return None
    middle = function.receptance.between(np.array([1j * X]), reduced.places)[0]
    try:
        with precision(64):
            closing = float(closing_argument(reduced, X, middle, np.zeros(middle.shape)))
    except PrecisionError:
        return None
    order = reduced.bodies - reduced.contacts - reduced.neutral
    total = (closing + order * float(arb.pi()) / 2 - float(steps.sum())) / np.pi
    return round(total) if abs(total - round(total)) < 0.05 else None


def _dets(function: Floats, q: Any) -> Any:
    A = function.matrices(1j * q)[0]
    sizes = np.abs(A).max(2, keepdims=True)
    return np.linalg.det(A / np.where(sizes > 0, sizes, 1))


def corners_and_more(box: tuple[Reals, Reals], seed: int = 1, more: int = 12) -> list[Reals]:
    """Points of a box (low, high): its corners, as long as they are few, and others; a fixed choice."""
    low, high = box
    ends = list(product(*zip(low, high, strict=True)))[:64]
    inner = np.random.default_rng(seed).uniform(size=(more, len(low)))
    return [np.array(end) for end in ends] + [low + t * (high - low) for t in inner]
