"""The splitting U·L = D/lead on many discs of σ at once, rigorous in float64.

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
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.float64 import companions, polynomial_and_slope
from mpsolve.numbers.jets import TINY, UP, U, powers_up_to

_TIE, _AHEAD = 1e-9, 1e-7  # relative, and in σ: how roots on the edge of a cut are told apart; nothing rests on it


@frozen
class Splittings:
    """On each disc |σ − m| ≤ r: exactly one pair has |a_k| ≤ box_k, and it has |a_k| ≤ tight_k, where `good`."""

    m: Any
    r: Reals
    z: Any
    up: int
    box: Reals
    tight: Reals
    good: Any
    T: Any
    error: Reals

    def take(self, rows: Any) -> Splittings:
        parts = (self.m, self.r, self.z, self.box, self.tight, self.good, self.T, self.error)
        m, r, z, box, tight, good, T, error = (part[rows] for part in parts)
        return Splittings(m, r, z, self.up, box, tight, good, T, error)


def split(table: Table, m: Complexes, r: Reals, up: int, nodes: Complexes | None = None) -> Splittings:
    """Splittings on the discs |σ − m| ≤ r with `up` roots in U: those of smallest Re P, or the first of `nodes`."""
    with np.errstate(all="ignore"):
        T, error = table.in_time(m)
        z = side_nodes(T, up) if nodes is None else _kept_apart(nodes, up)
        n = z.shape[1]
        c, lost = table.at(z, T, error, 1)
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


def contraction(W: Reals, size: Any, up: int) -> tuple[Reals, Reals, Truths]:
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


def near_roots(coefficients: Complexes) -> Any:
    """Floats near the roots of each polynomial (coefficients ascending), in no order."""
    C = companions(coefficients)
    z: Any = np.linalg.eigvals(np.where(np.isfinite(C), C, 0))
    for _ in range(2):
        value, slope = polynomial_and_slope(coefficients, z)
        step = value / slope
        z = np.where(np.isfinite(step) & (np.abs(step) < 0.1 * np.abs(z)), z - step, z)
    return z


def side_nodes(T: Complexes, up: int) -> Any:
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
    size = np.abs(z)
    gap = np.abs(z[:, :, None] - z[:, None, :]) + np.diag(np.full(z.shape[1], np.inf))
    if not (gap < 1e-5 * size.max(1)[:, None, None]).any():
        return z
    z = z.copy()
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
            others = np.where(np.eye(count, dtype=bool), 1, to[:, :, None, :]).prod(3)  # without the i-th
            value = to.prod(2) + (tight[:, None, :] * others).sum(2)
            below = np.abs(gap).prod(2)
            value = value / below * (1 + 128 * count * U) * UP + TINY
            ok = ok & ((value < disc.box[:, part]) & (below > TINY)).all(1)
    return ok
