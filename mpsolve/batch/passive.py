"""From which frequency on the contacts cannot give energy: the corner ρ of the count, in float64.

σG is sampled on a grid of frequencies; its Hermitian part must be positive definite from ρ to the end of the grid,
which lies far above every frequency of the track's own. That is no proof: what the grid does not see is not known.

There the count closes: its argument is that of the pivots of an accretive matrix at ρ (spectrum/closing.py).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.kernel import chunks, receptances
from mpsolve.batch.wave_sums import felt, moved_between, passes_branch
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths

_SMALL = 1e-9  # of the largest entry of its row: a pivot below it is not told from 0


def closing_argument(group: Group, rho: Reals) -> Reals:
    """Σ Arg(pivots of M) at σ̂ = iρ̂, M = [[S/σ, −B], [Bᵀ, σ(G + h)]]; nan where a pivot may be 0."""
    out, rows = np.empty(len(group)), np.arange(len(group))
    for part in chunks(group, len(group)):
        out[part] = _pivots(accretive(group, rows[part], 1j * rho[part]))
    return out


def accretive(group: Group, rows: Integers, sigma: Any) -> Complexes:
    """M, contacts first: their block is clearly accretive, and the bodies' are so where it reaches them."""
    n, c = group.bodies, group.contacts
    G = receptances(group, rows, sigma).G
    s = sigma[:, None, None]
    S = (group.S2[rows] * s + group.S1[rows]) * s + group.S0[rows]
    S[:, ~group.neutral] /= s
    M = np.zeros((len(rows), n + c, n + c), complex)
    M[:, :c, :c] = s * (G + group.h[rows][:, :, None] * np.eye(c))
    M[:, :c, c:] = group.B[rows].swapaxes(1, 2)
    M[:, c:, :c] = -group.B[rows]
    M[:, c:, c:] = S
    return M


def _pivots(M: Complexes) -> Reals:
    """By elimination with the largest diagonal entry first."""
    total, index = np.zeros(len(M)), np.arange(len(M))
    size = np.maximum(np.abs(M).max(2), 1e-300)
    while M.shape[1]:
        diagonal = np.einsum("kii->ki", M)
        pick = np.argmax(np.abs(diagonal) / size, 1)
        pivot = diagonal[index, pick]
        with np.errstate(all="ignore"):
            total = np.where(np.abs(pivot) > _SMALL * size[index, pick], total + np.angle(pivot), np.nan)
            row, column = M[index, pick], M[index, :, pick]
            M = M - column[:, :, None] * (row / pivot[:, None])[:, None, :]
        rest = np.arange(M.shape[1] - 1)[None, :]
        rest = rest + (rest >= pick[:, None])
        M = np.take_along_axis(np.take_along_axis(M, rest[:, :, None], 1), rest[:, None, :], 2)
        size = np.take_along_axis(size, rest, 1)
    return total


_RATIO = 1.3
_LOW, _HIGH = 2.0**-6, 32.0  # of the grid, in scaled frequencies; the latter beyond the track's own
_CLEAR = 1e-9  # of the largest: the least pivot that counts as positive
_TURN = 1.5  # rad, of a wave over the longest gap, as far as it comes
_FINEST = 1e-7  # relative step of the grid
_MOST = 400  # of the ends of the grid


def first_passive(group: Group) -> Reals:
    """ρ̂ of each entry, nan where there is none on the grid; equal tracks with equal contacts are looked at once."""
    rows = np.column_stack([group.D.reshape(len(group), -1), group.N.reshape(len(group), -1), group.x])
    _, first, back = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return _sampled(group[first])[back.reshape(-1)]


def outrun(group: Group) -> bool:
    """Whether the contacts run ahead of all waves, and each of them belongs to another set of bodies.

    All p-roots are then on one side, so that no contact feels itself nor those on that side of it: Δ̂ is that of the
    vehicles on a rigid rail, which are passive, and no root has Im q < 0.
    """
    if 0 < group.up < group.D.shape[1] - 1:
        return False
    linked = ((group.S0 != 0) | (group.S1 != 0) | (group.S2 != 0)).any(0)
    reach = np.eye(group.bodies, dtype=bool) | linked | linked.T
    for _ in range(group.bodies.bit_length()):
        reach = (reach.astype(int) @ reach.astype(int)) > 0
    touched = (group.B != 0).any(0)
    contacts = (reach.astype(int) @ touched.astype(int)) > 0
    return bool((contacts.sum(1) <= 1).all())


@dataclass(frozen=True)
class _Samples:
    """Frequencies of entries that have been looked at: sorted by entry, then descending."""

    row: Any
    at: Reals
    z: Any
    clear: Truths


def _sampled(group: Group) -> Reals:
    """ρ̂ from a coarse grid, and then from one on which no branch point of G is stepped over."""
    samples = _scanned(group)
    gaps = np.diff(group.x) if group.contacts > 1 else np.zeros((len(group), 1))
    longest, shortest = gaps.max(1), np.min(np.where(gaps > 0, gaps, np.inf), axis=1)
    while True:
        same = samples.row[1:] == samples.row[:-1]
        with np.errstate(invalid="ignore"):
            wide = same & passes_branch(samples.z, group.up)
            row = samples.row[1:]
            weight = felt(samples.z[1:], shortest[row], longest[row])
            wide |= same & ~(moved_between(samples.z, weight) < _TURN)
        wide &= samples.at[:-1] > (1 + _FINEST) * samples.at[1:]
        place = np.flatnonzero(wide)
        if not len(place):
            break
        samples = _refined(group, samples, place)
    broken = np.zeros(len(group))
    np.maximum.at(broken, samples.row[~samples.clear], samples.at[~samples.clear])
    good = samples.clear & (samples.at > broken[samples.row])
    out = np.full(len(group), np.inf)
    np.minimum.at(out, samples.row[good], samples.at[good])
    return np.where(np.isfinite(out), out, np.nan)


def _scanned(group: Group) -> _Samples:
    """From the top of the grid down: as long as nothing is told, then as long as it is clearly positive."""
    at = _HIGH * np.maximum(_own_frequencies(group), 1.0)
    begun = np.zeros(len(group), bool)
    open_, near = np.arange(len(group)), None
    seen = []
    while len(open_):
        clear, negative, near = _signs(group, open_, 1j * at[open_], near)
        begun[open_] |= clear
        mine = begun[open_]
        seen.append((open_[mine], at[open_[mine]], near[mine], clear[mine]))
        at[open_] /= _RATIO
        keep = np.where(mine, clear, ~negative) & (at[open_] > _LOW)
        open_, near = open_[keep], near[keep]
    row, at, z, clear = (np.concatenate(parts) for parts in zip(*seen, strict=True))
    order = np.lexsort((-at, row))
    return _Samples(row[order], at[order], z[order], clear[order])


def _refined(group: Group, samples: _Samples, place: Any) -> _Samples:
    """With the middles of the pieces behind these places."""
    row, at = samples.row[place], np.sqrt(samples.at[place] * samples.at[place + 1])
    clear, _, z = _signs(group, row, 1j * at, samples.z[place])
    return _Samples(
        np.insert(samples.row, place + 1, row),
        np.insert(samples.at, place + 1, at),
        np.insert(samples.z, place + 1, z, axis=0),
        np.insert(samples.clear, place + 1, clear),
    )


def _own_frequencies(group: Group) -> Any:
    """The largest |s| at which a wave of the track has wavenumber 0 or 1 (scaled), at rest: from D at P = 0."""
    C = group.D[:, 0, :]
    n = C.shape[1] - 1
    while n and not C[:, n].any():
        n -= 1
    if not n:
        return np.ones(len(group))
    size = np.abs(C[:, :n]) / np.where(C[:, n] != 0, np.abs(C[:, n]), np.inf)[:, None]
    return np.minimum((size ** (1 / (n - np.arange(n)))).max(1), _MOST)


def _signs(group: Group, rows: Any, sigma: Any, near: Complexes | None) -> tuple[Truths, Truths, Complexes]:
    """Where the Hermitian part is clearly positive, where it is clearly not, and the p-roots."""
    clear, negative = np.zeros(len(rows), bool), np.ones(len(rows), bool)
    roots = np.empty((len(rows), group.D.shape[1] - 1), complex)
    for part in chunks(group, len(rows)):
        values = receptances(group, rows[part], sigma[part], None if near is None else near[part])
        H = _shrunk(sigma[part, None, None] * values.G, group.x[rows[part]])
        one = _CLEAR * np.eye(H.shape[1])
        clear[part], roots[part] = _definite(H - one), values.z
        negative[part] = ~clear[part]
        rest = np.flatnonzero(~clear[part])
        if len(rest):
            negative[part.start + rest] = ~_definite(H[rest] + one)
    return clear, negative, roots


def _shrunk(V: Complexes, x: Any) -> Complexes:
    """V + V* over its largest diagonal entry; contacts at one place are taken once."""
    H = V + V.conj().swapaxes(1, 2)
    for j in range(1, H.shape[1]):  # a place that is there already: as if it stood alone
        same = np.flatnonzero(x[:, j] == x[:, j - 1])
        if len(same):
            H[same, j, :], H[same, :, j], H[same, j, j] = 0, 0, H[same, j - 1, j - 1].real
    size = np.abs(np.einsum("kii->ki", H)).max(1)
    fine = np.isfinite(H).all((1, 2)) & (size > 0)
    return np.where(fine[:, None, None], H / np.where(fine, size, 1)[:, None, None], -np.eye(H.shape[1]))


def _definite(H: Complexes) -> Truths:
    """Whether all pivots are positive; once one is not, the others do not matter."""
    H, good = H.copy(), np.ones(len(H), bool)
    for k in range(H.shape[1]):
        pivot = H[:, k, k].real
        good &= pivot > 0
        row = H[:, k, k + 1 :]
        H[:, k + 1 :, k + 1 :] -= row.conj()[:, :, None] * (row / np.where(good, pivot, np.inf)[:, None])[:, None, :]
    return good
