"""Equations (1) to (13) against the paper, typed in again: exact identities, 1 to 3 masses."""

from __future__ import annotations

import sympy as sp
from paper_equations import MASSES, agrees, balance, delta, differs, dimensional, dimensionless, statement, vanishes
from sympy import I, exp, pi

from paper.derivation.motion import (
    EI,
    N,
    P,
    c_b,
    chi,
    eta_b,
    eta_N,
    eta_S,
    k,
    k_p,
    m,
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
from paper.derivation.residues import alpha, xi


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
