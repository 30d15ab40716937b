"""Regions of the z-plane, exact: what a user asks for, and the polygon in which zeros are counted for it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.model import rational, shown
from mpsolve.numbers.units import measured
from mpsolve.numbers.written import Measured
from mpsolve.zeros.geometry import Point, Vertices, distance_squared, doubled_area, edges, is_simple, place_of_box

_SIDES = 32  # of the polygon round a disc


def exact_point(z: object, key: str) -> Point:
    """A complex number as two rationals: a pair, a number, or a text for a real one."""
    if isinstance(z, tuple) and len(z) == 2:
        return rational(z[0], key), rational(z[1], key)
    if isinstance(z, complex):
        return rational(z.real, key), rational(z.imag, key)
    return rational(z, key), Fraction(0)


def _bound(value: object, key: str) -> Fraction:
    """A text with a unit stays known as one."""
    number = measured(value, "rad/s", key, "bound")
    return number if isinstance(number, Measured) else rational(value, key)


@frozen
class Rectangle:
    """The open rectangle re_min < Re < re_max, im_min < Im < im_max; the bounds are exact rationals.

    For frequencies in SI they may be texts with a unit, "50 1/s".
    """

    re_min: Fraction
    re_max: Fraction
    im_min: Fraction
    im_max: Fraction

    def __init__(self, re_min: object, re_max: object, im_min: object, im_max: object) -> None:
        given = {"re_min": re_min, "re_max": re_max, "im_min": im_min, "im_max": im_max}
        vars(self).update({name: _bound(value, f"region.{name}") for name, value in given.items()})
        for axis in ("re", "im"):
            low, high = getattr(self, f"{axis}_min"), getattr(self, f"{axis}_max")
            if not low < high:
                stated = f"is {shown(high, high)}, not above {axis}_min = {shown(low, low)}"
                raise InputError(f"region.{axis}_max", f"{stated}: give the bounds in order")

    @property
    def has_units(self) -> bool:
        return any(isinstance(bound, Measured) for bound in self.bounds)

    @property
    def bounds(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """re_min, re_max, im_min, im_max."""
        return self.re_min, self.re_max, self.im_min, self.im_max

    def as_dict(self) -> dict[str, str]:
        """The bounds by name as exact texts."""
        return {name: str(value) for name, value in vars(self).items()}

    @property
    def polygon(self) -> Vertices:
        """Its corners, turned left."""
        a, b, c, d = self.bounds
        return (a, c), (b, c), (b, d), (a, d)

    def __str__(self) -> str:
        a, b, c, d = (f"{float(x):.6g}" for x in self.bounds)
        return f"{a} < Re q < {b}, {c} < Im q < {d}"


@frozen
class Disc:
    """The open disc |z − centre| < radius; centre: a complex number or a pair of exact ones."""

    centre: Point
    radius: Fraction

    def __init__(self, centre: object, radius: object) -> None:
        vars(self).update(centre=exact_point(centre, "region.centre"), radius=rational(radius, "region.radius"))
        if not self.radius > 0:
            raise InputError("region.radius", f"is {shown(self.radius)}: give a number above 0")

    @property
    def polygon(self) -> Vertices:
        """A polygon that holds the disc; that it does is checked exactly."""
        x, y = self.centre
        reach = float(self.radius) / math.cos(math.pi / _SIDES) * (1 + 1e-9)
        turns = [2 * math.pi * (k + 0.5) / _SIDES for k in range(_SIDES)]
        corners = tuple((x + Fraction(reach * math.cos(t)), y + Fraction(reach * math.sin(t))) for t in turns)
        if not all(distance_squared(self.centre, a, b) > self.radius**2 for a, b in edges(corners)):
            raise InputError("region.radius", f"is {shown(self.radius)}, out of the range of floats: scale z")
        return corners

    def __str__(self) -> str:
        return f"|z - ({float(self.centre[0]):.6g}{float(self.centre[1]):+.6g}i)| < {float(self.radius):.6g}"


@frozen
class Polygon:
    """The inside of a simple polygon; vertices: complex numbers or pairs of exact ones, in either direction."""

    vertices: Vertices

    def __init__(self, vertices: Iterable[object]) -> None:
        given = tuple(exact_point(z, f"region.vertices[{k}]") for k, z in enumerate(vertices, 1))
        if len(given) < 3 or not is_simple(given):
            raise InputError("region.vertices", "do not go once round a region: give the corners in their order")
        vars(self).update(vertices=given if doubled_area(given) > 0 else given[::-1])

    @property
    def polygon(self) -> Vertices:
        """Its corners, turned left."""
        return self.vertices

    def __str__(self) -> str:
        return (
            f"the polygon of {len(self.vertices)} corners from {float(self.vertices[0][0]):.6g}"
            f"{float(self.vertices[0][1]):+.6g}i"
        )


@frozen
class HalfPlane:
    """A half-plane bounded by a line along an axis; `bound` is the user's word that no zero in it has |z| ≥ bound.

    side: "upper" (Im z > at), "lower", "right" (Re z > at) or "left". What is proved is proved for |z| < bound.
    """

    side: str
    at: Fraction
    bound: Fraction

    def __init__(self, side: str, bound: object, at: object = 0) -> None:
        if side not in ("upper", "lower", "right", "left"):
            raise InputError("region.side", f'is {side!r}: give "upper", "lower", "right" or "left"')
        vars(self).update(side=side, at=rational(at, "region.at"), bound=rational(bound, "region.bound"))
        if not self.bound > abs(self.at):
            raise InputError("region.bound", f"is {shown(self.bound)}: give a number above |at|")

    @property
    def polygon(self) -> Vertices:
        """The corners of its part in the square max(|Re z|, |Im z|) < bound."""
        r, t = self.bound, self.at
        sides = {"upper": (-r, r, t, r), "lower": (-r, r, -r, t), "right": (t, r, -r, r), "left": (-r, t, -r, r)}
        return Rectangle(*sides[self.side]).polygon

    def __str__(self) -> str:
        part = "Im z" if self.side in ("upper", "lower") else "Re z"
        sign = ">" if self.side in ("upper", "right") else "<"
        return f"{part} {sign} {float(self.at):.6g}, |z| < {float(self.bound):.6g}"


@frozen
class Cut:
    """A branch cut of f: a ray, or a segment; the region's points are beside it, on either side.

    length: of a segment, in units of |direction|, None for a ray.
    """

    origin: Point
    direction: Point
    length: Fraction | None

    @classmethod
    def ray(cls, origin: object, direction: object) -> Cut:
        """From the branch point `origin` to infinity in any direction, a complex number that is not 0."""
        towards = exact_point(direction, "cuts")
        size = abs(towards[0]) + abs(towards[1])
        if not size:
            raise InputError("cuts", "has a ray in the direction 0: give one like 1, -1j or 3+4j")
        if not all(towards):
            towards = towards[0] / size, towards[1] / size
        return cls._of(exact_point(origin, "cuts"), towards, None)

    @classmethod
    def segment(cls, start: object, end: object) -> Cut:
        """Between two branch points."""
        a, b = exact_point(start, "cuts"), exact_point(end, "cuts")
        step = (b[0] - a[0], b[1] - a[1])
        if not any(step):
            raise InputError("cuts", "has a segment of length 0: give two branch points")
        length = Fraction(1) if all(step) else abs(step[0]) + abs(step[1])
        return cls._of(a, (step[0] / length, step[1] / length), length)

    @classmethod
    def _of(cls, origin: Point, direction: Point, length: Fraction | None) -> Cut:
        out = object.__new__(cls)
        vars(out).update(origin=origin, direction=direction, length=length)
        return out

    def __init__(self, *_: Any) -> None:
        raise InputError("cuts", "has a cut made by hand: give Cut.ray(origin, direction) or Cut.segment(a, b)")

    @property
    def tips(self) -> tuple[Point, ...]:
        """The branch points at its ends."""
        return (self.origin,) if self.length is None else (self.origin, self.at(self.length))

    def at(self, t: Fraction) -> Point:
        """The point origin + t direction."""
        return self.origin[0] + t * self.direction[0], self.origin[1] + t * self.direction[1]

    def place_of(self, p: Point) -> Fraction | None:
        """t with p = origin + t direction, None where p is not on the line of the cut."""
        x, y = p[0] - self.origin[0], p[1] - self.origin[1]
        off = x * self.direction[1] - y * self.direction[0]
        size = self.direction[0] ** 2 + self.direction[1] ** 2
        return None if off else (x * self.direction[0] + y * self.direction[1]) / size

    def holds(self, a: Point, b: Point) -> bool:
        """Whether the segment from a to b lies on the cut."""
        places = (self.place_of(a), self.place_of(b))
        return all(t is not None and t >= 0 and (self.length is None or t <= self.length) for t in places)

    def __str__(self) -> str:
        a, d = _words(self.origin), _words(self.direction)
        return (
            f"ray from {a} along {d}"
            if self.length is None
            else f"segment from {a} to {_words(self.at(self.length))}"
        )


def _words(z: Point) -> str:
    return f"{float(z[0]):.6g}{float(z[1]):+.6g}i"


Region = Rectangle | Disc | Polygon | HalfPlane


def bound_words(region: HalfPlane) -> str:
    """What is taken on the user's word about a half-plane."""
    return f"no zero in the half-plane has |z| ≥ {shown(region.bound)}, as the bound of HalfPlane says"


def place_of_box_in_disc(disc: Disc, low: Point, high: Point) -> bool | None:
    """The same for a disc."""
    (x, y), reach = disc.centre, disc.radius**2
    far = max(abs(low[0] - x), abs(high[0] - x)) ** 2 + max(abs(low[1] - y), abs(high[1] - y)) ** 2
    nearest = (min(max(x, low[0]), high[0]), min(max(y, low[1]), high[1]))
    near = (nearest[0] - x) ** 2 + (nearest[1] - y) ** 2
    return True if far < reach else False if near > reach else None


def place_in(region: Region, low: Point, high: Point) -> bool | None:
    """True if the closed box lies in the region, False if it lies outside, None where that is not told.

    A half-plane counts as the rectangle in which its zeros are, by the user's word.
    """
    if isinstance(region, Disc):
        return place_of_box_in_disc(region, low, high)
    return place_of_box(region.polygon, low, high)
