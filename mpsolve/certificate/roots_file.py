"""Certificates of zeros as JSON: the function, the region, every choice of the proof (certs/SPEC-ROOTS.md)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from mpsolve.certificate.format import Certificate, digest
from mpsolve.numbers.rootball import RootBall
from mpsolve.zeros.count import Count
from mpsolve.zeros.geometry import Point
from mpsolve.zeros.program import Expression
from mpsolve.zeros.reals import Tiling
from mpsolve.zeros.regions import Cut, Disc, HalfPlane, Rectangle, Region

FORMAT, VERSION = "mpsolve zeros", 1


def region_certificate(
    expression: Expression, count: Count, region: Region, balls: Sequence[RootBall], inside: int
) -> Certificate:
    """Of a count in a polygon, all zeros in it, and how many of them lie in the region."""
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "kind": "region",
        "function": _function(expression),
        "region": _region(region),
        "counted": [_point(p) for p in count.vertices],
        "cuts": [_cut(cut) for cut in count.cuts],
        "bits": count.bits,
        "breaks": [_places(row) for row in count.breaks],
        "trees": list(count.trees),
        "claim": {"count": inside},
        "roots": [_root(ball) for ball in balls],
    }
    return Certificate(content | {"sha256": digest(content)})


Brackets = Sequence[tuple[Fraction, Fraction]]


def interval_certificate(
    expression: Expression, a: Fraction, b: Fraction, tilings: Sequence[tuple[Tiling, int, Brackets]]
) -> Certificate:
    """Of the real zeros on an interval: each factor's tiles, the precision of its brackets, and these."""
    zeros = sorted((low, tiling.power) for tiling, _, brackets in tilings for low, _ in brackets)
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "kind": "interval",
        "function": _function(expression),
        "interval": [str(a), str(b)],
        "claim": {"zeros": len(zeros), "multiplicities": [power for _, power in zeros]},
        "tiles": [
            {
                "bits": t.bits,
                "places": [str(x) for x in t.places],
                "kinds": t.kinds,
                "sharp": bits,
                "brackets": [_point(pair) for pair in brackets],
            }
            for t, bits, brackets in tilings
        ],
    }
    return Certificate(content | {"sha256": digest(content)})


def _function(expression: Expression) -> dict[str, Any]:
    steps = [list(step) for step in expression.steps]
    return {"steps": steps, "numerator": expression.numerator, "denominator": expression.denominator}


def _point(p: Point) -> list[str]:
    return [str(p[0]), str(p[1])]


def _region(region: Region) -> dict[str, Any]:
    if isinstance(region, Rectangle):
        a, b, c, d = map(str, region.bounds)
        return {"kind": "rectangle", "re": [a, b], "im": [c, d]}
    if isinstance(region, Disc):
        return {"kind": "disc", "centre": _point(region.centre), "radius": str(region.radius)}
    if isinstance(region, HalfPlane):
        return {"kind": "half-plane", "side": region.side, "at": str(region.at), "bound": str(region.bound)}
    return {"kind": "polygon", "vertices": [_point(p) for p in region.vertices]}


def _cut(cut: Cut) -> dict[str, Any]:
    length = None if cut.length is None else str(cut.length)
    return {"origin": _point(cut.origin), "direction": _point(cut.direction), "length": length}


def _places(row: Sequence[float]) -> dict[str, Any]:
    """Places in [0, 1] as whole numbers over one power of two."""
    exact = [Fraction(t) for t in row]
    down = max(t.denominator for t in exact)
    return {"exponent": down.bit_length() - 1, "places": [int(t * down) for t in exact]}


def _root(ball: RootBall) -> dict[str, Any]:
    re, im, side = ball.in_units
    radius = side * Fraction(3, 2)
    m, e = radius.numerator, -(radius.denominator.bit_length() - 1)
    while m % 2 == 0:
        m, e = m // 2, e + 1
    return {
        "re": hex(re),
        "im": hex(im),
        "exponent": ball.exponent,
        "radius": [m, e],
        "multiplicity": ball.multiplicity,
    }
