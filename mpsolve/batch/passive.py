"""From which frequency on the contacts cannot give energy: the corner ρ of the count, in float64.

σG is sampled on a grid of frequencies; its Hermitian part must be positive definite from ρ to the end of the grid,
which lies far above every frequency of the track's own. That is no proof: what the grid does not see is not known.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.kernel import chunk_of, receptances

_RATIO = 1.3
_LOW, _HIGH = 2.0**-6, 32.0  # of the grid, in scaled frequencies; the latter beyond the track's own
_CLEAR = 1e-9  # of the largest: the least pivot that counts as positive
_MOST = 400  # of the ends of the grid


def first_passive(group: Group) -> Any:
    """ρ̂ of each entry, nan where there is none on the grid; equal tracks with equal contacts are looked at once."""
    rows = np.column_stack([group.D.reshape(len(group), -1), group.N.reshape(len(group), -1), group.x])
    _, first, back = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return _sampled(group[first])[back.reshape(-1)]


def _sampled(group: Group) -> Any:
    """From the top of the grid down: as long as nothing is told, then as long as it is clearly positive."""
    at = _HIGH * np.maximum(_own_frequencies(group), 1.0)
    out = np.full(len(group), np.nan)
    open_, near = np.arange(len(group)), None
    while len(open_):
        clear, negative, near = _signs(group, open_, 1j * at[open_], near)
        begun = np.isfinite(out[open_])
        out[open_[clear]] = at[open_[clear]]
        at[open_] /= _RATIO
        keep = np.where(begun, clear, ~negative) & (at[open_] > _LOW)
        open_, near = open_[keep], near[keep]
    return out


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


def _signs(group: Group, rows: Any, sigma: Any, near: Any) -> tuple[Any, Any, Any]:
    """Where the Hermitian part is clearly positive, where it is clearly not, and the p-roots."""
    clear, negative = np.zeros(len(rows), bool), np.ones(len(rows), bool)
    roots = np.empty((len(rows), group.D.shape[1] - 1), complex)
    step = chunk_of(group)
    for k in range(0, len(rows), step):
        part = slice(k, k + step)
        values = receptances(group, rows[part], sigma[part], None if near is None else near[part])
        H = _shrunk(sigma[part, None, None] * values.G, group.x[rows[part]])
        one = _CLEAR * np.eye(H.shape[1])
        clear[part], roots[part] = _definite(H - one), values.z
        negative[part] = ~clear[part]
        rest = np.flatnonzero(~clear[part])
        if len(rest):
            negative[k + rest] = ~_definite(H[rest] + one)
    return clear, negative, roots


def _shrunk(V: Any, x: Any) -> Any:
    """V + V* over its largest diagonal entry; contacts at one place are taken once."""
    H = V + V.conj().swapaxes(1, 2)
    for j in range(1, H.shape[1]):  # a place that is there already: as if it stood alone
        same = np.flatnonzero(x[:, j] == x[:, j - 1])
        if len(same):
            H[same, j, :], H[same, :, j], H[same, j, j] = 0, 0, H[same, j - 1, j - 1].real
    size = np.abs(np.einsum("kii->ki", H)).max(1)
    fine = np.isfinite(H).all((1, 2)) & (size > 0)
    return np.where(fine[:, None, None], H / np.where(fine, size, 1)[:, None, None], -np.eye(H.shape[1]))


def _definite(H: Any) -> Any:
    try:
        np.linalg.cholesky(H)
    except np.linalg.LinAlgError:
        if len(H) == 1:
            return np.zeros(1, bool)
        half = len(H) // 2
        return np.concatenate([_definite(H[:half]), _definite(H[half:])])
    return np.ones(len(H), bool)
