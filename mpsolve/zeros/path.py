"""The path round a region: the edges of its polygon, turned left, and both sides of the cuts that reach into it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from mpsolve.errors import InputError
from mpsolve.zeros.geometry import Point, Vertices, cross, distance_squared, edges, is_convex, is_inside
from mpsolve.zeros.regions import Cut


@dataclass(frozen=True)
class Leg:
    """A straight piece of the path from a to b; the region lies to its left."""

    a: Point
    b: Point

    def at(self, t: Fraction) -> Point:
        return self.a[0] + t * (self.b[0] - self.a[0]), self.a[1] + t * (self.b[1] - self.a[1])


def legs_round(vertices: Vertices, cuts: Sequence[Cut]) -> tuple[Leg, ...]:
    """The legs of all closed paths: cuts from outside are gone in and out, those that lie inside gone round.

    InputError for a cut that divides the region, or that ends on its boundary, and for cuts that meet.
    """
    require_apart(cuts)
    inner, loops = crossings(vertices, cuts)
    out: list[Leg] = []
    for k, (a, b) in enumerate(edges(vertices)):
        here = a
        for t, tip in sorted(inner.get(k, [])):
            point = Leg(a, b).at(t)
            out += [Leg(here, point), Leg(point, tip), Leg(tip, point)]
            here = point
        out.append(Leg(here, b))
    for a, b in loops:
        out += [Leg(a, b), Leg(b, a)]
    return tuple(out)


def require_apart(cuts: Sequence[Cut]) -> None:
    """InputError for two cuts that have a point in common."""
    for k, one in enumerate(cuts):
        for other in cuts[:k]:
            tips = any(a.holds(tip, tip) for a, b in ((one, other), (other, one)) for tip in b.tips)
            level, upright = (one, other) if one.direction[1] == 0 else (other, one)
            corner = (upright.origin[0], level.origin[1])
            if tips or (one.holds(corner, corner) and other.holds(corner, corner)):
                raise InputError("cuts", f"has two cuts that meet ({one}; {other}): divide the region between them")


def crossings(
    vertices: Vertices, cuts: Sequence[Cut]
) -> tuple[dict[int, list[tuple[Fraction, Point]]], list[tuple[Point, Point]]]:
    """For each edge the places where cuts come in, with their tips; and the cuts that lie inside."""
    inner: dict[int, list[tuple[Fraction, Point]]] = {}
    loops = []
    for cut in cuts:
        if any(cut.place_of(a) is not None and cut.place_of(b) is not None for a, b in edges(vertices)):
            if not is_convex(vertices):  # the line may go on inside
                raise InputError("cuts", f"has a cut along an edge of a region that is not convex ({cut}): divide it")
            continue  # along an edge: seen from inside only
        met = [(k, *found) for k, (a, b) in enumerate(edges(vertices)) if (found := _crossing(cut, a, b))]
        for tip in cut.tips:
            if any(not distance_squared(tip, a, b) for a, b in edges(vertices)):
                raise InputError("cuts", f"has a branch point on the boundary of the region ({cut}): move a side")
        inside = [tip for tip in cut.tips if is_inside(vertices, tip)]
        if len(inside) == 2:
            if met:
                raise InputError(
                    "cuts", f"has a cut that leaves the region and comes back ({cut}): give a smaller region"
                )
            loops.append((inside[0], inside[1]))
        elif len(inside) == 1 and len(met) == 1:
            k, t, _ = met[0]
            inner.setdefault(k, []).append((t, inside[0]))
        elif met or inside:
            raise InputError(
                "cuts", f"has a cut that divides the region ({cut}): give each side as a region of its own"
            )
    return inner, loops


def _crossing(cut: Cut, a: Point, b: Point) -> tuple[Fraction, Fraction] | None:
    """(t on the edge, place on the cut) where they cross; InputError at a corner."""
    here = cut.origin
    far = (here[0] + cut.direction[0], here[1] + cut.direction[1])
    p, q = cross(here, far, a), cross(here, far, b)
    if p == q or (p > 0 and q > 0) or (p < 0 and q < 0):
        return None
    t = p / (p - q)
    point = Leg(a, b).at(t)
    place = cut.place_of(point)
    if place is None or place < 0 or (cut.length is not None and place > cut.length):
        return None
    if t in (0, 1):
        raise InputError("cuts", f"has a cut through a corner of the region ({cut}): move a side")
    return t, place
