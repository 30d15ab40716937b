"""The derived statements by their numbers, and what equations of the paper are typed from in tests."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy import I, exp, pi

from mpsolve.derivation.step import Step
from paper.derivation import derivation
from paper.derivation.motion import numbered, positions, t
from paper.derivation.residues import K, q

delta = sp.DiracDelta
MASSES = pytest.mark.parametrize("masses", [1, 2, 3])


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
