"""The solution of a linear system over discs, as a jet: rigorous, batched in float64.

With R A = I + E, |E| x ≤ θ x, and y = y₀ + y₁ t any approximation whose residual f − A y is at most ρ: the error is
(I + E)⁻¹ R (f − A y), at most |R| ρ + θ c x with c = max (|R| ρ)_i / ((1 − θ) x_i).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.jets import TINY, UP, Jet, U
from mpsolve.proof.turning import regular


def solution(A: Jet, f: Jet) -> tuple[Jet, Any]:
    """(y with A y = f as jets of shape (discs, n, 1), where A is proved regular)."""
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
