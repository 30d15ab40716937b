"""The model derived symbolically, from the equation of motion (1) to the residue forms of the kernel.

Numbers are the paper's equations; (A1), (A2), ... are what the numerical code adds to them. The steps up to
(30) are in `motion` and `steps`, the residue forms of the kernel in `residues`; here are the inversion and the
rest, and all in order. `mpsolve derive examples/paper` prints them.

    >>> steps = derivation(masses=2)
    >>> [step.title for step in steps if step.number == "(18)"]
    ['Dispersion function']
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from mpsolve.derivation.step import Expr, Step
from mpsolve.errors import InputError

from . import motion as mo
from . import residues as rs
from . import steps as st
from .motion import T, Wtilde, a, det, eta_b, eta_N, eta_S, positions, q_lm, qbar, tau, what
from .residues import LOWER, UPPER, I, K, alpha, beta, p, q, r, xi
from .steps import with_equal_masses

__all__ = ["Step", "Formula", "derivation", "dispersion", "characteristic"]


@dataclass(frozen=True)
class Formula:
    """A sympy expression and the symbols in it, in the order in which `lambdify` takes them."""

    expression: Expr
    arguments: tuple[Expr, ...]

    def lambdify(self, modules: str = "mpmath") -> Callable[..., Any]:
        """The expression as a function of `arguments`, evaluated by `modules` as in sympy.lambdify."""
        function: Callable[..., Any] = sp.lambdify(self.arguments, self.expression, modules)
        return function


def kernel_steps(kernel: Step) -> tuple[Step, ...]:
    """(37)-(39) and the clean form of K_{,q}, by residues at simple p-roots."""
    printed = rs.kernel_derivative_print()
    above, below = rs.kernel_residues(UPPER), rs.kernel_residues(LOWER)
    integral = rs.kernel_derivative_integral(kernel.statement)
    slips = "The print has exp(i g d) for exp(i p g), D_{,pp}^2, D_{,ppp}^2 for (D^2)_{,pp}, (D^2)_{,ppp}."
    by_q = "(21) differentiated by q under the integral sign."
    upper = "(21) closed above: upper roots. The print has p for p_j in the exponent."
    return (
        Step("(A3)", "Partial fractions of 1/D", rs.partial_fractions(), "D monic in p: weights 1/D_{,p}(p_j)."),
        Step("(A4)", "Sum of the weights", rs.weights_sum(), "1/D falls off as p^-4, so they add to 0."),
        Step("(37)", "Kernel for xi >= 0", above, upper),
        Step("(37), xi < 0", "Kernel for xi < 0", below, "(21) closed below: lower roots, sign reversed."),
        Step("(38)", "Kernel's derivative", integral, by_q),
        Step("(39)", "Kernel's derivative, xi >= 0", printed, f"Double poles of (38), h = D^2. {slips}"),
        Step("(A5)", "Kernel's derivative by simple roots", rs.kernel_derivative(printed), "h = D^2 in (39)."),
    )


def real_wavenumber(D: Step) -> Step:
    """(A6): the frequencies at which p is a root of D, the boundary of the sheet for real p."""
    square, linear, constant = sp.Poly(D.statement.rhs, q).all_coeffs()
    split = sp.sqrt(sp.factor_terms(sp.expand(linear**2 - 4 * square * constant)))
    branches = (sp.expand_mul((-linear + side * split) / (2 * square)) for side in (1, -1))
    note = "(18) = 0, quadratic in q; for real p the frequencies on the cuts."
    return Step("(A6)", "Frequencies of a real wavenumber", tuple(sp.Eq(q, e) for e in branches), note)


def damping_rescaling(D: Step) -> Step:
    """(A7): damping rescales p, r, alpha and the axial force; K(xi) = beta^(-3/2) K_0(xi sqrt(beta))."""
    quartic = D.statement.rhs.subs(q, r + I * eta_b).expand().subs(eta_b**2, 1 - beta**2)
    root = sp.sqrt(beta)
    scaled = {p: root * p, r: beta * r, alpha: root * alpha, eta_N: beta * eta_N, eta_S: beta * eta_S}
    damped = sp.factor(sp.expand(quartic.subs(scaled, simultaneous=True)), beta)
    note = "All scaled in (18): beta^2 times the undamped D; K = beta^(-3/2) K_0(xi sqrt(beta))."
    return Step("(A7)", "Damping is a rescaling", sp.Eq(rs.D(root * p, beta * r + I * eta_b), damped), note)


def inversion() -> Step:
    """(32): the Bromwich integral (31) with qbar = i q."""
    integrand, substitution = Wtilde(xi, qbar) * sp.exp(qbar * tau) / (2 * sp.pi * I), I * q
    moved = integrand.replace(Wtilde, lambda xi_, _: Wtilde(xi_, q)).subs(qbar, substitution) * substitution.diff(q)
    ends = (sp.expand((a + side * I * T) / I) for side in (-1, 1))
    limit = sp.Limit(sp.Integral(moved, (q, *ends)), T, sp.oo)
    note = "qbar = i q in (31). Every singularity lies left of the line of (31); the print has right. Im q = -a."
    return Step("(31), (32)", "Inverse Laplace transform", sp.Eq(what(xi, tau), limit), note)


@lru_cache(maxsize=1)
def limiting_velocity(D: Step) -> tuple[Step, Step]:
    """(33), (34): the discriminant of D in p is quadratic in alpha^4 when eta_b = 0 and eta_N = eta_S."""
    quartic = D.statement.rhs.subs({eta_b: 0, eta_N: eta_S, q: q_lm})
    fourth = sp.Symbol("a_4", positive=True)
    condition = sp.discriminant(quartic, p).subs(alpha, fourth ** sp.Rational(1, 4))
    branches = sorted(sp.solve(condition, fourth), key=lambda e: float(e.subs(q_lm, 1)))
    note = "Double p-root of (18) at q = q_lm; for eta_b = 0 and eta_N = eta_S only."
    first, second = (sp.Eq(alpha, branch ** sp.Rational(1, 4)) for branch in branches)
    return (
        Step("(33)", "Limiting frequency, first branch", first, note + " Here 0 <= q_lm <= 1."),
        Step("(34)", "Limiting frequency, second branch", second, note),
    )


def residue_sum(image: Step) -> Step:
    """(35): (32) on (30), closed in the upper half-plane of q."""
    terms = [sp.exp(I * q * tau) * term for term in sp.Add.make_args(image.statement.rhs)]
    residues = sum(sp.Function("Res")(2 * sp.pi * I * term / (2 * sp.pi), q) for term in terms)
    cut = sp.Symbol("I_wbc") / (2 * sp.pi)
    note = "Residues at all poles above the line of (32), and the branch cuts. The print has eta_Mu for eta_M."
    return Step("(35)", "Displacement as a sum of residues", sp.Eq(what(xi, tau), residues + cut), note)


def harmonic_sum(residues: Step, charact: Step, masses: int) -> Step:
    """(36): the residues of (35) at q = 0, where det = pi^N, and at simple zeros q_Mj of det."""
    j, count, g = sp.Symbol("j", integer=True), sp.Symbol("n", integer=True), sp.Function("g")
    pole, total, at_zero = (
        sp.IndexedBase("q_M")[j],
        sp.S(0),
        with_equal_masses(charact.statement.rhs, masses).subs(q, 0),
    )
    slope = ((q - pole) * g(q)).diff(q).subs(q, pole)
    for residue in residues.statement.rhs.atoms(sp.Function("Res")):
        term = residue.args[0]
        steady = (term * q).subs(q, 0).subs(det(0), at_zero)
        harmonic = (term.subs(det(q), (q - pole) * g(q)) * (q - pole)).subs(q, pole)
        total += steady + sp.Sum(harmonic.subs(slope, sp.Function("det_q")(pole)), (j, 1, count))
    note = "Steady part (q = 0) and one harmonic for each induced frequency. The print has eta_Mu for eta_M."
    return Step("(36)", "Steady and harmonic parts", sp.Eq(what(xi, tau), total), note)


# The whole derivation, and the formulas that the numerical code is compared with


def _motion(masses: int) -> tuple[Step, ...]:
    motion, load_, velocity, acceleration = (
        mo.equation_of_motion(),
        mo.loading(masses),
        mo.contact(1),
        mo.contact(2),
    )
    field = mo.loading_field(load_, acceleration, masses)
    fixed = mo.governing(motion, field)
    moving = mo.moving_frame(fixed)
    scale, beam, loads = mo.scales(), mo.beam_ratios(), mo.load_ratios(masses)
    final = mo.dimensionless(moving, scale, beam, loads)
    return motion, load_, velocity, acceleration, field, fixed, moving, scale, beam, loads, final


@lru_cache(maxsize=1)
def _any_masses(D: Step, kernel: Step) -> tuple[Step, ...]:
    return (*kernel_steps(kernel), real_wavenumber(D), damping_rescaling(D))


@lru_cache(maxsize=8)
def derivation(masses: int = 2) -> tuple[Step, ...]:
    """Every step for `masses` masses, in the order in which each follows from those before it."""
    if masses < 1:
        raise InputError("masses", f"is {masses}: give one mass or more")
    steps = _motion(masses)
    rules = st.laplace_rules()
    image = st.laplace(steps[-1], rules, masses)
    direct, inverse = st.fourier_pair()
    D, spectrum, kernel = st.dispersion_function(image), st.fourier(image), st.kernel_integral()
    force, by_kernels = st.forces(spectrum, masses), st.displacement_image(spectrum, masses)
    rows = st.at_masses(by_kernels, masses)
    system = st.linear_system(rows, masses)
    charact, solved = st.determinant(system), st.mass_displacements(system, masses)
    general = st.displacement(by_kernels, solved, charact, masses)
    equal = st.displacement_equal(general, force, masses)
    residues = residue_sum(equal)
    return (
        *steps, rules, image, direct, spectrum, D, inverse, kernel, force, by_kernels, rows, system, charact,
        st.normalised_determinant(system, masses), solved, general, equal,
        *((st.equal_factors(system),) if masses == 2 else ()),
        inversion(), *limiting_velocity(D), residues, harmonic_sum(residues, charact, masses),
        *_any_masses(D, kernel),
    )  # fmt: skip


def _step(number: str, masses: int = 1) -> Step:
    return next(step for step in derivation(masses) if step.number == number)


def dispersion() -> Formula:
    """D of (18) in (p, q, alpha, eta_b, eta_N, eta_S)."""
    return Formula(_step("(18)").statement.rhs, (p, q, alpha, eta_b, eta_N, eta_S))


def characteristic(masses: int = 2) -> Formula:
    """det of (26) in (q, (eta_M1, ...), ((K_11, K_12, ...), ...)), K_ij = K(x_i - x_j, q).

    The characteristic function of the numerical code is Delta = det/pi^masses, see (A1).
    """
    matrix = _step("(25)", masses).statement.lhs.args[0].as_mutable()
    order = range(1, masses + 1)
    rows = tuple(tuple(sp.Symbol(f"K_{i}{j}") for j in order) for i in order)
    for i, here in enumerate(positions(masses)):
        for j, there in enumerate(positions(masses)):
            matrix[i, j] = matrix[i, j].subs(K(here - there, q), rows[i][j])
    determinant_ = sp.expand(matrix.det(method="berkowitz"))
    return Formula(determinant_, (q, mo.numbered("eta_M", masses), rows))
