"""Where wavenumbers are cut into cells, in floats: fine near the waves of the track. Nothing rests on the choice."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.float64 import companions
from mpsolve.passivity.subject import Subject, floats_of
from mpsolve.tracks.waveguide import carried

_REACH = 12.0  # of the cells, in the largest wavenumber that counts
_FAR = 100.0  # times the median: a root that is as good as infinite
_LEAST = 1e-6  # of the reach: the width that is given to a wave without damping


def cells(subject: Subject, q: Any, x: Reals, spread: Reals, side: int) -> Reals:
    """The ends of cells of wavenumber, ascending, shape (boxes, ends), for q and the parameters at points.

    spread: by how much q and the parameters vary about them, relative: cells need not be finer than what that blurs.
    side: the number of cells on each side of a wave.
    """
    v = floats_of(subject.v.items(), x)
    roots = wavenumbers(subject, q, v, x)
    size = np.abs(roots)
    size = np.where(size < _FAR * np.median(size, axis=1)[:, None], size, 0)
    reach = _REACH * np.maximum(size.max(1), 1e-6)
    width = np.maximum(np.abs(roots.imag), (np.abs(roots.real) * spread[:, None] + _LEAST * reach[:, None]) / 2)
    steps = np.sinh(
        np.linspace(-1, 1, 2 * side + 1)[None, None, :] * np.arcsinh(2 * reach[:, None] / width)[..., None]
    )
    ends = (roots.real[:, :, None] + width[:, :, None] * steps).reshape(len(q), -1)
    with np.errstate(all="ignore"):
        turn = np.where(v > 0, q / v, reach)
    ends = np.concatenate([ends, -reach[:, None], reach[:, None], turn[:, None]], axis=1)
    return np.sort(np.clip(ends, -reach[:, None], reach[:, None]), axis=1)


def wavenumbers(subject: Subject, q: Any, v: Reals, x: Reals) -> Any:
    """The roots p of D(ip, i(q − vp)), shape (boxes, degree)."""
    rows = subject.rows
    degree = max(i + j for i, j in rows)
    D = np.zeros((len(q), degree + 1), complex)
    turned = {(i, j): floats_of(terms, x) * 1j ** (i + j) for (i, j), terms in rows.items()}
    for (i, j), c in carried(turned, v).items():
        D[:, i] += c * q**j
    used = np.flatnonzero(np.abs(D).max(0) > 0)
    D, powers = D[:, : used[-1] + 1], np.arange(used[-1] + 1)
    with np.errstate(all="ignore"):  # in units of about the least root, so that no coefficient is lost beside others
        unit = np.nanmin((np.abs(D[:, :1] / D[:, 1:])) ** (1 / powers[1:]), axis=1, initial=np.inf)
    unit = np.where(np.isfinite(unit) & (unit > 0), unit, 1.0)[:, None]
    D = D * unit**powers
    least = 1e-12 * np.abs(D).max(1)
    D[:, -1] = np.where(np.abs(D[:, -1]) > least, D[:, -1], least)
    C = companions(D)
    return np.linalg.eigvals(np.where(np.isfinite(C), C, 0)) * unit
