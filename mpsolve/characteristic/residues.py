"""Residues of N/D and receptances on many discs of σ at once, rigorous in float64, where p-roots are told apart."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.characteristic.discs import Splittings
from mpsolve.characteristic.table import Table
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.jets import TINY, UP, Jet, U, joined, powers_up_to


@frozen
class Receptances:
    """G at each signed distance as jets of shape (discs, distances); `good` where it is bounded."""

    jet: Jet
    good: Any


def receptances(N: Table, D: Table, s: Splittings, distances: Reals) -> Receptances:
    """Σ N e^{Pξ}/D_P over the roots of U (ξ ≥ 0), −Σ over those of L (ξ < 0), where they are apart on the disc."""
    weight, p, alone = waves(N, D, s)
    return summed(weight, p, alone, s.up, distances)


def summed(weight: Jet, p: Jet, alone: Truths, up: int, distances: Reals) -> Receptances:
    """The sums of e^{Pξ} times its weight over the first `up` roots, and minus those over the others."""
    ahead = distances >= 0
    with np.errstate(all="ignore"):
        front = at_distances(p[:, :up], weight[:, :up], distances[ahead])
        back = -at_distances(p[:, up:], weight[:, up:], distances[~ahead])
        jet = joined([front, back]).taken(np.argsort(np.argsort(~ahead, kind="stable")))
        return Receptances(jet, alone & np.isfinite(jet.e).all(1) & np.isfinite(jet.a).all(1))


def at_distances(p: Jet, weight: Jet, xi: Reals) -> Jet:
    """Σ weight e^{Pξ} over the roots, shape (discs, distances)."""
    return ((p[:, :, None] * xi).exp() * weight[:, :, None]).sum(1)


def waves(N: Table, D: Table, s: Splittings) -> tuple[Jet, Jet, Truths]:
    """(N/D_P, P) at all p-roots, those of U first, as jets of shape (discs, roots), and where they are told apart."""
    with np.errstate(all="ignore"):
        roots, alone = told_apart(D, s)
        weight, p = weights(N, s.m, s.z, roots)
        return weight, p, alone & s.good


@frozen
class Roots:
    """Discs |P − z_k| ≤ eps that hold exactly one root for every σ of the disc, where `done`; c: D at P = z_k + e."""

    c: Complexes
    lost: Any
    eps: Reals
    powers: Reals
    r: Reals
    done: Truths


def isolated(D: Table, z: Any, T: Complexes, error: Reals, r: Reals) -> Roots:
    """Discs round the nodes with one root of D each; T, error: D in time."""
    c, lost, powers, by_e, slope = _round_nodes(D, z, T, error, r)
    order = np.arange(c.shape[2])
    base = by_e[:, :, 0] + 1e-250
    eps = 1.5 * base
    done = np.zeros(eps.shape, bool)
    for _ in range(6):
        terms = by_e * order * powers_up_to(eps, len(order))
        image = (base + terms.sum(2)) * UP
        done |= image < 0.999 * eps  # e → e − D/c₁₀ maps the disc into itself and contracts
        eps = np.where(done, eps, 1.6 * image)
        if done.all():
            break
    return Roots(c, lost, eps, powers, r, done & (slope > 0))


def _round_nodes(
    D: Table, z: Any, T: Complexes, error: Reals, r: Reals
) -> tuple[Complexes, Reals, Reals, Reals, Reals]:
    """D at P = z + e, its error, powers of r; Σ_j |c_ij| r^j/|c₁₀| but for c₁₀ itself; a lower bound of |c₁₀|."""
    c, lost = D.at(z, T, error)
    powers = powers_up_to(r, c.shape[3])
    slope = np.abs(c[:, :, 1, 0]) - lost[:, :, 1, 0]
    E = (np.abs(c) + lost) / slope[:, :, None, None] * UP
    E[:, :, 1, 0] = lost[:, :, 1, 0] / slope * UP
    return c, lost, powers, np.einsum("bkij,bj->bki", E, powers) * UP, slope


def told_apart(D: Table, s: Splittings) -> tuple[Roots, Truths]:
    """The roots of a splitting, and whether all of them are told apart."""
    c, lost, powers, by_e, slope = _round_nodes(D, s.z, s.T, s.error, s.r)
    eps, alone = _sides_told_apart(s)
    for _ in range(3):  # the root z + u, |u| ≤ eps, has u = −(the rest of D)/c₁₀
        image = (by_e * powers_up_to(eps, c.shape[2])).sum(2) * UP + TINY
        eps = np.where(image < eps, image, eps)
    good = alone & (slope > 0).all(1)
    return Roots(c, lost, eps, powers, s.r, good[:, None] & (eps >= 0)), good


def _sides_told_apart(s: Splittings) -> tuple[Any, Any]:
    """Radii of discs round the nodes, those of one side disjoint, each with one root of its factor; and where so.

    On |P − z_k| = e the factor is U₀/(P − z_k) times (P − z_k)(1 + Σ_{j≠k} a_j/(P − z_j)) + a_k. So there is one root
    within if |a_k| < e(1 − Σ|a_j|/(|z_j − z_k| − e)) (Rouché).
    """
    size, n = np.abs(s.z[:, :, None] - s.z[:, None, :]) * (1 - 8 * U), s.z.shape[1]
    other = np.eye(n, dtype=bool)
    other[: s.up, s.up :] = other[s.up :, : s.up] = True
    size = np.where(other, np.inf, size)
    eps, done = 3 * s.tight, np.zeros(s.tight.shape, bool)
    for widening in (1.02, 1.1, 1.5, 3.0):
        e = widening * s.tight + TINY
        gap = size - e[:, :, None]
        g = np.where(other, 0, s.tight[:, None, :] / gap).sum(2) * (1 + 4 * n * U)
        one = (gap > 0).all(2) & (g < 1) & (s.tight < e * (1 - g) * (1 - 8 * U))
        eps = np.where(done, eps, e)
        done |= one
        if done.all():
            break
    apart = (size * (1 - 8 * U) > eps[:, :, None] + eps[:, None, :]).all((1, 2))
    return eps, done.all(1) & apart


def weights(N: Table, m: Complexes, z: Any, roots: Roots) -> tuple[Jet, Jet]:
    """N/D_P and P at the roots round the nodes z, as jets of shape (discs, roots)."""
    c, lost, eps, powers = roots.c, roots.lost, roots.eps, roots.powers
    r = roots.r[:, None]
    slope = c[:, :, 1, 0]
    low = (np.abs(slope) - lost[:, :, 1, 0]) * (1 - 8 * U)
    e0, e1 = -c[:, :, 0, 0] / slope, -(c[:, :, 0, 1] / slope if c.shape[3] > 1 else 0 * slope)
    orders = _orders(c.shape[2], c.shape[3])
    grid = powers_up_to(eps, c.shape[2])
    high = np.einsum("bkij,bki,bj->bk", np.where(orders >= 2, np.abs(c) + lost, 0), grid, powers)
    first = lost[:, :, 0, 0] + lost[:, :, 1, 0] * eps + (lost[:, :, 0, 1] * r if c.shape[3] > 1 else 0)
    rounding = 16 * U * (np.abs(e0) + np.abs(e1) * r)
    root = Jet(e0, e1, ((high + first + TINY) / low + rounding) * UP, roots.r)
    P = root + z
    derivative = _expand(_slopes(c), _slopes(lost), root, grid, powers)
    T, error = N.in_time(m)
    n, n_lost = N.at(z, T, error)
    n_grid = powers_up_to(eps, n.shape[2])
    n_powers = powers_up_to(roots.r, n.shape[3])
    return _expand(n, n_lost, root, n_grid, n_powers) * derivative.inverse(), P


def _orders(rows: int, columns: int) -> Integers:
    return np.arange(rows)[:, None] + np.arange(columns)[None, :]


def _slopes(c: Any) -> Any:
    """The coefficients of the derivative in e."""
    return c[:, :, 1:, :] * np.arange(1, c.shape[2])[:, None]


def _expand(c: Complexes, lost: Any, root: Jet, grid: Reals, powers: Reals) -> Jet:
    """Σ c_ij e^i t^j at e = root, as a jet."""
    rows, columns = c.shape[2], c.shape[3]
    grid, powers = grid[:, :, :rows], powers[:, :columns]
    r = root.r[:, None]
    a, b, e = c[:, :, 0, 0], np.zeros_like(c[:, :, 0, 0]), lost[:, :, 0, 0]
    if rows > 1:
        term = c[:, :, 1, 0]
        a, b = a + term * root.a, b + term * root.b
        e = e + np.abs(term) * root.e + lost[:, :, 1, 0] * grid[:, :, 1]
    if columns > 1:
        b = b + c[:, :, 0, 1]
        e = e + lost[:, :, 0, 1] * r
    high = np.where(_orders(rows, columns) >= 2, np.abs(c) + lost, 0)
    e = e + np.einsum("bkij,bki,bj->bk", high, grid, powers)
    # |root.a|, |root.b| r and their sum are below eps (see `_roots`), so this covers the terms of a and b r too
    size = np.abs(c[:, :, 0, 0]) + (np.abs(c[:, :, 1, 0]) * grid[:, :, 1] if rows > 1 else 0) + np.abs(b) * r
    return Jet(a, b, (e + 16 * U * size) * UP + TINY, root.r)
