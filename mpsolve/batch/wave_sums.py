"""Sums of waves e^{zξ} between all contacts of a row, at many points.

And what p-roots tell of the way from one point to the next: whether they change sides, and how far waves turn.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals, Truths

_REACH = 1200.0
"""Exponents up to this are taken as products of waves; beyond it the distances are taken one by one."""
_EQUAL = 1e-14


def wave_sums(
    z: Any, weights: tuple[Complexes, Complexes | None, Complexes | None], x: Any, up: int
) -> tuple[Complexes, Any]:
    """G_ij and its slope: over the upper roots where ξ_i ≥ ξ_j, minus those over the lower ones elsewhere."""
    gaps = np.diff(x)
    if x.shape[1] > 1 and (gaps[:, 0] > 0).all() and (np.abs(gaps - gaps[:, :1]) <= _EQUAL * gaps[:, :1]).all():
        return _of_equal_gaps(z, weights, gaps[:, 0], x.shape[1], up)
    w, a, b = weights
    middle = (x[:, :1] + x[:, -1:]) / 2
    shifted = x - middle
    wide = np.abs(z.real).max(1, initial=0) * (x[:, -1] - x[:, 0]) > _REACH
    grown = np.exp(np.where(wide[:, None], 0, z)[:, None, :] * shifted[:, :, None])  # 1 where `wide`
    shrunk = 1 / grown
    ahead = np.tri(x.shape[1], dtype=bool)
    same = np.flatnonzero((np.diff(x) == 0).any(1))
    shrunk = np.ascontiguousarray(shrunk.transpose(2, 0, 1))

    def sided(weight: Any) -> Any:
        weighted = np.ascontiguousarray((grown * weight[:, None, :]).transpose(2, 0, 1))
        one, other = (_added(weighted[part], shrunk[part]) for part in (slice(0, up), slice(up, None)))
        out = np.negative(other, other)
        np.copyto(out, one, where=ahead)
        if len(same):  # contacts at one place: ξ = 0 belongs to the upper roots
            level = x[same][:, :, None] == x[same][:, None, :]
            out[same] = np.where(level, one[same], out[same])
        far = np.flatnonzero(wide)
        if len(far):
            out[far] = _one_by_one(z[far], weight[far], x[far], up)
        return out

    G = sided(w)
    if a is None:
        return G, None
    xi = x[:, :, None] - x[:, None, :]
    return G, sided(a) + xi * sided(b)


def _of_equal_gaps(
    z: Any, weights: tuple[Complexes, Complexes | None, Complexes | None], gap: Reals, count: int, up: int
) -> tuple[Any, Any]:
    """The same where all gaps are equal: 2·count − 1 sums are the whole matrix, and no wave grows."""
    ahead = np.arange(z.shape[1]) < up
    step = np.exp(np.where(ahead, z, -z).T * gap)
    waves = np.empty((count, *step.shape), complex)  # of k gaps, along the first axis
    waves[0], waves[1:] = 1, step
    for k in range(1, count):
        waves[k] *= waves[k - 1]

    def lined(weight: Any) -> Complexes:
        """(points, 2·count − 1): by i − j from 1 − count on."""
        terms = waves * weight.T
        line = np.zeros((len(z), 2 * count - 1), complex)
        for k in range(z.shape[1]):
            if k < up:
                line[:, count - 1 :] += terms[:, k].T
            else:
                line[:, : count - 1] -= terms[:0:-1, k].T
        return line

    def matrix(line: Complexes) -> Complexes:
        whole, one = line.strides
        shape, strides = (len(line), count, count), (whole, one, -one)
        return np.ascontiguousarray(np.lib.stride_tricks.as_strided(line[:, count - 1 :], shape, strides))

    w, a, b = weights
    G = matrix(lined(w))
    if a is None:
        return G, None
    xi = np.arange(1 - count, count) * gap[:, None]
    return G, matrix(lined(a) + xi * lined(b))


def _added(left: Any, right: Any) -> Any:
    """Σ_k left_k right_kᵀ for each point."""
    size = left.shape[2]
    if not len(left):
        return np.zeros((left.shape[1], size, size), complex)
    out = left[0][:, :, None] * right[0][:, None, :]
    for one, other in zip(left[1:], right[1:], strict=True):
        out += one[:, :, None] * other[:, None, :]
    return out


def _one_by_one(z: Any, weight: Complexes, x: Any, up: int) -> Complexes:
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
    for i in range(count - 1, 0, -1):  # contacts at one place: ξ = 0 belongs to the upper roots
        here = same[gaps[same, i - 1] == 0]
        out[here, i - 1] = out[here, i]
    return out


_SIDES = 0.4


def passes_branch(z: Any, up: int) -> Truths:
    """Whether G may have a branch point between a point and the next: an upper and a lower p-root come together.

    That is so where a root moves by more than a part of its distance to the other side.
    """
    before, after = z[:-1], z[1:]
    out = np.zeros(len(after), bool)
    for one, other in ((before, after), (after, before)):
        for k in range(z.shape[1]):
            rest = range(up, z.shape[1]) if k < up else range(up)
            room = np.full(len(after), np.inf)
            for j in rest:
                room = np.minimum(room, np.abs(one[:, k] - one[:, j]))
            out |= ~(_nearest(one[:, k], other) < _SIDES * room)
    return out


def moved_between(z: Any, weight: Reals) -> Reals:
    """The largest move of a p-root from each point to the next; weight: of each root at the later points."""
    before, after = z[:-1], z[1:]
    out = np.zeros(len(after))
    for k in range(z.shape[1]):
        out = np.maximum(out, _nearest(after[:, k], before) * weight[:, k])
    return out


def felt(z: Any, shortest: Reals, longest: Reals) -> Any:
    """The largest ξ |e^{zξ}| over the distances between these: how much a move of a root turns what it adds to G."""
    decay = np.abs(z.real)
    with np.errstate(all="ignore"):
        xi = np.clip(1 / decay, np.minimum(shortest, longest)[:, None], longest[:, None])
        return xi * np.exp(-decay * xi)


def _nearest(one: Any, other: Complexes) -> Any:
    out = np.abs(one - other[:, 0])
    for j in range(1, other.shape[1]):
        out = np.minimum(out, np.abs(one - other[:, j]))
    return out
