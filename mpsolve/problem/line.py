"""A beam whose cuts lie on one line: on it the beam is undamped, and the two halves of the sheet are two problems.

D = EI P⁴ + T P² + m s² + c s + k depends on s through (s + η)², η = c/2m. With τ = σ + η (z = q − iη) the track is
undamped, and its cuts lie on Re τ = 0, if EI y² − T y + k − c²/4m > 0 for all y = p². Below the line, Re τ > 0, the
roots are those of the vehicle S(τ − η) on the undamped track; those above, at −τ, those of S(−τ − η): reflection
transposes G (SPEC2, the whole sheet).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, TypeVar

from flint import arb, fmpq_mpoly_ctx, fmpq_poly

from mpsolve.frozen import frozen
from mpsolve.numbers.balls import precision
from mpsolve.numbers.bivariate import to_rows
from mpsolve.numbers.realroots import as_fmpq, is_positive, negative_point, positive_roots
from mpsolve.problem.reduced import Guide, Reduced
from mpsolve.tracks.waveguide import Polynomial, Track, Waveguide, moved, moving

C = TypeVar("C")
_TERMS = {(4, 0), (2, 0), (0, 0), (0, 1), (0, 2)}


@frozen
class Line:
    """The undamped problems of both halves in scaled units; `height` is η̂."""

    height: Fraction
    lower: Reduced
    upper: Reduced

    @property
    def beam(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """EI, T, k − c²/4m and m of D̂ at rest."""
        D = self.lower.guide.D_rest
        return D[4, 0], D.get((2, 0), Fraction(0)), D[0, 0], D[0, 2]

    @property
    def joined(self) -> bool | None:
        """Whether the cuts of both sides meet at Re z = 0; None where they just touch."""
        EI, T, k, m = self.beam
        at_zero = fmpq_poly([as_fmpq(x) for x in (k, -T - m * self.lower.guide.v**2, EI)])
        if is_positive(at_zero):
            return False
        return True if negative_point(at_zero) is not None else None

    def in_gap(self, z: Fraction) -> bool:
        """Whether no p-root is real at the real z: D(ip, iz) > 0 for all real p."""
        EI, T, k, m = self.beam
        v = self.lower.guide.v
        c = (k - m * z * z, 2 * m * v * z, -T - m * v * v, Fraction(0), EI)
        return all(is_positive(fmpq_poly([as_fmpq(x * sign**i) for i, x in enumerate(c)])) for sign in (1, -1))

    @property
    def passive_from(self) -> Fraction:
        """A bound of |z|², exact: beyond it the mobility of the undamped track has a positive definite real part."""
        EI, T, k, m = self.beam
        b = T + m * self.lower.guide.v**2  # of EI y² − b y + k + m |z|²
        return max(Fraction(0), (b * b / (4 * EI) - k) / m) if b > 0 else Fraction(0)

    @property
    def branch_points(self) -> list[tuple[arb, int]]:
        """The z > 0 at which p-roots meet, ascending balls, with the multiplicity of each in the discriminant."""
        squares = discriminant(self.lower.guide.D)
        with precision(128):
            return [(x.sqrt(), k) for x, k in positive_roots(squares)]


def discriminant(D: Polynomial) -> fmpq_poly:
    """Of D(P, σ) in P, a polynomial in z² = −σ²."""
    context = fmpq_mpoly_ctx.get(("P", "s"), "lex")
    found = context.from_dict({key: as_fmpq(c) for key, c in D.items()}).discriminant("P")
    return fmpq_poly([c * (-1) ** j for j, c in enumerate(to_rows(found)[0].coeffs()[::2])])


def beam_height(track: Track | Waveguide) -> Fraction | None:
    """η = c/2m in the track's own units; None where it is no beam on one layer."""
    waveguide = track.waveguide
    D, N = waveguide.dispersion, waveguide.numerator
    if not (set(D) <= _TERMS and {(4, 0), (0, 0), (0, 2)} <= set(D) and set(N) == {(0, 0)}):
        return None
    if not (D[4, 0] > 0 and D[0, 2] > 0 and N[0, 0] > 0):
        return None
    height = D.get((0, 1), Fraction(0)) / (2 * D[0, 2])
    return height if height >= 0 else None


def line_height(track: Track | Waveguide) -> Fraction | None:
    """η where all cuts of a beam lie on Im q = η: no free wave decays without vibrating. None for other tracks."""
    height, D = beam_height(track), track.waveguide.dispersion
    if height is None:
        return None
    rest = D[0, 0] - height**2 * D[0, 2]
    at_rest = fmpq_poly([as_fmpq(x) for x in (rest, -D.get((2, 0), Fraction(0)), D[4, 0])])
    return height if is_positive(at_rest) else None


def on_line(reduced: Reduced) -> Line | None:
    """The two problems; None where the cuts of the track do not lie on one line."""
    if line_height(reduced.problem.track) is None:
        return None
    guide = reduced.guide
    height = guide.D_rest.get((0, 1), Fraction(0)) / (2 * guide.D_rest[0, 2])
    rest = moved_in_s(guide.D_rest, -height)
    undamped: Guide = replace(guide, D_rest=rest, D=moving(rest, guide.v))
    below = moved_pencil(reduced.S, -height)
    above = (below[0], tuple(tuple(-x for x in row) for row in below[1]), below[2])
    return Line(height, replace(reduced, guide=undamped, S=below), replace(reduced, guide=undamped, S=above))


def moved_in_s(D: Mapping[tuple[int, int], C], by: Fraction) -> dict[tuple[int, int], C]:
    """D(P, s + by), whatever its coefficients are: exact numbers, or polynomials in free parameters."""
    return {key: c for key, c in moved(D, 1, by).items() if c}


def moved_pencil(S: tuple[Any, Any, Any], by: Fraction) -> tuple[Any, Any, Any]:
    """S(σ + by) in powers of σ, of numbers or of polynomials in free parameters."""
    K, C, M = S
    n = range(len(M))
    constant = tuple(tuple(K[i][j] + C[i][j] * by + M[i][j] * by**2 for j in n) for i in n)
    return constant, tuple(tuple(C[i][j] + M[i][j] * (2 * by) for j in n) for i in n), M
