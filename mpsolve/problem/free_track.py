"""The equations of a track with free parameters, exact polynomials, in the scales of a guide."""

from __future__ import annotations

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

from mpsolve.numbers.several import Ring, Several
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Track, Waveguide

FreePolynomial = dict[tuple[int, int], Several]
"""Σ c P^i σ^j with c polynomials in the free parameters."""


def free_guide(
    track: Track | Waveguide, scale: Guide, ring: Ring, v: Several
) -> tuple[FreePolynomial, FreePolynomial, Several]:
    """D̂ and N̂ at rest, and v̂, in the scales of a guide."""
    P, s = Fraction(2) ** -scale.length, Fraction(2) ** -scale.time
    free = Waveguide(free_matrix(track, ring), track.loaded)
    out = []
    for polynomial, like in ((free.dispersion, scale.D_rest), (free.numerator, scale.N_rest)):
        rescaled = {(i, j): ring.constant(c) * P**i * s**j for (i, j), c in polynomial.items()}
        key = next(key for key in like if key in rescaled)
        factor = like[key] / rescaled[key].at(ring.point)
        out.append({key: c * factor for key, c in rescaled.items()})
    return out[0], out[1], v * (P / s)


def free_matrix(track: Track | Waveguide, ring: Ring) -> Any:
    """The equations of the track as polynomials in P and s, with coefficients in the free parameters."""
    if isinstance(track, Waveguide):
        return track.matrix
    wide = Ring(("P", "s", *ring.names), (Fraction(0), Fraction(0), *ring.point))
    P, s, *_ = wide.variables
    values = {name: _lifted(ring.constant(value), wide) for name, value in track.parameters.items()}
    rows = track.equations(SimpleNamespace(P=P, s=s, **values))
    return tuple(tuple(_in_P_and_s(wide.constant(entry), ring) for entry in row) for row in rows)


def _lifted(value: Several, wide: Ring) -> Several:
    return Several(wide, {(0, 0, *exponents): c for exponents, c in value})


def _in_P_and_s(entry: Several, ring: Ring) -> FreePolynomial:
    out: dict[tuple[int, int], dict[tuple[int, ...], Fraction]] = {}
    for (i, j, *rest), c in entry:
        out.setdefault((i, j), {})[tuple(rest)] = c
    return {key: Several(ring, terms) for key, terms in out.items()}
