"""Lines over one quantity: several curves with names at their ends, marks, and ground on which growth is shaded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
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

_APART, _STEP, _WIDTH = 14.0, 3.5, 7.5
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
    drawn, taken = _marks(axes, marks)
    parts += drawn
    taken += [_Word(LEFT + 6, TOP + 15, "grows", "start")] * (grows_above is not None)
    parts += [text(word.x, word.y, word.said, word.anchor) for word in _apart(_names(axes, curves), taken)]
    parts += axes.titled(x_title, y_title)
    return svg(parts, title)


def _range(values: Sequence[Any], margin: float = 0.0) -> tuple[float, float]:
    finite = np.concatenate([np.ravel(v)[np.isfinite(np.ravel(v))] for v in values]) if len(values) else np.zeros(0)
    if not len(finite):
        return 0.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    wide = (high - low) or abs(high) or 1.0
    return low - margin * wide, high + margin * wide


@dataclass(frozen=True)
class _Word:
    x: float
    y: float
    said: str
    anchor: str

    @property
    def reach(self) -> tuple[float, float]:
        wide = _WIDTH * len(self.said)
        left = {"start": self.x, "end": self.x - wide}[self.anchor]
        return left, left + wide


def _apart(words: list[_Word], taken: list[_Word]) -> list[_Word]:
    """Each word at the height nearest to its own at which it lies over none that is placed before it."""
    for word in words:
        shifts = sorted((k * _STEP for k in range(-40, 41)), key=abs)
        heights = [word.y + d for d in shifts if TOP + 12 <= word.y + d <= _LOWEST]
        free = (y for y in heights if not any(_meets(replace(word, y=y), other) for other in taken))
        taken.append(replace(word, y=next(free, word.y)))
    return taken


def _meets(a: _Word, b: _Word) -> bool:
    (left, right), (low, high) = a.reach, b.reach
    return min(right, high) > max(left, low) and abs(a.y - b.y) < _APART


def _marks(axes: Axes, marks: Sequence[Mark]) -> tuple[list[str], list[_Word]]:
    parts, words = [], []
    for k, mark in enumerate(sorted(marks, key=lambda one: one.x)):
        x = float(axes.px(mark.x))
        if not LEFT <= x <= WIDE - RIGHT:
            continue
        parts.append(path(f"M {x:.1f} {TOP} V {HIGH - BOTTOM}", "here"))
        right = x < (LEFT + WIDE - RIGHT) / 2
        y = _LOWEST - 16 * (k % 3)
        words.append(_Word(x + (5 if right else -5), y, mark.name, "start" if right else "end"))
    return parts, words


def _names(axes: Axes, curves: Sequence[Curve]) -> list[_Word]:
    """The names at the ends of the curves."""
    words = []
    for curve in curves:
        good = np.flatnonzero(np.isfinite(curve.y))
        if curve.name and len(good):
            x, y = float(axes.px(curve.x[good[-1]])), float(axes.py(curve.y[good[-1]]))
            words.append(_Word(min(x, WIDE - RIGHT) - 5, float(np.clip(y - 4, TOP + 12, _LOWEST)), curve.name, "end"))
    return sorted(words, key=lambda word: word.y)
