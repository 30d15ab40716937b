"""Newton's method for arrays of guesses, each with its case, and roots made exact on the lines of symmetry.

The unknown is t = √(q − iη_b − |q_lm|) and the function t Δ: both are smooth at the branch point, where Δ ~ 1/t.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.fast.cases import Cases
from mpsolve.model.characteristic import characteristic_rate

SAME = 1e-8  # relative distance of two approximations to one root
_STEPS, _PATIENT = 14, 40  # roots close together are approached slowly
_SETTLED = 1e-9  # a relative step after which quadratic convergence leaves nothing but rounding
_SNAP = 1e-7


def polish(cases: Cases, q: Any, known: Any = None) -> Any:
    """The roots that the guesses q lead to, folded into Re q ≥ 0; nan where they lead nowhere.

    cases and q: one-dimensional. known: roots to be divided out, shape (guesses, k), nan for none.
    """
    result = np.full(q.shape, np.nan, complex)
    place = np.flatnonzero(np.isfinite(q))
    some, q = cases[place], q[place]
    for _ in range(_STEPS if known is None else _PATIENT):
        if not len(place):
            break
        with np.errstate(all="ignore"):
            move, size = _step(some, q, 0 if known is None else _poles(q, known[place]))
            bound = 0.3 * np.abs(q) + 0.02  # a step far from a root is no more than a direction
            q = q + move * np.minimum(1, bound / np.where(size > 0, size, 1))
            settled = size < _SETTLED * np.abs(q)
        result[place[settled]] = q[settled]
        keep = ~settled & np.isfinite(q)
        place, some, q = place[keep], some[keep], q[keep]
    result = np.where(result.real < 0, -result.conj(), result)
    result[np.abs(result) < 1e-12] = np.nan
    return result


def _step(cases: Cases, q: Any, poles: Any) -> tuple[Any, Any]:
    """The step in q, and a bound of its size that no accident makes small: t and −t are one q."""
    value, slope = characteristic_rate(cases.track, q)
    t = np.sqrt(q - 1j * cases.eta_b - np.abs(cases.limit))
    step = -t * value / (2 * t * t * (slope - poles * value) + value)
    return (2 * t + step) * step, (2 * np.abs(t) + np.abs(step)) * np.abs(step)


def _poles(q: Any, known: Any) -> Any:
    """Σ 1/(q − k) over the known roots k and their mirror images."""
    terms = [1 / (q[:, None] - known), 1 / (q[:, None] + known.conj()) * np.where(known.real == 0, 0, 1)]
    return np.nansum(terms, axis=(0, 2))


def snapped(cases: Cases, q: Any) -> Any:
    """Roots next to a line of symmetry put on it: the imaginary axis, and for η_b = 0 the gap of the real axis."""
    q = q.copy()
    with np.errstate(invalid="ignore"):
        close = _SNAP * np.abs(q)
        on_imaginary = (np.abs(q.real) < close) & (q.real != 0)
        on_real = (cases.eta_b == 0) & (np.abs(q.imag) < close) & (q.real < cases.limit) & (q.imag != 0)
    for near, line in ((on_imaginary, 1j), (on_real, 1)):
        place = np.flatnonzero(near)
        if len(place):
            start = (q[place] / line).real * line
            moved = (polish(cases[place], start + 0j) / line).real * line
            with np.errstate(invalid="ignore"):
                same = np.abs(moved - q[place]) < SAME * np.abs(moved)
            q[place[same]] = moved[same]
    return q


def distinct(cases: Cases, q: Any, width: int) -> Any:
    """The first `width` different roots of every row (cases, guesses), padded with nan.

    Joined cuts part the sheet in two: roots on different sides are different, however close they are.
    """
    q, rows = q.copy(), np.arange(len(q))
    found = np.full((len(q), width), np.nan, complex)
    with np.errstate(invalid="ignore"):
        above = (q.imag > cases.eta_b[:, None]) & (cases.limit <= 0)[:, None]
        for k in range(width):
            first = np.isfinite(q).argmax(axis=1)
            root = found[:, k] = q[rows, first]
            near = np.abs(q - root[:, None]) < SAME * np.abs(root[:, None])
            q[near & (above == above[rows, first][:, None])] = np.nan
            if not np.isfinite(q).any():
                break
    return found


def weight(q: Any) -> Any:
    """How many roots each row stands for: a root off the imaginary axis has its mirror image −q̄."""
    return (np.isfinite(q) * np.where(q.real == 0, 1, 2)).sum(axis=-1)


def packed(q: Any, width: int) -> Any:
    """Rows with their roots first, cut or padded with nan to `width` columns."""
    order = np.argsort(~np.isfinite(q), axis=1, kind="stable")[:, :width]
    q = np.take_along_axis(q, order, axis=1)
    padding = np.full((len(q), width - q.shape[1]), np.nan, complex)
    return np.concatenate([q, padding], axis=1)
