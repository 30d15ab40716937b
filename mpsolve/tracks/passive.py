"""Whether a track at rest takes energy from any harmonic force: Ω Im(N/D) ≤ 0 for all real p and Ω, decided exactly.

With y = p², z = Ω², N = Nₑ + iΩ Nₒ and D alike, −Ω Im(N D*) = z (Nₑ Dₒ − Nₒ Dₑ), a polynomial in y and z that must
not be negative on the quadrant y, z ≥ 0. Between the zeros y of its discriminant and of its first and last
coefficients the zeros z neither meet nor pass 0, so that one rational y in each interval decides.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from flint import fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from mpsolve.frozen import frozen
from mpsolve.numbers.bivariate import to_rows
from mpsolve.numbers.realroots import as_fmpq, negative_point, samples
from mpsolve.tracks.at_rest import in_squares, rows_of, wavenumber
from mpsolve.tracks.waveguide import Track, Waveguide, power

_CONTEXT = fmpq_mpoly_ctx.get(("z", "y"), "lex")


@frozen
class Passivity:
    """passive: the track gives no energy. lossless: it takes none either. witness: (p, Ω) where it gives some."""

    passive: bool
    lossless: bool
    witness: tuple[float, float] | None = None


@lru_cache(maxsize=256)
def passivity(track: Track | Waveguide) -> Passivity:
    """The decision about the track at rest; InputError as for `at_rest`."""
    guide = track.waveguide
    rows_of(guide)
    in_squares(guide.numerator, "N")
    w = power(guide.dispersion, guide.numerator)
    if not w:
        return Passivity(passive=True, lossless=True)
    found = _negative(_CONTEXT.from_dict({(j, i): as_fmpq(c) for (i, j), c in w.items()}))
    witness = None if found is None else (wavenumber(found[0]), wavenumber(found[1]))
    return Passivity(passive=found is None, lossless=False, witness=witness)


def _negative(F: fmpq_mpoly) -> tuple[Fraction, Fraction] | None:
    """Rational y, z > 0 where F changes to values below 0, or None where F ≥ 0 on the quadrant."""
    if all(c > 0 for c in F.coeffs()):
        return None
    content, factors = F.factor_squarefree()
    odd = _CONTEXT.constant(content)
    for factor, often in factors:
        odd *= factor if often % 2 else 1
    for y in _cells(odd):
        z = negative_point(fmpq_poly([row(as_fmpq(y)) for row in to_rows(odd)]))
        if z is not None:
            return y, z
    return None


def _cells(F: fmpq_mpoly) -> list[Fraction]:
    """A rational y > 0 in each interval over which the zeros z of the squarefree F do not meet, vanish or pass 0."""
    rows = to_rows(F)
    edges = next(row for row in rows if row) * rows[-1]
    return samples(edges * to_rows(F.discriminant("z"))[0] if len(rows) > 2 else edges)
