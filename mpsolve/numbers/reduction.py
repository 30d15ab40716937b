"""Tight determinants of matrices of balls, also where they are singular: everything is reduced to one scalar.

An LU decomposition in float64 of the midpoint, P A Q ≈ L U, whose last pivot is left out of U, gives exact matrices
left = L⁻¹P and right = Q U⁻¹ with left · A · right ≈ diag(1, …, 1, s): its first block is regular and near the
identity, so det A = 0 exactly where the scalar s = b_nn − b_n B⁻¹ b^n is 0, and s loses no width to the others.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_mat, exact_ball


@dataclass(frozen=True)
class Reduction:
    """left · A · right ≈ diag(1, …, 1, s); factor = 1/det(left · right), exact but for the rounding of its balls."""

    left: Any
    right: Any
    factor: Any

    @staticmethod
    def of(A: Any) -> Reduction:
        """The reduction for matrices near the midpoint of A; `PrecisionError` where float64 does not reach."""
        n = A.nrows()
        middle = np.array([[complex(A[i, j]) for j in range(n)] for i in range(n)])
        if not np.isfinite(middle).all():
            raise PrecisionError("the characteristic matrix is out of float64's range here")
        L, U, rows, columns = _full_pivoting(middle)
        U[-1, -1] = 1
        left, right = np.zeros_like(L), np.zeros_like(U)
        lower, upper = np.linalg.inv(L), np.linalg.inv(U)
        left[:, rows], right[columns, :] = np.tril(lower, -1) + np.eye(n), np.triu(upper)
        factor = acb(_parity(rows) * _parity(columns))
        for x in np.diag(upper):
            factor = factor / exact_ball(complex(x))
        return Reduction(_exact(left), _exact(right), factor)

    def _blocks(self, A: Any) -> tuple[Any, Any, Any, Any]:
        B = self.left * A * self.right
        n = B.nrows() - 1
        first = acb_mat(n, n, [B[i, j] for i in range(n) for j in range(n)])
        return first, acb_mat(n, 1, [B[i, n] for i in range(n)]), acb_mat(1, n, [B[n, j] for j in range(n)]), B[n, n]

    def scalar(self, A: Any) -> Any:
        """s(A): 0 exactly where A is singular."""
        first, column, row, corner = self._blocks(A)
        return corner - _entry(row * _solved(first, column)) if first.nrows() else corner

    def scalar_slope(self, A: Any, A_slope: Any) -> Any:
        """The derivative of s along A_slope."""
        first, column, row, _ = self._blocks(A)
        d_first, d_column, d_row, d_corner = self._blocks(A_slope)
        if not first.nrows():
            return d_corner
        x, y = _solved(first, column), _solved(first.transpose(), row.transpose()).transpose()
        return d_corner - _entry(d_row * x) - _entry(y * d_column) + _entry(y * d_first * x)

    def determinant(self, A: Any, A_slope: Any) -> tuple[Any, Any]:
        """det A and its derivative along A_slope."""
        first = self._blocks(A)[0]
        s, d_s = self.scalar(A), self.scalar_slope(A, A_slope)
        if not first.nrows():
            return self.factor * s, self.factor * d_s
        size = self.factor * first.det()
        turn = _solved(first, self._blocks(A_slope)[0]).trace()
        return size * s, size * (d_s + s * turn)

    def kernel(self, A: Any) -> list[Any]:
        """A vector x ≠ 0 with A x = 0 for each singular matrix of the balls A."""
        first, column, _, _ = self._blocks(A)
        n = first.nrows()
        head = [-x for x in _solved(first, column).entries()] if n else []
        return list((self.right * acb_mat(n + 1, 1, [*head, acb(1)])).entries())


def _solved(a: Any, b: Any) -> Any:
    try:
        return a.solve(b)
    except ZeroDivisionError:
        raise PrecisionError("the characteristic matrix is too wide here: split the piece") from None


def _entry(a: Any) -> Any:
    return a[0, 0]


def _exact(a: Any) -> Any:
    n = len(a)
    return acb_mat(n, n, [exact_ball(complex(x)) for x in a.ravel()])


def _parity(order: list[int]) -> int:
    """The sign of a permutation."""
    seen, sign = set(), 1
    for k in range(len(order)):
        while k not in seen:
            seen.add(k)
            k = order[k]
            sign = sign if k in seen else -sign
    return sign


def _full_pivoting(a: Any) -> tuple[Any, Any, list[int], list[int]]:
    """L, U, row and column order with a[rows][:, columns] = L U; the last pivot may be 0."""
    n = len(a)
    U, L = a.copy(), np.eye(n, dtype=complex)
    rows, columns = list(range(n)), list(range(n))
    for k in range(n - 1):
        i, j = divmod(int(np.argmax(np.abs(U[k:, k:]))), n - k)
        i, j = i + k, j + k
        if U[i, j] == 0:
            raise PrecisionError("the characteristic matrix has a kernel of more than one dimension in float64")
        U[[k, i]] = U[[i, k]]
        U[:, [k, j]] = U[:, [j, k]]
        L[[k, i], :k] = L[[i, k], :k]
        rows[k], rows[i] = rows[i], rows[k]
        columns[k], columns[j] = columns[j], columns[k]
        L[k + 1 :, k] = U[k + 1 :, k] / U[k, k]
        U[k + 1 :] -= np.outer(L[k + 1 :, k], U[k])
        U[k + 1 :, k] = 0
    return L, U, rows, columns
