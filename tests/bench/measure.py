"""What all benches share: medians of repetitions in one process, processor time, and counted evaluations."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from mpsolve import Case
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.cases import as_problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.ranges.scope import forget


def median(function: Callable[[], Any], repeats: int = 5) -> float:
    """Processor seconds of one call, which other programs hardly change: the median of `repeats` calls."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        function()
        times.append(time.process_time() - start)
    return statistics.median(times)


def fresh(function: Callable[[], Any]) -> Callable[[], Any]:
    """Without what earlier questions about ranges have found of the track."""

    def asked() -> Any:
        forget()
        return function()

    return asked


class Counted:
    """A function of (…, q) that counts its calls and the points q that it was given."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self.function = function
        self.calls = self.points = 0

    def __call__(self, *arguments: Any) -> Any:
        self.calls += 1
        self.points += getattr(arguments[-1], "size", 1)
        return self.function(*arguments)


def delta_and_slope(case: Case) -> Callable[[Any], tuple[Any, Any]]:
    """Δ and Δ_q of a case on arrays of q in float64, up to a constant factor: what the search for candidates has."""
    reduced = reduce_problem(as_problem(case))
    floats, turn = Floats(reduced), 1j / float(reduced.frequency_unit)

    def at(q: Any) -> tuple[Any, Any]:
        points = np.asarray(q, complex)
        value, slope = floats.delta(turn * points.ravel())
        return value.reshape(points.shape), turn * slope.reshape(points.shape)

    return at


def seconds(value: float) -> str:
    """With a unit that fits, in ten columns."""
    for unit, scale in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= scale:
            return f"{value / scale:7.2f} {unit:2}"
    return f"{value / 1e-9:7.2f} ns"
