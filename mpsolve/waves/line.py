"""The undamped dispersion relation along the line Ω = ω − vp of a moving force, as exact rows over the velocity.

F(p, Ω) = D₀(ip, iΩ) is real and even in p and in Ω. For ω = 0 the line is looked at in y = p² and w = v², where it is
z = Ω² = wy; else in p and v. Powers of p, and factors in the velocity alone, are taken out.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from mpsolve.errors import InputError
from mpsolve.numbers.bivariate import Rows, from_rows, to_rows
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.tracks.waveguide import Waveguide

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
