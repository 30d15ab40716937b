"""Dispersion curves in floats: all frequencies Ω_k(p) of free waves, each branch continued along p."""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import fmpq_poly

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Complexes, Integers, Reals
from mpsolve.numbers.float64 import balanced, polynomial_and_slope
from mpsolve.tracks.at_rest import rows_of
from mpsolve.tracks.waveguide import Track, Waveguide

_POLISH = 4  # Newton steps on what the eigenvalues give
_HALVINGS = 14  # of a step of p in which branches are not told apart


def dispersion(track: Track | Waveguide, p: Any) -> Any:
    """All branches Ω_k(p) of the track at rest: a complex array of shape (len(p), branches).

    Free waves e^{i(px + Ωt)}: Ω = −is, s the roots of D(ip, s); Im Ω ≥ 0 is the rate of decay. p: real wavenumbers,
    in an order along which the branches are to be continuous; at p[0] they stand in ascending order of Re Ω, then of
    Im Ω. Without damping every Ω is real, exactly, and ascending at every p. Floats: nothing is proved; the relative
    error of simple roots is that of the polynomial in s, mostly below 1e-12.

    >>> from mpsolve.tracks import String
    >>> dispersion(String(T=4, m=1, k=9), [0, 2]).real
    array([[-3.,  3.],
           [-5.,  5.]])
    """
    wavenumbers = checked_wavenumbers(p)
    rows = rows_of(track.waveguide)
    if not any(any(row.coeffs()) for row in rows[1::2]):
        return _undamped(rows[::2], wavenumbers) + 0j
    return continued(lambda x: _damped(rows, x), wavenumbers)


def checked_wavenumbers(p: Any) -> Reals:
    """The wavenumbers as a list of finite floats."""
    try:
        given = np.asarray(p, dtype=float)
    except (TypeError, ValueError):
        raise InputError("p", "holds what is no real number: give real wavenumbers in rad/m") from None
    if given.ndim != 1 or not len(given) or not np.isfinite(given).all():
        raise InputError("p", f"has the shape {given.shape} or is not finite: give a list of finite wavenumbers")
    return given


def coefficients(rows: list[fmpq_poly], p: Reals) -> Reals:
    """The coefficients of s⁰, s¹, … at every p, in floats."""
    y = p * p
    return np.stack([np.polyval([float(c.p) / float(c.q) for c in reversed(row.coeffs())], y) for row in rows], 1)


def _undamped(rows: list[fmpq_poly], p: Reals) -> Reals:
    """Ω = ±√−z, z = s² the roots of an even D, which are real and not positive for a track that stands."""
    roots = _roots(coefficients(rows, p))
    omega = np.sqrt(np.maximum(-roots.real, 0.0))
    return np.sort(np.concatenate([-omega, omega], 1), 1)


def _damped(rows: list[fmpq_poly], p: Reals) -> Complexes:
    omega = -1j * _roots(coefficients(rows, p))
    return np.take_along_axis(omega, np.lexsort((omega.imag, omega.real), axis=1), 1)


def _roots(c: Reals) -> Any:
    """The roots of every row of coefficients."""
    scaled, near, unit = balanced(c)
    return _polished(scaled, near) * unit


def _polished(c: Reals, x: Complexes) -> Complexes:
    """Newton steps, each kept where it lessens the residual."""
    for _ in range(_POLISH):
        f, slope = polynomial_and_slope(c, x)
        with np.errstate(all="ignore"):
            step = f / slope
        better = np.where(np.isfinite(step), x - step, x)
        x = np.where(np.abs(polynomial_and_slope(c, better)[0]) < np.abs(f), better, x)
    return x


def continued(branches: Any, p: Reals) -> Any:
    """The values of `branches(p)`, those of each row in the order that continues the row before it."""
    table = branches(p)
    out = np.empty_like(table)
    out[0] = table[0]
    for k in range(1, len(p)):
        out[k] = table[k][_order(branches, p[k - 1], out[k - 1], p[k], table[k], _HALVINGS)]
    return out


def _order(branches: Any, p: float, here: Complexes, q: float, there: Complexes, halvings: int) -> Any:
    """Where each branch at p goes to at q; the step is halved while two of them want the same place."""
    distance = np.abs(here[:, None] - there[None, :])
    nearest = distance.argmin(1)
    apart = np.sort(distance, 1)
    clear = len(here) == 1 or bool((apart[:, 0] < 0.25 * apart[:, 1]).all())
    if clear and len(set(nearest.tolist())) == len(nearest):
        return nearest
    if not halvings or p == q:
        return _greedy(distance)
    middle = (p + q) / 2
    values = branches(np.array([middle]))[0]
    values = values[_order(branches, p, here, middle, values, halvings - 1)]
    return _order(branches, middle, values, q, there, halvings - 1)


def _greedy(distance: Reals) -> Integers:
    """The nearest pairs first: for branches that meet, where every choice is continuous."""
    left, out = distance.copy(), np.zeros(len(distance), dtype=int)
    for _ in range(len(distance)):
        i, j = np.unravel_index(left.argmin(), left.shape)
        out[i] = j
        left[i, :], left[:, j] = np.inf, np.inf
    return out
