"""Lines over one quantity: several curves with names at their ends, marks, and ground on which growth is shaded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.pictures.axes import (
    BOTTOM,
    HIGH,
    LEFT,
    RIGHT,
    TOP,
    WIDE,
    Axes,
    box,
    clip,
    curve_class,
    line,
    path,
    svg,
    text,
)

_APART = 14.0
_LOWEST = HIGH - BOTTOM - 6.0


@dataclass(frozen=True)
class Curve:
    """y over x; nan breaks it. name: written at its highest end. beyond: from this x on it is only shown in grey."""

    x: Any
    y: Any
    name: str = ""
    beyond: float | None = None


@dataclass(frozen=True)
class Mark:
    """A vertical line at x with a word."""

    x: float
    name: str


def lines_picture(
    curves: Sequence[Curve],
    x_title: str,
    y_title: str,
    title: str,
    *,
    name: str,
    x: tuple[float, float] | None = None,
    y: tuple[float, float] | None = None,
    marks: Sequence[Mark] = (),
    grows_above: float | None = None,
) -> str:
    """The curves in their colours and dashes; where y > grows_above the ground is shaded."""
    axes = Axes(x or _range([c.x for c in curves]), y or _range([c.y for c in curves], 0.06))
    parts = [clip(f"{name}-inside")]
    if grows_above is not None and grows_above < axes.y[1]:
        low = max(grows_above, axes.y[0])
        ground = float(axes.py(low))
        parts.append(box(LEFT, TOP, WIDE - LEFT - RIGHT, ground - TOP, "grows"))
    parts.append(f'<g clip-path="url(#{name}-inside)">')
    for k, curve in enumerate(curves):
        inside = np.ones(np.shape(curve.x), bool) if curve.beyond is None else np.asarray(curve.x) <= curve.beyond
        parts.append(line(axes, curve.x, np.where(inside, curve.y, np.nan), curve_class(k)))
        if not inside.all():
            parts.append(line(axes, curve.x, np.where(inside, np.nan, curve.y), f"{curve_class(k)} beyond"))
    parts.append("</g>")
    parts += _marks(axes, marks)
    parts += _names(axes, curves)
    if grows_above is not None:
        parts.append(text(LEFT + 6, TOP + 15, "grows"))
    parts += axes.titled(x_title, y_title)
    return svg(parts, title)


def _range(values: Sequence[Any], margin: float = 0.0) -> tuple[float, float]:
    finite = np.concatenate([np.ravel(v)[np.isfinite(np.ravel(v))] for v in values]) if len(values) else np.zeros(0)
    if not len(finite):
        return 0.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    wide = (high - low) or abs(high) or 1.0
    return low - margin * wide, high + margin * wide


def _marks(axes: Axes, marks: Sequence[Mark]) -> list[str]:
    parts = []
    for k, mark in enumerate(sorted(marks, key=lambda one: one.x)):
        x = float(axes.px(mark.x))
        if not LEFT <= x <= WIDE - RIGHT:
            continue
        parts.append(path(f"M {x:.1f} {TOP} V {HIGH - BOTTOM}", "here"))
        right = x < (LEFT + WIDE - RIGHT) / 2
        y = HIGH - BOTTOM - 8 - 16 * (k % 3)
        parts.append(text(x + (5 if right else -5), y, mark.name, "start" if right else "end"))
    return parts


def _names(axes: Axes, curves: Sequence[Curve]) -> list[str]:
    """Names at the ends of the curves, moved apart."""
    ends = []
    for curve in curves:
        good = np.flatnonzero(np.isfinite(curve.y))
        if curve.name and len(good):
            x, y = float(axes.px(curve.x[good[-1]])), float(axes.py(curve.y[good[-1]]))
            ends.append((float(np.clip(y, TOP + 12, _LOWEST)), min(x, WIDE - RIGHT) - 5, curve.name))
    ends.sort()
    heights = [y for y, _, _ in ends]
    for k in range(1, len(heights)):
        heights[k] = max(heights[k], heights[k - 1] + _APART)
    for k in range(len(heights) - 1, -1, -1):
        heights[k] = min(heights[k], _LOWEST if k == len(heights) - 1 else heights[k + 1] - _APART)
    return [text(x, y - 4, name, "end") for y, (_, x, name) in zip(heights, ends, strict=True)]
