"""Roots in a rectangle that reaches above the real axis, below every cut: a second column of the table."""

from __future__ import annotations

from typing import Any

import numpy as np

from oracle_general.count import Alarm
from oracle_general.floats import Floats
from oracle_general.roots import rectangle_contour, roots_in_rectangle
from oracle_general.tracks import track

MOST = 12


def lowest_cut(problem: dict[str, Any]) -> float:
    """The least Im Ω of the track at rest over a dense set of real p (its cuts in q begin there)."""
    D, _ = track(problem["track"])
    orders = max(j for _, j in D)
    least, scale = np.inf, Floats(problem)
    size = np.abs(scale.p_roots(np.array([-1j * scale.scale]))).max()
    for p in np.concatenate([[0.0], size * np.geomspace(1e-6, 30, 2000)]):
        X = np.zeros(orders + 1)
        for (i, j), value in D.items():
            X[j] += float(value) * p**i
        roots = np.roots(X[::-1])
        if len(roots):
            least = min(least, float((-roots.real).min()))
    return least


def with_rectangle(row: dict[str, Any], digits: int = 25) -> dict[str, Any]:
    """The row with a rectangle, its count and its roots with Re q ≥ 0; as it is where none can be had."""
    hidden = any(v["model"] == "matrices" and len(v["B"]) > len(v["places"]) for v in row["vehicles"])
    floats = Floats(row)
    height = 0.6 * lowest_cut(row)
    if hidden or height < 1e-3 * floats.scale:
        return row
    for wide in (3.0, 1.7, 0.9):
        right, bottom, top = (
            float(f"{x:.3g}") for x in (wide * floats.scale, -0.7 * floats.scale, min(height, floats.scale))
        )
        try:
            found = _twice(floats, right, bottom, top, digits)
        except ArithmeticError:
            continue
        corners = [f"{x:.3g}" for x in (-right, bottom, right, top)]
        roots = [[_figure(q.real, abs(q)), _figure(q.imag, abs(q))] for q in found]
        return {**row, "rectangle": {"corners": corners, "count": _mirrored(found), "roots": roots}}
    return row


def _twice(floats: Floats, right: float, bottom: float, top: float, digits: int) -> list[Any]:
    """The roots with Re q ≥ 0: as many, with their mirror images, as the argument counts round the rectangle."""
    whole = [
        round(rectangle_contour(floats, complex(-right, bottom), complex(right, top), start).angle / 2 / np.pi)
        for start in (16, 51)
    ]
    if whole[0] != whole[1] or whole[0] > MOST:
        raise Alarm(f"{whole} roots")
    found = (
        roots_in_rectangle(floats, complex(-0.0137 * right, bottom), complex(right, top), digits) if whole[0] else []
    )
    found = [q for q in found if q.real > -1e-12 * right]
    if _mirrored(found) != whole[0]:
        raise Alarm(f"{_mirrored(found)} of {whole[0]} roots")
    return sorted(found, key=lambda q: (float(q.real), float(q.imag)))


def _mirrored(roots: list[Any]) -> int:
    return sum(1 if abs(q.real) < 1e-12 * abs(q) else 2 for q in roots)


def _figure(x: Any, size: Any) -> str:
    return "0" if abs(x) < 1e-12 * size else f"{float(x):.10e}"
