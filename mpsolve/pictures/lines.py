"""Lines over one quantity: several curves with names at their ends, marks, and ground on which growth is shaded."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
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
    end_mark,
    line,
    mark_at,
    marked,
    path,
    svg,
    text,
)
from mpsolve.vibration.motion import Vibration

_APART, _WIDTH, _ROW = 14.0, 7.5, 17
_SHORT = 3  # letters: names that stand at their curves, longer ones in a key below
_LOWEST = HIGH - BOTTOM - 6.0


@dataclass(frozen=True)
class Curve:
    """y over x; nan breaks it. name: at its end, or in a key. beyond: from this x on it is only shown in grey.

    ends: at which of its points it ends at a cut, which has a mark of its own.
    """

    x: Reals
    y: Any
    name: str = ""
    beyond: float | None = None
    ends: Sequence[bool] = ()


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
        parts.append(marked(axes, curve.x, np.where(inside, curve.y, np.nan), k))
        parts += [
            end_mark(float(axes.px(a)), float(axes.py(b)))
            for a, b, end in zip(curve.x, curve.y, curve.ends, strict=False)
            if end
        ]
        if not inside.all():
            parts.append(line(axes, curve.x, np.where(inside, np.nan, curve.y), f"{curve_class(k)} beyond"))
    parts.append("</g>")
    ink, taken = np.concatenate([_ink(axes, curves), _uprights(axes, marks)], 1), []
    if grows_above is not None:
        taken.append(_Word(LEFT + 6, TOP + 15, "grows", "start"))
    long = any(len(curve.name) > _SHORT for curve in curves)
    parts += _marks(axes, marks, ink, taken)
    if not long:
        _names(axes, curves, ink, taken)
    parts += [text(word.x, word.y, word.said, word.anchor) for word in taken]
    parts += axes.titled(x_title, y_title)
    return svg([*parts, *(_key(curves) if long else [])], title, HIGH + (4 + _ROW * -(-len(curves) // 2)) * long)


def motion_pictures(
    found: Vibration, names: Mapping[int, str], si: bool, until: Any = slice(None), prefix: str = ""
) -> tuple[str, str]:
    """The rail under the named contacts (counted from 0), and the forces there; grey after the first lift-off.

    si: in mm, kN and s. until: which times are shown. prefix: of the names of the elements.
    """
    end, pictures = None if found.lift_off is None else found.lift_off.time, []
    length, force, time = ("mm", "kN", "s") if si else ("unit lengths", "unit forces", "τ")
    for name, title, y_title, rows, factor in (
        ("deflection", "Deflection of the rail under the contacts", f"deflection, {length}", found.rail, 1000.0),
        ("force", "Contact forces", f"contact force, {force}", found.contact_force, 1e-3),
    ):
        one = factor if si else 1.0
        curves = [Curve(found.times[until], one * rows[k][until], said, end) for k, said in names.items()]
        marks = [] if end is None else [Mark(end, "lift-off")]
        pictures.append(lines_picture(curves, f"time, {time}", y_title, title, name=f"{prefix}{name}", marks=marks))
    return pictures[0], pictures[1]


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


def _ink(axes: Axes, curves: Sequence[Curve]) -> Reals:
    """Points (2, n) of the picture on the curves, close to each other."""
    points = [np.zeros((2, 0))]
    for curve in curves:
        x, y = np.broadcast_arrays(axes.px(curve.x), axes.py(curve.y))
        good = np.isfinite(x) & np.isfinite(y)
        if good.sum() > 1:
            fine = np.arange(float(x[good].min()), float(x[good].max()), 1.0)
            near = np.abs(fine[:, None] - x[good]).min(1) < WIDE / 20  # not over gaps
            order = np.argsort(x[good])
            points.append(np.stack([fine, np.interp(fine, x[good][order], y[good][order])])[:, near])
    return np.concatenate(points, 1)


def _uprights(axes: Axes, marks: Sequence[Mark]) -> Reals:
    """Points (2, n) on the lines of the marks."""
    y = np.arange(TOP, HIGH - BOTTOM, 4.0)
    return np.array([(float(axes.px(mark.x)), at) for mark in marks for at in y]).reshape(-1, 2).T


def _placed(words: list[_Word], ink: Reals, taken: list[_Word]) -> None:
    """The first of the words that lies over nothing, else over no other word, else the first of all."""
    clear = [word for word in words if not any(_meets(word, other) for other in taken)]
    free = (word for word in clear if not _over(word, ink))
    taken.append(next(free, clear[0] if clear else words[0]))


def _meets(a: _Word, b: _Word) -> bool:
    (left, right), (low, high) = a.reach, b.reach
    return min(right, high) > max(left, low) and abs(a.y - b.y) < _APART


def _over(word: _Word, ink: Reals) -> bool:
    """Whether a curve runs through the word."""
    left, right = word.reach
    x, y = ink
    return bool(((x > left - 2) & (x < right + 2) & (y > word.y - 12) & (y < word.y + 4)).any())


def _marks(axes: Axes, marks: Sequence[Mark], ink: Reals, taken: list[_Word]) -> list[str]:
    parts = []
    heights = [*np.arange(_LOWEST, TOP + 20, -8.0).tolist()]
    for mark in sorted(marks, key=lambda one: one.x):
        x = float(axes.px(mark.x))
        if not LEFT <= x <= WIDE - RIGHT:
            continue
        parts.append(path(f"M {x:.1f} {TOP} V {HIGH - BOTTOM}", "here"))
        right = x < (LEFT + WIDE - RIGHT) / 2
        sides = [(x + 5, "start"), (x - 5, "end")][:: 1 if right else -1]
        room = [(at, anchor) for at, anchor in sides if _inside(at, mark.name, anchor)] or sides[:1]
        _placed([_Word(at, y, mark.name, anchor) for at, anchor in room for y in heights], ink, taken)
    return parts


def _inside(x: float, said: str, anchor: str) -> bool:
    left, right = _Word(x, 0.0, said, anchor).reach
    return left >= LEFT and right <= WIDE - RIGHT


def _names(axes: Axes, curves: Sequence[Curve], ink: Reals, taken: list[_Word]) -> None:
    """Short names beside the curves, as near to their ends as there is room."""
    for own, curve in enumerate(curves):
        alone, *others = (_ink(axes, some) for some in ([curve], [*curves[:own], *curves[own + 1 :]]))
        x, y = np.broadcast_arrays(axes.px(curve.x), axes.py(curve.y))
        good = np.flatnonzero(np.isfinite(y) & (y > TOP) & (y < HIGH - BOTTOM))
        if not curve.name or not len(good):
            continue
        places = good[:: -max(1, len(good) // 12)].tolist()
        words = []
        for k in places:
            at = min(max(float(x[k]), LEFT + 14), WIDE - RIGHT) - 4
            for shift in (-5.0, 15.0, -11.0, 21.0, -17.0, 27.0):
                words.append(_Word(at, float(np.clip(y[k] + shift, TOP + 12, _LOWEST)), curve.name, "end"))
        _placed([*(word for word in words if _own(word, alone, *others)), *words], ink, taken)


def _own(word: _Word, own: Reals, others: Reals) -> bool:
    """Whether the curve is clearly nearer to the word than any other one is."""
    middle = np.array([[sum(word.reach) / 2], [word.y - 4]])
    near, next_near = (float(np.hypot(*(ink - middle)).min(initial=np.inf)) for ink in (own, others))
    return near < 0.6 * next_near


def _key(curves: Sequence[Curve]) -> list[str]:
    """Below the axes, in two columns: each curve's line and marks with its name."""
    parts = []
    for k, curve in enumerate(curves):
        x, y = LEFT + (k % 2) * (WIDE - LEFT - RIGHT) / 2, HIGH + 10 + _ROW * (k // 2)
        parts += [path(f"M{x:.1f} {y}h30", curve_class(k)), mark_at(x + 15, y, k)]
        parts.append(text(x + 36, y + 4, curve.name, name="note"))
    return parts
