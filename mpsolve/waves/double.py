"""Double real p-roots on the line of a force at a velocity where its discriminant is 0, and what they are.

One of a simple root of the discriminant is real, as its conjugate could be no other. Others are computed over the
field of the algebraic number v.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from flint import fmpq_poly

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import arb, precision
from mpsolve.proof.ladder import climb
from mpsolve.waves.algebraic import embedded, isolated, multiple_roots, places, slope, split
from mpsolve.waves.line import Line
from mpsolve.waves.place import Place
from mpsolve.waves.velocity import Kind

_DOUBLINGS = 3  # of the precision before a double root is sought over the field


def double_roots(along: Line, place: Place, single: bool, bits: int) -> Iterator[tuple[Any, Kind]]:
    """All of them but p = 0, in balls (y = p² for ω = 0); PrecisionError where they are not told apart.

    single: the discriminant has a simple root there, and the degree in p does not drop.
    """
    p = _single(along, place, bits) if single else None
    if p is None:
        yield from _over_field(along, place, bits)
    else:
        yield p, _curvature(along, place, p, bits) if along.squared and p > 0 else Kind.TOUCHING


def _single(along: Line, place: Place, bits: int) -> Any:
    """The one double root (y for ω = 0), known to be real, in a ball; None where precision does not show it."""

    def real(work: int) -> arb:
        f = embedded(along.rows, place.x.ball(work))
        try:
            roots = isolated(f.derivative())
        except ValueError:
            roots = []
        near = [root for root in roots if f(root).contains(0)]
        if len(near) != 1 or not near[0].imag.contains(0) or not _fine(near[0].real, bits):
            raise PrecisionError("a double root is not told apart from others")
        return arb(near[0].real)

    try:
        return climb(real, bits + 64, (bits + 64) << _DOUBLINGS)
    except PrecisionError:
        return None


def _over_field(along: Line, place: Place, bits: int) -> Iterator[tuple[Any, Kind]]:
    """Every double real root, by exact common divisors."""
    m = fmpq_poly(place.x.m)
    _, rest = split(multiple_roots(along.rows, m), [fmpq_poly([]), fmpq_poly([1])], m)  # p = 0 is found elsewhere
    meeting, rest = split(rest, along.slope, m)
    for y in places(meeting, place.x, bits + 64):
        yield y, Kind.MEETING
    if not along.squared:
        for p in places(rest, place.x, bits + 64):
            yield p, Kind.TOUCHING
        return
    flat, rest = split(rest, slope(slope(along.rows)), m)
    for y in places(flat, place.x, bits + 64):
        yield y, Kind.STATIONARY
    for y in places(rest, place.x, bits + 64):
        yield y, _curvature(along, place, y, bits)


def _curvature(along: Line, place: Place, y: Any, bits: int) -> Kind:
    """w = (phase velocity)² over y along the branch has w″ = −f_yy/f_w where f_y = 0."""
    rows, across = along.rows, [row.derivative() for row in along.rows]
    with precision(bits + 64):
        x = place.x.ball(bits + 64)
        bend = embedded(slope(slope(rows)), x)(y).real * embedded(across, x)(y).real
    if bend < 0:
        return Kind.MINIMUM
    if bend > 0:
        return Kind.MAXIMUM
    raise PrecisionError("the curvature of a branch has no proved sign")


def _fine(ball: Any, bits: int) -> bool:
    """Whether the ball has the digits asked for."""
    return bool(ball.is_exact() or ball.rel_accuracy_bits() >= bits - 32)
