"""Where a determinant of Taylor models vanishes: nowhere in a box, at one real point at most, or not told.

With floats X, Y from the singular values at the middle, X A Y = [[I + E, e], [f, g]]; where ‖E‖ ≤ η < 1, det A = 0
exactly where s = g − f (I + E)⁻¹ e is 0, and |s − (g − f e)| ≤ ‖f‖ ‖e‖ η/(1 − η), with ‖e‖ = max |e_i|/x_i and the
norms that belong to it, for some x > 0. The real box has no zero of s if Re(d s) > 0 for one direction d: near a zero
the coefficients of s are all but parallel, as roots move along the real axis, so directions normal to them tell most.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic, by_variable, pairs
from mpsolve.proof.turning import weighed


@dataclass(frozen=True)
class Scalar:
    """s over each box, where it is bounded; det A = 0 exactly where s = 0 (boxes with `good`).

    strain[v]: how much each variable moves the reduced matrix; rest: how much of it the model leaves out.
    """

    s: Quadratic
    good: Truths
    strain: Reals
    rest: Reals


def scalar(A: Quadratic, good: Truths, real: bool = False) -> Scalar:
    """The reduction of matrices of shape (boxes, n, n); real: by real X and Y, for A that are real at the middle."""
    n = A.k.shape[-1]
    with np.errstate(all="ignore"):
        finite = good & np.isfinite(A.k).all((0, 2, 3)) & np.isfinite(A.e).all((1, 2))
        if n == 1:
            one, rest = A[:, 0, 0], A.e[:, 0, 0] / np.abs(A.a[:, 0, 0])
            return Scalar(one, finite, np.abs(one.b / one.a), rest)
        middle = np.where(finite[:, None, None], A.a.real if real else A.a, np.eye(n))
        left, sizes, right = np.linalg.svd(middle)
        scale = 1 / np.maximum(np.concatenate([sizes[:, :-1], sizes[:, -2:-1]], 1), TINY)
        X, Y = scale[:, :, None] * np.swapaxes(left.conj(), 1, 2), np.swapaxes(right.conj(), 1, 2)
        k = X @ A.k @ Y
        size_X, size_Y = np.abs(X), np.abs(Y)
        lost = 64 * (n + 4) * U
        e = size_X @ (A.e + lost * np.abs(A.k).sum(0)) @ size_Y
        B = Quadratic(k, e * UP + TINY, A.m)
        E = B[:, :-1, :-1]
        defect = np.abs(E.k[0] - np.eye(n - 1)) + E.spread
        x, eta = weighed(defect, 8)
        eta = eta * UP
        column, row = B[:, :-1, -1:], B[:, -1:, :-1]
        product = (row @ column)[:, 0, 0]
        s = B[:, -1, -1] + -product
        rest = (row.size[:, 0] * x).sum(1) * (column.size[:, :, 0] / x).max(1) * eta / (1 - eta) * UP * UP
        fine = eta < 0.9
        strain = np.where(finite, np.abs(B.b).sum(3).max(2), 0.0)
        bound = np.where(fine, s.e + rest, np.inf)
        return Scalar(Quadratic(s.k, bound, s.m), finite & fine, strain, B.e.sum(2).max(1))


@dataclass(frozen=True)
class Verdict:
    """nonzero: boxes of real u with no zero of s, proved; weight[v]: what stands against it, by variable."""

    nonzero: Truths
    weight: Reals


def nonzero(s: Quadratic) -> Verdict:
    """The test in several directions. weight is what each variable takes off in the best of them, to within e."""
    with np.errstate(all="ignore"):
        found = np.zeros(s.e.shape, bool)
        best, way = np.full(s.e.shape, -np.inf), np.ones(s.e.shape, complex)
        for d in _directions(s):
            margin = _margin(s, d)
            found |= margin > 0
            share = np.nan_to_num(margin / np.abs(s.a * d), nan=-np.inf)
            way = np.where(share > best, d, way)
            best = np.maximum(best, share)
        return Verdict(found, _taken(s, way))


def _directions(s: Quadratic) -> list[Complexes]:
    """Towards the value, normal to each coefficient, and normal to the sum of them."""
    out = [s.a.conj()]
    out += [1j * b.conj() for b in s.b]
    if len(s.b) > 1:
        out.append(1j * s.b.sum(0).conj())
    return [np.where(np.abs(d) > 0, d / np.where(np.abs(d) > 0, np.abs(d), 1), 1) for d in out]


def _margin(s: Quadratic, d: Complexes) -> Any:
    """A number above 0 only where Re(±d s) > 0 over the box; |d| ≤ 1 to within roundings."""
    k = (s.k * d).real
    k = k * np.where(k[0] < 0, -1.0, 1.0)
    low = k[0].copy()
    for n, (i, j) in enumerate(pairs(s.m), 1 + s.m):
        if i != j:
            low -= np.abs(k[n])
            continue
        linear, bend = np.abs(k[1 + i]), k[n]
        inner = (bend > 0) & (2 * bend > linear)
        low -= np.where(inner, linear * linear / (4 * np.where(inner, bend, 1)), linear - bend)
    slack = s.e * (1 + 8 * U) + 64 * (len(s.k) + 4) * U * np.abs(s.k).sum(0) + TINY
    return low - slack * UP


def _taken(s: Quadratic, d: Complexes) -> Any:
    """For each variable the moduli of its coefficients in this direction, and a little of them in any."""
    return by_variable(np.abs((s.k * d).real) + 2.0**-12 * np.abs(s.k), s.m)


def guess(s: Quadratic) -> Reals:
    """Real u with Re s = Im s = 0 by Newton's method for the quadratic in two variables, in floats; nan if none."""
    u = np.zeros((2, len(s.e)))
    with np.errstate(all="ignore"):
        for _ in range(6):
            value = s.a + s.b[0] * u[0] + s.b[1] * u[1]
            value = value + s.c[0] * u[0] ** 2 + s.c[1] * u[0] * u[1] + s.c[2] * u[1] ** 2
            g0 = s.b[0] + 2 * s.c[0] * u[0] + s.c[1] * u[1]
            g1 = s.b[1] + s.c[1] * u[0] + 2 * s.c[2] * u[1]
            det = (g0.conj() * g1).imag
            step = np.stack([(value.conj() * g1).imag, (g0.conj() * value).imag]) / det
            u = u - step
    return u


def in_plane(s: Quadratic) -> Quadratic:
    """As a model in the first two variables, with what the others do in the remainder."""
    if s.m == 2:
        return s
    kept = [0, 1, 2, *(1 + s.m + n for n, (_, j) in enumerate(pairs(s.m)) if j < 2)]
    rest = np.setdiff1d(np.arange(len(s.k)), kept)
    more = np.abs(s.k[rest]).sum(0) * (1 + 4 * (len(rest) + 4) * U)
    return Quadratic(s.k[kept], (s.e + more) * UP, 2)


def one_at_most(s: Quadratic) -> Any:
    """Boxes (two variables) in whose half |u_i| ≤ 1/2, real u, s is proved to have one zero at most.

    The remainder is analytic on |u_i| ≤ 1, so its derivatives in the half are at most 2 e. With J the slopes at the
    middle as a real matrix, |J⁻¹| times what they vary by has norm < 1: s is injective there.
    """
    with np.errstate(all="ignore"):
        g0, g1 = s.b
        c = np.abs(s.c)
        vary = np.stack([c[0] + c[1] / 2 + 2 * s.e, c[2] + c[1] / 2 + 2 * s.e]) * (1 + 64 * U)
        det = np.abs((g0.conj() * g1).imag) - 8 * U * np.abs(g0) * np.abs(g1)
        # |J⁻¹| has rows of moduli |g1|/det, |g0|/det, a column's error is one complex number: a matrix of rank one,
        # whose norm in the weights of its rows is
        worst = (np.abs(g1) * vary[0] + np.abs(g0) * vary[1]) / det * (1 + 64 * U)
        return (det > 0) & np.isfinite(worst) & (worst < 0.9)
