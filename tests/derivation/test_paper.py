"""Each derived statement against the paper's equation, typed in again: exact identities, 1 to 3 masses."""

from __future__ import annotations

import unicodedata

import mpmath
import pytest
import sympy as sp
from sympy import I, exp, pi

from mpsolve.derivation import paper_residues as rs
from mpsolve.derivation.paper import Step, characteristic, derivation, dispersion, kernel_resolvent, render
from mpsolve.derivation.paper_residues import K, alpha, beta, p, q, r, xi
from mpsolve.derivation.paper_steps import (
    EI,
    N,
    P,
    T,
    W,
    Wtilde,
    a,
    c_b,
    chi,
    det,
    eta_b,
    eta_C,
    eta_M,
    eta_N,
    eta_S,
    k,
    k_p,
    m,
    numbered,
    positions,
    q_lm,
    qbar,
    s,
    t,
    tau,
    v,
    v_cr,
    w,
    w_st,
    what,
    x,
)
from mpsolve.errors import InputError

MASSES = pytest.mark.parametrize("masses", [1, 2, 3])
delta = sp.DiracDelta
ROOTS = p1, p2, p3, p4 = rs.roots


def step(number: str, masses: int = 2) -> Step:
    (found,) = (e for e in derivation(masses) if e.number == number)
    return found


def statement(number: str, masses: int = 2):
    return step(number, masses).statement


def vanishes(expression) -> bool:
    """Zero as a rational function of everything that is in it: exact, never numerical."""
    expanded = sp.expand(expression)
    return expanded == 0 or sp.expand(sp.numer(sp.together(expanded))) == 0


def differs(left, right) -> bool:
    """Some term of the expanded difference stays."""
    return sp.expand(left - right) != 0


def agrees(equation, left, right) -> bool:
    return vanishes(equation.lhs - left) and vanishes(equation.rhs - right)


def balance(equation):
    return equation.lhs - equation.rhs


def dimensional(masses):
    """(mass, constant force, harmonic force e^{i...}, place) of each mass of (2)."""
    for j, place in enumerate(positions(masses, "d_"), start=1):
        M, P_C, P_A, omega, phi = (sp.Symbol(f"{n}{j}") for n in ("M_", "P_C", "P_A", "omega_f", "phi_f"))
        yield M, P_C + P_A * exp(I * (omega * t + phi + 3 * pi / 2)), place


def dimensionless(masses):
    """(eta_M, eta_C, eta_A, omega, phi, place) of each mass of (13)."""
    names = ("eta_M", "eta_C", "eta_A", "omegahat_f")
    for j, place in enumerate(positions(masses), start=1):
        yield *(sp.Symbol(f"{n}{j}", real=True) for n in names), sp.Symbol(f"phi_f{j}"), place


def F(masses):
    return [sp.Function(f"F_{j}")(q) for j in range(1, masses + 1)]


def matrix(masses):
    """The matrix of (25) and its right side."""
    x_, eta = positions(masses), numbered("eta_M", masses)
    kernels = sp.Matrix(masses, masses, lambda i, j: K(x_[i] - x_[j], q))
    return pi * sp.eye(masses) - 2 * q**2 * kernels * sp.diag(*eta), kernels * sp.Matrix(F(masses))


def printed_det():
    """(26) as printed, with d = x_2."""
    (e1, e2), d = numbered("eta_M", 2), positions(2)[1]
    own = (pi - 2 * e1 * q**2 * K(0, q)) * (pi - 2 * e2 * q**2 * K(0, q))
    return own - 4 * e1 * e2 * q**4 * K(d, q) * K(-d, q)


def quartic():
    return sp.prod(p - root for root in ROOTS)


def slope(root):
    """D_{,p} at a root."""
    return quartic().diff(p).subs(p, root)


# (1)-(13)


def test_eq_1_equation_of_motion():
    f = w(x, t)
    left = EI * f.diff(x, 4) + (N - k_p) * f.diff(x, x) + m * f.diff(t, t) + c_b * f.diff(t) + k * f
    assert agrees(statement("(1)"), left, sp.Function("p")(x, t))


@MASSES
def test_eq_2_loading(masses):
    """(2) with w_{0j,tt}; the print's w_{0j,t} does not give the units of a force."""
    total, printed = 0, 0
    for j, (M, force, d) in enumerate(dimensional(masses), start=1):
        w_0 = sp.Function(f"w_0{j}")(t)
        total += (force - M * w_0.diff(t, 2)) * delta(x - v * t - d)
        printed += (force - M * w_0.diff(t)) * delta(x - v * t - d)
    assert agrees(statement("(2)", masses), sp.Function("p")(x, t), total)
    assert differs(statement("(2)", masses).rhs, printed)


def test_eqs_3_5_mass_velocity():
    f = w(x, t)
    assert agrees(statement("(3), (5)"), sp.Function("w_0j")(t).diff(t), v * f.diff(x) + f.diff(t))


def test_eqs_4_6_mass_acceleration():
    f = w(x, t)
    right = v**2 * f.diff(x, x) + 2 * v * f.diff(x, t) + f.diff(t, t)
    assert agrees(statement("(4), (6)"), sp.Function("w_0j")(t).diff(t, 2), right)


@MASSES
def test_eq_7_loading_in_the_field(masses):
    f = w(x, t)
    acceleration = f.diff(t, t) + 2 * v * f.diff(x, t) + v**2 * f.diff(x, x)
    total = sum((force - M * acceleration) * delta(x - v * t - d) for M, force, d in dimensional(masses))
    assert vanishes(statement("(7)", masses).rhs - total)


@MASSES
def test_eq_8_governing_equation(masses):
    f = w(x, t)
    left = EI * f.diff(x, 4) + (N - k_p) * f.diff(x, x) + m * f.diff(t, t) + c_b * f.diff(t) + k * f
    right = 0
    for M, force, d in dimensional(masses):
        left += M * delta(x - v * t - d) * (f.diff(t, t) + 2 * v * f.diff(x, t) + v**2 * f.diff(x, x))
        right += force * delta(x - v * t - d)
    assert agrees(statement("(8)", masses), left, right)


@MASSES
def test_eq_9_moving_coordinate(masses):
    """(9) with omega_fj, phi_fj as in (2); the print drops the index f."""
    f = w(s, t)
    left = EI * f.diff(s, 4) + (N - k_p) * f.diff(s, s) + k * f + c_b * (f.diff(t) - v * f.diff(s))
    left += m * (f.diff(t, t) - 2 * v * f.diff(s, t) + v**2 * f.diff(s, s))
    right = sum((force - M * f.diff(t, t)) * delta(s - d) for M, force, d in dimensional(masses))
    assert agrees(statement("(9)", masses), left, right)


def test_eq_9_holds_for_a_travelling_wave():
    """(8) on sin(g x + h t) cosh(x) is (9) on the same wave seen from the moving frame."""
    g, h = sp.symbols("g h")
    fixed, moving = balance(statement("(8)")), balance(statement("(9)"))
    wave = sp.sin(g * x + h * t) * sp.cosh(x)
    there = fixed.subs(w(x, t), wave).doit().subs(x, s + v * t)
    here = moving.subs(w(s, t), wave.subs(x, s + v * t)).doit()
    assert vanishes(there - here)


def test_eq_10_scales():
    wave, speed, static = statement("(10)")[3:]
    assert vanishes(wave.rhs**4 - k / (4 * EI))
    assert vanishes(speed.rhs**4 - 4 * k * EI / m**2)
    assert vanishes(speed.rhs - sp.sqrt(k / m) / wave.rhs)  # the second form of v_cr
    assert vanishes(static.rhs - P * chi / (2 * k))
    assert statement("(10)")[:3] == (
        sp.Eq(xi, chi * s),
        sp.Eq(tau, chi * v_cr * t),
        sp.Eq(what(xi, tau), w(s, t) / w_st),
    )


def test_eq_11_beam_ratios():
    damping, axial, shear = statement("(11)")
    assert agrees(damping, eta_b, c_b / (2 * sp.sqrt(m * k)))
    assert agrees(axial, eta_N, N / (2 * sp.sqrt(k * EI)))
    assert agrees(shear, eta_S, k_p / (2 * sp.sqrt(k * EI)))


@MASSES
def test_eq_12_load_ratios(masses):
    known = {equation.lhs: equation.rhs for equation in statement("(12)", masses)}
    assert known.pop(alpha) == v / v_cr
    for j, (e_M, e_C, e_A, omega, _, place) in enumerate(dimensionless(masses), start=1):
        assert known.pop(e_M) == sp.Symbol(f"M_{j}") * chi / m
        assert (known.pop(e_C), known.pop(e_A)) == (sp.Symbol(f"P_C{j}") / P, sp.Symbol(f"P_A{j}") / P)
        assert known.pop(omega) == sp.Symbol(f"omega_f{j}") / (chi * v_cr)
        if place != 0:
            assert known.pop(place) == chi * sp.Symbol(f"d_{j}", real=True)
    assert not known


@MASSES
def test_eq_13_dimensionless_equation(masses):
    f = what(xi, tau)
    left = f.diff(xi, 4) + 4 * (eta_N - eta_S + alpha**2) * f.diff(xi, xi) + 4 * f.diff(tau, tau)
    left += -8 * alpha * f.diff(xi, tau) + 8 * eta_b * (f.diff(tau) - alpha * f.diff(xi)) + 4 * f
    right = 0
    for e_M, e_C, e_A, omega, phi, place in dimensionless(masses):
        harmonic = 2 * e_A * exp(I * (omega * tau + phi + 3 * pi / 2))
        right += 4 * (2 * e_C + harmonic - e_M * f.diff(tau, tau)) * delta(xi - place)
    assert agrees(statement("(13)", masses), left, right)


# (14)-(30)


def test_eq_14_laplace_transform_of_derivatives():
    """By (14) on e^{-b tau} minus its start, whose value and slope at 0 vanish."""
    b = sp.Symbol("b", positive=True)
    f = exp(-b * tau) - 1 + b * tau
    image = sp.laplace_transform(f, tau, qbar, noconds=True)
    for order, rule in enumerate(statement("(14)")):
        F_ = sp.LaplaceTransform(sp.Function("f")(tau), tau, qbar)
        assert rule.rhs == qbar**order * F_
        derived = sp.laplace_transform(f.diff(tau, order), tau, qbar, noconds=True)
        assert vanishes(rule.rhs.subs(F_, image) - derived)


@MASSES
def test_eq_15_laplace_image(masses):
    f = Wtilde(xi, q)
    left = f.diff(xi, 4) + 4 * (eta_N - eta_S + alpha**2) * f.diff(xi, xi) - 4 * q**2 * f
    left += -8 * I * q * alpha * f.diff(xi) + 8 * (I * q * eta_b * f - eta_b * alpha * f.diff(xi)) + 4 * f
    right = 0
    for e_M, e_C, e_A, omega, phi, place in dimensionless(masses):
        harmonic = 8 * e_A * exp(I * (phi + 3 * pi / 2)) / (I * q - I * omega)
        right += (8 * e_C / (I * q) + harmonic + 4 * e_M * q**2 * f) * delta(xi - place)
    assert agrees(statement("(15)", masses), left, right)


def test_eqs_16_19_fourier_pair():
    direct = sp.Integral(Wtilde(xi, q) * exp(-I * p * xi), (xi, -sp.oo, sp.oo))
    inverse = sp.Integral(W(p, q) * exp(I * p * xi), (p, -sp.oo, sp.oo)) / (2 * pi)
    assert statement("(16)") == sp.Eq(W(p, q), direct)
    assert statement("(19)") == sp.Eq(Wtilde(xi, q), inverse)


@MASSES
def test_eq_17_wavenumber_domain(masses):
    """(17) with the mass terms inside 1/D; the print has them outside."""
    force = mass = 0
    for e_M, e_C, e_A, omega, phi, place in dimensionless(masses):
        harmonic = 8 * e_A * exp(I * (phi + 3 * pi / 2)) / (I * q - I * omega)
        force += (8 * e_C / (I * q) + harmonic) * exp(-I * p * place)
        mass += 4 * e_M * q**2 * Wtilde(place, q) * exp(-I * p * place)
    D = rs.D(p, q)
    assert agrees(statement("(17)", masses), W(p, q), (force + mass) / D)
    assert differs(statement("(17)", masses).rhs, force / D + mass)


@MASSES
def test_eq_18_dispersion_function(masses):
    D = p**4 - 4 * p**2 * (eta_N - eta_S + alpha**2) - 4 * q**2
    D += 8 * alpha * p * q + 8 * I * eta_b * (q - alpha * p) + 4
    assert agrees(statement("(18)", masses), rs.D(p, q), D)
    assert vanishes(dispersion().expression - D)
    assert dispersion().arguments == (p, q, alpha, eta_b, eta_N, eta_S)


@MASSES
def test_eq_20_laplace_image_by_kernels(masses):
    total = 0
    for F_j, e_M, place in zip(F(masses), numbered("eta_M", masses), positions(masses), strict=True):
        total += (F_j + 2 * e_M * q**2 * Wtilde(place, q)) * K(xi - place, q) / pi
    assert agrees(statement("(20)", masses), Wtilde(xi, q), total)


def test_eq_21_kernel():
    assert statement("(21)") == sp.Eq(K(xi, q), sp.Integral(exp(I * p * xi) / rs.D(p, q), (p, -sp.oo, sp.oo)))


@MASSES
def test_eq_22_force_amplitudes(masses):
    for equation, F_j, (_, e_C, e_A, omega, phi, _) in zip(
        statement("(22)", masses), F(masses), dimensionless(masses), strict=True
    ):
        harmonic = 4 * e_A * exp(I * (phi + 3 * pi / 2)) / (I * q - I * omega)
        assert agrees(equation, F_j, 4 * e_C / (I * q) + harmonic)


def test_eqs_23_24_two_masses():
    (F1, F2), (e1, e2), d = F(2), numbered("eta_M", 2), positions(2)[1]
    W0, Wd = Wtilde(0, q), Wtilde(d, q)
    load1, load2 = F1 + 2 * e1 * q**2 * W0, F2 + 2 * e2 * q**2 * Wd
    first, second = statement("(23), (24)")
    assert agrees(first, pi * W0, load1 * K(0, q) + load2 * K(-d, q))
    assert agrees(second, pi * Wd, load1 * K(d, q) + load2 * K(0, q))


@MASSES
def test_eq_25_linear_system(masses):
    system, (left, right) = statement("(25)", masses), matrix(masses)
    assert (system.lhs.args[0] - left).applyfunc(sp.expand).is_zero_matrix
    assert list(system.lhs.args[1]) == [Wtilde(place, q) for place in positions(masses)]
    assert (system.rhs - right).applyfunc(sp.expand).is_zero_matrix


def test_eq_26_determinant_of_two_masses():
    assert agrees(statement("(26)"), det(q), printed_det())


def test_eq_26_of_two_masses_at_one_place_is_that_of_their_sum():
    (e1, e2), d = numbered("eta_M", 2), positions(2)[1]
    (single,) = numbered("eta_M", 1)
    together = statement("(26)").rhs.subs(d, 0)
    assert vanishes(together - pi * statement("(26)", 1).rhs.subs(single, e1 + e2))


@MASSES
def test_eq_26_is_pi_n_times_the_characteristic_function(masses):
    """(A1): det = pi^N det[I - (2 q^2/pi) K_ij eta_Mj]."""
    x_, eta = positions(masses), numbered("eta_M", masses)
    Delta = sp.Matrix(
        masses, masses, lambda i, j: sp.KroneckerDelta(i, j) - 2 * q**2 / pi * K(x_[i] - x_[j], q) * eta[j]
    ).det()
    assert agrees(statement("(26)", masses), det(q), pi**masses * Delta)
    assert agrees(statement("(A1)", masses).doit(), det(q), pi**masses * Delta)


def test_eqs_27_28_mass_displacements():
    (F1, F2), (e1, e2), d = F(2), numbered("eta_M", 2), positions(2)[1]
    K0, Kp, Km = K(0, q), K(d, q), K(-d, q)
    right1, right2 = F1 * K0 + F2 * Km, F1 * Kp + F2 * K0
    first, second = statement("(27), (28)")
    numerator1 = (pi - 2 * e2 * q**2 * K0) * right1 + 2 * e2 * q**2 * Km * right2
    numerator2 = (pi - 2 * e1 * q**2 * K0) * right2 + 2 * e1 * q**2 * Kp * right1
    assert agrees(first, Wtilde(0, q), numerator1 / det(q))
    assert agrees(second, Wtilde(d, q), numerator2 / det(q))


@MASSES
def test_eqs_27_28_solve_the_linear_system(masses):
    left, right = matrix(masses)
    numerators = sp.Matrix([equation.rhs * det(q) for equation in statement("(27), (28)", masses)])
    residual = left * numerators - right * statement("(26)", masses).rhs
    assert residual.applyfunc(sp.expand).is_zero_matrix


def test_eq_29_displacement_of_two_masses():
    (F1, F2), (e1, e2), d = F(2), numbered("eta_M", 2), positions(2)[1]
    ahead = F1 * pi - 2 * F1 * e2 * q**2 * K(0, q) + 2 * F2 * e1 * q**2 * K(-d, q)
    behind = F2 * pi - 2 * F2 * e1 * q**2 * K(0, q) + 2 * F1 * e2 * q**2 * K(d, q)
    total = (ahead * K(xi, q) + behind * K(xi - d, q)) / det(q)
    assert agrees(statement("(29)"), Wtilde(xi, q), total)


@MASSES
def test_eq_29_meets_eqs_27_28_at_the_masses(masses):
    """At xi = x_i, (29) is the displacement of mass i."""
    values, charact = statement("(29)", masses).rhs, statement("(26)", masses).rhs
    for equation, place in zip(statement("(27), (28)", masses), positions(masses), strict=True):
        assert vanishes((values.subs(xi, place) - equation.rhs) * det(q))
    (F1,), (e1,) = F(1), numbered("eta_M", 1)
    if masses == 1:
        assert vanishes(values - F1 * K(xi, q) / det(q))
        assert vanishes(charact - pi + 2 * e1 * q**2 * K(0, q))


def test_eq_30_equal_masses_and_forces():
    d, common = positions(2)[1], 4 * eta_C / (I * q) / det(q)
    first = common * (pi - 2 * eta_M * q**2 * (K(0, q) - K(-d, q))) * K(xi, q)
    second = common * (pi - 2 * eta_M * q**2 * (K(0, q) - K(d, q))) * K(xi - d, q)
    assert agrees(statement("(30)"), Wtilde(xi, q), first + second)


@MASSES
def test_eq_30_is_eq_29_specialised(masses):
    equal = dict.fromkeys(numbered("eta_M", masses), eta_M) | dict.fromkeys(F(masses), 4 * eta_C / (I * q))
    assert vanishes(statement("(29)", masses).rhs.subs(equal) - statement("(30)", masses).rhs)


def test_equal_masses_factor():
    """(A2): det/pi^2 = [1 - a(K0 + sqrt(Kd K-d))][1 - a(K0 - sqrt(Kd K-d))], a = 2 eta_M q^2/pi."""
    d, a_ = positions(2)[1], 2 * eta_M * q**2 / pi
    root = sp.sqrt(K(d, q) * K(-d, q))
    product = (1 - a_ * (K(0, q) + root)) * (1 - a_ * (K(0, q) - root))
    equal = printed_det().subs(dict.fromkeys(numbered("eta_M", 2), eta_M))
    assert vanishes(statement("(A2)").rhs - pi**2 * product)
    assert vanishes(statement("(A2)").rhs - equal)


# (31)-(39)


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


def test_text_holds_each_step():
    text = render(derivation(2))
    assert all(f"{e.number} {e.title}" in text for e in derivation(2))
    assert unicodedata.normalize("NFC", "ŵ(ξ, τ)") in unicodedata.normalize("NFC", text)


def test_latex_is_ascii_and_balanced():
    source = render(derivation(2), style="latex")
    assert source.isascii()
    assert source.startswith("\\documentclass")
    assert source.rstrip().endswith("\\end{document}")
    assert source.count("\\begin{align*}") == source.count("\\end{align*}") == len(derivation(2))
    bare = source.replace("\\{", "").replace("\\}", "")
    assert bare.count("{") == bare.count("}")
    assert source.count("\\left") - source.count("\\leftarrow") == source.count("\\right")


def test_bad_input_raises():
    with pytest.raises(InputError, match="masses"):
        derivation(0)
    with pytest.raises(InputError, match="style"):
        render(derivation(1), style="html")
