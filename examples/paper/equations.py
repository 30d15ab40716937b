"""Equations (1) to (39): each as printed against the derivation, symbolically and exactly.

A printed equation is a text that sympy reads; it is right if its balance (left minus right) is that of the derived
statement. If not, and the corrected text is right, the print has a slip.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.parsing.sympy_parser import parse_expr

from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import shown
from mpsolve.derivation.step import Step
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.problem.case import Case

from .cases import certificate, pair, spectrum
from .derivation import derivation
from .derivation import motion as st
from .derivation import residues as rs
from .harmonic import harmonic
from .limits import limiting_frequency

_SYMBOLS = (
    "x s t tau T a EI m k v chi v_cr w_st P N k_p c_b eta_b eta_N eta_S eta_M eta_C q_lm qbar w what Wtilde W det"
)
_KERNEL = "p q xi alpha K K_q D"


def _names() -> dict[str, Any]:
    names: dict[str, Any] = {name: getattr(st, name) for name in _SYMBOLS.split()}
    names |= {name: getattr(rs, name) for name in _KERNEL.split()}
    names |= {f"p_{k}": root for k, root in enumerate(rs.roots, 1)}
    for name in ("eta_M", "eta_C", "eta_A", "omegahat_f"):
        names |= {str(symbol): symbol for symbol in st.numbered(name, 2)}
    names |= {"x_2": st.positions(2)[1], "d_2": st.positions(2, "d_")[1], "load": st.load, "delta": sp.DiracDelta}
    names |= {
        name: sp.Function(name)
        for name in ("F", "w_01", "w_02", "w_0j", "F_1", "F_2", "D_q", "D_pp", "D_ppp", "h_pp", "h_ppp")
    }
    return names | {"d": lambda f, *by: f.diff(*by), "D_p": _slope}


def _slope(root: Any) -> Any:
    """D_{,p} at a root of the monic quartic."""
    return sp.prod(rs.p - other for other in rs.roots).diff(rs.p).subs(rs.p, root)


def read(text: str) -> Any:
    """left = right as left − right; a text without '=' as it stands."""
    parts = [parse_expr(part, local_dict=_names()) for part in text.split("=")]
    return parts[0] - parts[1] if len(parts) == 2 else parts[0]


def vanishes(expression: Any) -> bool:
    """Zero as a rational function of everything that is in it: exact, never numerical."""
    expanded = sp.expand(expression)
    return bool(expanded == 0 or sp.expand(sp.numer(sp.together(expanded))) == 0)


def statements(step: Step) -> list[Any]:
    """The balances of a step, row by row."""
    parts = step.statement if isinstance(step.statement, tuple) else (step.statement,)
    found = []
    for part in parts:
        if isinstance(part.lhs, sp.MatMul):
            found += list(part.lhs.doit() - part.rhs)
        else:
            found.append(part.lhs - part.rhs)
    return found


def derived(number: str) -> Step:
    return next(step for step in derivation(2) if step.number == number)


def holds(texts: tuple[str, ...], balances: list[Any]) -> bool:
    """Whether each text is one of the derived balances."""
    return all(any(vanishes(read(text) - balance) for balance in balances) for text in texts)


def equation(claim: Claim) -> Finding:
    """As printed, and as corrected, against the derivation."""
    steps = [derived(source) for source in claim.values("source")]
    balances = [balance for step in steps for balance in statements(step)]
    return judged(claim, lambda texts: holds(texts, balances), steps[0].note)


def judged(claim: Claim, right: Any, note: str) -> Finding:
    """PROVED as printed, SLIP if only the corrected text is right, else REFUTED."""
    corrected = claim.at.get("corrected", ())
    if right(claim.values("form")):
        return Finding(Verdict.PROVED, "Derived symbolically; the printed form is identical.", steps=(note,))
    if corrected and right(corrected):
        sentence = (
            f"{claim.number('slip')} The corrected form is derived symbolically; the printed one differs from it (if "
            "the machine-read text is faithful)."
        )
        return Finding(Verdict.SLIP, sentence, (("corrected", "; ".join(corrected)),), (note,))
    return Finding(Verdict.REFUTED, "The printed form is not what the derivation gives.", steps=(note,))


def inversion(claim: Claim) -> Finding:
    """(32): integrand and ends of the derived integral."""
    step = derived("(31), (32)")
    integral = step.statement.rhs.args[0]
    _, low, high = integral.limits[0]
    right = [integral.function, low, high]

    def same(texts: tuple[str, ...]) -> bool:
        return all(vanishes(read(text) - value) for text, value in zip(texts, right, strict=True))

    return judged(claim, same, step.note)


def inversion_by_time(claim: Claim) -> Finding:
    """(31): with s = iq and t = τ, integrand and ends are those of the derived (32)."""
    step = derived("(31), (32)")
    integral = step.statement.rhs.args[0]
    _, low, high = integral.limits[0]
    image = sp.Function("F")

    def right(texts: tuple[str, ...]) -> bool:
        inside = read(texts[0]).subs({st.s: sp.I * rs.q, st.t: st.tau}) * sp.I  # ds = i dq
        inside = inside.subs(image(sp.I * rs.q), st.Wtilde(rs.xi, rs.q))
        ends = [-sp.I * read(text) for text in texts[1:]]
        pairs = zip((inside, *ends), (integral.function, low, high), strict=True)
        return all(vanishes(value - expected) for value, expected in pairs)

    return judged(claim, right, step.note)


def branch_of_the_limit(claim: Claim) -> Finding:
    """(33), (34): fourth powers, so that no root's branch is in the way."""
    step = derived(claim.number("source"))
    fourth = sp.expand(step.statement.rhs**4)
    return judged(claim, lambda texts: vanishes(read(texts[0]) ** 4 - fourth), step.note)


def residues(claim: Claim) -> Finding:
    """(35): the sum of the functions of which residues are taken."""
    step = derived("(35)")
    total = sum(term.args[0] for term in step.statement.rhs.atoms(sp.Function("Res")))
    return judged(claim, lambda texts: vanishes(read(texts[0]) - total), step.note)


def harmonics(claim: Claim) -> Finding:
    """(36): the steady part and the summand; and whether they alone are ŵ."""
    step = derived("(36)")
    right = step.statement.rhs
    sums = right.atoms(sp.Sum)
    pole, slope = sp.IndexedBase("q_M")[sp.Symbol("j", integer=True)], sp.Function("det_q")
    summand = sum(part.function for part in sums).subs(slope(pole), sp.Symbol("det_q")).subs(pole, rs.q)
    whole = [right - sum(sums), summand]

    def same(texts: tuple[str, ...]) -> bool:
        return all(vanishes(read(text) - value) for text, value in zip(texts, whole, strict=True))

    found = judged(claim, same, step.note)
    case = pair("0.9", "0.05", "70", "1")
    start = harmonic(case).start
    numbers = (
        *found.numbers,
        ("|right side| at τ = 0, ξ = 0 (α = 0.9, η_b = 0.05, η_M = 70, d = 1)", shown(start, 10)),
    )
    if found.verdict is Verdict.REFUTED:
        return Finding(found.verdict, found.sentence, numbers, found.steps)
    sentence = (
        f"{claim.number('slip')} As an equation for ŵ it also lacks the branch-cut term of (35): at τ = 0 it is not "
        "0, as homogeneous initial conditions ask (certified). It is the harmonic part of ŵ."
    )
    certificates = [(claim.id, certificate(case))]
    return Finding(Verdict.SLIP, sentence, numbers, found.steps, certificates=certificates)


def kernel_slope(claim: Claim) -> Finding:
    """(39): the term of one root, summed over the two upper roots."""
    step = derived("(39)")

    def same(texts: tuple[str, ...]) -> bool:
        term = read(texts[0])
        return vanishes(2 * sp.pi * sp.I * sum(term.subs(rs.p, rs.roots[j]) for j in rs.UPPER) - step.statement.rhs)

    return judged(claim, same, step.note)


def laplace(claim: Claim) -> Finding:
    """(14): the printed integral, on f = τ² e^{−τ}, multiplies by q̄ for each derivative."""
    tau, qbar = st.tau, sp.Symbol("qbar", positive=True)
    f = tau**2 * sp.exp(-tau)

    def right(texts: tuple[str, ...]) -> bool:
        kernel = read(texts[0]).subs(st.qbar, qbar)
        images = [sp.integrate(f.diff(tau, n) * kernel, (tau, 0, sp.oo)) for n in range(3)]
        return all(sp.simplify(images[n] - qbar**n * images[0]) == 0 for n in (1, 2))

    return judged(claim, right, derived("(14)").note)


def fourier(claim: Claim) -> Finding:
    """(16), (19): the printed pair takes e^{−ξ²} to its transform and back."""
    p, xi = sp.Symbol("p", real=True), sp.Symbol("xi", real=True)

    def right(texts: tuple[str, ...]) -> bool:
        there, back = (read(text).subs({rs.p: p, rs.xi: xi}) for text in texts)
        image = sp.integrate(sp.exp(-(xi**2)) * there, (xi, -sp.oo, sp.oo))
        again = sp.integrate(sp.simplify(image) * back, (p, -sp.oo, sp.oo))
        return bool(sp.simplify(again - sp.exp(-(xi**2))) == 0)

    return judged(claim, right, derived("(19)").note)


def one_place(claim: Claim) -> Finding:
    """After (26): at d = 0 it is the characteristic equation of one mass η_M1 + η_M2 (times π)."""
    pair_, total = derived("(26)").statement.rhs, read(claim.number("form"))
    one = sp.pi * (sp.pi - 2 * total * rs.q**2 * rs.K(0, rs.q))
    if vanishes(pair_.subs(st.positions(2)[1], 0) - one):
        return Finding(Verdict.PROVED, "With d = 0 in (26): π times the equation of one mass. Exact identity.")
    return Finding(Verdict.REFUTED, "With d = 0 in (26) another mass comes out.")


def side_of_singularities(claim: Claim) -> Finding:
    """(31): where the poles of the image lie, seen from the line Re q̄ = a."""
    case = pair("0.67", "0.05", "70", "1.5")
    places = [-root.q.imag for root in spectrum(case).roots]
    far = max(places, key=float)
    numbers = (("largest Re q̄ = −Im q of the poles (α = 0.67, η_b = 0.05, η_M = 70, d = 1.5)", shown(far, 12)),)
    certificates = [(claim.id, certificate(case))]
    if claim.number("side") == "left":
        return Finding(Verdict.PROVED, "All poles have Re q̄ < a.", numbers, certificates=certificates)
    sentence = (
        "They lie to the left of the line: the image is analytic for Re q̄ > a, and every pole is at a bounded Re q̄ "
        "(certified example), so 'right' cannot be meant."
    )
    return Finding(Verdict.SLIP, sentence, numbers, certificates=certificates)


def limit_with_damping(claim: Claim) -> Finding:
    """(33), (34): whether they hold for every η_b < 1 when η_N = η_S, as the text says."""
    numbers, right = [], []
    for eta_b in claim.values("eta_b"):
        with precision(128):
            case = Case(alpha="0.5", eta_b=eta_b, eta_m=1)
            q = limiting_frequency(case)
            back = ((8 + 20 * q**2 - q**4 - q * (q**2 + 8) * (q**2 + 8).sqrt()) / 8).sqrt().sqrt()
            numbers.append((f"η_b = {eta_b}, α = 0.5: q_lm", shown(q, 12)))
            numbers.append((f"η_b = {eta_b}: α by (33) at this q_lm", shown(back, 8)))
            right.append(bool(back.overlaps(rational_ball(case.alpha.as_fraction()))))
    if all(right):
        return Finding(Verdict.UNDECIDABLE, "No damping ratio looked at contradicts it.", numbers)
    sentence = (
        "For η_b = 0 only; with damping q_lm is that of the rescaled undamped beam. And (33) is real "
        "for q_lm ≤ 1 only."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)
