"""The rail under a harmonic force that moves along: tables for solvers that have their own vehicle and time steps."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from mpsolve.characteristic.floats import Receptance
from mpsolve.characteristic.proved import told_apart
from mpsolve.characteristic.roots import float_roots
from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.balls import acb, precision
from mpsolve.numbers.model import rational, shown
from mpsolve.problem.reduced import track_guide
from mpsolve.tracks.at_rest import require_stable
from mpsolve.tracks.waveguide import Track, Waveguide

_BITS = 320


def receptance(track: Any, xi: Any, omega: Any, v: object = 0) -> Complexes:
    """Displacement of the rail per unit force, float64, complex, shape (len(xi), len(omega)).

    A force e^{iωt} that moves along the track at the velocity v deflects the rail at the distance ξ ahead of it
    by receptance · e^{iωt}. Units are those of the track, m/N, m and rad/s for SI. omega: real, or complex with
    Im ω ≤ 0 (a growing force); at a real ω it is the limit from Im ω < 0, so that undamped waves run away from the
    force. An obstacle Z_j(ω) at x_j that presses with Z_j w gives the system det[I − G(x_i − x_j, ω) Z_j(ω)] = 0,
    Z = M ω² for a mass. InputError for what is not finite, and where float64 does not reach.

    The deflection under a static unit force on a beam on springs is χ/(2k), χ = (k/4EI)^¼:

    >>> from mpsolve import tracks
    >>> beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1)
    >>> round(float(receptance(beam, 0, 0)[0, 0].real), 12)
    0.5
    """
    if not isinstance(track, (Track, Waveguide)):
        raise InputError("track", f"is of type {type(track).__name__}: give one of mpsolve.tracks")
    velocity = rational(v, "v", "m/s", "velocity")
    if velocity < 0:
        raise InputError("v", f"is {shown(velocity, v)}, but must not be below 0: x runs ahead of the force")
    places, points = _listed("xi", xi, float), _listed("omega", omega, complex)
    if (points.imag > 0).any():
        raise InputError("omega", "lies above the real axis, where the cuts may be: give Im ω ≤ 0")
    local = _receptance(track, velocity)
    guide = local.guide
    unit = Fraction(2) ** guide.length
    exact = [Fraction(float(x)) / unit for x in places]
    sigma = 1j * points * 2.0**guide.time
    with np.errstate(all="ignore"):
        try:
            doubtful = local.doubtful(sigma, max((float(abs(x)) for x in exact), default=0.0))
            table = np.empty((len(places), len(points)), complex)
            table[:, ~doubtful] = local(sigma[~doubtful], exact, slope=False)[0]
            for k in np.flatnonzero(doubtful):
                table[:, k] = _sharp(local, complex(sigma[k]), exact)
        except (ArithmeticError, ValueError, np.linalg.LinAlgError, PrecisionError):
            raise _out_of_reach() from None  # no number of float64, or no roots that are told apart
        table *= float(guide.g)
    if not np.isfinite(table).all():
        raise _out_of_reach()
    return table


def _sharp(local: Receptance, sigma: complex, xi: list[Fraction]) -> list[complex]:
    """Ĝ with as many bits as tell all p-roots apart, a little to the right of the imaginary axis if σ is on it."""
    with precision(_BITS):
        at = acb(sigma.real or 2.0**-100 * max(abs(sigma), 1.0), sigma.imag)
        D = [row(at) for row in local.symbols.D.balls()]
        found = told_apart(local.symbols, at, (D, float_roots(D, local.symbols.degree)), local.upper)
        if found is None:
            raise PrecisionError("p-roots nearly meet")
        return [complex(g) for g in found.receptances(xi, slope=False)[0]]


@lru_cache(maxsize=32)
def _receptance(track: Track | Waveguide, velocity: Fraction) -> Receptance:
    """Kept for the next call; InputError for a track that grows by itself, where a p-root has no side."""
    require_stable(track)
    return Receptance(track_guide(track, velocity))


def _listed(name: str, values: Any, kind: type) -> Any:
    out: Any
    try:
        out = np.atleast_1d(np.asarray(values, kind))
    except (TypeError, ValueError):
        raise InputError(name, "is no list of numbers: give a number, or a list of numbers") from None
    if out.ndim != 1 or not out.size or not np.isfinite(out).all():
        raise InputError(name, "is no list of finite numbers: give a number, or a list of numbers")
    return out


def _out_of_reach() -> InputError:
    return InputError("omega", "has points where the receptance is infinite, or out of float64's reach: give others")
