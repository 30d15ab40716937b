"""Equations (14) to (30) against the paper, typed in again: exact identities, 1 to 3 masses."""

from __future__ import annotations

import sympy as sp
from paper_equations import MASSES, F, agrees, delta, differs, dimensionless, matrix, printed_det, statement, vanishes
from sympy import I, exp, pi

from paper.derivation import dispersion
from paper.derivation import residues as rs
from paper.derivation.motion import W, Wtilde, det, eta_b, eta_C, eta_M, eta_N, eta_S, numbered, positions, qbar, tau
from paper.derivation.residues import K, alpha, p, q, xi


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
