"""Symbolic residue forms of the kernel K(xi, q), each computed from the one before: (37)-(39) and the cubic.

Every function returns an equation (or a tuple of them) that holds identically in its symbols. The roots of
D(p, q) in p are p_1, p_2 above the real axis and p_3, p_4 below; C_j = 1/D_{,p}(p_j).
c_2, c_1, c_0 are the coefficients of D in r = q - i eta_b: D = p^4 + c_2 p^2 + c_1 p + c_0.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import sympy as sp

Expr: TypeAlias = Any

I = sp.I  # noqa: E741
p, xi = sp.symbols("p xi", real=True)
q, r, d = sp.Symbol("q"), sp.Symbol("r"), sp.Symbol("d", positive=True)
alpha, beta = sp.symbols("alpha beta", positive=True)
A, sigma = sp.Symbol("A", real=True), sp.Symbol("sigma")
s, y, t, t_lower, R, delta, delta_lower = sp.symbols("s y t t' R delta delta'")
c0, c1, c2 = sp.symbols("c_0 c_1 c_2")
roots = sp.symbols("p_1:5")
weights = sp.symbols("C_1:5", cls=sp.Function)
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


def factors() -> tuple[Expr, Expr]:
    """D = U L without a cubic term: U = p^2 - s p + t (upper roots), L = p^2 + s p + t' (lower roots)."""
    return p**2 - s * p + t, p**2 + s * p + t_lower


def factor_conditions() -> tuple[Expr, Expr]:
    """t + t' and t - t' from the p^2 and p^1 coefficients of U L = p^4 + c_2 p^2 + c_1 p + c_0, y = s^2."""
    U, L = factors()
    product = sp.Poly(sp.expand(U * L), p).all_coeffs()
    solved = sp.solve([product[2] - c2, product[3] - c1], [t, t_lower], dict=True)[0]
    total, difference = sp.expand(solved[t] + solved[t_lower]), sp.expand(solved[t] - solved[t_lower])
    return sp.Eq(t + t_lower, total.subs(s**2, y)), sp.Eq(t - t_lower, difference)


def resolvent_cubic() -> Expr:
    """g(y) = 0: the p^0 coefficient, 4 t t' = (t + t')^2 - (t - t')^2 = 4 c_0, times y."""
    total, difference = (condition.rhs for condition in factor_conditions())
    cubic = sp.expand((total**2 - 4 * c0) * y) - difference**2 * s**2
    return sp.Eq(sp.collect(cubic, y), 0)


def resultant() -> Expr:
    """R = res(U, L), the product of the differences of upper and lower roots, in y: zero where two meet."""
    total, difference = (condition.rhs for condition in factor_conditions())
    U, L = (f.subs({t: (total + difference) / 2, t_lower: (total - difference) / 2}) for f in factors())
    return sp.Eq(R, sp.expand(sp.expand(sp.resultant(U, L, p)).subs(s, sp.sqrt(y))))


def resultant_slope() -> Expr:
    """g'(y), with c_0 eliminated by g(y) = 0."""
    cubic = resolvent_cubic().lhs
    return sp.Eq(sp.Derivative(sp.Function("g")(y), y), sp.expand(cubic.diff(y).subs(c0, sp.solve(cubic, c0)[0])))


def kernel_factored(half: tuple[int, int]) -> Expr:
    """K(xi) from (37) over the roots +-s/2 +- delta of U (xi >= 0) or of L (xi < 0), in sinc and cos.

    U = (p - s/2)^2 - delta^2, L = (p + s/2)^2 - delta'^2. At a root of one factor the other one equals their
    difference, and the product of its two values there is R. sinc and cos are even in delta: no branch.
    """
    sign, split = (1, delta) if half == UPPER else (-1, delta_lower)
    own, other = factors() if half == UPPER else factors()[::-1]
    centre = sign * s / 2
    waves = sp.S(0)
    for root, partner in ((split, -split), (-split, split)):
        opposite = (other - own).subs(p, centre + partner)
        waves += sp.exp(I * root * xi) * opposite / own.diff(p).subs(p, centre + root)
    waves = sp.expand(sp.expand(waves).rewrite(sp.cos))
    even, odd = sp.cos(split * xi), sp.sin(split * xi)
    ripple = sp.factor(sp.expand(waves.coeff(odd) * split).subs(s**2, y)) * xi * sp.sinc(split * xi)
    bracket = ripple + waves.coeff(even) * even
    return sp.Eq(K(xi, q), sign * 2 * sp.pi * I * sp.exp(I * centre * xi) * bracket / R)


def root_splits() -> tuple[Expr, Expr]:
    """delta^2 = y/4 - t and delta'^2 = y/4 - t', a quarter of the discriminants of U and L."""
    upper, lower = (sp.expand(sp.discriminant(f, p) / 4).subs(s**2, y) for f in factors())
    return sp.Eq(delta**2, upper), sp.Eq(delta_lower**2, lower)


def kernel_origin() -> Expr:
    """K(0) = -4 pi i s/g'(y), the same from above and from below."""
    return sp.Eq(K(0, q), kernel_factored(UPPER).rhs.subs(xi, 0))


def resolvent_form(half: tuple[int, int]) -> Expr:
    """`kernel_factored` with y, t, t', R, delta, delta' put in: an expression in xi, s, c_1, c_2 alone."""
    splits = {delta: sp.sqrt(root_splits()[0].rhs), delta_lower: sp.sqrt(root_splits()[1].rhs)}
    total, difference = (condition.rhs for condition in factor_conditions())
    offsets = {t: (total + difference) / 2, t_lower: (total - difference) / 2, R: resultant().rhs}
    return kernel_factored(half).rhs.subs(splits).subs(offsets).subs(y, s**2)


def kernel_gap() -> Expr:
    """K(0)^2 - K(d) K(-d) over the roots; K(0) is taken once from above and once from below.

    Each exponential e^{i(p_j - p_l)d}, j upper and l lower, is at most 1 in modulus.
    """

    def half_sum(half: tuple[int, int], distance: Expr) -> Expr:
        sign = 1 if half == UPPER else -1
        waves = (weights[j](q) * sp.exp(I * roots[j] * distance) for j in half)
        return sign * 2 * sp.pi * I * sum(waves)

    difference = half_sum(UPPER, 0) * half_sum(LOWER, 0) - half_sum(UPPER, d) * half_sum(LOWER, -d)
    products = [weights[j](q) * weights[k](q) for j in UPPER for k in LOWER]
    gathered = sp.collect(sp.expand(difference), products, evaluate=False)
    brackets = (sp.powsimp(sp.expand(gathered[product] / (4 * sp.pi**2))) for product in products)
    total = sum(4 * sp.pi**2 * product * bracket for product, bracket in zip(products, brackets, strict=True))
    return sp.Eq(K(0, q) ** 2 - K(d, q) * K(-d, q), total)


def uniformisation(coefficients: dict[Expr, Expr]) -> Expr:
    """r^2 as a rational function of sigma^2 = y/4: the resolvent cubic is linear in r^2."""
    cubic = resolvent_cubic().lhs.subs(coefficients).subs(y, 4 * sigma**2)
    (square,) = sp.solve(sp.expand(cubic).subs(r, sp.sqrt(R)), R)
    numerator, denominator = sp.fraction(sp.factor(square))
    return sp.Eq(r**2, numerator / denominator)
