"""Regular matrices over discs, solutions with them, and the change of the argument of their determinants: rigorous.

For A over a disc and any float matrix R: if |R A − I| x ≤ θ x with x > 0 and θ < 1, then R A is an H-matrix, so
det A ≠ 0; its pivots without exchange keep |pivot − 1| ≤ θ, and arg det A changes between two points of the disc by
the difference of Σ Arg(pivots of R A) there (SPEC, pieces).

Why: in the norm max |y_i|/x_i, I + E with |E| ≤ θ. Let E₁₁ be a leading block and α, β the sums of moduli of a later
row over it and beyond it, α + β ≤ θ. Each row of E₁₁ and E₁₂ has sums θ₁ + θ₂ ≤ θ, so |(I + E₁₁)⁻¹E₁₂| ≤ (θ − θ₁)/
(1 − θ₁) ≤ θ, and the row's Schur complement differs from that of I by at most β + αθ ≤ θ.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.numbers.jets import TINY, UP, Jet, U

THETA = 0.97
"""Below 1 by a margin, so that a checker that rounds otherwise agrees."""
_PIVOTS = 0.99
"""The most that θ + φ may be in `pivot_arguments`."""


@frozen
class Regular:
    """For each disc the preconditioner R, the vector x, θ; `good` where |R A − I| x ≤ θ x, θ < THETA, is proved."""

    R: Any
    x: Any
    theta: Any
    good: Any


def regular(A: Jet) -> Regular:
    """The test for matrices A of shape (discs, n, n)."""
    n = A.a.shape[1]
    with np.errstate(all="ignore"):
        finite = np.isfinite(A.a).all((1, 2)) & np.isfinite(A.e).all((1, 2)) & np.isfinite(A.b).all((1, 2))
        middle = np.where(finite[:, None, None], A.a, np.eye(n))
        try:
            R = np.linalg.inv(middle)
        except np.linalg.LinAlgError:  # one of them is singular: each by itself
            R = np.stack([_inverse(a) for a in middle])
        size = np.abs(R)
        lost = 16 * (n + 4) * U
        r = A.r[:, None, None]
        E = np.abs(R @ middle - np.eye(n)) + lost * (size @ np.abs(middle) + 1)
        E = E + np.abs(R @ A.b) * r + size @ (A.e + lost * np.abs(A.b) * r)
        E = E * UP
        x, theta = weighed(E)
        return Regular(R, x, theta, finite & (theta < THETA))


def weighed(E: Reals, rounds: int = 12) -> tuple[Reals, Reals]:
    """(x > 0 for which θ is nearly the least, θ with E x ≤ θ x) of matrices E ≥ 0."""
    kept = E + 0.02 * np.eye(E.shape[1])  # no floor: each component has a unit of its own
    x = np.ones((*E.shape[:2], 1))
    for _ in range(rounds):
        x = kept @ x
    x = (x / x.max(1, keepdims=True))[:, :, 0]
    return x, np.max(np.einsum("bij,bj->bi", E, x) / x, axis=1) * UP


def _inverse(a: Any) -> Any:
    try:
        return np.linalg.inv(a)
    except np.linalg.LinAlgError:
        return np.eye(len(a))


def pivot_arguments(piece: Regular, A: Jet) -> tuple[Reals, Reals, Truths]:
    """(Σ Arg pivots of R A, a bound of its error, where it is bounded) at a thin point of each disc.

    The pivots in floats are those of M + F, M = R A and |F| x ≤ φ x (rounding of the product and backward error of
    the elimination). Along M + t F a pivot has the derivative (−m M₁₁⁻¹, 1) F (−M₁₁⁻¹ m′, 1)ᵀ, at most φ/(1 − θ′),
    θ′ = θ + φ, and a modulus of at least 1 − θ′: its argument changes by at most φ/(1 − θ′)².
    """
    n = A.a.shape[1]
    with np.errstate(all="ignore"):
        lu = piece.R @ A.a
        for k in range(n - 1):
            factor = lu[:, k + 1 :, k] / lu[:, k, k][:, None]
            lu[:, k + 1 :, k + 1 :] -= factor[:, :, None] * lu[:, None, k, k + 1 :]
            lu[:, k + 1 :, k] = factor
        size = np.abs(piece.R)
        lower = np.tril(np.abs(lu), -1) + np.eye(n)
        radius = A.e + np.abs(A.b) * A.r[:, None, None]
        P = size @ radius + 16 * (n + 4) * U * (size @ np.abs(A.a) + lower @ np.triu(np.abs(lu)))
        phi = np.max(np.einsum("bij,bj->bi", P * UP, piece.x) / piece.x, axis=1) * UP
        total = np.angle(np.diagonal(lu, axis1=1, axis2=2)).sum(1)
        wide = (piece.theta + phi) * UP
        good = piece.good & (wide < _PIVOTS) & np.isfinite(total)
        least = 1 - np.minimum(wide, _PIVOTS)  # of the moduli of pivots
        return total, n * (phi / (least * least) * (1 + 8 * U) + (16 + 2 * n) * U) * UP, good


def solution(A: Jet, f: Jet) -> tuple[Jet, Truths]:
    """(y with A y = f as jets of shape (discs, n, 1), where A is proved regular).

    With R A = I + E, |E| x ≤ θ x, and y = y₀ + y₁ t any approximation whose residual f − A y is at most ρ: the error
    is (I + E)⁻¹ R (f − A y), at most |R| ρ + θ c x with c = max (|R| ρ)_i / ((1 − θ) x_i).
    """
    found = regular(A)
    with np.errstate(all="ignore"):
        r = A.r[:, None, None]
        y0 = found.R @ f.a
        y1 = found.R @ (f.b - A.b @ y0)
        n = A.a.shape[1]
        lost = 16 * (n + 4) * U
        a0, a1, s0, s1 = np.abs(A.a), np.abs(A.b) * r, np.abs(y0), np.abs(y1) * r
        rest = np.abs(f.a - A.a @ y0) + np.abs(f.b - A.b @ y0 - A.a @ y1) * r + np.abs(A.b @ y1) * r * r
        rest = rest + f.e + A.e @ (s0 + s1) + lost * ((a0 + a1) @ (s0 + s1) + np.abs(f.a) + np.abs(f.b) * r)
        moved = np.abs(found.R) @ (rest * UP + TINY) * UP
        x, theta = found.x[:, :, None], found.theta[:, None, None]
        c = (moved / x).max(1, keepdims=True) / (1 - theta)
        e = (moved + theta * c * x) * (UP + 64 * U)
    return Jet(y0, y1, e, A.r), found.good
