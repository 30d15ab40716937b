"""Equations (31) to (36) against the paper, typed in again: exact identities, 1 to 3 masses."""

from __future__ import annotations

import pytest
import sympy as sp
from paper_equations import MASSES, statement, vanishes
from sympy import I, exp, pi

from mpsolve.derivation.paper import dispersion
from mpsolve.derivation.paper_motion import (
    T,
    Wtilde,
    a,
    det,
    eta_b,
    eta_C,
    eta_M,
    eta_N,
    eta_S,
    positions,
    q_lm,
    tau,
    what,
)
from mpsolve.derivation.paper_residues import K, alpha, p, q, xi


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
