"""A drawing of the user's own track and vehicles, lengths to scale, made from their equations alone.

Fields of the track become layers, coupling between fields springs and dampers; coordinates of a vehicle become boxes,
those that touch the rail wheels. Nothing is known of any model.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from mpsolve.pictures.axes import WIDE, box, disc, path, svg, text
from mpsolve.problem.problem import Problem
from mpsolve.tracks.waveguide import Polynomial
from mpsolve.vehicles.vehicle import Pencil

_MARGIN, _LAYER, _LEVEL, _WHEEL = 16, 44, 40, 8
_SPRINGS = 9


@dataclass(frozen=True)
class Box:
    """A part of a vehicle: its coordinates, how many links it is above the wheels, and where it reaches."""

    coordinates: tuple[int, ...]
    level: int
    left: float
    right: float


def boxes_of(pencil: Pencil) -> list[Box]:
    """The wheels (level 0) and what is above them, by links of springs and dampers.

    Coordinates of one level that hang on the same parts below are one body: its bounce and its pitch.
    """
    n = pencil.size
    linked = [{j for j in range(n) if j != i and (pencil.K[i][j] or pencil.C[i][j])} for i in range(n)]
    touches = {i: [float(x) for x, b in zip(pencil.places, pencil.B[i], strict=True) if b] for i in range(n)}
    level = {i: 0 for i in range(n) if touches[i]}
    reach = {i: (min(x), max(x)) for i, x in touches.items() if x}
    current = set(level)
    while current:
        above = {j for i in current for j in linked[i]} - level.keys()
        for j in above:
            ends = [reach[i] for i in linked[j] if i in current]
            reach[j] = (min(a for a, _ in ends), max(b for _, b in ends))
            level[j] = level[min(i for i in linked[j] if i in current)] + 1
        current = above
    groups: dict[tuple[int, frozenset[int]], list[int]] = {}
    for i in sorted(level):
        below = frozenset(j for j in linked[i] if level.get(j, -1) == level[i] - 1)
        key = (level[i], below if below else frozenset([-1 - i]))
        groups.setdefault(key, []).append(i)
    return [
        Box(tuple(group), where, min(reach[i][0] for i in group), max(reach[i][1] for i in group))
        for (where, _), group in groups.items()
    ]


@dataclass(frozen=True)
class Layer:
    """A field of the track: what it is made of, and to which fields below it is tied (−1: the ground)."""

    bends: bool
    heavy: bool
    tied: tuple[tuple[int, bool, bool], ...]  # (to, spring, damper)


def layers_of(matrix: Sequence[Sequence[Polynomial]]) -> list[Layer]:
    """The fields of the track from the rail downwards."""
    out = []
    size = len(matrix)
    for i in range(size):
        own = matrix[i][i]
        ties = []
        for j in range(i + 1, size):
            spring, damper = bool(matrix[i][j].get((0, 0))), bool(matrix[i][j].get((0, 1)))
            if matrix[i][j]:
                ties.append((j, spring, damper))
        spring, damper = (sum(matrix[i][j].get((0, k), 0) for j in range(size)) != 0 for k in (0, 1))
        if spring or damper:
            ties.append((-1, spring, damper))
        out.append(Layer(any(power >= 2 for power, _ in own), bool(own.get((0, 2))), tuple(ties)))
    return out


def model_picture(problem: Problem, si: bool = True) -> str:
    """The drawing: x ahead is right, the velocity points right. si: in m and m/s, else in the paper's ratios."""
    pencil = problem.pencil
    places = [float(x) for x in pencil.places]
    reach = max(3.0, 0.25 * (max(places) - min(places)))
    left, right = min(places) - reach, max(places) + reach
    vehicles, layers = boxes_of(pencil), layers_of(problem.track.waveguide.matrix)
    top = max((box.level for box in vehicles), default=0)
    rail = 34 + (top + 1) * _LEVEL
    high = rail + _LAYER * len(layers) + 46

    def x(place: float) -> float:
        return _MARGIN + (place - left) / (right - left) * (WIDE - 2 * _MARGIN)

    parts = [_velocity(problem, si)]
    parts += _track(layers, rail)
    parts += _vehicles(vehicles, pencil, rail, x)
    parts += _ruler(places, x, high - 20, " m" if si else "")
    return svg(parts, "The track and the vehicles, lengths along the track to scale", high)


def _velocity(problem: Problem, si: bool) -> str:
    v = float(problem.v)
    told = f"v = {v:.6g} m/s = {3.6 * v:.6g} km/h" if si else f"α = {v:.6g}"
    said = text(_MARGIN, 20, told, name="note")
    return said + (path(f"M {WIDE - 110} 26 h 90 m -8 -5 l 8 5 l -8 5") if v else "")


def _track(layers: list[Layer], rail: float) -> list[str]:
    parts, ground, wide = [], rail + _LAYER * len(layers), WIDE / _SPRINGS
    for k, layer in enumerate(layers):
        y = rail + _LAYER * k
        if k == 0 or layer.bends:
            parts.append(path(f"M 0 {y} H {WIDE}", "rail"))
        elif layer.heavy:
            parts += [box((j + 0.22) * wide, y - 6, 0.56 * wide, 12) for j in range(_SPRINGS)]
        for to, spring, damper in layer.tied:
            end = ground if to < 0 else rail + _LAYER * to - (0 if layers[to].bends else 6)
            aside = to < 0 and k < len(layers) - 1
            for j in range(_SPRINGS):
                parts += _tie((j + (0.85 if aside else 0.5)) * wide, y, end, spring, damper)
    parts.append(path(f"M 0 {ground} H {WIDE}"))
    return parts + [path(f"M {x} {ground} l -8 8", "tick") for x in range(10, WIDE + 8, 16)]


def _tie(x: float, y: float, end: float, spring: bool, damper: bool) -> list[str]:
    both = 6 * (spring and damper)
    return [_spring(x - both, y, end)] * spring + [_damper(x + both, y, end)] * damper


def _spring(x: float, y: float, end: float) -> str:
    step = (end - y) / 8
    zigzag = " ".join(f"L {x + 4 * (-1) ** k:.1f} {y + (k + 1) * step:.1f}" for k in range(1, 6))
    return path(f"M {x:.1f} {y:.1f} V {y + step:.1f} {zigzag} L {x:.1f} {y + 7 * step:.1f} V {end:.1f}")


def _damper(x: float, y: float, end: float) -> str:
    middle, size = (y + end) / 2, min(6.0, (end - y) / 5)
    pot = f"M {x - 5:.1f} {middle - size:.1f} v {2 * size:.1f} h 10 v {-2 * size:.1f}"
    rods = f"M {x:.1f} {y:.1f} V {middle:.1f} m -4 0 h 8 M {x:.1f} {middle + size:.1f} V {end:.1f}"
    return path(f"{rods} {pot}")


def _vehicles(boxes: list[Box], pencil: Pencil, rail: float, x: Any) -> list[str]:
    parts: list[str] = []
    for one in boxes:
        name = ", ".join(pencil.names[i] for i in one.coordinates)
        if one.level == 0 and one.left == one.right:
            parts += _wheel(one, pencil, rail, x(one.left), name)
            continue
        y, a, b = rail - 2 * _WHEEL - _LEVEL * one.level, x(one.left) - 9, x(one.right) + 9
        parts += [box(a, y - 8, b - a, 16, title=name), *_hung(one, boxes, y, x)]
    return parts


def _wheel(one: Box, pencil: Pencil, rail: float, x: float, name: str) -> list[str]:
    contact = min(range(pencil.contacts), key=lambda j: abs(float(pencil.places[j]) - one.left))
    soft = bool(pencil.h[contact])
    wheel = disc(x, rail - _WHEEL - 2 - 6 * soft, _WHEEL, title=name)
    return [wheel, *[path(f"M {x - 5:.1f} {rail - 8} l 10 3 l -10 3")] * soft]


def _hung(one: Box, boxes: list[Box], y: float, x: Any) -> list[str]:
    """The links from a box to what is below it."""
    below = [b for b in boxes if b.level == one.level - 1 and one.left <= b.left and b.right <= one.right]
    end = y + _LEVEL - (8 if one.level > 1 else 2)
    return [_spring(x((b.left + b.right) / 2), y + 8, end) for b in below]


def _ruler(places: list[float], x: Any, y: float, unit: str) -> list[str]:
    marks = sorted(set(places))
    if not 2 <= len(marks) <= 8:
        length = marks[-1] - marks[0]
        said = f"{len(marks)} contacts over {length:.6g}{unit}" if length else ""
        return [text(WIDE / 2, y, said, "middle", "note")]
    parts = []
    for a, b in pairwise(marks):
        parts.append(path(f"M {x(a):.1f} {y} H {x(b):.1f} m 0 -4 v 8 M {x(a):.1f} {y - 4} v 8"))
        if x(b) - x(a) > 42:
            parts.append(text((x(a) + x(b)) / 2, y + 14, f"{b - a:.4g}{unit}", "middle", "note"))
    return parts
