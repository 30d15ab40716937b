"""Receptances at very many points, each of one entry of a group; characteristic matrices there, log Δ̂ and its slope.

Sums of residues at the p-roots; companion matrices at the few points where two roots of one side nearly meet.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.wave_sums import wave_sums
from mpsolve.characteristic.follow import cancelled, first_roots, from_near, upper_first
from mpsolve.characteristic.receptance import by_companions
from mpsolve.characteristic.splitting import float_splitting
from mpsolve.characteristic.symbol import Coefficients
from mpsolve.numbers.arrays import Complexes, Integers
from mpsolve.numbers.float64 import AT_A_ZERO, Float64
from mpsolve.numbers.float64 import log_slope as slope_of_log

_K = Float64()
_LOST = 1e-9
"""What residues of close p-roots may lose before companion matrices take their place."""
_CELLS = 1 << 16  # of the matrices of one chunk: they stay in the processor's cache


@dataclass(frozen=True)
class Values:
    """At each point: the p-roots, G between the contacts and its slope in σ (or None)."""

    z: Any
    G: Any
    G_sigma: Any


def chunks(group: Group, count: int) -> Iterator[slice]:
    """As many of `count` points as are computed at a time."""
    size = max(group.contacts, len(group.border[0].kept) + group.contacts, 2)
    step = max(64, min(4096, _CELLS // size**2))
    return (slice(k, min(k + step, count)) for k in range(0, count, step))


def coefficients(table: Any, rows: Any, sigma: Any) -> Any:
    """Σ_j table[row, i, j] σ^j for each point, shape (points, i)."""
    some = table[rows]
    out = some[:, :, -1].astype(complex)
    for j in range(some.shape[2] - 2, -1, -1):
        out = out * sigma[:, None] + some[:, :, j]
    return out


def _local(group: Group, rows: Any, sigma: Any, slope: bool) -> Coefficients:
    """D and N at each point, and where asked their slopes in σ; arrays of shape (points, 1)."""
    tables = (group.D, group.N, *((group.D_s, group.N_s) if slope else ()))
    values = (coefficients(table, rows, sigma) for table in tables)
    parts = [[a[:, i : i + 1] for i in range(a.shape[1])] for a in values]
    return Coefficients(*parts, *([] if slope else ([], [])))


def wave_roots(group: Group, rows: Any, sigma: Any, near: Any = None) -> Any:
    """The p-roots at each point, upper ones first; near: those of points close by, or None."""
    D = coefficients(group.D, rows, sigma)
    z = from_near(D, first_roots(D) if near is None else near)
    return upper_first(z, group.up, lambda tied, at: _local(group, rows[tied], sigma[tied], True).drift(at))


def receptances(group: Group, rows: Any, sigma: Any, near: Any = None, slope: bool = False) -> Values:
    """G between the contacts, shape (points, contacts, contacts)."""
    with np.errstate(all="ignore"):
        return at_roots(group, rows, sigma, wave_roots(group, rows, sigma, near), slope)


def at_roots(group: Group, rows: Any, sigma: Any, z: Any, slope: bool = False) -> Values:
    """The same for p-roots that are known, upper ones first."""
    with np.errstate(all="ignore"):
        local = _local(group, rows, sigma, slope)
        if slope:
            terms = local.terms(z)
            weights = terms.w, terms.a, terms.b
        else:
            weights = local.weight(z), None, None
        G, G_sigma = wave_sums(z, weights, group.x[rows], group.up)
        met = cancelled(z, weights[0], group.up, slope, _LOST)
        if len(met):
            values = _by_companions(group, rows[met], sigma[met], z[met], slope)
            G[met] = values[0]
            if slope:
                G_sigma[met] = values[1]
    return Values(z, G, G_sigma)


def _by_companions(group: Group, rows: Any, sigma: Any, z: Any, slope: bool) -> Any:
    """G and its slope where roots of one side meet, (1 or 2, points, contacts, contacts)."""
    local = _local(group, rows, sigma, slope)
    local = Coefficients(*([c[:, 0] for c in part] for part in (local.D, local.N, local.D_sigma, local.N_sigma)))
    x, count = group.x[rows], group.contacts
    pairs = [(i, j) for i in range(count) for j in range(count)]
    xi, ahead = [x[:, i] - x[:, j] for i, j in pairs], [i >= j for i, j in pairs]
    found = by_companions(_K, local, float_splitting(local.D, z, group.up), xi, ahead, slope)
    G = np.array([np.stack(rows, -1).reshape(-1, count, count) for rows in found if rows])
    for i in range(count - 1):  # places that are one
        same = np.flatnonzero(x[:, i] == x[:, i + 1])
        G[:, same, i, i + 1] = G[:, same, i, i]
    return G


_FILLED = 1 << 14  # of the matrices that are filled together: they stay in the processor's cache


def matrices(group: Group, rows: Integers, sigma: Any, values: Values) -> tuple[Any, Any]:
    """The characteristic matrix with direct contacts eliminated, and its slope in σ where that of G is known."""
    step = max(1, _FILLED // group.contacts**2)
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
