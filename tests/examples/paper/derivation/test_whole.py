"""Each derived statement against the paper's equation, typed in again: exact identities, 1 to 3 masses."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from paper_equations import MASSES, agrees, differs, statement, vanishes
from sympy import I, exp, pi

from mpsolve.errors import InputError
from paper.derivation import characteristic, derivation, dispersion
from paper.derivation import residues as rs
from paper.derivation.motion import T, Wtilde, a, det, eta_b, eta_C, eta_M, eta_N, eta_S, positions, q_lm, tau, what
from paper.derivation.residues import K, alpha, beta, p, q, r, xi

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


def test_frequencies_of_a_real_wavenumber():
    """(A6): q = alpha p + i eta_b +- sqrt(p^4 - 4 N p^2 + 4 beta^2)/2."""
    root = sp.sqrt(p**4 - 4 * (eta_N - eta_S) * p**2 + 4 * (1 - eta_b**2))
    found = [equation.rhs for equation in statement("(A6)")]
    for side in (1, -1):
        typed = alpha * p + I * eta_b + side * root / 2
        assert sum(vanishes(typed - branch) for branch in found) == 1
        assert vanishes(dispersion().expression.subs(q, typed))


def test_damping_is_a_rescaling():
    """(A7): D(p sqrt(beta); beta r, alpha sqrt(beta), beta N, eta_b) = beta^2 D(p; r, alpha, N, 0)."""
    D, root = dispersion().expression, sp.sqrt(beta)
    damped = {p: root * p, q: beta * r + I * eta_b, alpha: root * alpha, eta_N: beta * eta_N, eta_S: beta * eta_S}
    scaled = D.subs(damped, simultaneous=True)
    assert vanishes((scaled - statement("(A7)").rhs).expand().subs(eta_b**2, 1 - beta**2))
    assert vanishes(statement("(A7)").rhs - beta**2 * D.subs({eta_b: 0, q: r}))


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
def test_kernel_by_quadrature_and_residues(place):
    """(21) by quadrature and (37), at one frequency."""
    with mpmath.workdps(30):
        D, q_, g = dispersion().lambdify(), mpmath.mpc("0.9", "-0.3"), mpmath.mpf(place)
        roots = p_roots(D, q_)
        assert [root.imag > 0 for root in roots] == [True, True, False, False]
        number = "(37)" if g >= 0 else "(37), xi < 0"
        residues = sp.lambdify((xi, *ROOTS), statement(number).rhs, "mpmath")(g, *roots)
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


def test_eqs_31_32_inverse_laplace_transform():
    """(32); the text of (31) has the singularities to the right of the line, they lie to its left."""
    integral = sp.Integral(Wtilde(xi, q) * exp(I * q * tau) / (2 * pi), (q, -I * a - T, -I * a + T))
    assert statement("(31), (32)") == sp.Eq(what(xi, tau), sp.Limit(integral, T, sp.oo))


@pytest.mark.parametrize(("number", "side"), [("(33)", -1), ("(34)", 1)])
def test_eqs_33_34_limiting_velocity(number, side):
    """Both hold for eta_b = 0 and eta_N = eta_S only; the print names the second condition alone."""
    fourth = (8 + 20 * q_lm**2 - q_lm**4 + side * q_lm * (q_lm**2 + 8) ** sp.Rational(3, 2)) / 8
    equation = statement(number)
    assert equation.lhs == alpha
    assert vanishes(equation.rhs**4 - fourth)
    quartic_ = dispersion().expression.subs({eta_b: 0, eta_N: eta_S, q: q_lm})
    assert vanishes(sp.discriminant(quartic_, p).subs(alpha, fourth ** sp.Rational(1, 4)))


def test_eq_35_sum_of_residues():
    """(35) with eta_M for the print's eta_Mu."""
    d, res = positions(2)[1], sp.Function("Res")
    factor = 4 * eta_C / q / det(q) * exp(I * q * tau)
    first = factor * (pi - 2 * eta_M * q**2 * (K(0, q) - K(-d, q))) * K(xi, q)
    second = factor * (pi - 2 * eta_M * q**2 * (K(0, q) - K(d, q))) * K(xi - d, q)
    rest = statement("(35)").rhs - sp.Symbol("I_wbc") / (2 * pi)
    found = [term.args[0] for term in rest.as_ordered_terms()]
    assert all(term.func == res for term in rest.as_ordered_terms())
    assert len(found) == 2
    assert vanishes(sum(found) - first - second)


def test_eq_36_steady_and_harmonic_parts():
    """(36) with eta_M for the print's eta_Mu."""
    d, j, slope_ = positions(2)[1], sp.Symbol("j", integer=True), sp.Function("det_q")
    pole = sp.IndexedBase("q_M")[j]
    steady = 4 * eta_C / pi * (K(xi, 0) + K(xi - d, 0))
    factor = 4 * eta_C * exp(I * pole * tau) / (pole * slope_(pole))
    first = factor * (pi - 2 * eta_M * pole**2 * (K(0, pole) - K(-d, pole))) * K(xi, pole)
    second = factor * (pi - 2 * eta_M * pole**2 * (K(0, pole) - K(d, pole))) * K(xi - d, pole)
    right = statement("(36)").rhs
    sums = right.atoms(sp.Sum)
    assert vanishes(right - sum(sums) - steady)
    assert vanishes(sum(e.function for e in sums) - first - second)


@MASSES
def test_eq_36_steady_part_is_that_of_the_forces_alone(masses):
    steady = sum(4 * eta_C / pi * K(xi - place, 0) for place in positions(masses))
    right = statement("(36)", masses).rhs
    assert vanishes(right - sum(right.atoms(sp.Sum)) - steady)
