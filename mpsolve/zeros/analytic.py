"""A proof that f is analytic in a region without its cuts: boxes that cover it, each of which passes.

The boxes are halves of halves of cells, along their longer side (the lower or left half first); cells are divided by
the lines of the cuts and by those across their tips, so that a cut is an edge of the boxes beside it. A tree is
written as a text in the order in which its boxes are visited: "." passes, "o" lies outside, "|" is halved.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from flint import acb, arb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import rational_ball
from mpsolve.proof.effort import Effort
from mpsolve.zeros.function import Function
from mpsolve.zeros.geometry import Point, Vertices, box_of, place_of_box
from mpsolve.zeros.regions import Cut

_DEEPEST = 60
_DEEP, _MOST_DEEP = 40, 500
"""So many boxes of such a depth lie along a line, as beside a cut that is not declared, and not round a point."""

Box = tuple[Fraction, Fraction, Fraction, Fraction]
"""re_min, re_max, im_min, im_max."""


class NotAnalyticError(PrecisionError):
    """No box round `place` passes, however small, or far too many are needed; `cause` says what fails there."""

    def __init__(self, place: complex, cause: PrecisionError) -> None:
        super().__init__(f"f is not proved to be analytic near {place:.6g}: {cause}")
        self.place, self.cause = place, cause


@dataclass(frozen=True)
class Edge:
    """An edge of a box on the line of a cut: on the cut itself, or beyond its tip."""

    start: Point
    end: Point
    normal: Point  # into the box
    beyond: tuple[Point, Point] | None  # the tip and the direction away from the cut


def hull(*points: Point) -> Any:
    """The ball that holds a box or a segment given by its corners; exact where they are short."""
    return acb(*(_interval([p[k] for p in points]) for k in (0, 1)))


def _interval(xs: Sequence[Fraction]) -> Any:
    low, high = min(xs), max(xs)
    if low == high:
        return rational_ball(low)
    return rational_ball((low + high) / 2) + arb(0, rational_ball((high - low) / 2).upper())


def cells(vertices: Vertices, cuts: Sequence[Cut]) -> list[Box]:
    """The box of the polygon, divided by the lines of the cuts and across their tips; columns from the left."""
    left, right, low, high = box_of(vertices)
    xs, ys = {left, right}, {low, high}
    for cut in cuts:
        for x, y in cut.tips:
            xs |= {x} if left < x < right else set()
            ys |= {y} if low < y < high else set()
    return [(a, b, c, d) for a, b in pairwise(sorted(xs)) for c, d in pairwise(sorted(ys))]


def halves(box: Box) -> tuple[Box, Box]:
    a, b, c, d = box
    if b - a >= d - c:
        m = (a + b) / 2
        return (a, m, c, d), (m, b, c, d)
    m = (c + d) / 2
    return (a, b, c, m), (a, b, m, d)


def is_outside(vertices: Vertices, box: Box) -> bool:
    """Whether no point of the closed box is inside the polygon."""
    a, b, c, d = box
    return place_of_box(vertices, (a, c), (b, d)) is False


def edges_on_cuts(box: Box, cuts: Sequence[Cut]) -> list[Edge]:
    """The edges of a box that lie on the line of a cut: on the cut, or next to its tip beyond it."""
    a, b, c, d = box
    one, zero = Fraction(1), Fraction(0)
    sides = [
        ((a, c), (b, c), (zero, one)),
        ((a, d), (b, d), (zero, -one)),
        ((a, c), (a, d), (one, zero)),
        ((b, c), (b, d), (-one, zero)),
    ]
    out = []
    for start, end, normal in sides:
        for cut in cuts:
            if cut.holds(start, end):
                out.append(Edge(start, end, normal, None))
            elif cut.place_of(start) is not None and cut.place_of(end) is not None:
                x, y = cut.direction
                for tip, away in zip(cut.tips, ((-x, -y), (x, y)), strict=False):
                    if tip in (start, end):
                        out.append(Edge(start, end, normal, (tip, away)))
    return out


def require_box(f: Function, box: Box, cuts: Sequence[Cut]) -> None:
    """`PrecisionError` unless f is analytic on the closed box without the cuts."""
    a, b, c, d = box
    ball = hull((a, c), (b, d))
    try:
        f.require_analytic(ball)
    except PrecisionError:
        for edge in edges_on_cuts(box, cuts):
            if _beside(f, ball, edge):
                return
        raise


def _beside(f: Function, ball: Any, edge: Edge) -> bool:
    beyond = None if edge.beyond is None else tuple(hull(p) for p in edge.beyond)
    try:
        f.require_analytic(ball, (hull(edge.start, edge.end), hull(edge.normal)), beyond)
    except PrecisionError:
        return False
    return True


def cover_region(f: Function, vertices: Vertices, cuts: Sequence[Cut], effort: Effort) -> tuple[str, ...]:
    """The tree of each cell; empty where f is entire. NotAnalyticError where no box passes near a place."""
    if f.entire:
        return ()
    return tuple(_tree(f, vertices, cuts, cell, effort) for cell in cells(vertices, cuts))


def _tree(f: Function, vertices: Vertices, cuts: Sequence[Cut], cell: Box, effort: Effort) -> str:
    out, stack, deep = list[str](), [(cell, 0)], 0
    while stack:
        box, depth = stack.pop()
        effort.spend(1)
        if is_outside(vertices, box):
            out.append("o")
            continue
        try:
            require_box(f, box, cuts)
            out.append(".")
        except PrecisionError as error:
            deep += depth >= _DEEP
            if depth >= _DEEPEST or deep > _MOST_DEEP:
                raise NotAnalyticError(complex((box[0] + box[1]) / 2, (box[2] + box[3]) / 2), error) from None
            out.append("|")
            first, second = halves(box)
            stack += [(second, depth + 1), (first, depth + 1)]
    return "".join(out)
