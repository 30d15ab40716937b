"""det A and tr A⁻¹A′ of matrices of balls from one elimination, of the leading half."""

from __future__ import annotations

from typing import Any

from mpsolve.numbers.balls import acb, acb_mat

_WHOLE = 5
"""Matrices up to this size are not worth halving."""


def det_and_trace(A: Any, A_slope: Any) -> tuple[Any, Any]:
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


def _by_halves(A: Any, A_slope: Any) -> tuple[Any, Any]:
    X, Y, Z, W = _quarters(A)
    X_, Y_, Z_, W_ = _quarters(A_slope)
    inverse = X.inv()
    P, Q = inverse * Y, Z * inverse
    S = W - Z * P
    turned = S.solve(W_ - Q * Y_ - (Z_ - Q * X_) * P)
    return X.det() * S.det(), (inverse * X_).trace() + turned.trace()


def _quarters(a: Any) -> list[Any]:
    k, rows = a.nrows() // 2, a.tolist()
    sides = (slice(k), slice(k, None))
    return [acb_mat([row[side] for row in rows[part]]) for part in sides for side in sides]
