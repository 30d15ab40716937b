"""Receptances and the characteristic matrix at very many points, each of one entry of a group.

Sums of residues at the p-roots; companion matrices at the few points where two roots of one side nearly meet.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.waves import by_companions, from_near, polynomial_and_slope, upper_first
from mpsolve.characteristic.receptance import Dual, dual_residues
from mpsolve.characteristic.splitting import monic, sharpened
from mpsolve.characteristic.splitting import sylvester as sylvester_rows
from mpsolve.numbers.float64 import Float64

_K = Float64()
_NEAR = 2e-3
"""Roots of one side that are nearer than this, relative to the larger, are taken together."""
_REACH = 1200.0
"""Exponents up to this are taken as products of waves; beyond it the distances are taken one by one."""
_CELLS = 1 << 16  # of the matrices of one chunk: they stay in the processor's cache


@dataclass(frozen=True)
class Values:
    """At each point: the p-roots, G between the contacts and its slope in σ (or None)."""

    z: Any
    G: Any
    G_sigma: Any


def chunk_of(group: Group) -> int:
    """How many points are computed at a time."""
    size = max(group.contacts, len(group.kept) + group.contacts, 2)
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
    z = from_near(D, by_companions(D) if near is None else near)

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
        z = wave_roots(group, rows, sigma, near)
        local = _Local(group, rows, sigma)
        weights = local.weights(z, slope)
        x = group.x[rows]
        G, G_sigma = _sums(z, weights, x, group.up)
        met = np.flatnonzero(_meet(z, group.up, 0.05 if slope else _NEAR))
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


def _sums(z: Any, weights: tuple[Any, Any, Any], x: Any, up: int) -> tuple[Any, Any]:
    """G_ij and its slope: over the upper roots where ξ_i ≥ ξ_j, minus those over the lower ones elsewhere."""
    w, a, b = weights
    middle = (x[:, :1] + x[:, -1:]) / 2
    shifted = x - middle
    wide = np.abs(z.real).max(1, initial=0) * (x[:, -1] - x[:, 0]) > _REACH
    grown = np.exp(np.where(wide[:, None, None], 0, z[:, None, :] * shifted[:, :, None]))  # (points, contacts, roots)
    shrunk = 1 / grown
    ahead = x[:, :, None] >= x[:, None, :]

    def sided(weight: Any) -> Any:
        one = (grown[:, :, :up] * weight[:, None, :up]) @ shrunk[:, :, :up].swapaxes(1, 2)
        other = (grown[:, :, up:] * weight[:, None, up:]) @ shrunk[:, :, up:].swapaxes(1, 2)
        out = np.where(ahead, one, -other)
        far = np.flatnonzero(wide)
        if len(far):
            out[far] = _one_by_one(z[far], weight[far], x[far], up)
        return out

    G = sided(w)
    if a is None:
        return G, None
    xi = x[:, :, None] - x[:, None, :]
    return G, sided(a) + xi * sided(b)


def _one_by_one(z: Any, weight: Any, x: Any, up: int) -> Any:
    """The same from gap to gap, where products of waves leave the range of float64."""
    count = x.shape[1]
    out = np.zeros((len(z), count, count), complex)
    gaps = np.diff(x)
    for k in range(z.shape[1]):
        ahead = k < up
        factor = np.exp((1 if ahead else -1) * z[:, k, None] * gaps)
        E = np.zeros_like(out)
        E[:, 0, 0] = 1 if ahead else 0
        for i in range(1, count):
            E[:, i, :i] = E[:, i - 1, :i] * factor[:, i - 1, None]
            if ahead:
                E[:, i, i] = 1
            else:
                E[:, i, i - 1] = factor[:, i - 1]
        out += weight[:, k, None, None] * (E if ahead else -E.swapaxes(1, 2))
    same = np.flatnonzero((gaps == 0).any(1))
    for i in range(1, count):  # contacts at one place: ξ = 0 belongs to the upper roots
        here = same[gaps[same, i - 1] == 0]
        out[here, i - 1] = out[here, i]
    return out


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


def matrices(group: Group, rows: Any, sigma: Any, values: Values) -> tuple[Any, Any]:
    """The characteristic matrix with direct contacts eliminated, and its slope in σ where that of G is known."""
    s = sigma[:, None, None]
    S0, S1, S2, B = (a[rows] for a in (group.S0, group.S1, group.S2, group.B))
    S = (S2 * s + S1) * s + S0
    A = _assembled(group, rows, S, B, values.G)
    if values.G_sigma is None:
        return A, None
    S_s = 2 * S2 * s + S1
    kept, indirect = group.kept, group.indirect
    size, width = group.bodies + len(indirect), len(kept) + group.contacts
    slope = np.zeros((len(rows), size, width), complex)
    slope[:, : group.bodies, : len(kept)] = S_s[:, :, kept]
    for body, contact in group.direct:
        b = B[:, body, contact, None]
        for i in _touched(group, body):
            slope[:, i, len(kept) :] -= (
                S_s[:, i, body, None] * values.G[:, contact] + S[:, i, body, None] * values.G_sigma[:, contact]
            ) / b
    slope[:, group.bodies :, len(kept) :] = values.G_sigma[:, indirect]
    return A, slope


def _assembled(group: Group, rows: Any, S: Any, B: Any, G: Any) -> Any:
    kept, indirect, bodies = group.kept, group.indirect, group.bodies
    A = np.empty((len(rows), bodies + len(indirect), len(kept) + group.contacts), complex)
    A[:, :bodies, : len(kept)] = S[:, :, kept]
    A[:, :bodies, len(kept) :] = -B
    for body, contact in group.direct:
        b = B[:, body, contact, None]
        for i in _touched(group, body):
            A[:, i, len(kept) :] -= S[:, i, body, None] / b * G[:, contact]
    if indirect:
        A[:, bodies:, : len(kept)] = B.swapaxes(1, 2)[:, indirect][:, :, kept]
        A[:, bodies:, len(kept) :] = G[:, indirect]
        for place, j in enumerate(indirect):
            A[:, bodies + place, len(kept) + j] += group.h[rows, j]
    return A


def _touched(group: Group, body: int) -> list[int]:
    """Bodies whose equations have this body's motion in them."""
    some = (group.S0[:, :, body] != 0) | (group.S1[:, :, body] != 0) | (group.S2[:, :, body] != 0)
    return [int(i) for i in np.flatnonzero(some.any(0))]


def log_delta(group: Group, rows: Any, sigma: Any, near: Any = None) -> tuple[Any, Any]:
    """log Δ̂ (its imaginary part modulo 2π, up to a constant of the entry) and the p-roots at each point."""
    out, roots = np.empty(len(rows), complex), np.empty((len(rows), group.D.shape[1] - 1), complex)
    step = chunk_of(group)
    for k in range(0, len(rows), step):
        part = slice(k, k + step)
        values = receptances(group, rows[part], sigma[part], None if near is None else near[part])
        with np.errstate(all="ignore"):
            sign, size = np.linalg.slogdet(matrices(group, rows[part], sigma[part], values)[0])
        out[part], roots[part] = size + 1j * np.angle(sign), values.z
    return out, roots
