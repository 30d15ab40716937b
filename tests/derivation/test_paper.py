"""Each derived statement against the paper's equation, typed in again: exact identities, 1 to 3 masses."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from paper_equations import MASSES, agrees, differs, statement, vanishes
from sympy import I, exp, pi

from mpsolve.derivation import paper_residues as rs
from mpsolve.derivation.paper import characteristic, derivation, dispersion, kernel_resolvent
from mpsolve.derivation.paper_motion import eta_b, eta_N, eta_S
from mpsolve.derivation.paper_residues import K, alpha, beta, p, q, r, xi
from mpsolve.errors import InputError

ROOTS = p1, p2, p3, p4 = rs.roots


def quartic():
    return sp.prod(p - root for root in ROOTS)


def slope(root):
    """D_{,p} at a root."""
    return quartic().diff(p).subs(p, root)


# (1)-(13)


# (14)-(30)


# (31)-(39)


def test_eq_37_kernel_by_residues():
    """(37) with e^{i p_j g}; the print has e^{i p g} in the sum. Below the axis the sign is reversed."""
    upper = 2 * pi * I * sum(exp(I * root * xi) / slope(root) for root in (p1, p2))
    lower = -2 * pi * I * sum(exp(I * root * xi) / slope(root) for root in (p3, p4))
    assert vanishes(statement("(37)").rhs - upper)
    assert vanishes(statement("(37), xi < 0").rhs - lower)


def test_partial_fractions_and_the_sum_of_weights():
    """(A3), (A4); by (A4) both forms of (37) give the same K(0)."""
    assert sp.cancel(sp.together(statement("(A3)").rhs * quartic())) == 1
    assert statement("(A4)").rhs == 0
    assert vanishes(statement("(A4)").lhs - sum(1 / slope(root) for root in ROOTS))
    jump = statement("(37)").rhs - statement("(37), xi < 0").rhs
    assert sp.cancel(sp.together(jump.subs(xi, 0))) == 0


def test_eq_38_derivative_of_the_kernel():
    D = rs.D(p, q)
    integrand = -D.diff(q) / D**2 * exp(I * p * xi)
    assert agrees(statement("(38)"), rs.K_q(xi, q), sp.Integral(integrand, (p, -sp.oo, sp.oo)))


def printed_39(g, first, second):
    """The right side of (39) in given exponent and second and third derivatives."""
    total = 0
    for root in (p1, p2):
        n = sp.Function("D_q")(p) * exp(I * p * g)
        fraction = -6 * n.diff(p) * first(p) + 2 * n * second(p)
        total += (fraction / (3 * first(p) ** 2)).subs(p, root)
    return 2 * pi * I * total


def test_eq_39_derivative_of_the_kernel():
    """(39) with e^{i p g} and with (D^2)_{,pp}, (D^2)_{,ppp} for the print's D_{,pp}^2, D_{,ppp}^2."""
    corrected = printed_39(xi, sp.Function("h_pp"), sp.Function("h_ppp"))
    assert agrees(statement("(39)"), rs.K_q(xi, q), corrected)
    with_squares = printed_39(xi, lambda z: sp.Function("D_pp")(z) ** 2, lambda z: sp.Function("D_ppp")(z) ** 2)
    assert differs(statement("(A5)").rhs, with_squares)


def test_derivative_of_the_kernel_over_simple_roots():
    """(A5): 2 pi i sum [D_q D_pp e^{ipg}/D_p^3 - (D_q e^{ipg})_p/D_p^2]."""
    D_p, D_pp, D_q = (sp.Function(name)(p) for name in ("D_p", "D_pp", "D_q"))
    wave = exp(I * p * xi)
    term = D_q * D_pp * wave / D_p**3 - (D_q * wave).diff(p) / D_p**2
    total = 2 * pi * I * sum(term.subs(p, root) for root in (p1, p2))
    assert vanishes(statement("(A5)").rhs - total)


def test_derivative_of_the_kernel_is_that_of_its_residues():
    """(A5) is (37) differentiated by q along a moving root, p_{j,q} = -D_q/D_p, for any D(p, q)."""
    D = sp.Function("D")(p, q)
    here = {"D_p": D.diff(p), "D_pp": D.diff(p, p), "D_q": D.diff(q)}
    names = {sp.Function(name)(p): value for name, value in here.items()}
    term = statement("(A5)").rhs.subs(exp(I * p2 * xi), 0).subs(p1, p).subs(names).doit()
    residue = 2 * pi * I * exp(I * p * xi) / D.diff(p)
    moving = residue.diff(q) + residue.diff(p) * (-D.diff(q) / D.diff(p))
    assert vanishes(term - moving)


# What the numerical code adds


def shifted_quartic():
    """D in r = q - i eta_b, with A and beta: p^4 - 4 A p^2 + 8 alpha r p + 4 beta^2 - 4 r^2."""
    return p**4 - 4 * rs.A * p**2 + 8 * alpha * r * p + 4 * beta**2 - 4 * r**2


def test_coefficients_of_the_shifted_quartic():
    """(A6)."""
    known = {equation.lhs: equation.rhs for equation in statement("(A6)")}
    D = p**4 + known[rs.c2] * p**2 + known[rs.c1] * p + known[rs.c0]
    assert vanishes(D - shifted_quartic())
    physical = D.subs({rs.A: eta_N - eta_S + alpha**2, beta: sp.sqrt(1 - eta_b**2), r: q - I * eta_b})
    assert vanishes(physical - dispersion().expression)


def test_frequencies_of_a_real_wavenumber():
    """(A7): q = alpha p + i eta_b +- sqrt(p^4 - 4 N p^2 + 4 beta^2)/2."""
    root = sp.sqrt(p**4 - 4 * (eta_N - eta_S) * p**2 + 4 * (1 - eta_b**2))
    found = [equation.rhs for equation in statement("(A7)")]
    for side in (1, -1):
        typed = alpha * p + I * eta_b + side * root / 2
        assert sum(vanishes(typed - branch) for branch in found) == 1
        assert vanishes(dispersion().expression.subs(q, typed))


def test_damping_is_a_rescaling():
    """(A8): D(p sqrt(beta); beta r, alpha sqrt(beta), beta N, eta_b) = beta^2 D(p; r, alpha, N, 0)."""
    D, root = dispersion().expression, sp.sqrt(beta)
    damped = {p: root * p, q: beta * r + I * eta_b, alpha: root * alpha, eta_N: beta * eta_N, eta_S: beta * eta_S}
    scaled = D.subs(damped, simultaneous=True)
    assert vanishes((scaled - statement("(A8)").rhs).expand().subs(eta_b**2, 1 - beta**2))
    assert vanishes(statement("(A8)").rhs - beta**2 * D.subs({eta_b: 0, q: r}))


def test_factors_of_the_quartic():
    """(A9): t + t' = y + c2, t - t' = c1/s; (A10) is then t t' = c0."""
    total, difference = statement("(A9)")
    assert agrees(total, rs.t + rs.t_lower, rs.y + rs.c2)
    assert agrees(difference, rs.t - rs.t_lower, rs.c1 / rs.s)
    c0 = ((rs.s**2 + rs.c2) ** 2 - (rs.c1 / rs.s) ** 2) / 4
    upper = p**2 - rs.s * p + (rs.s**2 + rs.c2 + rs.c1 / rs.s) / 2
    lower = p**2 + rs.s * p + (rs.s**2 + rs.c2 - rs.c1 / rs.s) / 2
    assert vanishes(upper * lower - (p**4 + rs.c2 * p**2 + rs.c1 * p + c0))
    assert vanishes(statement("(A10)").lhs.subs({rs.c0: c0, rs.y: rs.s**2}))


def test_resolvent_cubic():
    """(A10): y^3 + 2 c2 y^2 + (c2^2 - 4 c0) y - c1^2 = 0."""
    y = rs.y
    cubic = y**3 + 2 * rs.c2 * y**2 + (rs.c2**2 - 4 * rs.c0) * y - rs.c1**2
    assert agrees(statement("(A10)"), cubic, 0)


def test_resultant_is_the_slope_of_the_cubic():
    """(A11), (A12): R = 2 y (y + c2) + c1^2/y = g'(y); and R is the product of the root differences."""
    y = rs.y
    R = 2 * y * (y + rs.c2) + rs.c1**2 / y
    assert agrees(statement("(A11)"), rs.R, R)
    assert vanishes(statement("(A12)").rhs - R)
    assert statement("(A12)").lhs == sp.Derivative(sp.Function("g")(y), y)
    product = sp.prod(a_ - b for a_ in (p1, p2) for b in (p3, -p1 - p2 - p3))
    upper_sum = p1 + p2
    c2, c1 = (sp.Poly(quartic().subs(p4, -p1 - p2 - p3), p).coeff_monomial(p**n) for n in (2, 1))
    assert sp.cancel(sp.together(R.subs({y: upper_sum**2, rs.c2: c2, rs.c1: c1}) - product)) == 0


def test_root_splits():
    """(A13): delta^2 = y/4 - t, delta'^2 = y/4 - t'."""
    upper, lower = statement("(A13)")
    assert agrees(upper, rs.delta**2, rs.y / 4 - rs.t)
    assert agrees(lower, rs.delta_lower**2, rs.y / 4 - rs.t_lower)


def test_kernel_by_the_resolvent_cubic():
    """(A14), (A15), (A16) as in sinc and cos."""
    B, B_lower = rs.y - rs.t + rs.t_lower, rs.y + rs.t - rs.t_lower
    z, z_lower = rs.delta * xi, rs.delta_lower * xi
    ahead = I * B * xi * sp.sinc(z) - 2 * rs.s * sp.cos(z)
    behind = I * B_lower * xi * sp.sinc(z_lower) + 2 * rs.s * sp.cos(z_lower)
    assert vanishes(statement("(A14)").rhs - 2 * pi * I * exp(I * rs.s * xi / 2) * ahead / rs.R)
    assert vanishes(statement("(A15)").rhs + 2 * pi * I * exp(-I * rs.s * xi / 2) * behind / rs.R)
    assert statement("(A16)") == sp.Eq(K(0, q), -4 * pi * I * rs.s / rs.R)
    assert vanishes(statement("(A15)").rhs.subs(xi, 0) - statement("(A16)").rhs)


@pytest.mark.parametrize(("number", "cubic"), [("(37)", "(A14)"), ("(37), xi < 0", "(A15)")])
def test_kernel_by_the_cubic_is_the_sum_of_residues(number, cubic):
    """(A14), (A15) equal (37) for roots s/2 +- delta and -s/2 +- delta', whatever s, delta, delta' are."""
    s_, above, below = rs.s, rs.delta, rs.delta_lower
    at = {p1: s_ / 2 + above, p2: s_ / 2 - above, p3: -s_ / 2 + below, p4: -s_ / 2 - below}
    R = sp.prod(at[upper] - at[lower] for upper in (p1, p2) for lower in (p3, p4))
    values = {rs.t: s_**2 / 4 - above**2, rs.t_lower: s_**2 / 4 - below**2, rs.y: s_**2, rs.R: R}
    factored = statement(cubic).rhs.replace(sp.sinc, lambda z: sp.sin(z) / z).rewrite(exp).subs(values)
    residues = statement(number).rhs.subs(at, simultaneous=True)
    E, G, H = sp.symbols("E G H")
    waves = {exp(I * xi * s_ / 2): E, exp(I * xi * above): G, exp(I * xi * below): H}
    difference = sp.together((residues - factored).replace(exp, lambda z: exp(sp.expand(z)).expand()).subs(waves))
    assert not difference.has(exp)
    assert sp.cancel(difference) == 0


def test_coupling_of_two_masses():
    """(A17): K(0)^2 - K(d) K(-d) = 4 pi^2 sum c_j c_l (1 - e^{i(p_j - p_l)d}), by (37) and (A4)."""
    d, identity = rs.d, statement("(A17)")
    assert identity.lhs == K(0, q) ** 2 - K(d, q) * K(-d, q)
    c = [weight(q) for weight in rs.weights]
    total = sum((1 - exp(I * (ROOTS[j] - ROOTS[k_]) * d)) * c[j] * c[k_] for j in (0, 1) for k_ in (2, 3))
    assert vanishes(identity.rhs - 4 * pi**2 * total)

    def ahead(g):
        return 2 * pi * I * sum(c[j] * exp(I * ROOTS[j] * g) for j in (0, 1))

    def behind(g):
        return -2 * pi * I * sum(c[j] * exp(I * ROOTS[j] * g) for j in (2, 3))

    kernels = ahead(0) ** 2 - ahead(d) * behind(-d)
    assert vanishes((kernels - identity.rhs).subs(c[3], -c[0] - c[1] - c[2]))
    assert differs(kernels, identity.rhs)


def test_uniformisation():
    """(A18): r^2 = sigma^2 [(sigma^2 - A)^2 - beta^2]/(alpha^2 - sigma^2)."""
    square = rs.sigma**2
    right = square * ((square - rs.A) ** 2 - beta**2) / (alpha**2 - square)
    assert statement("(A18)").lhs == r**2
    assert sp.cancel(statement("(A18)").rhs - right) == 0
    cubic = statement("(A10)").lhs.subs({e.lhs: e.rhs for e in statement("(A6)")})
    assert sp.cancel(sp.together(cubic.subs(rs.y, 4 * square).subs(r, sp.sqrt(right)))) == 0


# The formulas as functions, and the printing

PARAMETERS = {"alpha": "0.4", "eta_b": "0.1", "eta_N": "0.2", "eta_S": "0.05"}


def numbers():
    return [mpmath.mpf(value) for value in PARAMETERS.values()]


def p_roots(D, q_):
    """The roots of D in p, upper ones first, by interpolation of the monic quartic."""
    values = [D(mpmath.mpf(n), q_, *numbers()) for n in range(-2, 3)]
    vandermonde = mpmath.matrix([[mpmath.mpf(n) ** e for e in range(4, -1, -1)] for n in range(-2, 3)])
    coefficients = list(mpmath.lu_solve(vandermonde, mpmath.matrix(values)))
    return sorted(mpmath.polyroots(coefficients, maxsteps=200, extraprec=200), key=lambda z: -z.imag)


@pytest.mark.parametrize("place", ["0.7", "-1.3"])
def test_kernel_by_quadrature_residues_and_cubic(place):
    """(21) by quadrature, (37), and (A14) or (A15), at one frequency."""
    with mpmath.workdps(30):
        D, q_, g = dispersion().lambdify(), mpmath.mpc("0.9", "-0.3"), mpmath.mpf(place)
        roots = p_roots(D, q_)
        assert [root.imag > 0 for root in roots] == [True, True, False, False]
        number = "(37)" if g >= 0 else "(37), xi < 0"
        residues = sp.lambdify((xi, *ROOTS), statement(number).rhs, "mpmath")(g, *roots)
        s_ = roots[0] + roots[1]
        at_0, at_1, at_minus_1 = (D(value, q_, *numbers()) for value in (0, 1, -1))
        c1, c2 = (at_1 - at_minus_1) / 2, (at_1 + at_minus_1) / 2 - 1 - at_0
        cubic = kernel_resolvent()[0 if g >= 0 else 1].lambdify()(g, s_, c1, c2)
        assert abs(cubic - residues) < mpmath.mpf(10) ** -25
    with mpmath.workdps(16):
        end = 80
        panels = range(-end, end + 1, 4)
        integral = mpmath.quad(lambda z: mpmath.exp(1j * z * g) / D(z, q_, *numbers()), panels, maxdegree=5)
        assert abs(integral - residues) < 1 / mpmath.mpf(end) ** 3  # beyond, the integrand is below 1.01/p^4


@MASSES
def test_characteristic_takes_the_kernel_values(masses):
    formula = characteristic(masses)
    q_, eta, K_ = formula.arguments
    assert (len(eta), len(K_)) == (masses, masses)
    expected = sp.Matrix(masses, masses, lambda i, j: pi * int(i == j) - 2 * q_**2 * K_[i][j] * eta[j]).det()
    assert vanishes(formula.expression - expected)
    values = [[1 + i + 2 * j for j in range(masses)] for i in range(masses)]
    by_numbers = formula.lambdify()(mpmath.mpf(2), range(1, masses + 1), values)
    at = {q_: 2} | dict(zip(eta, range(1, masses + 1), strict=True))
    at |= {K_[i][j]: values[i][j] for i in range(masses) for j in range(masses)}
    assert abs(by_numbers - mpmath.mpf(sp.N(expected.subs(at), 20))) < 1e-8 * abs(by_numbers)


@MASSES
def test_steps_have_their_own_numbers_and_are_equations(masses):
    steps = derivation(masses)
    assert len({e.number for e in steps}) == len(steps)
    for one in steps:
        parts = one.statement if isinstance(one.statement, tuple) else (one.statement,)
        assert all(isinstance(part, sp.Eq) for part in parts), one.number
        assert (one.title + one.note).isascii()


def test_every_numbered_equation_is_derived():
    numbers_ = " ".join(e.number for e in derivation(2))
    assert [n for n in range(1, 40) if f"({n})" not in numbers_] == []


def test_bad_input_raises():
    with pytest.raises(InputError, match="masses"):
        derivation(0)
