"""The characteristic matrix at very many points, log Δ̂ and its slope."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.kernel import Values, chunk_of, receptances

_AT_A_ROOT = complex(1e300)


def matrices(group: Group, rows: Any, sigma: Any, values: Values) -> tuple[Any, Any]:
    """The characteristic matrix with direct contacts eliminated, and its slope in σ where that of G is known."""
    S, S_s = _pencil(group, rows, sigma)
    A = _assembled(group, rows, S, values.G)
    if values.G_sigma is None:
        return A, None
    slope = np.zeros_like(A)
    _put_pencil(group, slope, S_s)
    kept = len(group.kept)
    for place, (i, contact, b) in group.through.items():
        factor = 1 / group.B[rows, b, contact]
        slope[:, i, kept:] -= (S_s[:, place] * factor)[:, None] * values.G[:, contact]
        slope[:, i, kept:] -= (S[:, place] * factor)[:, None] * values.G_sigma[:, contact]
    slope[:, group.bodies :, kept:] = values.G_sigma[:, group.indirect]
    return A, slope


def _pencil(group: Group, rows: Any, sigma: Any) -> tuple[Any, Any]:
    """The entries of S that are not 0, and their slopes in σ."""
    S0, S1, S2 = (a[rows] for a in group.pencil)
    s = sigma[:, None]
    return (S2 * s + S1) * s + S0, 2 * S2 * s + S1


def _put_pencil(group: Group, A: Any, S: Any) -> None:
    """The entries of S whose columns are unknowns."""
    column = {body: k for k, body in enumerate(group.kept)}
    for place, (i, j) in enumerate(group.cells):
        if j in column:
            A[:, i, column[j]] = S[:, place]


def _assembled(group: Group, rows: Any, S: Any, G: Any) -> Any:
    kept, indirect, bodies = group.kept, group.indirect, group.bodies
    A = np.zeros((len(rows), bodies + len(indirect), len(kept) + group.contacts), complex)
    B = group.B[rows]
    A[:, :bodies, len(kept) :] = -B
    _put_pencil(group, A, S)
    own = [(place, i, contact) for place, (i, contact, b) in group.through.items() if i == b]
    if own:
        places, bodies_, contacts = (list(part) for part in zip(*own, strict=True))
        factor = S[:, places] / B[:, bodies_, contacts]
        if bodies_ == contacts == list(range(group.contacts)):
            A[:, : group.contacts, len(kept) :] -= factor[:, :, None] * G
        else:
            A[:, bodies_, len(kept) :] -= factor[:, :, None] * G[:, contacts]
    for place, (i, contact, b) in group.through.items():
        if i != b:
            A[:, i, len(kept) :] -= (S[:, place] / B[:, b, contact])[:, None] * G[:, contact]
    if indirect:
        A[:, bodies:, : len(kept)] = B.swapaxes(1, 2)[:, indirect][:, :, kept]
        A[:, bodies:, len(kept) :] = G[:, indirect]
        for place, j in enumerate(indirect):
            A[:, bodies + place, len(kept) + j] += group.h[rows, j]
    return A


def log_delta(group: Group, rows: Any, sigma: Any, near: Any = None) -> tuple[Any, Any]:
    """log Δ̂ (its imaginary part modulo 2π, up to a constant of the entry) and the p-roots at each point."""
    out, roots = np.empty(len(rows), complex), np.empty((len(rows), group.D.shape[1] - 1), complex)
    step = chunk_of(group)
    for k in range(0, len(rows), step):
        part = slice(k, k + step)
        values = receptances(group, rows[part], sigma[part], None if near is None else near[part])
        out[part], roots[part] = log_det(matrices(group, rows[part], sigma[part], values)[0]), values.z
    return out, roots


def log_det(A: Any) -> Any:
    """log det A of many matrices."""
    with np.errstate(all="ignore"):
        if A.shape[1] == 1:
            return np.log(A[:, 0, 0])
        if A.shape[1] == 2:
            return np.log(A[:, 0, 0] * A[:, 1, 1] - A[:, 0, 1] * A[:, 1, 0])
        sign, size = np.linalg.slogdet(A)
        return size + 1j * np.angle(sign)


def log_slope(group: Group, rows: Any, q: Any, near: Any = None) -> tuple[Any, Any]:
    """d log Δ̂/dq and the p-roots at each point."""
    out, roots = np.empty(len(q), complex), np.empty((len(q), group.D.shape[1] - 1), complex)
    step = chunk_of(group)
    for k in range(0, len(q), step):
        part = slice(k, k + step)
        with np.errstate(all="ignore"):
            values = receptances(group, rows[part], 1j * q[part], None if near is None else near[part], slope=True)
            out[part] = 1j * _turned(*matrices(group, rows[part], 1j * q[part], values))
        roots[part] = values.z
    return out, roots


def _turned(A: Any, A_s: Any) -> Any:
    """tr(A⁻¹A′); nan where it is not known."""
    if A.shape[1] <= 2:
        return _quotient(A, A_s)
    fine = np.isfinite(A).all((1, 2)) & np.isfinite(A_s).all((1, 2))
    A, A_s = np.where(fine[:, None, None], A, np.eye(A.shape[1])), np.where(fine[:, None, None], A_s, 0)
    try:
        trace = np.einsum("kii->k", np.linalg.solve(A, A_s))
    except np.linalg.LinAlgError:  # at a root itself
        trace = np.array([_trace(a, b) for a, b in zip(A, A_s, strict=True)])
    return np.where(fine, trace, np.nan)


def _quotient(A: Any, A_s: Any) -> Any:
    """(det A)′/det A of small matrices."""
    det, moved = A[:, 0, 0], A_s[:, 0, 0]
    if A.shape[1] == 2:
        moved = A[:, 0, 0] * A_s[:, 1, 1] + A[:, 1, 1] * A_s[:, 0, 0]
        moved -= A[:, 0, 1] * A_s[:, 1, 0] + A[:, 1, 0] * A_s[:, 0, 1]
        det = A[:, 0, 0] * A[:, 1, 1] - A[:, 0, 1] * A[:, 1, 0]
    return np.where(det == 0, _AT_A_ROOT, moved / np.where(det == 0, 1, det))


def _trace(a: Any, b: Any) -> complex:
    try:
        return complex(np.trace(np.linalg.solve(a, b)))
    except np.linalg.LinAlgError:
        return _AT_A_ROOT
