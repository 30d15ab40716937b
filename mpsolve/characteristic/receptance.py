"""G(ξ, σ) = N/D in wavenumber, back in space: divided differences by companion matrices, one formula for all cases.

For monic A with roots z_1 … z_m (repeated or not) and f analytic there, e₁ᵀ f(C_A) e_m = Σ f(z_k)/A'(z_k). Hence
G(ξ ≥ 0) = e₁ᵀ e^{ξC_U} N(C_U) L(C_U)⁻¹ e_m / lead, and G(ξ < 0) = −(the same with U and L exchanged): finite where
roots of one side meet, and so are the slopes in σ of everything.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from mpsolve.characteristic.splitting import Splitting, sylvester
from mpsolve.characteristic.symbol import Coefficients
from mpsolve.numbers.arithmetic import Arithmetic

Orders = Sequence[Sequence[Any]]
"""Coefficients of a polynomial in P and, where slopes are asked for, theirs in σ; of a monic one without its 1."""


def companion(K: Arithmetic, A: Orders) -> Any:
    """The matrix C whose characteristic polynomial is the monic one with these coefficients.

    With slopes it is [[C, C′], [0, C]]: every function of it has its slope beside its value.
    """
    m, like = len(A[0]), A[0][0] * 0
    shift = [[like + int(j == i + 1) for j in range(m)] for i in range(m - 1)]
    still = [[like] * m for _ in range(m - 1)]
    return _blocks(K, [[*(still if k else shift), [-c for c in a]] for k, a in enumerate(A)])


def _blocks(K: Arithmetic, parts: Sequence[Orders]) -> Any:
    """[[A, A′], [0, A]] from A and A′."""
    nothing = [[x * 0 for x in row] for row in parts[0]]
    n = len(parts)
    rows = [[parts[j - i] if j >= i else nothing for j in range(n)] for i in range(n)]
    return K.matrix([[x for part in row for x in part[i]] for row in rows for i in range(len(nothing))])


def at_matrix(K: Arithmetic, polynomial: Orders, C: Any, size: int) -> Any:
    """Σ c_i C^i; size: of C, without slopes."""
    total: Any = None
    for orders in reversed(list(zip(*polynomial, strict=True))):
        zero = orders[0] * 0
        one = _blocks(K, [[[c if i == j else zero for j in range(size)] for i in range(size)] for c in orders])
        total = one if total is None else K.product(total, C) + one
    return total


def residues(K: Arithmetic, A: Orders, B: Orders, F: Orders, xi: Sequence[Any]) -> list[tuple[Any, ...]]:
    """Σ over the roots z of A of e^{zξ} F(z)/(A'(z) B(z)) for each ξ, and its slope where those are given."""
    n, m, like = len(A), len(A[0]), F[0][0] * 0
    if not m:
        return [(like,) * n for _ in xi]
    C = companion(K, A)
    last = K.matrix([[like + int(i == n * m - 1)] for i in range(n * m)])
    over = at_matrix(K, [[*b, like + int(not k)] for k, b in enumerate(B)], C, m)
    tail = K.solve(over, K.product(at_matrix(K, F, C, m), last))
    moved = (tail if (x == 0) is True else K.product(K.exp(K.times(C, like + x)), tail) for x in xi)
    return [tuple(K.entry(one, k * m, 0) for k in reversed(range(n))) for one in moved]


def by_companions(
    K: Arithmetic, local: Coefficients, split: Splitting, xi: Sequence[Any], ahead: Sequence[bool], slope: bool
) -> tuple[list[Any], list[Any]]:
    """G(ξ, σ) and its slope in σ where asked: the residues over U where ξ is ahead, minus those over L elsewhere."""
    U, L, N = ([part] for part in (split.upper, split.lower, [c / split.lead for c in local.N]))
    if slope:
        for part, own in zip((U, L, N), _slopes(K, local, split), strict=True):
            part.append(own)
    found: dict[int, list[Any]] = {}
    for one, other, side in ((U, L, True), (L, U, False)):
        some = [k for k, first in enumerate(ahead) if first is side]
        for k, values in zip(some, residues(K, one, other, N, [xi[k] for k in some]), strict=True):
            found[k] = [g if side else -g for g in values]
    rows = [found[k] for k in range(len(xi))]
    return [row[0] for row in rows], [row[1] for row in rows] if slope else []


def _slopes(K: Arithmetic, local: Coefficients, split: Splitting) -> tuple[list[Any], list[Any], list[Any]]:
    """Slopes in σ of U, L and N/lead: (U·L)′ = (D/lead)′ is linear in those of U and L."""
    like, n, m = local.D[0] * 0, len(local.D) - 1, len(split.upper)
    D, D_s, N, N_s = ([c / split.lead for c in part] for part in (local.D, local.D_sigma, local.N, local.N_sigma))
    D_s += [like] * (n + 1 - len(D_s))
    N_s += [like] * (len(N) - len(N_s))
    grown = D_s[n]
    rest = [[a - b * grown] for a, b in zip(D_s[:n], D[:n], strict=True)]
    rows = [[like + x for x in row] for row in sylvester(split.upper, split.lower)]
    moved = K.solve(K.matrix(rows), K.matrix(rest))
    out = [K.entry(moved, i, 0) for i in range(n)]
    return out[:m], out[m:], [a - b * grown for a, b in zip(N_s, N, strict=True)]
