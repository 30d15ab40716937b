"""The splitting U·L = D/lead and the receptance on many discs of σ at once, rigorous in float64.

Nodes z are floats near the p-roots, the first `up` of them for U (the roots with Re P < 0 where Re σ > 0). With
U = U₀(1 + Σ a_k/(P − z_k)) and L likewise, U·L = D/lead is a_k = W_k/(1 + Σ_l b_l/(z_k − z_l)), l over the other
side, W_k = D(z_k)/(lead Π_{i≠k}(z_k − z_i)): a contraction where those sums stay below 1/2 (SPEC, splitting).
Any nodes are allowed: nothing rests on them.

Why it is enough: U·L and D/lead are monic of the same degree, so they agree where they agree at n different nodes,
and that is the equation. Its right sides map the polydisc |a_k| ≤ β_k into a smaller one: one fixed point, the limit
of iterates that are analytic in σ (Earle and Hamilton), so U and L are analytic on the disc.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.characteristic.table import Table
from mpsolve.frozen import frozen
from mpsolve.numbers.float64 import companions, polynomial_and_slope
from mpsolve.numbers.jets import TINY, UP, Jet, U, powers_up_to

_TIE, _AHEAD = 1e-9, 1e-7  # relative, and in σ: how roots on the edge of a cut are told apart; nothing rests on it


@frozen
class Splittings:
    """On each disc |σ − m| ≤ r: exactly one pair has |a_k| ≤ box_k, and it has |a_k| ≤ tight_k, where `good`."""

    m: Any
    r: Any
    z: Any
    up: int
    box: Any
    tight: Any
    good: Any
    T: Any
    error: Any

    def take(self, rows: Any) -> Splittings:
        parts = (self.m, self.r, self.z, self.box, self.tight, self.good, self.T, self.error)
        m, r, z, box, tight, good, T, error = (part[rows] for part in parts)
        return Splittings(m, r, z, self.up, box, tight, good, T, error)


def split(table: Table, m: Any, r: Any, up: int, nodes: Any = None) -> Splittings:
    """Splittings on the discs |σ − m| ≤ r with `up` roots in U: those of smallest Re P, or the first of `nodes`."""
    with np.errstate(all="ignore"):
        T, error = table.in_time(m)
        z = side_nodes(T, up) if nodes is None else _kept_apart(nodes, up)
        n = z.shape[1]
        c, lost = table.at(z, T, error)
        gap = z[:, :, None] - z[:, None, :]
        gap[:, np.arange(n), np.arange(n)] = 1
        powers = powers_up_to(r, T.shape[1])
        lead, lead_lost = np.abs(T[:, :, n]), error[:, :, n]
        low = lead[:, 0] - lead_lost[:, 0] - ((lead + lead_lost)[:, 1:] * powers[:, 1:]).sum(1) * UP
        size = np.abs(gap)
        W = np.einsum("bkj,bj->bk", np.abs(c[:, :, 0, :]) + lost[:, :, 0, :], powers) * UP
        below = size.prod(2) * low[:, None]
        W = W / below * (1 + 64 * n * U) * UP + TINY
        W = np.where((low[:, None] > 0) & (below > TINY), W, np.inf)
        box, image, done = contraction(W, size, up)
        return Splittings(m, r, z, up, box, image, done, T, error)


def contraction(W: Any, size: Any, up: int) -> tuple[Any, Any, Any]:
    """(β, the bounds of |a_k| that follow, where a_k = W_k/(1 + Σ b_l/(z_k − z_l)) contracts); size: |z_k − z_l|."""
    inverse = (1 + 8 * U) / size
    inverse[:, :up, :up] = 0
    inverse[:, up:, up:] = 0
    box, image = 1.2 * W, W
    done = np.zeros(len(W), bool)
    for _ in range(10):
        s = np.einsum("bkl,bl->bk", inverse, box) * UP
        image = np.where(done[:, None], image, W / (1 - s) * UP)
        inside = (s < 0.499).all(1) & (image < 0.999 * box).all(1)
        done |= inside
        box = np.where(done[:, None], box, 1.15 * image)
        if done.all():
            break
    return box, image, done


def near_roots(coefficients: Any) -> Any:
    """Floats near the roots of each polynomial (coefficients ascending), in no order."""
    C = companions(coefficients)
    z: Any = np.linalg.eigvals(np.where(np.isfinite(C), C, 0))
    for _ in range(2):
        value, slope = polynomial_and_slope(coefficients, z)
        step = value / slope
        z = np.where(np.isfinite(step) & (np.abs(step) < 0.1 * np.abs(z)), z - step, z)
    return z


def side_nodes(T: Any, up: int) -> Any:
    """Floats near the roots of Σ T[:, 0, i] P^i, those of U first, never two the same.

    T[:, j, i] belongs to P^i t^j. Of roots with one real part those come first that would have the smaller one
    further to the right in σ: a wave on the edge of a cut belongs to the side from which it comes.
    """
    z = near_roots(T[:, 0, :])
    key = z.real.copy()
    if 0 < up < z.shape[1] and T.shape[1] > 1:
        ranks = np.sort(key, 1)
        tie = ranks[:, up] - ranks[:, up - 1] < _TIE * np.abs(z).max(1)
        if tie.any():
            along, across = (polynomial_and_slope(T[tie, k, :], z[tie]) for k in (1, 0))
            drift = -along[0] / across[1]
            key[tie] += _AHEAD * np.nan_to_num(drift.real)
    return _kept_apart(np.take_along_axis(z, np.argsort(key, axis=1), 1), up)


def _kept_apart(z: Any, up: int) -> Any:
    """The nodes, moved a little where two nearly coincide."""
    z, size = z.copy(), np.abs(z)
    for i in range(z.shape[1]):
        for k in range(i + 1, z.shape[1]):
            scale = np.maximum(np.maximum(size[:, i], size[:, k]), 1e-12 * size.max(1))
            near = np.abs(z[:, i] - z[:, k]) < 1e-5 * scale
            z[:, k] = np.where(near, z[:, k] + (1e-3 if k < up else 1e-3j) * scale, z[:, k])
    return z


def linked(disc: Splittings, thin: Splittings) -> Any:
    """True where the pair of `thin`, at a point of `disc`, is the pair of `disc`: |a_k| = |U(z_k)/U₀′(z_k)| < box."""
    ok = disc.good & thin.good
    with np.errstate(all="ignore"):
        for part in (slice(0, disc.up), slice(disc.up, None)):
            z, w, tight = disc.z[:, part], thin.z[:, part], thin.tight[:, part]
            count = z.shape[1]
            if not count:
                continue
            gap = z[:, :, None] - z[:, None, :]
            gap[:, np.arange(count), np.arange(count)] = 1
            to = np.abs(z[:, :, None] - w[:, None, :])
            value = to.prod(2)
            for i in range(count):
                value = value + tight[:, i, None] * np.delete(to, i, 2).prod(2)
            below = np.abs(gap).prod(2)
            value = value / below * (1 + 128 * count * U) * UP + TINY
            ok = ok & ((value < disc.box[:, part]) & (below > TINY)).all(1)
    return ok


@frozen
class Receptances:
    """G at each signed distance as jets of shape (discs, distances); `good` where it is bounded."""

    jet: Jet
    good: Any


def receptances(N: Table, D: Table, s: Splittings, distances: Any) -> Receptances:
    """Σ N e^{Pξ}/D_P over the roots of U (ξ ≥ 0), −Σ over those of L (ξ < 0), where they are apart on the disc."""
    weight, p, alone = waves(N, D, s)
    return summed(weight, p, alone, s.up, distances)


def summed(weight: Jet, p: Jet, alone: Any, up: int, distances: Any) -> Receptances:
    """The sums of e^{Pξ} times its weight over the first `up` roots, and minus those over the others."""
    with np.errstate(all="ignore"):
        r, ahead, behind = weight.r, distances >= 0, distances < 0
        parts = []
        for side, mask, sign in ((slice(0, up), ahead, 1.0), (slice(up, None), behind, -1.0)):
            x = distances[mask]
            if not len(x):
                continue
            if weight.a[:, side].shape[1] == 0:
                zero = np.zeros((len(r), len(x)))
                parts.append((mask, Jet(zero + 0j, zero + 0j, zero, r)))
                continue
            grown, heavy = (Jet(f.a[:, side, None], f.b[:, side, None], f.e[:, side, None], r) for f in (p, weight))
            parts.append((mask, ((grown * x).exp() * heavy * sign).sum(1)))
        a, b = (np.zeros((len(r), len(distances)), complex) for _ in range(2))
        e = np.zeros((len(r), len(distances)))
        for mask, jet in parts:
            a[:, mask], b[:, mask], e[:, mask] = jet.a, jet.b, jet.e
        good = alone & np.isfinite(e).all(1) & np.isfinite(a).all(1)
        return Receptances(Jet(a, b, e, r), good)


def waves(N: Table, D: Table, s: Splittings) -> tuple[Jet, Jet, Any]:
    """(N/D_P, P) at all p-roots, those of U first, as jets of shape (discs, roots), and where they are told apart."""
    with np.errstate(all="ignore"):
        roots, alone = told_apart(D, s)
        weight, p = weights(N, s.m, s.z, roots)
        return weight, p, alone & s.good


@frozen
class Roots:
    """Discs |P − z_k| ≤ eps that hold exactly one root for every σ of the disc, where `done`; c: D at P = z_k + e."""

    c: Any
    lost: Any
    eps: Any
    powers: Any
    r: Any
    done: Any


def isolated(D: Table, z: Any, T: Any, error: Any, r: Any) -> Roots:
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


def _round_nodes(D: Table, z: Any, T: Any, error: Any, r: Any) -> tuple[Any, Any, Any, Any, Any]:
    """D at P = z + e, its error, powers of r; Σ_j |c_ij| r^j/|c₁₀| but for c₁₀ itself; a lower bound of |c₁₀|."""
    c, lost = D.at(z, T, error)
    powers = powers_up_to(r, c.shape[3])
    slope = np.abs(c[:, :, 1, 0]) - lost[:, :, 1, 0]
    E = (np.abs(c) + lost) / slope[:, :, None, None] * UP
    E[:, :, 1, 0] = lost[:, :, 1, 0] / slope * UP
    return c, lost, powers, np.einsum("bkij,bj->bki", E, powers) * UP, slope


def told_apart(D: Table, s: Splittings) -> tuple[Roots, Any]:
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
    apart = (size * (1 - 8 * U) > eps[:, :, None] + eps[:, None, :]).all((1, 2))
    return eps, done.all(1) & apart


def weights(N: Table, m: Any, z: Any, roots: Roots) -> tuple[Jet, Jet]:
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


def _orders(rows: int, columns: int) -> Any:
    return np.arange(rows)[:, None] + np.arange(columns)[None, :]


def _slopes(c: Any) -> Any:
    """The coefficients of the derivative in e."""
    return c[:, :, 1:, :] * np.arange(1, c.shape[2])[:, None]


def _expand(c: Any, lost: Any, root: Jet, grid: Any, powers: Any) -> Jet:
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
