"""The steps of the derivation from the Laplace transform (14) of the equation of motion to its solution (30).

Each function takes the steps that its own follows from; sympy computes every statement, nothing is restated.
Any number of masses: x_1 = 0, x_2, ... are their dimensionless positions in the moving frame (x_2 is the
print's d hat), d_1 = 0, d_2, ... the same in metres. Notes are ASCII and name each slip of the print.
"""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from mpsolve.derivation.step import Expr, Step

from . import residues as rs
from .motion import W, Wtilde, det, dirac, eta_C, eta_M, gathered, numbered, positions, qbar, split_sum, tau, what
from .residues import I, K, p, q, xi


def _amplitudes(masses: int) -> tuple[Expr, ...]:
    """F_1, F_2, ... of (22), functions of q."""
    return tuple(sp.Function(f"F_{j}")(q) for j in range(1, masses + 1))


@lru_cache(maxsize=1)
def laplace_rules() -> Step:
    """(14): images of the field's time derivatives with homogeneous initial conditions."""
    f, rules = sp.Function("f"), []
    for order in (0, 1, 2):
        image = sp.laplace_transform(f(tau).diff(tau, order), tau, qbar, noconds=True)
        start = {f(0): 0, sp.Subs(f(tau).diff(tau), tau, 0): 0}
        rules.append(
            sp.Eq(sp.LaplaceTransform(f(tau).diff(tau, order), tau, qbar), image.subs(start), evaluate=False)
        )
    return Step("(14)", "Laplace transform", tuple(rules), "f(0) = f_{,tau}(0) = 0; then qbar = i q.")


def _image(expression: Expr, rules: Step) -> Expr:
    """`expression`, linear in the field, with each derivative of the field replaced by its Laplace image."""
    powers = [eq.rhs.coeff(rules.statement[0].lhs) for eq in rules.statement]
    images = {}
    for n, power in enumerate(powers):
        for order in range(5):
            images[what(xi, tau).diff(tau, n).diff(xi, order)] = power * Wtilde(xi, q).diff(xi, order)
    return expression.xreplace(images)


def laplace(equation: Step, rules: Step, masses: int) -> Step:
    """(15): Laplace transform of (13)."""
    point = sp.S(0)
    for delta in dirac(xi, masses, "x_"):
        field, force = split_sum(equation.statement.rhs.coeff(delta), lambda e: e.has(what))
        point += (sp.laplace_transform(force, tau, qbar, noconds=True) + _image(field, rules)) * delta
    beam = _image(equation.statement.lhs, rules)
    statement = sp.Eq(gathered(beam.subs(qbar, I * q), Wtilde), sp.expand_mul(point.subs(qbar, I * q)))
    note = "(14) on (13), qbar = i q; exp(3 i pi/2) = -i."
    return Step("(15)", "Laplace image of the governing equation", statement, note)


def fourier_pair() -> tuple[Step, Step]:
    """(16) and (19)."""
    direct = sp.Integral(Wtilde(xi, q) * sp.exp(-I * p * xi), (xi, -sp.oo, sp.oo))
    inverse = sp.Integral(W(p, q) * sp.exp(I * p * xi), (p, -sp.oo, sp.oo)) / (2 * sp.pi)
    return (
        Step("(16)", "Fourier transform", sp.Eq(W(p, q), direct), "Definition; the print has F on both sides."),
        Step("(19)", "Inverse Fourier transform", sp.Eq(Wtilde(xi, q), inverse), "Definition."),
    )


def dispersion_function(image: Step) -> Step:
    """(18): the left side of (15) applied to e^{i p xi}, divided by e^{i p xi}."""
    applied = image.statement.lhs.subs(Wtilde(xi, q), sp.exp(I * p * xi)).doit()
    note = "The operator of (15) on exp(i p xi): each derivative by xi becomes i p."
    return Step("(18)", "Dispersion function", sp.Eq(rs.D(p, q), sp.expand(applied * sp.exp(-I * p * xi))), note)


def fourier(image: Step) -> Step:
    """(17): Fourier transform of (15), solved for W; the deltas sift."""
    terms = sp.Add.make_args(image.statement.rhs)
    sifted = sum(sp.integrate(term * sp.exp(-I * p * xi), (xi, -sp.oo, sp.oo)) for term in terms)
    note = "(16) on (15), divided by D. In the print the mass terms stand outside 1/D; they belong inside."
    return Step(
        "(17)", "Transformed displacement in the wavenumber domain", sp.Eq(W(p, q), sifted / rs.D(p, q)), note
    )


def kernel_integral() -> Step:
    """(21)."""
    integral = sp.Integral(sp.exp(I * p * xi) / rs.D(p, q), (p, -sp.oo, sp.oo))
    return Step("(21)", "Kernel", sp.Eq(K(xi, q), integral), "Definition: what (19) makes of 1/D, times 2 pi.")


def _loads(spectrum: Step, masses: int) -> list[Expr]:
    """The coefficients of e^{-i p x_j}/D in (17)."""
    waves = [sp.exp(-I * p * place) for place in positions(masses)]
    loads = dict.fromkeys(waves, sp.S(0))
    for term in sp.Add.make_args(spectrum.statement.rhs * rs.D(p, q)):
        amplitude, wave = term.as_independent(p, as_Add=False)
        loads[wave] += amplitude
    return [loads[wave] for wave in waves]


def forces(spectrum: Step, masses: int) -> Step:
    """(22): the force part of (17) at each mass, halved so that (20) has the factor 1/pi."""
    parts = [split_sum(load_, lambda e: e.has(Wtilde))[1] for load_ in _loads(spectrum, masses)]
    pairs = (sp.Eq(F, sp.expand_mul(part / 2)) for F, part in zip(_amplitudes(masses), parts, strict=True))
    return Step("(22)", "Force amplitudes", tuple(pairs), "Read off (17).")


def displacement_image(spectrum: Step, masses: int) -> Step:
    """(20): (19) on (17), term by term: e^{i p xi} e^{-i p x_j}/D integrates to K(xi - x_j)."""
    total = sp.S(0)
    for place, load_, F in zip(positions(masses), _loads(spectrum, masses), _amplitudes(masses), strict=True):
        inertia, _ = split_sum(load_, lambda e: e.has(Wtilde))
        wave = sp.powsimp(sp.exp(I * p * xi) * sp.exp(-I * p * place))
        shifted = sp.expand(wave.exp / (I * p))
        total += (2 * F + inertia) / (2 * sp.pi) * K(shifted, q)
    return Step("(20)", "Laplace image by kernels", sp.Eq(Wtilde(xi, q), total), "(19) on (17), with (21) and (22).")


def at_masses(image: Step, masses: int) -> Step:
    """(23), (24): pi times (20) at each mass."""
    rows = tuple(
        sp.Eq(sp.pi * Wtilde(place, q), sp.expand(sp.pi * image.statement.rhs.subs(xi, place)))
        for place in positions(masses)
    )
    return Step("(23), (24)", "Displacements of the masses", rows, "(20) at xi = x_i, times pi; one row a mass.")


def linear_system(rows: Step, masses: int) -> Step:
    """(25)."""
    unknowns = [Wtilde(place, q) for place in positions(masses)]
    matrix, right = sp.linear_eq_to_matrix([eq.lhs - eq.rhs for eq in rows.statement], unknowns)
    matrix = matrix.applyfunc(lambda e: sp.collect(e, q)).as_immutable()
    left = sp.MatMul(matrix, sp.ImmutableMatrix(unknowns), evaluate=False)
    note = "(23), (24) collected by the unknowns: pi I - 2 q^2 K(x_i - x_j, q) eta_Mj."
    return Step("(25)", "Linear system", sp.Eq(left, right.as_immutable(), evaluate=False), note)


def determinant(system: Step) -> Step:
    """(26)."""
    statement = sp.Eq(det(q), sp.expand(system.statement.lhs.args[0].det(method="berkowitz")))
    return Step(
        "(26)", "Characteristic determinant", statement, "Determinant of (25); det = 0 is the frequency equation."
    )


def normalised_determinant(system: Step, masses: int) -> Step:
    """(A1): det = pi^N det[I - (2 q^2/pi) K_ij eta_Mj]."""
    matrix = (system.statement.lhs.args[0] / sp.pi).applyfunc(sp.expand)
    statement = sp.Eq(det(q), sp.pi**masses * sp.Determinant(matrix))
    return Step(
        "(A1)", "Characteristic function", statement, "pi taken out of each row of (25); the rest is Delta(q)."
    )


def mass_displacements(system: Step, masses: int) -> Step:
    """(27), (28): Cramer's rule on (25)."""
    solution = system.statement.lhs.args[0].adjugate() * system.statement.rhs
    places = zip(positions(masses), solution, strict=True)
    rows = tuple(sp.Eq(Wtilde(place, q), sp.expand(entry) / det(q)) for place, entry in places)
    return Step("(27), (28)", "Displacements of the masses solved", rows, "(25) by its adjugate, with (26).")


def displacement(image: Step, solved: Step, charact: Step, masses: int) -> Step:
    """(29): (27), (28) put into (20), over the common denominator det, where a factor pi cancels."""
    known = {eq.lhs: eq.rhs * det(q) for eq in solved.statement}
    total = sp.S(0)
    for place in positions(masses):
        load_, _ = split_sum(image.statement.rhs.coeff(K(xi - place, q)), lambda e: e.has(Wtilde))
        force = image.statement.rhs.coeff(K(xi - place, q)) - load_
        numerator = sp.expand(force * charact.statement.rhs + load_.subs(known))
        total += numerator / det(q) * K(xi - place, q)
    note = "(27), (28) in (20); the products of three kernels and one factor pi cancel."
    return Step("(29)", "Transformed displacement", sp.Eq(Wtilde(xi, q), total), note)


def with_equal_masses(expression: Expr, masses: int) -> Expr:
    """`expression` with every eta_Mj = eta_M."""
    return expression.subs(dict.fromkeys(numbered("eta_M", masses), eta_M))


def displacement_equal(general: Step, force: Step, masses: int) -> Step:
    """(30): (29) for equal masses under equal constant forces."""
    equal = dict.fromkeys(numbered("eta_A", masses), 0) | dict.fromkeys(numbered("eta_C", masses), eta_C)
    amplitudes = {eq.lhs: eq.rhs.subs(equal) for eq in force.statement}
    common = amplitudes[_amplitudes(masses)[0]]
    total = sp.S(0)
    for place in positions(masses):
        factor = with_equal_masses(general.statement.rhs.coeff(K(xi - place, q)), masses).subs(amplitudes)
        total += common * sp.expand(factor * det(q) / common) / det(q) * K(xi - place, q)
    note = "eta_Mj = eta_M, eta_Cj = eta_C, eta_Aj = 0 in (29) and (22)."
    return Step("(30)", "Equal masses and forces", sp.Eq(Wtilde(xi, q), total), note)


def equal_factors(system: Step) -> Step:
    """(A2): the determinant of two equal masses by the eigenvalues of its matrix."""
    values = with_equal_masses(system.statement.lhs.args[0], 2).eigenvals(multiple=True)
    note = "Product of the eigenvalues of (25); the square root's branch drops out of the product."
    return Step("(A2)", "Two equal masses factor", sp.Eq(det(q), sp.Mul(*values)), note)
