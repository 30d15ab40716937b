"""Receptances at very many points, each of one entry of a group.

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
from mpsolve.numbers.float64 import Float64

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
