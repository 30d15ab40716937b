"""G(ξ, σ) = N/D in wavenumber, back in space: divided differences by companion matrices, one formula for all cases.

For monic A with roots z_1 … z_m (repeated or not) and f analytic there, e₁ᵀ f(C_A) e_m = Σ f(z_k)/A'(z_k). Hence
G(ξ ≥ 0) = e₁ᵀ e^{ξC_U} N(C_U) L(C_U)⁻¹ e_m / lead, and G(ξ < 0) = −(the same with U and L exchanged): finite where
roots of one side meet, and so are the slopes in σ of everything.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from mpsolve.characteristic.splitting import Splitting, sylvester
from mpsolve.characteristic.symbol import Symbols, horner, slope_in_P
from mpsolve.frozen import frozen
from mpsolve.numbers.arithmetic import Arithmetic


def companion(K: Arithmetic, coefficients: Sequence[Any]) -> Any:
    """The matrix whose characteristic polynomial is the monic one with these coefficients."""
    m, like = len(coefficients), coefficients[0] * 0
    rows = [[like + int(j == i + 1) for j in range(m)] for i in range(m - 1)]
    return K.matrix([*rows, [-c for c in coefficients]])


def at_matrix(K: Arithmetic, coefficients: Sequence[Any], C: Any, size: int) -> Any:
    """Σ c_i C^i."""
    like = coefficients[0] * 0
    total = K.matrix([[like] * size for _ in range(size)])
    one = K.matrix([[like + int(i == j) for j in range(size)] for i in range(size)])
    for c in reversed(coefficients):
        total = K.product(total, C) + K.times(one, c)
    return total


def residues(K: Arithmetic, A: Sequence[Any], B: Sequence[Any], F: Sequence[Any], xi: Sequence[Any]) -> list[Any]:
    """Σ over the roots z of A of e^{zξ} F(z)/(A'(z) B(z)) for each ξ; A, B monic without their leading 1."""
    m = len(A)
    if not m:
        return [F[0] * 0 for _ in xi]
    C, like = companion(K, A), A[0] * 0
    last = K.matrix([[like + int(i == m - 1)] for i in range(m)])
    over = at_matrix(K, [*B, like + 1], C, m)
    tail = K.solve(over, K.product(at_matrix(K, F, C, m), last))
    return [K.entry(tail if x == 0 else K.product(K.exp(K.times(C, like + x)), tail), 0, 0) for x in xi]


def two_sided(
    K: Arithmetic, U: Sequence[Any], L: Sequence[Any], F: Sequence[Any], xi: Sequence[Fraction]
) -> list[Any]:
    """The residues over U where ξ ≥ 0, minus those over L where ξ < 0; ξ exact rationals."""
    ahead, behind = ([x for x in xi if (x >= 0) is side] for side in (True, False))
    out = dict(zip(ahead, residues(K, U, L, F, [K.number(x) for x in ahead]), strict=True))
    out |= {x: -g for x, g in zip(behind, residues(K, L, U, F, [K.number(x) for x in behind]), strict=True)}
    return [out[x] for x in xi]


def by_companions(
    K: Arithmetic, symbols: Symbols, split: Splitting, sigma: Any, xi: Sequence[Fraction], slope: bool
) -> tuple[list[Any], list[Any]]:
    """G(ξ, σ) and, where asked, its slope in σ, for each exact ξ."""
    like = sigma * 0
    N = [(like + c) / split.lead for c in symbols.N.at(K, sigma)]
    if not slope:
        return two_sided(K, split.upper, split.lower, N, xi), []
    dU, dL, dN = _slopes(K, symbols, split, sigma, N)
    U, L = Dual([like + c for c in split.upper], dU), Dual([like + c for c in split.lower], dL)
    out: dict[Any, tuple[Any, Any]] = {}
    for one, other, sign in ((U, L, 1), (L, U, -1)):
        side = [x for x in xi if (x >= 0) is (sign > 0)]
        found = dual_residues(K, one, other, Dual(N, dN), [K.number(x) for x in side], like)
        out |= {x: (sign * g, sign * g_s) for x, (g, g_s) in zip(side, found, strict=True)}
    return [out[x][0] for x in xi], [out[x][1] for x in xi]


def _slopes(
    K: Arithmetic, symbols: Symbols, split: Splitting, sigma: Any, N: Sequence[Any]
) -> tuple[list[Any], list[Any], list[Any]]:
    """Slopes in σ of U, L and N/lead: (U·L)′ = (D/lead)′ is linear in those of U and L."""
    like, n = sigma * 0, symbols.degree
    D = [(like + c) / split.lead for c in symbols.D.at(K, sigma)]
    D_s = [(like + c) / split.lead for c in symbols.D_sigma.at(K, sigma)]
    D_s += [like] * (n + 1 - len(D_s))
    grown = D_s[n]
    rest = [[a - b * grown] for a, b in zip(D_s[:n], D[:n], strict=True)]
    rows = [[like + x for x in row] for row in sylvester(split.upper, split.lower)]
    moved = K.solve(K.matrix(rows), K.matrix(rest))
    out = [K.entry(moved, i, 0) for i in range(n)]
    N_s = [(like + c) / split.lead for c in symbols.N_sigma.at(K, sigma)]
    N_s += [like] * (len(N) - len(N_s))
    m = len(split.upper)
    return out[:m], out[m:], [a - b * grown for a, b in zip(N_s, N, strict=True)]


@frozen
class Dual:
    """Coefficients of a polynomial in P, and their slopes in σ; a monic one stands without its leading 1."""

    value: list[Any]
    slope: list[Any]


def dual_residues(K: Arithmetic, A: Dual, B: Dual, F: Dual, xi: Sequence[Any], like: Any) -> list[tuple[Any, Any]]:
    """`residues` and their slopes: of block matrices [[C, C′], [0, C]] every function has its slope beside it."""
    m = len(A.value)
    if not m:
        return [(like, like) for _ in xi]
    shift = [[like + int(j == i + 1) for j in range(m)] for i in range(m - 1)]
    rows = [[*shift[i], *[like] * m] for i in range(m - 1)]
    rows += [[*(-c for c in A.value), *(-c for c in A.slope)]]
    rows += [[*[like] * m, *shift[i]] for i in range(m - 1)]
    rows += [[*[like] * m, *(-c for c in A.value)]]
    C = K.matrix(rows)
    last = K.matrix([[like + int(i == 2 * m - 1)] for i in range(2 * m)])
    over = _at_dual(K, [*B.value, like + 1], [*B.slope, like], C, m)
    tail = K.solve(over, K.product(_at_dual(K, F.value, F.slope, C, m), last))
    out = []
    for x in xi:
        moved = tail if (x == 0) is True else K.product(K.exp(K.times(C, like + x)), tail)
        out.append((K.entry(moved, m, 0), K.entry(moved, 0, 0)))
    return out


def _at_dual(K: Arithmetic, values: Sequence[Any], slopes: Sequence[Any], C: Any, m: int) -> Any:
    """Σ c_i C^i for dual coefficients."""
    like = values[0] * 0
    total: Any = None
    for c, d in zip(reversed(values), reversed(slopes), strict=True):
        term = [[like] * (2 * m) for _ in range(2 * m)]
        for i in range(m):
            term[i][i] = term[i + m][i + m] = c
            term[i][i + m] = d
        total = K.matrix(term) if total is None else K.product(total, C) + K.matrix(term)
    return total


@frozen
class Terms:
    """A simple p-root z gives G the term w e^{zξ}, and its slope in σ the term (a + bξ) e^{zξ}."""

    z: Any
    w: Any
    a: Any
    b: Any


@frozen
class Coefficients:
    """D, N, D_σ, N_σ as coefficients in P at one σ."""

    D: list[Any]
    N: list[Any]
    D_sigma: list[Any]
    N_sigma: list[Any]

    @cached_property
    def slopes(self) -> tuple[list[Any], ...]:
        """D_P, D_PP, N_P, D_σP."""
        D_P = slope_in_P(self.D)
        return D_P, slope_in_P(D_P), slope_in_P(self.N), slope_in_P(self.D_sigma)

    def terms(self, z: Any) -> Terms:
        """Residue at a simple root z of D of N e^{Pξ}/D, and of its derivative in σ, a double pole."""
        D_P, D_PP, N_P, D_sP = (horner(x, z) for x in self.slopes)
        N, D_s = horner(self.N, z), horner(self.D_sigma, z)
        over = 1 / D_P
        lost = N * D_s * over * over
        turn = (N_P * D_s + N * D_sP) * over * over
        return Terms(z, N * over, horner(self.N_sigma, z) * over - turn + lost * D_PP * over, -lost)
