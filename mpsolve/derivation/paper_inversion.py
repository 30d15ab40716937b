"""The inversion (31) to the sum of residues (36): steps of the derivation, each from those before it."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from mpsolve.derivation.paper_motion import Step, T, Wtilde, a, det, eta_b, eta_N, eta_S, q_lm, qbar, tau, what
from mpsolve.derivation.paper_residues import I, alpha, p, q, xi
from mpsolve.derivation.paper_steps import with_equal_masses


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
