"""det A and tr A⁻¹A′ of matrices of balls from one elimination, of the leading half."""

from __future__ import annotations

from typing import Any

from mpsolve.numbers.balls import acb, acb_mat

_WHOLE = 5
"""Matrices up to this size are not worth halving."""


def det_and_trace(A: Any, A_slope: Any) -> tuple[Any, Any]:
    """det A and tr A⁻¹A′ = (det A)′/det A; not finite where FLINT finds A singular.

    With A = [[X, Y], [Z, W]] and A′ in the same rows, S = W − Z X⁻¹Y: det A = det X det S, and the rows of A⁻¹A′ are
    X⁻¹A′₁ − X⁻¹Y V and V = S⁻¹(A′₂ − Z X⁻¹A′₁).
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


def _by_halves(A: Any, A_slope: Any) -> tuple[Any, Any]:
    n, k = A.nrows(), A.nrows() // 2
    rows, slopes = A.tolist(), A_slope.tolist()
    X, Z = (acb_mat([r[:k] for r in part]) for part in (rows[:k], rows[k:]))
    above, below = ([r[k:] + d for r, d in zip(rows[p], slopes[p], strict=True)] for p in (slice(k), slice(k, n)))
    first = X.solve(acb_mat(above))
    second, first = (acb_mat(below) - Z * first).tolist(), first.tolist()
    S, right = acb_mat([r[: n - k] for r in second]), acb_mat([r[n - k :] for r in second])
    V = S.solve(right).tolist()
    trace = sum((V[i][k + i] for i in range(n - k)), acb(0)) + sum((first[i][n - k + i] for i in range(k)), acb(0))
    return X.det() * S.det(), trace - (acb_mat([r[: n - k] for r in first]) * acb_mat([r[:k] for r in V])).trace()
