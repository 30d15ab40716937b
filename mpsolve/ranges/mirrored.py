"""Real roots in boxes that touch q = 0, of one of the two kinds each: those at q = 0 itself, and pairs beside it.

Such a box is taken with its mirror image, −b ≤ q ≤ b. Roots q, −q̄ go together: the reduced determinant s, by real
matrices, has s(−q) = conj s(q), so that on the real box Re s is even and Im s odd in q. Real roots with q = 0 are the
zeros of Re s there, a function of the parameters alone; those with q ≠ 0 are the common zeros of

    A = Re s,    B = Im s/u₀,

which are analytic across u₀ = 0 and even: where pairs ±q come to q = 0 the curve on which they are real ends on a
line of divergences. Of a Taylor model of s on complex |u_i| ≤ 1 with the rest e, both have models,

    A = Re(k + Σ b_j u_j + c_00 u₀² + Σ c_ij u_i u_j),    B = Im(b₀ + Σ c_0j u_j)      (i, j > 0),

each with a rest of e: with s*(u) the function with conjugate coefficients, A and iu₀B are (s ± s*)/2, the rests of
which are at most e, and dividing by u₀ changes no bound on |u₀| = 1, hence none within (maximum modulus). So A + iλB
is a function of the kind of s, with a rest of (1 + λ)e; λ > 0 brings the slopes of both to one size.
"""

from __future__ import annotations

import numpy as np

from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic, pairs


def beside_zero(s: Quadratic) -> Quadratic:
    """A + iλB: its real zeros are the real roots with q ≠ 0, and where these come to q = 0. s: mirrored, real."""
    k = np.zeros_like(s.k)
    k[0] = s.k[0].real + 1j * s.k[1].imag
    for n, (i, j) in enumerate(pairs(s.m), 1 + s.m):
        if i:
            k[n] = s.k[n].real
        elif j:
            k[1 + j] = s.k[1 + j].real + 1j * s.k[n].imag
        else:
            k[n] = s.k[n].real
    own, other = (np.abs(part[1 : 1 + s.m]).max(0) for part in (k.real, k.imag))
    other = np.where(other > 0, other, np.abs(k[0].imag))
    with np.errstate(all="ignore"):
        ratio = np.where((own > 0) & (other > 0), own / other, 1.0)
        times = np.exp2(np.round(np.log2(np.where(np.isfinite(ratio), ratio, 1.0))))
        k = k.real + 1j * (k.imag * times)
        return Quadratic(k, ((1 + times) * s.e + 8 * U * np.abs(k).sum(0)) * UP + TINY, s.m)


def at_zero(s: Quadratic) -> Quadratic:
    """A at u₀ = 0 plus i times a multiple of u₀: its real zeros are the roots with q = 0."""
    k = np.zeros_like(s.k)
    for n, pair in enumerate([(), *((j,) for j in range(s.m)), *pairs(s.m)]):
        if 0 not in pair:
            k[n] = s.k[n].real
    k[1] = 1j * np.maximum(np.abs(k[1 : 1 + s.m]).max(0), TINY)
    return Quadratic(k, (s.e + 8 * U * np.abs(k).sum(0)) * UP + TINY, s.m)
