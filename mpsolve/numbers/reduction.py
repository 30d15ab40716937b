"""Tight determinants of matrices of balls, also where they are singular: everything is reduced to one scalar.

Exact matrices, chosen in float64, make left · A · right ≈ diag(1, …, 1, s). Where the middle of A is regular, left is
its inverse, right the identity and s ≈ 1: the first-order width is then the least possible. Where it is nearly
singular, with a null vector v and a left null vector u, the last column of right is v, and left is the inverse of A
with one column replaced by u: the first block is regular, so det A = 0 exactly where s = b_nn − b_n B⁻¹ b^n is 0.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.balls import acb, acb_mat, exact_ball

_WHOLE = 5
"""Matrices up to this size are not worth halving."""
_SINGULAR = 2.0**-20
"""Of the largest singular value of an equilibrated matrix: below it a matrix is nearly singular."""


@frozen
class Reduction:
    """left · A · right ≈ diag(1, …, 1, s), both exact and regular."""

    left: acb_mat
    right: acb_mat

    @staticmethod
    def of(A: acb_mat, near_root: bool = False, moves: acb_mat | None = None) -> Reduction:
        """The reduction for matrices near the midpoint of A; `PrecisionError` where float64 does not reach.

        near_root: treat A as nearly singular at any rate, so that s is a smooth function next to a root.
        moves: of what size A changes; a row that is 0 at the root is then not taken for small everywhere.
        """
        middle = _floats(A)
        if not np.isfinite(middle).all():
            raise PrecisionError("the characteristic matrix is out of float64's range here")
        size = np.abs(middle) + (0 if moves is None else np.abs(_floats(moves)))
        try:
            left, right = _regular(middle) if not near_root and _is_regular(middle) else _bordered(middle, size)
        except np.linalg.LinAlgError:
            raise PrecisionError("the characteristic matrix has a kernel of more than one dimension here") from None
        if not np.isfinite(left).all():
            raise PrecisionError("the characteristic matrix is out of float64's range here")
        return Reduction(_exact(left), _exact(right))

    @cached_property
    def one_sided(self) -> bool:
        """Whether right is the identity: left · A is near it."""
        n = self.right.nrows()
        return all(x == int(k // n == k % n) for k, x in enumerate(self.right.entries()))

    @cached_property
    def factor(self) -> acb:
        """1/det(left · right), at the precision at which it is first asked for."""
        return 1 / (self.left.det() if self.one_sided else self.left.det() * self.right.det())

    def _blocks(self, A: Any) -> tuple[acb_mat, acb_mat, acb_mat, acb]:
        B = self.left * A * self.right
        n = B.nrows() - 1
        first = acb_mat(n, n, [B[i, j] for i in range(n) for j in range(n)])
        return first, acb_mat(n, 1, [B[i, n] for i in range(n)]), acb_mat(1, n, [B[n, j] for j in range(n)]), B[n, n]

    def scalar(self, A: acb_mat) -> acb:
        """s(A): 0 exactly where A is singular."""
        first, column, row, corner = self._blocks(A)
        return corner - _entry(row * _solved(first, column)) if first.nrows() else corner

    def scalar_slope(self, A: Any, A_slope: acb_mat) -> Any:
        """The derivative of s along A_slope."""
        first, column, row, _ = self._blocks(A)
        d_first, d_column, d_row, d_corner = self._blocks(A_slope)
        if not first.nrows():
            return d_corner
        x, y = _solved(first, column), _solved(first.transpose(), row.transpose()).transpose()
        return d_corner - _entry(d_row * x) - _entry(y * d_column) + _entry(y * d_first * x)

    def determinant(self, A: acb_mat, A_slope: acb_mat) -> tuple[acb, acb]:
        """det A and its derivative along A_slope."""
        if self.one_sided:
            near, slope = self.left * A, self.left * A_slope
            value = self.factor * _near_one(near)
            return value, value * _solved(near, slope).trace()
        first, column, row, corner = self._blocks(A)
        d_first, d_column, d_row, d_corner = self._blocks(A_slope)
        n = first.nrows()
        if not n:
            return self.factor * corner, self.factor * d_corner
        columns = [
            [x, y, *line]
            for x, y, line in zip(*(m.entries() for m in (column, d_column)), d_first.tolist(), strict=True)
        ]
        found = _solved(first, acb_mat(columns)).tolist()  # first⁻¹ times column, its slope, and the slope of first
        x, d_x = (acb_mat(n, 1, [line[k] for line in found]) for k in (0, 1))
        turned = acb_mat([line[2:] for line in found])
        s = corner - _entry(row * x)
        d_s = d_corner - _entry(d_row * x) - _entry(row * d_x) + _entry(row * (turned * x))
        size = self.factor * _near_one(first)
        return size * s, size * (d_s + s * turned.trace())

    def kernel(self, A: acb_mat) -> list[acb]:
        """A vector x ≠ 0 with A x = 0 for each singular matrix of the balls A."""
        if self.left.det().contains(0):
            raise PrecisionError("the characteristic matrix is too badly conditioned in float64 to show its kernel")
        first, column, _, _ = self._blocks(A)
        n = first.nrows()
        head = [-x for x in _solved(first, column).entries()] if n else []
        return list((self.right * acb_mat(n + 1, 1, [*head, acb(1)])).entries())


def _solved(a: Any, b: acb_mat) -> Any:
    try:
        return a.solve(b)
    except ZeroDivisionError:
        raise PrecisionError("the characteristic matrix is too wide here: split the piece") from None


def _near_one(a: Any) -> acb:
    """The determinant of a matrix near the identity, by elimination without exchange: no width beyond first order."""
    rows, value = a.tolist(), acb(1)
    for k, pivots in enumerate(rows):
        value *= pivots[k]
        if pivots[k].contains(0):
            raise PrecisionError("the characteristic matrix is too wide here: split the piece")
        for row in rows[k + 1 :]:
            factor = row[k] / pivots[k]
            for j in range(k + 1, len(rows)):
                row[j] -= factor * pivots[j]
    return value


def _entry(a: Any) -> Any:
    return a[0, 0]


def _exact(a: Any) -> acb_mat:
    n = len(a)
    return acb_mat(n, n, [exact_ball(complex(x)) for x in a.ravel()])


def _floats(A: acb_mat) -> Complexes:
    return np.array([[complex(x) for x in row] for row in A.tolist()])


def _equilibrated(a: Any, size: Any) -> tuple[Reals, Reals, Complexes]:
    """Powers of two r, c that bring the rows and columns of r · size · c near 1, and r a c."""
    r = np.exp2(-np.round(np.log2(np.maximum(size.max(1), 1e-300))))
    c = np.exp2(-np.round(np.log2(np.maximum((r[:, None] * size).max(0), 1e-300))))
    return r, c, r[:, None] * a * c


def _is_regular(a: Any) -> bool:
    sizes = np.linalg.svd(_equilibrated(a, np.abs(a))[2], compute_uv=False)
    return bool(sizes[-1] > _SINGULAR * sizes[0])


def _regular(a: Any) -> tuple[Any, Any]:
    return np.linalg.inv(a), np.eye(len(a), dtype=complex)


def _bordered(a: Any, size: Any) -> tuple[Any, Complexes]:
    """By the singular vectors of the least singular value."""
    r, c, even = _equilibrated(a, size)
    U, _, V = np.linalg.svd(even)
    v, u = V[-1].conj() * c, U[:, -1] / r
    j = int(np.argmax(np.abs(V[-1])))
    v, others = v / v[j], [k for k in range(len(a)) if k != j]
    right = np.eye(len(a), dtype=complex)[:, [*others, j]]
    right[:, -1] = v
    return np.linalg.inv(np.column_stack([a[:, others], u])), right


def det_and_trace(A: acb_mat, A_slope: acb_mat) -> tuple[acb, acb]:
    """det A and tr A⁻¹A′ = (det A)′/det A; not finite where FLINT finds A singular.

    With A = [[X, Y], [Z, W]], P = X⁻¹Y, Q = ZX⁻¹ and S = W − ZP: det A = det X · det S, so the trace is that of X⁻¹X′
    and of S⁻¹S′, S′ = W′ − QY′ − (Z′ − QX′)P.
    """
    try:
        if A.nrows() > _WHOLE:
            return _by_halves(A, A_slope)
    except ZeroDivisionError:  # of a half; the whole may be regular
        pass
    try:
        return A.det(), A.solve(A_slope).trace()
    except ZeroDivisionError:
        return acb("nan"), acb("nan")


def _by_halves(A: acb_mat, A_slope: acb_mat) -> tuple[acb, acb]:
    X, Y, Z, W = _quarters(A)
    X_, Y_, Z_, W_ = _quarters(A_slope)
    inverse = X.inv()
    P, Q = inverse * Y, Z * inverse
    S = W - Z * P
    turned = S.solve(W_ - Q * Y_ - (Z_ - Q * X_) * P)
    return X.det() * S.det(), (inverse * X_).trace() + turned.trace()


def _quarters(a: Any) -> list[acb_mat]:
    k, rows = a.nrows() // 2, a.tolist()
    sides = (slice(k), slice(k, None))
    return [acb_mat([row[side] for row in rows[part]]) for part in sides for side in sides]
