"""The roots themselves: subdivision of the count, moments of the contour as starts, the secant method in mpmath."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from oracle_general.count import Alarm, Count, Turning, count_below, count_inside, turning
from oracle_general.floats import Floats
from oracle_general.landmarks import crowded
from oracle_general.precise import Precise


def rectangle_contour(problem: Any, a: complex, b: complex, start: int = 16) -> Turning:
    """log Δ̃ once round the rectangle with corners a (lower left) and b (upper right), counterclockwise."""
    corners = [a, complex(b.real, a.imag), b, complex(a.real, b.imag), a]
    parts = [_side(problem, z, w, start) for z, w in pairwise(corners)]
    q = np.concatenate([part.q[:-1] for part in parts] + [parts[-1].q[-1:]])
    return Turning(q, np.concatenate([part.increments for part in parts]))


def _side(problem: Any, z: complex, w: complex, start: int) -> Turning:
    """One side; a horizontal one begins with points at the landmarks."""
    x = crowded(problem.landmarks, z.imag) if z.imag == w.imag else np.array([])
    marks = (np.concatenate([x, -x]) - z.real) / (w.real - z.real) if len(x) else x
    return turning(problem.log_delta, lambda t: z + (w - z) * t, start, marks=marks)


def roots_in_rectangle(problem: Floats, a: complex, b: complex, digits: int = 25, depth: int = 60) -> list[Any]:
    """All roots between the corners a and b, each by mpmath; as many as the argument counts, or an Alarm."""
    precise = Precise(problem.problem, digits)
    return _search(problem, precise, a, b, depth)


def _search(problem: Floats, precise: Precise, a: complex, b: complex, depth: int) -> list[Any]:
    contour = rectangle_contour(problem, a, b)
    number = round(contour.angle / 2 / np.pi)
    if number <= 0:
        if number < 0:
            raise Alarm(f"{number} roots between {a} and {b}")
        return []
    if number == 1:
        found = settled(precise, contour.moment(1))
        if found is not None and a.real <= found.real <= b.real and a.imag <= found.imag <= b.imag:
            return [found]
    if depth == 0:
        raise Alarm(f"{number} roots between {a} and {b} do not part")
    cut = 0.4731
    if (b - a).real > (b - a).imag:
        x = a.real + cut * (b.real - a.real)
        halves = [(a, complex(x, b.imag)), (complex(x, a.imag), b)]
    else:
        y = a.imag + cut * (b.imag - a.imag)
        halves = [(a, complex(b.real, y)), (complex(a.real, y), b)]
    return [root for low, high in halves for root in _search(problem, precise, low, high, depth - 1)]


def settled(precise: Precise, start: complex) -> Any:
    """The root near `start`, at more and more digits until two agree to 14 of them; None where none is found."""
    try:
        last = precise.root(start)
        for _ in range(4):
            precise = Precise(precise.problem, 2 * precise.mp.dps)
            found = precise.root(complex(last))
            if abs(found - last) < 1e-14 * abs(found):
                return found
            last = found
    except (ArithmeticError, precise.mp.NoConvergence):
        return None
    return None


def growing(problem: Floats, digits: int = 25, level: float | None = None, within: float | None = None,
            ) -> tuple[Count, list[Any]]:  # fmt: skip
    """The count of roots with Im q < level, and those of them with Re q ≥ 0 (the others are their mirror images)."""
    total = count_below(problem, level) if within is None else count_inside(problem, within, level)
    if total.number == 0:
        return total, []
    radius = total.radius
    while count_inside(problem, radius / 2, level).number == total.number:
        radius /= 2
    top = -1e-9 * problem.scale if level is None else level
    found = roots_in_rectangle(
        problem, complex(-0.0137 * radius, top - 1.01 * radius), complex(1.01 * radius, top), digits
    )
    kept = [q for q in found if abs(q - 1j * top) < radius and q.real > -1e-12 * radius]
    paired = sum(1 if abs(q.real) < 1e-12 * radius else 2 for q in kept)
    if paired != total.number:
        raise Alarm(f"{paired} roots found of {total.number}")
    return total, sorted(kept, key=lambda q: (float(q.real), float(q.imag)))
