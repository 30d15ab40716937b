"""Exact geometry of polygons and boxes: no float decides where a point lies."""

from __future__ import annotations

from fractions import Fraction

Point = tuple[Fraction, Fraction]
Vertices = tuple[Point, ...]


def edges(vertices: Vertices) -> list[tuple[Point, Point]]:
    return list(zip(vertices, [*vertices[1:], vertices[0]], strict=True))


def cross(o: Point, a: Point, b: Point) -> Fraction:
    """Twice the area of the triangle o, a, b: above 0 where it turns left."""
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def doubled_area(vertices: Vertices) -> Fraction:
    return sum((a[0] * b[1] - a[1] * b[0] for a, b in edges(vertices)), Fraction(0))


def is_convex(vertices: Vertices) -> bool:
    """Of a simple polygon that turns left."""
    n = len(vertices)
    return all(cross(vertices[k - 1], vertices[k], vertices[(k + 1) % n]) >= 0 for k in range(n))


def is_simple(vertices: Vertices) -> bool:
    """Whether the edges meet in their common corners only."""
    sides = edges(vertices)
    n = len(sides)
    if any(a == b for a, b in sides) or not doubled_area(vertices):
        return False
    for j in range(n):
        for k in range(j):
            apart = not _meet(*sides[j], *sides[k])
            next_to = (j - k) in (1, n - 1)
            if not apart and not (next_to and not _overlap(sides[j], sides[k])):
                return False
    return True


def _meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Whether two closed segments have a point in common."""
    p, q, r, s = cross(a, b, c), cross(a, b, d), cross(c, d, a), cross(c, d, b)
    if ((p > 0 > q) or (p < 0 < q)) and ((r > 0 > s) or (r < 0 < s)):
        return True
    touching = ((p, a, b, c), (q, a, b, d), (r, c, d, a), (s, c, d, b))
    return any(not value and _between(x, y, z) for value, x, y, z in touching)


def _between(a: Point, b: Point, p: Point) -> bool:
    """Whether p, on the line of a and b, lies on the segment."""
    return all(min(a[k], b[k]) <= p[k] <= max(a[k], b[k]) for k in (0, 1))


def _overlap(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    """Whether two neighbouring edges lie on each other."""
    (a, b), (c, d) = one, other
    shared = b if b in (c, d) else a
    p, q = (a if shared == b else b), (d if shared == c else c)
    along = (p[0] - shared[0]) * (q[0] - shared[0]) + (p[1] - shared[1]) * (q[1] - shared[1])
    return not cross(shared, p, q) and along > 0


def distance_squared(p: Point, a: Point, b: Point) -> Fraction:
    """Of a point from a segment."""
    x, y = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y)
    t = min(max(t, Fraction(0)), Fraction(1))
    u, v = p[0] - a[0] - t * x, p[1] - a[1] - t * y
    return u * u + v * v


def is_inside(vertices: Vertices, p: Point) -> bool:
    """Whether a point that is on no edge lies inside, by the edges that pass to its right."""
    inside = False
    for a, b in edges(vertices):
        if (a[1] > p[1]) != (b[1] > p[1]):
            upward = b[1] > a[1]
            inside ^= (cross(a, b, p) > 0) == upward
    return inside


def box_of(vertices: Vertices) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    """re_min, re_max, im_min, im_max."""
    xs, ys = [p[0] for p in vertices], [p[1] for p in vertices]
    return min(xs), max(xs), min(ys), max(ys)


def grown(vertices: Vertices, part: Fraction) -> Vertices | None:
    """A convex polygon scaled about its middle by 1 + part; None for one that is not convex."""
    if not is_convex(vertices):
        return None
    n = len(vertices)
    x, y = (sum((p[k] for p in vertices), Fraction(0)) / n for k in (0, 1))
    return tuple((x + (p[0] - x) * (1 + part), y + (p[1] - y) * (1 + part)) for p in vertices)


def place_of_box(vertices: Vertices, low: Point, high: Point) -> bool | None:
    """True if the closed box lies inside the polygon, False if outside, None if it meets an edge."""
    a, c = low
    b, d = high
    left, right, bottom, top = box_of(vertices)
    if b < left or a > right or d < bottom or c > top:
        return False
    if len(vertices) == 4 and set(vertices) == {(left, bottom), (right, bottom), (right, top), (left, top)}:
        return True if left < a and b < right and bottom < c and d < top else None
    for p, q in edges(vertices):
        if max(p[0], q[0]) < a or min(p[0], q[0]) > b or max(p[1], q[1]) < c or min(p[1], q[1]) > d:
            continue
        sides = [cross(p, q, corner) for corner in ((a, c), (b, c), (b, d), (a, d))]
        if not (all(x > 0 for x in sides) or all(x < 0 for x in sides)):
            return None
    return is_inside(vertices, ((a + b) / 2, (c + d) / 2))
