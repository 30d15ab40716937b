"""A problem in the form that is computed with: scaled by exact powers of two, unfelt and neutral modes taken out.

P = P̂/L and σ = σ̂/T with L, T powers of two, so that the coefficients of D̂ and N̂ are near 1. G = g Ĝ, and the
vehicle is scaled by g and body by body. Only nonzero constants and the named factors divide Δ.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from math import log2
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.model import shown
from mpsolve.problem.problem import Problem
from mpsolve.tracks.structure import own_damping
from mpsolve.tracks.waveguide import Polynomial, Track, Waveguide, mapped, moving, scaled
from mpsolve.vehicles.felt import Parts, split_felt
from mpsolve.vehicles.vehicle import Rows


@frozen
class Guide:
    """The track at a velocity in scaled units: D̂ and N̂ at rest (in P, s) and moving (in P, σ).

    own: (c, i) if the loaded field alone has the damping c p^i, i ≥ 2.
    """

    length: int
    time: int
    D_rest: Polynomial
    N_rest: Polynomial
    D: Polynomial
    N: Polynomial
    v: Fraction
    g: Fraction
    own: tuple[Fraction, int] | None = None

    @property
    def degree(self) -> int:
        """The number of p-roots."""
        return max(i for i, _ in self.D)


@frozen
class Reduced:
    """A scaled problem: Δ̂ = det [[S, −B], [Bᵀ, Ĝ + diag ĥ]], S = S₀ + S₁σ̂ + S₂σ̂², rows of neutral modes divided by σ̂.

    places: the different places of contacts, ascending (scaled); index: for each contact the number of its place.
    S: three matrices of scaled exact numbers; B, h as scaled; scales: powers of two of the coordinates.
    """

    problem: Problem
    guide: Guide
    places: tuple[Fraction, ...]
    index: tuple[int, ...]
    S: tuple[Rows, Rows, Rows]
    B: Rows
    h: tuple[Fraction, ...]
    parts: Parts
    scales: tuple[int, ...]

    @property
    def bodies(self) -> int:
        return len(self.B)

    @property
    def contacts(self) -> int:
        return len(self.index)

    @property
    def neutral(self) -> int:
        """How many factors σ have been divided out."""
        return self.parts.neutral

    @property
    def frequency_unit(self) -> Fraction:
        """q = q̂ · frequency_unit."""
        return Fraction(2) ** -self.guide.time

    @property
    def smallest_gap(self) -> Fraction | None:
        """Of the scaled places; None for one place."""
        gaps = [b - a for a, b in zip(self.places, self.places[1:], strict=False)]
        return min(gaps) if gaps else None


@lru_cache(maxsize=64)
def reduce_problem(problem: Problem) -> Reduced:
    """The scaled problem; InputError where a premise fails (an odd dispersion, a velocity at a wave speed)."""
    guide = scale_guide(problem)
    pencil = problem.pencil
    unit = Fraction(2) ** guide.length
    scaled_places = [place / unit for place in pencil.places]
    places = sorted(set(scaled_places))
    parts = split_felt(pencil)
    rate = Fraction(2) ** -guide.time
    S = [times(rows, guide.g * rate**k) for k, rows in enumerate((parts.K, parts.C, parts.M))]
    scales = _scales(S)
    S = [conjugate(rows, scales) for rows in S]
    B = tuple(tuple(x * Fraction(2) ** scales[i] for x in row) for i, row in enumerate(parts.B))
    h = tuple(x / guide.g for x in pencil.h)
    index = tuple(places.index(place) for place in scaled_places)
    return Reduced(problem, guide, tuple(places), index, without_neutral(S, parts.neutral), B, h, parts, scales)


def without_neutral(S: Sequence[Any], neutral: int) -> tuple[Any, Any, Any]:
    """The matrices of σ⁰, σ¹, σ² with the last `neutral` rows divided by σ."""
    first = len(S[0]) - neutral

    def shift(k: int) -> Any:
        zero = (Fraction(0),) * len(S[k])
        return tuple((S[k + 1][i] if k < 2 else zero) if i >= first else S[k][i] for i in range(len(S[k])))

    return shift(0), shift(1), shift(2)


def scale_guide(problem: Problem) -> Guide:
    """The problem's track at its velocity, scaled."""
    return track_guide(problem.track, problem.v)


def track_guide(track: Track | Waveguide, velocity: Fraction) -> Guide:
    """Powers of two for length and time that bring the coefficients of D nearest to one size."""
    waveguide = track.waveguide
    D, N = waveguide.dispersion, waveguide.numerator
    for name, polynomial in (("D", D), ("N", N)):
        if any(i % 2 for i, _ in polynomial):
            raise InputError(
                "track", f"has odd powers of p in {name}, so it is not reciprocal: only such tracks are known here"
            )
    keys = list(D)
    rows = np.array([[1.0, i, j] for i, j in keys])
    logs = np.array([_log2(c) for c in D.values()])
    fit = np.linalg.lstsq(rows, logs, rcond=None)[0]
    length, time = (
        round(float(fit[1])),
        4 * round(float(fit[2]) / 4),
    )  # so that q^γ of the tail theorem scales exactly
    unit_P, unit_s = Fraction(2) ** -length, Fraction(2) ** -time
    rescale = lambda i, j, c: c * unit_P**i * unit_s**j  # noqa: E731
    D, N = mapped(D, rescale), mapped(N, rescale)
    e, f = (round(max(map(_log2, a.values()), default=0.0)) for a in (D, N))
    D, N = scaled(D, Fraction(2) ** -e), scaled(N, Fraction(2) ** -f)
    v = velocity * unit_P / unit_s
    g = Fraction(2) ** (f - e - length)
    own = own_damping(waveguide)
    if own is not None:
        own = own[0] * unit_s * unit_P ** own[1] * g / unit_P, own[1]
    guide = Guide(length, time, D, N, moving(D, v), moving(N, v), v, g, own)
    _require_no_wave_speed(guide, velocity)
    _require_waves(guide)
    return guide


def _require_no_wave_speed(guide: Guide, velocity: Fraction) -> None:
    """No power of p is lost: the highest coefficient of D in P is then constant, so that no p-root is infinite."""
    if velocity and guide.degree < max(i + j for i, j in guide.D_rest):
        stated = f"is {shown(velocity)}, exactly a speed at which waves of the track run as they become short"
        raise InputError("v", f"{stated}, where the equations lose a solution: change it a little")


def _require_waves(guide: Guide) -> None:
    """N/D falls at least as p⁻²: G is given by either kind of p-roots at distance 0, and small at infinity."""
    if not guide.degree:
        raise InputError("track", "has no dispersion in p: give a track that carries waves")
    if max((i for i, _ in guide.N), default=0) + 2 > guide.degree:
        raise InputError("track", "has a point receptance that does not exist: let D grow with p by p² more than N")


def _log2(x: Fraction) -> float:
    return log2(abs(x.numerator)) - log2(x.denominator)


def times(rows: Any, factor: Fraction) -> Any:
    """Every entry times a factor."""
    return tuple(tuple(x * factor for x in row) for row in rows)


def conjugate(rows: Any, scales: tuple[int, ...]) -> Any:
    """Each row and column times its power of two."""
    return tuple(
        tuple(x * Fraction(2) ** (scales[i] + scales[j]) for j, x in enumerate(row)) for i, row in enumerate(rows)
    )


def _scales(S: list[Rows]) -> tuple[int, ...]:
    """Powers of two that bring the diagonal of S near 1."""
    sizes = [sum((abs(rows[i][i]) for rows in S), Fraction(0)) for i in range(len(S[0]))]
    return tuple(-round(_log2(size) / 2) if size else 0 for size in sizes)
