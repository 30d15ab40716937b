"""Symbolic residue forms of the kernel K(xi, q), each computed from the one before: (37)-(39).

Every function returns an equation (or a tuple of them) that holds identically in its symbols. The roots of
D(p, q) in p are p_1, p_2 above the real axis and p_3, p_4 below; C_j = 1/D_{,p}(p_j).
"""

from __future__ import annotations

import sympy as sp

from mpsolve.derivation.step import Expr

I = sp.I  # noqa: E741
p, xi = sp.symbols("p xi", real=True)
q, r = sp.symbols("q r")
alpha, beta = sp.symbols("alpha beta", positive=True)
roots = sp.symbols("p_1:5")
K = sp.Function("K")
K_q = sp.Function("K_q")
D = sp.Function("D")

UPPER, LOWER = (0, 1), (2, 3)


def simple_residue(expression: Expr, pole: Expr) -> Expr:
    """Residue at a simple pole whose factor 1/(p - pole) stands in `expression` explicitly."""
    return (expression * (p - pole)).subs(p, pole)


def partial_fractions() -> Expr:
    """1/D = sum C_j/(p - p_j) over the four simple roots of the monic quartic D, C_j = 1/D_{,p}(p_j)."""
    inverse = 1 / sp.prod(p - root for root in roots)
    return sp.Eq(inverse, sum(simple_residue(inverse, root) / (p - root) for root in roots))


def weights_sum() -> Expr:
    """Sum of the C_j over all four roots is 0, since 1/D falls off as p^-4; so K(0) has two residue forms."""
    terms = [simple_residue(partial_fractions().lhs, root) for root in roots]
    return sp.Eq(sum(terms, sp.S(0)), sp.cancel(sp.together(sum(terms))), evaluate=False)


def kernel_residues(half: tuple[int, int]) -> Expr:
    """(37): K(xi) by residues of e^{ip xi}/D, closed above (xi >= 0) or below (xi < 0, sign reversed)."""
    sign = 1 if half == UPPER else -1
    integrand = sp.exp(I * p * xi) * partial_fractions().lhs
    return sp.Eq(K(xi, q), sign * 2 * sp.pi * I * sum(simple_residue(integrand, roots[j]) for j in half))


def kernel_derivative_integral(kernel: Expr) -> Expr:
    """(38): the integral (21) differentiated by q under the integral sign."""
    return sp.Eq(K_q(xi, q), kernel.rhs.diff(q))


def double_pole(integrand: Expr, pole: Expr) -> Expr:
    """(39): residue of n/h at a double zero of h, in the values there of n, n_{,p}, h_{,pp} and h_{,ppp}.

    With h = (p - pole)^2 m(p) the residue is (n/m)_{,p}; m and m_{,p} are eliminated for h's derivatives.
    """
    m = sp.Function("m")(p)
    h = (p - pole) ** 2 * m
    unknowns = m.subs(p, pole), m.diff(p).subs(p, pole)
    values = sp.solve(
        [sp.Function("h_pp")(pole) - h.diff(p, 2).subs(p, pole).doit(),
         sp.Function("h_ppp")(pole) - h.diff(p, 3).subs(p, pole).doit()],
        unknowns, dict=True,
    )[0]  # fmt: skip
    return (integrand / m).diff(p).subs(p, pole).subs(values)


def kernel_derivative_print() -> Expr:
    """(39) as corrected: the integrand of (38) by `double_pole`, h = D^2, at the two upper roots."""
    numerator = -sp.Function("D_q")(p) * sp.exp(I * p * xi)
    return sp.Eq(K_q(xi, q), 2 * sp.pi * I * sum(double_pole(numerator, roots[j]) for j in UPPER))


def kernel_derivative(printed: Expr) -> Expr:
    """K_{,q} over simple roots: h = D^2 put into (39), so h_{,pp} = 2 D_p^2 and h_{,ppp} = 6 D_p D_pp."""
    square, result = D(p) ** 2, printed.rhs
    for j in UPPER:
        first, second = sp.Function("D_p")(roots[j]), sp.Function("D_pp")(roots[j])
        for order, name in ((2, "h_pp"), (3, "h_ppp")):
            value = square.diff(p, order).subs({D(p).diff(p, 2): second}).subs({D(p).diff(p): first})
            result = result.subs(sp.Function(name)(roots[j]), value.subs(D(p), 0))
    return sp.Eq(printed.lhs, result)
