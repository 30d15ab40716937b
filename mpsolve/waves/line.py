"""The undamped dispersion relation along the line Ω = ω − vp of a moving force, and its double real p-roots.

F(p, Ω) = D₀(ip, iΩ) is real and even in p and in Ω. For ω = 0 the line is looked at in y = p² and w = v², where it is
z = Ω² = wy; else in p and v. Powers of p, and factors in the velocity alone, are taken out.

Double roots are sought at a velocity where the discriminant of the line is 0. One of a simple root of the
discriminant is real, as its conjugate could be no other. Others are computed over the field of the algebraic number
v.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import arb, precision
from mpsolve.numbers.bivariate import Rows, from_rows, to_rows
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.proof.ladder import climb
from mpsolve.tracks.waveguide import Waveguide
from mpsolve.waves.algebraic import embedded, isolated, multiple_roots, places, slope, split
from mpsolve.waves.place import Place
from mpsolve.waves.velocity import Kind

_CONTEXT = fmpq_mpoly_ctx.get(("p", "v"), "lex")


@dataclass(frozen=True)
class Line:
    """F along the line is content(v) · p^stripped · Σ rows_i p^i, the rows without a common factor, rows_0 ≠ 0.

    rows: the coefficients of p⁰, p¹, … (of y⁰, y¹, … where `squared`), polynomials in v (in w = v² where `squared`).
    slope: ∂F/∂Ω (∂F/∂z where `squared`) along the same line, over the whole of F. repeated: F has a repeated factor,
    of which one is kept. squared: ω = 0, p stands for y = p² and v for w = v².
    """

    squared: bool
    rows: Rows
    slope: Rows
    content: fmpq_poly
    stripped: int
    repeated: bool

    @property
    def lead(self) -> fmpq_poly:
        """Where it is 0 the degree in p drops."""
        return self.rows[-1]

    @property
    def discriminant(self) -> fmpq_poly:
        """Where it is 0 two p-roots meet, or two run to infinity; a constant where there are less than two."""
        if len(self.rows) < 3:
            return fmpq_poly([1])
        return to_rows(from_rows(self.rows, _CONTEXT).discriminant("p"))[0]


def line(guide: Waveguide, omega: Fraction) -> Line:
    """The line of a force of frequency ω over undamped equations; InputError where no wave is left."""
    squared = not omega
    F, repeated = _radical(_relation(guide, squared))
    p, v = _CONTEXT.gens()
    along = v * p if squared else _CONTEXT.constant(as_fmpq(omega)) - v * p
    f, slope = F.compose(p, along), F.derivative(1).compose(p, along)
    rows = to_rows(f)
    if len(rows) == 0 or F.degrees()[1] == 0:
        raise InputError("track", "carries no undamped wave: give it mass")
    stripped = next(k for k, row in enumerate(rows) if row)
    rows = rows[stripped:]
    content = fmpq_poly([])
    for row in rows:
        content = row.gcd(content)
    return Line(squared, [row // content for row in rows], to_rows(slope), content, stripped, repeated)


def _relation(guide: Waveguide, squared: bool) -> fmpq_mpoly:
    """F(p, Ω), or over y = p² and z = Ω²."""
    terms: dict[tuple[int, ...], fmpq] = {}
    for (i, j), c in guide.dispersion.items():
        if i % 2 or j % 2:
            raise InputError("track", "differs from its mirror image: give one that is the same in both directions")
        key = (i // 2, j // 2) if squared else (i, j)
        terms[key] = as_fmpq(c * (-1) ** ((i + j) // 2))
    return _CONTEXT.from_dict(terms)


def _radical(F: fmpq_mpoly) -> tuple[fmpq_mpoly, bool]:
    content, factors = F.factor_squarefree()
    out = _CONTEXT.constant(content)
    for factor, _ in factors:
        out *= factor
    return out, any(power > 1 for _, power in factors)


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
