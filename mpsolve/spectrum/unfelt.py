"""Frequencies of the part of a vehicle that no contact feels: the track has no say in them."""

from __future__ import annotations

from fractions import Fraction
from math import lcm

from flint import acb, fmpz_poly

from mpsolve.numbers.balls import complex_roots, precision
from mpsolve.tracks.waveguide import Polynomial, determinant
from mpsolve.vehicles.felt import Parts
from mpsolve.vehicles.vehicle import Rows

_BITS = 128


def unfelt_frequencies(parts: Parts) -> tuple[acb, ...]:
    """Balls of the q with det(K + iqC − q²M) = 0 on the unfelt part, in the problem's units, as often as they are."""
    if parts.unfelt is None:
        return ()
    M, C, K = parts.unfelt
    size = range(len(M))
    found = determinant(tuple(tuple(_entry((K, C, M), i, j) for j in size) for i in size))
    with precision(_BITS):
        roots = complex_roots(_integers(found))
        turned = [(acb(sigma.imag, -sigma.real), int(times)) for sigma, times in roots]
    return tuple(q for q, times in turned for _ in range(times))


def _entry(parts: tuple[Rows, ...], i: int, j: int) -> Polynomial:
    return {(0, k): rows[i][j] for k, rows in enumerate(parts) if rows[i][j]}


def _integers(polynomial: Polynomial) -> fmpz_poly:
    """The polynomial in σ times a whole number."""
    top = max(j for _, j in polynomial)
    values = [polynomial.get((0, j), Fraction(0)) for j in range(top + 1)]
    down = lcm(*(x.denominator for x in values))
    return fmpz_poly([int(x * down) for x in values])
