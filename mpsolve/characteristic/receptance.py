"""G(ξ, σ) = N/D in wavenumber, back in space: divided differences by companion matrices, one formula for all cases.

For monic A with roots z_1 … z_m (repeated or not) and f analytic there, e₁ᵀ f(C_A) e_m = Σ f(z_k)/A'(z_k). Hence
G(ξ ≥ 0) = e₁ᵀ e^{ξC_U} N(C_U) L(C_U)⁻¹ e_m / lead, and G(ξ < 0) = −(the same with U and L exchanged): finite where
roots of one side meet. The slope in σ is the same functional of F = N_σ D − N D_σ over (U², L²).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from mpsolve.characteristic.splitting import Splitting
from mpsolve.characteristic.symbol import Symbols, horner, product, slope_in_P
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


def two_sided(K: Arithmetic, U: Sequence[Any], L: Sequence[Any], F: Sequence[Any], xi: Sequence[Any]) -> list[Any]:
    """The residues over U where ξ ≥ 0, minus those over L where ξ < 0; ξ exact rationals."""
    ahead, behind = ([x for x in xi if (x >= 0) is side] for side in (True, False))
    out = dict(zip(ahead, residues(K, U, L, F, [K.number(x) for x in ahead]), strict=True))
    out |= {x: -g for x, g in zip(behind, residues(K, L, U, F, [K.number(x) for x in behind]), strict=True)}
    return [out[x] for x in xi]


def by_companions(
    K: Arithmetic, symbols: Symbols, split: Splitting, sigma: Any, xi: Sequence[Any], slope: bool
) -> tuple[list[Any], list[Any]]:
    """G(ξ, σ) and, where asked, its slope in σ, for each exact ξ."""
    like = sigma * 0
    N = [(like + c) / split.lead for c in symbols.N.at(K, sigma)]
    G = two_sided(K, split.upper, split.lower, N, xi)
    if not slope:
        return G, []
    F = [(like + c) / split.lead**2 for c in symbols.F.at(K, sigma)]
    U2, L2 = (product([*a, 1], [*a, 1])[:-1] for a in (split.upper, split.lower))
    return G, two_sided(K, U2, L2, F, xi)


@dataclass(frozen=True)
class Terms:
    """A simple p-root z gives G the term w e^{zξ}, and its slope in σ the term (a + bξ) e^{zξ}."""

    z: Any
    w: Any
    a: Any
    b: Any


@dataclass(frozen=True)
class Coefficients:
    """D, N, D_σ, N_σ as coefficients in P at one σ."""

    D: list[Any]
    N: list[Any]
    D_sigma: list[Any]
    N_sigma: list[Any]

    def terms(self, z: Any) -> Terms:
        """Residue at a simple root z of D of N e^{Pξ}/D, and of its derivative in σ, a double pole."""
        D_P, N, D_s = slope_in_P(self.D), horner(self.N, z), horner(self.D_sigma, z)
        over = 1 / horner(D_P, z)
        lost = N * D_s * over * over
        bend = horner(slope_in_P(D_P), z) * over
        turn = (horner(slope_in_P(self.N), z) * D_s + N * horner(slope_in_P(self.D_sigma), z)) * over * over
        return Terms(z, N * over, horner(self.N_sigma, z) * over - turn + lost * bend, -lost)
