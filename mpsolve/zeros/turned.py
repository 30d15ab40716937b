"""The plane turned, so that slanting cuts lie along an axis: z = d·w with an exact complex number d.

What is counted then is g(w) = f(d·w). Polynomials in z are composed exactly, coefficient by coefficient, so that the
argument of a root or a logarithm that is real on a cut of f stays free of an imaginary part on the cut of g.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from math import isqrt

from flint import acb

from mpsolve.errors import InputError
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.zeros.answer import Zeros
from mpsolve.zeros.geometry import Point
from mpsolve.zeros.program import LEAVES, OPERATIONS, Expression, Program, Step, reduced, taken
from mpsolve.zeros.regions import Cut, Disc, HalfPlane, Polygon, Region, bound_words

_MOST_DEGREE = 32  # a polynomial of a higher one is composed step by step

Coefficients = tuple[Point, ...]
"""Of 1, z, z², …, each a complex number of two rationals; the last one is not 0."""


def times(a: Point, b: Point) -> Point:
    """The product of two complex numbers."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def over(a: Point, b: Point) -> Point:
    """The quotient a/b."""
    size = b[0] * b[0] + b[1] * b[1]
    x, y = times(a, (b[0], -b[1]))
    return x / size, y / size


def slant(cuts: Iterable[Cut]) -> Point | None:
    """The direction d in which the cuts lie along the axes of w; None where they do so already.

    InputError for cuts that are neither parallel nor at right angles to each other, one of which slants.
    """
    known = list(cuts)
    slanting = [cut for cut in known if cut.direction[0] and cut.direction[1]]
    if not slanting:
        return None
    d = slanting[0].direction
    for cut in known:
        x, y = over(cut.direction, d)
        if x and y:
            stated = f"has cuts that are neither parallel nor at right angles ({slanting[0]}; {cut})"
            raise InputError("cuts", f"{stated}: divide the region, so that each part has one slant only")
    return d


def turned_cut(cut: Cut, d: Point) -> Cut:
    """The same cut in the plane of w."""
    origin = over(cut.origin, d)
    if cut.length is None:
        x, y = over(cut.direction, d)
        return Cut.ray(origin, (Fraction((x > 0) - (x < 0)), Fraction((y > 0) - (y < 0))))
    return Cut.segment(origin, over(cut.at(cut.length), d))


def turned_region(region: Region, d: Point) -> Region:
    """The same region in the plane of w; a half-plane as the polygon in which its zeros are, by the user's word."""
    if not isinstance(region, Disc):
        return Polygon(over(p, d) for p in region.polygon)
    size = d[0] * d[0] + d[1] * d[1]
    root = Fraction(isqrt(size.numerator), isqrt(size.denominator))
    if root * root != size:
        stated = f"has the direction {complex_words(d)}, of irrational length, beside a disc"
        raise InputError("cuts", f"{stated}: give a direction like 3+4j, or a Polygon as the region")
    return Disc(over(region.centre, d), region.radius / root)


def turned_back(answer: Zeros, words: str, region: Region, there: Region, d: Point) -> Zeros:
    """The answer of f(d·w) in `there` as one of f, called `words`, in `region`."""
    text = f"({complex_words(d)})"
    note = f"counted in w = z/{text}, in which the cuts lie along an axis; the certificate is one of f({text} w)"
    with precision(int(4 * answer.digits) + 64):
        factor = acb(*map(rational_ball, d))
        zeros = tuple(replace(zero, q=factor * zero.q, real=False) for zero in answer.roots)
    if answer.region != there:  # its boundary was moved
        region = Polygon(times(p, d) for p in answer.region.polygon)
    assumed = answer.assumed
    if isinstance(region, HalfPlane):
        assumed += (bound_words(region),)
    reason = answer.reason and replace(answer.reason, message=f"{answer.reason.message}, in w = z/{text}")
    return replace(
        answer,
        function=words,
        region=region,
        roots=tuple(sorted(zeros, key=lambda zero: (float(zero.q.real.mid()), float(zero.q.imag.mid())))),
        note=f"{answer.note}; {note}" if answer.note else note,
        assumed=assumed,
        reason=reason,
    )


def complex_words(d: Point) -> str:
    """A complex number of two rationals as a text."""
    return f"{d[0]} {'-' if d[1] < 0 else '+'} {abs(d[1])}i"


@dataclass(frozen=True)
class _Value:
    """A step of the new program, or a polynomial that is not written out yet."""

    step: int | None
    polynomial: Coefficients | None = None


def composed(expression: Expression, d: Point) -> Expression:
    """f(d·w) as an expression in w."""
    program, values = Program(), list[_Value]()
    for step in expression.steps:
        values.append(_composed(program, step, values, d))
    outputs = [expression.numerator, *([] if expression.denominator is None else [expression.denominator])]
    steps, places = reduced(program.steps, _written(program, [values[k] for k in outputs]))
    return Expression(steps, places[0], places[1] if len(places) > 1 else None)


def _written(program: Program, values: list[_Value]) -> list[int]:
    return [_write(program, value) for value in values]


def _composed(program: Program, step: Step, values: list[_Value], d: Point) -> _Value:
    name, parts = step[0], [values[k] for k in taken(step)]
    found = _polynomial(step, parts, d)
    if found is not None:
        return _Value(None, found)
    if name == "pi":
        return _Value(program.step("pi"))
    if name == "div" and all(part.polynomial is not None for part in parts):
        return _Value(_quotient(program, *(part.polynomial or () for part in parts)))
    places = _written(program, parts)
    if name in OPERATIONS:
        return _Value(int(getattr(program, name)(*places)))
    if name == "pow":
        return _Value(program.whole(places[0], step[2]))
    return _Value(program.step(name, *places, *step[2:]))


def _polynomial(step: Step, parts: list[_Value], d: Point) -> Coefficients | None:
    """The step as a polynomial in w, where it is one of a degree that is not too high."""
    name, known = step[0], [part.polynomial for part in parts]
    if name in LEAVES:
        zero = (Fraction(0), Fraction(0))
        if name == "number":
            return _trimmed([(Fraction(step[1]), Fraction(0))])
        return (zero, d) if name == "z" else ((Fraction(0), Fraction(1)),) if name == "i" else None
    if any(one is None for one in known) or name not in (*OPERATIONS, "pow"):
        return None
    a = known[0] or ()
    if name == "pow":
        return _power(a, step[2])
    b = known[1] or ()
    if name == "div":
        return tuple(over(c, b[0]) for c in a) if len(b) == 1 else None
    if name == "mul":
        return _product(a, b) if len(a) + len(b) <= _MOST_DEGREE + 2 else None
    sign = 1 if name == "add" else -1
    n = max(len(a), len(b))
    nothing = (Fraction(0), Fraction(0))
    a, b = (row + (nothing,) * (n - len(row)) for row in (a, b))
    return _trimmed([(x[0] + sign * y[0], x[1] + sign * y[1]) for x, y in zip(a, b, strict=True)])


def _trimmed(row: list[Point]) -> Coefficients:
    while row and not any(row[-1]):
        row.pop()
    return tuple(row)


def _product(a: Coefficients, b: Coefficients) -> Coefficients:
    row = [(Fraction(0), Fraction(0))] * max(len(a) + len(b) - 1, 0)
    for j, x in enumerate(a):
        for k, y in enumerate(b):
            u, v = times(x, y)
            row[j + k] = row[j + k][0] + u, row[j + k][1] + v
    return _trimmed(row)


def _power(a: Coefficients, n: int) -> Coefficients | None:
    if (len(a) - 1) * n > _MOST_DEGREE or n > _MOST_DEGREE:
        return None
    out: Coefficients = ((Fraction(1), Fraction(0)),)
    for _ in range(n):
        out = _product(out, a)
    return out


def _number(program: Program, c: Point) -> int:
    imaginary = program.mul(program.number(c[1]), program.i) if c[1] else program.number(0)
    return program.add(program.number(c[0]), imaginary)


def _write(program: Program, value: _Value) -> int:
    """Its step; a polynomial by Horner's rule."""
    if value.step is not None:
        return value.step
    row = value.polynomial or ()
    out = program.number(0)
    for c in reversed(row):
        out = program.add(program.mul(out, program.z), _number(program, c))
    return out


def _quotient(program: Program, a: Coefficients, b: Coefficients) -> int:
    """a/b with the leading coefficients taken out, so that what is real on a line has real parts."""
    if not b:
        raise InputError("f", "is divided by zero: give a function that has values")
    if not a:
        return program.number(0)
    monic = [_write(program, _Value(None, tuple(over(c, row[-1]) for c in row))) for row in (a, b)]
    return program.mul(_number(program, over(a[-1], b[-1])), program.div(*monic))
