"""The characteristic matrix at very many points, log Δ̂ and its slope."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.kernel import Values, chunks, receptances
from mpsolve.numbers.arrays import Complexes, Integers
from mpsolve.numbers.float64 import AT_A_ZERO
from mpsolve.numbers.float64 import log_slope as slope_of_log

_CELLS = 1 << 14  # of the matrices that are filled together: they stay in the processor's cache


def matrices(group: Group, rows: Integers, sigma: Any, values: Values) -> tuple[Any, Any]:
    """The characteristic matrix with direct contacts eliminated, and its slope in σ where that of G is known."""
    step = max(1, _CELLS // group.contacts**2)
    parts = [slice(k, k + step) for k in range(0, max(len(rows), 1), step)]
    found = [_matrices(group, rows[part], sigma[part], values, part) for part in parts]
    A, slopes = zip(*found, strict=True) if len(found) > 1 else found[0]
    if len(found) > 1:
        A, slopes = np.concatenate(A), None if slopes[0] is None else np.concatenate(slopes)
    return A, slopes


def _matrices(group: Group, rows: Any, sigma: Any, values: Values, part: slice) -> tuple[Any, Any]:
    border, table = group.border
    (c0, c1, c2), s = np.moveaxis(table[rows], 1, 0), sigma[:, None]
    f, (first, second) = (c2 * s + c1) * s + c0, border.one_each
    own = np.ravel_multi_index((first, second), (group.contacts, group.contacts))
    G, G_s = (
        None if a is None else np.take(a[part].reshape(len(s), group.contacts**2), own, 1)
        for a in (values.G, values.G_sigma)
    )
    return border.matrix(f, G), None if G_s is None else border.slope(f, G, 2 * c2 * s + c1, G_s)


def log_delta(group: Group, rows: Integers, sigma: Any, near: Complexes | None = None) -> tuple[Complexes, Complexes]:
    """log Δ̂ (its imaginary part modulo 2π, up to a constant of the entry) and the p-roots at each point."""
    out, roots = np.empty(len(rows), complex), np.empty((len(rows), group.D.shape[1] - 1), complex)
    for part in chunks(group, len(rows)):
        values = receptances(group, rows[part], sigma[part], None if near is None else near[part])
        out[part], roots[part] = log_det(matrices(group, rows[part], sigma[part], values)[0]), values.z
    return out, roots


def log_det(A: Complexes) -> Any:
    """log det A of many matrices."""
    with np.errstate(all="ignore"):
        if A.shape[1] == 1:
            return np.log(A[:, 0, 0])
        if A.shape[1] == 2:
            return np.log(A[:, 0, 0] * A[:, 1, 1] - A[:, 0, 1] * A[:, 1, 0])
        sign, size = np.linalg.slogdet(A)
        return size + 1j * np.angle(sign)


def log_slope(group: Group, rows: Integers, q: Any, near: Complexes | None = None) -> tuple[Complexes, Complexes]:
    """d log Δ̂/dq and the p-roots at each point."""
    out, roots = np.empty(len(q), complex), np.empty((len(q), group.D.shape[1] - 1), complex)
    for part in chunks(group, len(q)):
        with np.errstate(all="ignore"):
            values = receptances(group, rows[part], 1j * q[part], None if near is None else near[part], slope=True)
            both = matrices(group, rows[part], 1j * q[part], values)
            out[part] = 1j * (_quotient if both[0].shape[1] <= 2 else slope_of_log)(*both)
        roots[part] = values.z
    return out, roots


def _quotient(A: Complexes, A_s: Complexes) -> Complexes:
    """(det A)′/det A of small matrices."""
    det, moved = A[:, 0, 0], A_s[:, 0, 0]
    if A.shape[1] == 2:
        moved = A[:, 0, 0] * A_s[:, 1, 1] + A[:, 1, 1] * A_s[:, 0, 0]
        moved -= A[:, 0, 1] * A_s[:, 1, 0] + A[:, 1, 0] * A_s[:, 0, 1]
        det = A[:, 0, 0] * A[:, 1, 1] - A[:, 0, 1] * A[:, 1, 0]
    return np.where(det == 0, AT_A_ZERO, moved / np.where(det == 0, 1, det))
