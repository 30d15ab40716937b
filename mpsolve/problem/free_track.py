"""The equations of a track with free parameters, exact polynomials, in the scales of a guide."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from mpsolve.numbers.several import Ring, Several
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Track, Waveguide, over_ring

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
    return over_ring(type(track), track.parameters, ring)
