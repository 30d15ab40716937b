"""Receptances at very many points, each of one entry of a group.

Sums of residues at the p-roots; companion matrices at the few points where two roots of one side nearly meet.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.wave_sums import wave_sums
from mpsolve.batch.waves import first_roots, from_near, upper_first
from mpsolve.characteristic.receptance import Dual, dual_residues
from mpsolve.characteristic.splitting import monic, sharpened
from mpsolve.characteristic.splitting import sylvester as sylvester_rows
from mpsolve.numbers.float64 import Float64, polynomial_and_slope

_K = Float64()
_NEAR, _NEAR_SLOPE = 2e-3, 0.05
"""Roots of one side that are nearer than this, relative to the larger, are taken together; slopes lose more."""
_CELLS = 1 << 16  # of the matrices of one chunk: they stay in the processor's cache


@dataclass(frozen=True)
class Values:
    """At each point: the p-roots, G between the contacts and its slope in σ (or None)."""

    z: Any
    G: Any
    G_sigma: Any


def chunk_of(group: Group) -> int:
    """How many points are computed at a time."""
    size = max(group.contacts, len(group.border[0].kept) + group.contacts, 2)
    return max(64, min(4096, _CELLS // size**2))


def coefficients(table: Any, rows: Any, sigma: Any) -> Any:
    """Σ_j table[row, i, j] σ^j for each point, shape (points, i)."""
    some = table[rows]
    out = some[:, :, -1].astype(complex)
    for j in range(some.shape[2] - 2, -1, -1):
        out = out * sigma[:, None] + some[:, :, j]
    return out


def wave_roots(group: Group, rows: Any, sigma: Any, near: Any = None) -> Any:
    """The p-roots at each point, upper ones first; near: those of points close by, or None."""
    D = coefficients(group.D, rows, sigma)
    z = from_near(D, first_roots(D) if near is None else near)

    def drift(tied: Any, at: Any) -> Any:
        slope = _value(coefficients(group.D_s, rows[tied], sigma[tied]), at)
        with np.errstate(all="ignore"):
            return np.nan_to_num(-slope / polynomial_and_slope(D[tied], at)[1])

    return upper_first(z, group.up, drift)


def _value(a: Any, z: Any) -> Any:
    """Σ a_i z^i at several z for each row of a."""
    out = np.zeros_like(z) + a[:, -1:]
    for i in range(a.shape[1] - 2, -1, -1):
        out = out * z + a[:, i : i + 1]
    return out


def receptances(group: Group, rows: Any, sigma: Any, near: Any = None, slope: bool = False) -> Values:
    """G between the contacts, shape (points, contacts, contacts)."""
    with np.errstate(all="ignore"):
        return at_roots(group, rows, sigma, wave_roots(group, rows, sigma, near), slope)


def at_roots(group: Group, rows: Any, sigma: Any, z: Any, slope: bool = False) -> Values:
    """The same for p-roots that are known, upper ones first."""
    with np.errstate(all="ignore"):
        local = _Local(group, rows, sigma)
        weights = local.weights(z, slope)
        x = group.x[rows]
        G, G_sigma = wave_sums(z, weights, x, group.up)
        met = np.flatnonzero(_meet(z, group.up, _NEAR_SLOPE if slope else _NEAR))
        if len(met):
            values = _by_companions(group, rows[met], sigma[met], z[met], slope)
            G[met] = values[0]
            if slope:
                G_sigma[met] = values[1]
    return Values(z, G, G_sigma)


@dataclass(frozen=True)
class _Local:
    """D, N and their slopes in σ at points."""

    group: Group
    rows: Any
    sigma: Any

    def weights(self, z: Any, slope: bool) -> tuple[Any, Any, Any]:
        """Of e^{zξ} in G; and a, b of (a + bξ) e^{zξ} in its slope."""
        D = coefficients(self.group.D, self.rows, self.sigma)
        N = coefficients(self.group.N, self.rows, self.sigma)
        over = 1 / polynomial_and_slope(D, z)[1]
        if not slope:
            return _value(N, z) * over, None, None
        D_s = coefficients(self.group.D_s, self.rows, self.sigma)
        N_s = coefficients(self.group.N_s, self.rows, self.sigma)
        n, d_s = _value(N, z), _value(D_s, z)
        lost = n * d_s * over * over
        bend = _value(_in_P(_in_P(D)), z) * over
        turn = (_value(_in_P(N), z) * d_s + n * _value(_in_P(D_s), z)) * over * over
        return n * over, _value(N_s, z) * over - turn + lost * bend, -lost


def _in_P(a: Any) -> Any:
    out = a[:, 1:] * np.arange(1, a.shape[1])
    return out if out.shape[1] else np.zeros((len(a), 1), complex)


def _meet(z: Any, up: int, near: float) -> Any:
    """Where two roots of one side are near to one another."""
    out = np.zeros(len(z), bool)
    size = np.abs(z)
    for i in range(z.shape[1]):
        for j in range(i):
            if (i < up) == (j < up):
                out |= np.abs(z[:, i] - z[:, j]) < near * np.maximum(size[:, i], size[:, j])
    return out


def _by_companions(group: Group, rows: Any, sigma: Any, z: Any, slope: bool) -> tuple[Any, Any]:
    """G and its slope where roots of one side meet, by the formula of characteristic/receptance.py."""
    D = coefficients(group.D, rows, sigma)
    lead = D[:, -1]
    columns = [D[:, i] for i in range(D.shape[1])]
    U, L = (list(monic([part[:, k] for k in range(part.shape[1])])) for part in (z[:, : group.up], z[:, group.up :]))
    for _ in range(2):
        U, L = sharpened(_K, columns, U, L)
    N, dN, dU, dL = _slopes(group, rows, sigma, U, L, lead)
    x, like = group.x[rows], sigma * 0
    count = group.contacts
    G, G_sigma = np.zeros((len(rows), count, count), complex), np.zeros((len(rows), count, count), complex)
    pairs = [(i, j) for i in range(count) for j in range(count)]
    for one, other, sign in ((Dual(U, dU), Dual(L, dL), 1), (Dual(L, dL), Dual(U, dU), -1)):
        side = [(i, j) for i, j in pairs if (i >= j) is (sign > 0)]
        found = dual_residues(_K, one, other, Dual(N, dN), [x[:, i] - x[:, j] + 0j for i, j in side], like)
        for (i, j), (g, g_s) in zip(side, found, strict=True):
            G[:, i, j], G_sigma[:, i, j] = sign * g, sign * g_s
    for i in range(count - 1):  # places that are one
        same = np.flatnonzero(x[:, i] == x[:, i + 1])
        if len(same):
            G[same, i, i + 1], G_sigma[same, i, i + 1] = G[same, i, i], G_sigma[same, i, i]
    return G, G_sigma if slope else None


def _slopes(group: Group, rows: Any, sigma: Any, U: Any, L: Any, lead: Any) -> tuple[Any, Any, Any, Any]:
    """N/lead and the slopes in σ of it, of U and of L."""
    n = len(U) + len(L)
    D, D_s, N, N_s = (coefficients(a, rows, sigma) / lead[:, None] for a in (group.D, group.D_s, group.N, group.N_s))
    grown = D_s[:, n]
    rest = [[D_s[:, i] - D[:, i] * grown] for i in range(n)]
    moved = _K.solve(_K.matrix([[sigma * 0 + c for c in row] for row in sylvester_rows(U, L)]), _K.matrix(rest))
    parts = [moved[:, i, 0] for i in range(n)]
    N_s = N_s - N * grown[:, None]
    return list(N.T), list(N_s.T), parts[: len(U)], parts[len(U) :]
