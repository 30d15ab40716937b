"""The steps of the derivation from the equation of motion (1) to the sum of residues (36).

Each function takes the steps that its own follows from; sympy computes every statement, nothing is restated.
Any number of masses: x_1 = 0, x_2, ... are their dimensionless positions in the moving frame (x_2 is the
print's d hat), d_1 = 0, d_2, ... the same in metres. Notes are ASCII and name each slip of the print.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from mpsolve.derivation import paper_residues as rs
from mpsolve.derivation.paper_residues import Expr, I, K, alpha, p, q, xi


@dataclass(frozen=True)
class Step:
    """One statement: its number, what it is, the sympy equation (or a tuple of them), and how it follows."""

    number: str
    title: str
    statement: Expr
    note: str


x, s = sp.symbols("x s", real=True)
t, tau, T, a = sp.symbols("t tau T a", positive=True)
EI, m, k, v, chi, v_cr, w_st, P = sp.symbols("EI m k v chi v_cr w_st P", positive=True)
N, k_p, c_b = sp.symbols("N k_p c_b", real=True)
eta_b, eta_N, eta_S, eta_M, eta_C = sp.symbols("eta_b eta_N eta_S eta_M eta_C", real=True)  # noqa: N816
q_lm, qbar, d_j = sp.Symbol("q_lm", positive=True), sp.Symbol("qbar"), sp.Symbol("d_j", real=True)
w, what, Wtilde, W, det = (sp.Function(name) for name in ("w", "what", "Wtilde", "W", "det"))
load = sp.Function("p")(x, t)


def numbered(name: str, masses: int) -> tuple[Expr, ...]:
    """name1, name2, ..., real symbols."""
    return tuple(sp.Symbol(f"{name}{j}", real=True) for j in range(1, masses + 1))


def positions(masses: int, name: str = "x_") -> tuple[Expr, ...]:
    """x_1 = 0, x_2, ... in the moving frame; with name "d_" the same in metres, x_j = chi d_j."""
    return (sp.S(0), *numbered(name, masses)[1:])


def _dirac(place: Expr, masses: int, name: str) -> list[Expr]:
    return [sp.DiracDelta(place - offset) for offset in positions(masses, name)]


def _amplitudes(masses: int) -> tuple[Expr, ...]:
    """F_1, F_2, ... of (22), functions of q."""
    return tuple(sp.Function(f"F_{j}")(q) for j in range(1, masses + 1))


def _split(expression: Expr, keep: Callable[[Expr], bool]) -> tuple[Expr, Expr]:
    """The terms of a sum for which `keep` holds, and the others."""
    terms = sp.Add.make_args(sp.expand_mul(expression))
    return sp.Add(*(e for e in terms if keep(e))), sp.Add(*(e for e in terms if not keep(e)))


def _gather(expression: Expr, field: Expr) -> Expr:
    """A sum linear in `field`, its derivatives and deltas, with the coefficients of each of them together."""
    sums: dict[Expr, Expr] = {}
    for term in sp.Add.make_args(sp.expand_mul(expression)):
        coefficient, factor = term.as_independent(field, sp.DiracDelta, as_Add=False)
        sums[factor] = sums.get(factor, sp.S(0)) + coefficient
    return sp.Add(*(sp.factor_terms(total) * factor for factor, total in sums.items()))


def _by_delta(expression: Expr) -> Expr:
    """A sum of point loads, collected by their deltas."""
    return sp.collect(sp.expand_mul(expression), expression.atoms(sp.DiracDelta))


# The equation of motion and its dimensionless form: (1)-(13)


def equation_of_motion() -> Step:
    """(1)."""
    f = w(x, t)
    beam = EI * f.diff(x, 4) + (N - k_p) * f.diff(x, 2) + m * f.diff(t, 2) + c_b * f.diff(t) + k * f
    note = "Euler-Bernoulli beam, axial force N > 0 in compression, viscoelastic Pasternak foundation. Start."
    return Step("(1)", "Equation of motion", sp.Eq(beam, load), note)


def loading(masses: int) -> Step:
    """(2) with the second time derivative of the mass displacements w_0j."""
    total = sp.S(0)
    for j, delta in enumerate(_dirac(x - v * t, masses, "d_"), start=1):
        P_C, P_A, M, frequency, phase = (sp.Symbol(f"{n}{j}") for n in ("P_C", "P_A", "M_", "omega_f", "phi_f"))
        force = P_C + P_A * sp.exp(I * (frequency * t + phase + 3 * sp.pi / 2))
        total += (force - M * sp.Function(f"w_0{j}")(t).diff(t, 2)) * delta
    note = "Forces and inertia at x_j = v t + d_j, d_1 = 0. The print has w_{0j,t} for w_{0j,tt}."
    return Step("(2)", "Loading", sp.Eq(load, total), note)


def contact(order: int) -> Step:
    """(3)-(6): the time derivatives of w_0j(t) = w(v t + d_j, t) by the chain rule, at x = v t + d_j."""
    derivative = w(v * t + d_j, t).diff(t, order).subs(d_j, x - v * t).doit()
    number, what_ = ("(3), (5)", "velocity") if order == 1 else ("(4), (6)", "acceleration")
    statement = sp.Eq(sp.Function("w_0j")(t).diff(t, order), sp.expand(derivative))
    return Step(number, f"Mass {what_}", statement, "Tight contact, w_0j(t) = w(x_j, t); right side at x = x_j.")


def loading_field(load_: Step, acceleration: Step, masses: int) -> Step:
    """(7): (4) and (6) put into (2)."""
    known = {sp.Function(f"w_0{j}")(t).diff(t, 2): acceleration.statement.rhs for j in range(1, masses + 1)}
    statement = sp.Eq(load, load_.statement.rhs.xreplace(known))
    note = "(4), (6) in (2); f(x_j) delta(x - x_j) = f(x) delta(x - x_j). The print has omega_j for omega_fj."
    return Step("(7)", "Loading in the displacement field", statement, note)


def governing(motion: Step, load_: Step) -> Step:
    """(8): (7) put into (1), the mass terms moved to the left."""
    balance = motion.statement.lhs - motion.statement.rhs.subs(load, load_.statement.rhs)
    field, force = _split(balance, lambda e: e.has(w))
    note = "(7) in (1): each mass has an inertial, a Coriolis and a centrifugal force."
    return Step("(8)", "Governing equation", sp.Eq(_gather(field, w), _by_delta(-force)), note)


def moving_frame(equation: Step) -> Step:
    """(9): s = x - v t by the chain rule."""
    moved = sp.Function("moved")
    balance = equation.statement.lhs - equation.statement.rhs
    balance = balance.subs(w(x, t), moved(x - v * t, t)).doit().subs(x, s + v * t).doit()
    point, beam = _split(balance.replace(moved, w), lambda e: e.has(sp.DiracDelta))
    note = "s = x - v t in (8): w_{,x} = w_{,s}, w_{,t} = w_{,t} - v w_{,s}. Only M_j w_{,tt} stays."
    return Step("(9)", "Moving coordinate", sp.Eq(_gather(beam, w), _by_delta(-point)), note)


def scales() -> Step:
    """(10)."""
    wave = sp.Eq(chi, (k / (4 * EI)) ** sp.Rational(1, 4))
    speed = sp.Eq(v_cr, (4 * k * EI / m**2) ** sp.Rational(1, 4))
    fields = sp.Eq(xi, chi * s), sp.Eq(tau, chi * v_cr * t), sp.Eq(what(xi, tau), w(s, t) / w_st)
    note = "Scales of length, time, displacement. P is a reference force, P_C1 in the print."
    return Step("(10)", "Scales", (*fields, wave, speed, sp.Eq(w_st, P * chi / (2 * k))), note)


def beam_ratios() -> Step:
    """(11)."""
    force = 2 * sp.sqrt(k * EI)
    pairs = sp.Eq(eta_b, c_b / (2 * sp.sqrt(m * k))), sp.Eq(eta_N, N / force), sp.Eq(eta_S, k_p / force)
    return Step(
        "(11)", "Damping ratio, axial force, Pasternak modulus", pairs, "Definitions. The print has eta_s for eta_S."
    )


def load_ratios(masses: int) -> Step:
    """(12), and the positions and frequencies of (10) for each mass."""
    pairs = [sp.Eq(alpha, v / v_cr)]
    for j in range(1, masses + 1):
        scaled = (("eta_C", "P_C", 1 / P), ("eta_A", "P_A", 1 / P), ("eta_M", "M_", chi / m))
        pairs += [sp.Eq(sp.Symbol(f"{new}{j}", real=True), sp.Symbol(f"{old}{j}") * by) for new, old, by in scaled]
        frequency = sp.Symbol(f"omega_f{j}") / (chi * v_cr)
        pairs.append(sp.Eq(sp.Symbol(f"omegahat_f{j}", real=True), frequency))
    lengths = zip(positions(masses)[1:], positions(masses, "d_")[1:], strict=True)
    pairs += [sp.Eq(new, chi * old) for new, old in lengths]
    return Step("(12)", "Velocity, force and mass ratios", tuple(pairs), "Definitions; x_j = chi d_j.")


def dimensionless(equation: Step, scale: Step, beam: Step, loads: Step) -> Step:
    """(13): (10)-(12) put into (9), divided by the coefficient of the fourth derivative."""
    balance = equation.statement.lhs - equation.statement.rhs
    balance = balance.replace(w, lambda s_, t_: w_st * what(chi * s_, t_)).doit().subs(s, xi / chi).doit()
    balance = (
        balance.replace(what, lambda xi_, t_: what(xi_, chi * v_cr * t_)).doit().subs(t, tau / (chi * v_cr)).doit()
    )
    physical = {e for eq in (*beam.statement, *loads.statement) for e in eq.rhs.free_symbols}
    physical -= {chi, v_cr, P, m, k, EI}
    for eq in (*beam.statement, *loads.statement):
        (old,) = eq.rhs.free_symbols & physical
        balance = balance.subs(old, sp.solve(eq, old)[0])
    wave, speed, static = scale.statement[3:]
    for eq in (static, speed):
        balance = balance.subs(eq.lhs, eq.rhs)
    balance = balance.subs(k, sp.solve(wave, k)[0])
    balance = sp.expand_mul(balance.expand(diracdelta=True, wrt=xi, power_exp=False, power_base=False))
    balance = sp.expand_mul(balance / balance.coeff(what(xi, tau).diff(xi, 4)))
    point, field = _split(balance, lambda e: e.has(sp.DiracDelta))
    note = "(10)-(12) in (9), delta(s - d_j) = chi delta(xi - x_j), divided by EI chi^4 w_st."
    return Step("(13)", "Dimensionless governing equation", sp.Eq(_gather(field, what), _by_delta(-point)), note)


# The transforms and the solution in the transformed domain: (14)-(30)


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
    for delta in _dirac(xi, masses, "x_"):
        field, force = _split(equation.statement.rhs.coeff(delta), lambda e: e.has(what))
        point += (sp.laplace_transform(force, tau, qbar, noconds=True) + _image(field, rules)) * delta
    beam = _image(equation.statement.lhs, rules)
    statement = sp.Eq(_gather(beam.subs(qbar, I * q), Wtilde), sp.expand_mul(point.subs(qbar, I * q)))
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
    parts = [_split(load_, lambda e: e.has(Wtilde))[1] for load_ in _loads(spectrum, masses)]
    pairs = (sp.Eq(F, sp.expand_mul(part / 2)) for F, part in zip(_amplitudes(masses), parts, strict=True))
    return Step("(22)", "Force amplitudes", tuple(pairs), "Read off (17).")


def displacement_image(spectrum: Step, masses: int) -> Step:
    """(20): (19) on (17), term by term: e^{i p xi} e^{-i p x_j}/D integrates to K(xi - x_j)."""
    total = sp.S(0)
    for place, load_, F in zip(positions(masses), _loads(spectrum, masses), _amplitudes(masses), strict=True):
        inertia, _ = _split(load_, lambda e: e.has(Wtilde))
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
        load_, _ = _split(image.statement.rhs.coeff(K(xi - place, q)), lambda e: e.has(Wtilde))
        force = image.statement.rhs.coeff(K(xi - place, q)) - load_
        numerator = sp.expand(force * charact.statement.rhs + load_.subs(known))
        total += numerator / det(q) * K(xi - place, q)
    note = "(27), (28) in (20); the products of three kernels and one factor pi cancel."
    return Step("(29)", "Transformed displacement", sp.Eq(Wtilde(xi, q), total), note)


def _equal(expression: Expr, masses: int) -> Expr:
    """`expression` with every eta_Mj = eta_M."""
    return expression.subs(dict.fromkeys(numbered("eta_M", masses), eta_M))


def displacement_equal(general: Step, force: Step, masses: int) -> Step:
    """(30): (29) for equal masses under equal constant forces."""
    equal = dict.fromkeys(numbered("eta_A", masses), 0) | dict.fromkeys(numbered("eta_C", masses), eta_C)
    amplitudes = {eq.lhs: eq.rhs.subs(equal) for eq in force.statement}
    common = amplitudes[_amplitudes(masses)[0]]
    total = sp.S(0)
    for place in positions(masses):
        factor = _equal(general.statement.rhs.coeff(K(xi - place, q)), masses).subs(amplitudes)
        total += common * sp.expand(factor * det(q) / common) / det(q) * K(xi - place, q)
    note = "eta_Mj = eta_M, eta_Cj = eta_C, eta_Aj = 0 in (29) and (22)."
    return Step("(30)", "Equal masses and forces", sp.Eq(Wtilde(xi, q), total), note)


def equal_factors(system: Step) -> Step:
    """(A2): the determinant of two equal masses by the eigenvalues of its matrix."""
    values = _equal(system.statement.lhs.args[0], 2).eigenvals(multiple=True)
    note = "Product of the eigenvalues of (25); the square root's branch drops out of the product."
    return Step("(A2)", "Two equal masses factor", sp.Eq(det(q), sp.Mul(*values)), note)


# Inversion, limiting frequency, residues: (31)-(39)


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
    pole, total, at_zero = sp.IndexedBase("q_M")[j], sp.S(0), _equal(charact.statement.rhs, masses).subs(q, 0)
    slope = ((q - pole) * g(q)).diff(q).subs(q, pole)
    for residue in residues.statement.rhs.atoms(sp.Function("Res")):
        term = residue.args[0]
        steady = (term * q).subs(q, 0).subs(det(0), at_zero)
        harmonic = (term.subs(det(q), (q - pole) * g(q)) * (q - pole)).subs(q, pole)
        total += steady + sp.Sum(harmonic.subs(slope, sp.Function("det_q")(pole)), (j, 1, count))
    note = "Steady part (q = 0) and one harmonic for each induced frequency. The print has eta_Mu for eta_M."
    return Step("(36)", "Steady and harmonic parts", sp.Eq(what(xi, tau), total), note)
