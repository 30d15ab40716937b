"""The equation of motion (1) and its dimensionless form (13): steps of the derivation, each from those before it."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from mpsolve.derivation.step import Expr, Step

from .residues import I, alpha, xi

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


def dirac(place: Expr, masses: int, name: str) -> list[Expr]:
    return [sp.DiracDelta(place - offset) for offset in positions(masses, name)]


def split_sum(expression: Expr, keep: Callable[[Expr], bool]) -> tuple[Expr, Expr]:
    """The terms of a sum for which `keep` holds, and the others."""
    terms = sp.Add.make_args(sp.expand_mul(expression))
    return sp.Add(*(e for e in terms if keep(e))), sp.Add(*(e for e in terms if not keep(e)))


def gathered(expression: Expr, field: Expr) -> Expr:
    """A sum linear in `field`, its derivatives and deltas, with the coefficients of each of them together."""
    sums: dict[Expr, Expr] = {}
    for term in sp.Add.make_args(sp.expand_mul(expression)):
        coefficient, factor = term.as_independent(field, sp.DiracDelta, as_Add=False)
        sums[factor] = sums.get(factor, sp.S(0)) + coefficient
    return sp.Add(*(sp.factor_terms(total) * factor for factor, total in sums.items()))


def by_delta(expression: Expr) -> Expr:
    """A sum of point loads, collected by their deltas."""
    return sp.collect(sp.expand_mul(expression), expression.atoms(sp.DiracDelta))


def equation_of_motion() -> Step:
    """(1)."""
    f = w(x, t)
    beam = EI * f.diff(x, 4) + (N - k_p) * f.diff(x, 2) + m * f.diff(t, 2) + c_b * f.diff(t) + k * f
    note = "Euler-Bernoulli beam, axial force N > 0 in compression, viscoelastic Pasternak foundation. Start."
    return Step("(1)", "Equation of motion", sp.Eq(beam, load), note)


def loading(masses: int) -> Step:
    """(2) with the second time derivative of the mass displacements w_0j."""
    total = sp.S(0)
    for j, delta in enumerate(dirac(x - v * t, masses, "d_"), start=1):
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
    field, force = split_sum(balance, lambda e: e.has(w))
    note = "(7) in (1): each mass has an inertial, a Coriolis and a centrifugal force."
    return Step("(8)", "Governing equation", sp.Eq(gathered(field, w), by_delta(-force)), note)


def moving_frame(equation: Step) -> Step:
    """(9): s = x - v t by the chain rule."""
    moved = sp.Function("moved")
    balance = equation.statement.lhs - equation.statement.rhs
    balance = balance.subs(w(x, t), moved(x - v * t, t)).doit().subs(x, s + v * t).doit()
    point, beam = split_sum(balance.replace(moved, w), lambda e: e.has(sp.DiracDelta))
    note = "s = x - v t in (8): w_{,x} = w_{,s}, w_{,t} = w_{,t} - v w_{,s}. Only M_j w_{,tt} stays."
    return Step("(9)", "Moving coordinate", sp.Eq(gathered(beam, w), by_delta(-point)), note)


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
    point, field = split_sum(balance, lambda e: e.has(sp.DiracDelta))
    note = "(10)-(12) in (9), delta(s - d_j) = chi delta(xi - x_j), divided by EI chi^4 w_st."
    return Step("(13)", "Dimensionless governing equation", sp.Eq(gathered(field, what), by_delta(-point)), note)
