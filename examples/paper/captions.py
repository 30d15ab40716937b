"""Captions against the text, and what the text says of its own symbols, exactly."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import grid, shown
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.problem.case import Case

from .derivation import dispersion
from .equations import derived
from .limits import critical_velocity_ratio

_MACHINE_READ = "If the machine-read text is faithful."


def same_list(claim: Claim) -> Finding:
    """The values that two places give for one thing, as text and caption for a figure."""
    text, caption = (_listed(claim.values(name)) for name in ("text", "caption"))
    if sorted(text, key=Fraction) == sorted(caption, key=Fraction):
        return Finding(Verdict.PROVED, "Both places give the same values.")
    only = sorted(set(text) ^ set(caption), key=Fraction)
    sentence = f"The two places differ: {', '.join(only)} stand in one of them only. {_MACHINE_READ}"
    return Finding(Verdict.SLIP, sentence, (("one", "; ".join(text)), ("the other", "; ".join(caption))))


def _listed(values: tuple[str, ...]) -> tuple[str, ...]:
    """The values, those of first:step:last one by one."""
    return tuple(x for value in values for x in (grid(value) if ":" in value else (value,)))


def distinct_values(claim: Claim) -> Finding:
    """A list in which each value should stand once."""
    values = claim.values("values")
    twice = sorted({x for x in values if values.count(x) > 1}, key=float)
    if not twice:
        return Finding(Verdict.PROVED, "Each value stands once.")
    return Finding(Verdict.SLIP, f"{', '.join(twice)} stands twice: one curve's value is not known. {_MACHINE_READ}")


def distinct_captions(claim: Claim) -> Finding:
    """Panels of one figure with one description."""
    panels = claim.values("panels")
    twice = sorted({x for x in panels if panels.count(x) > 1})
    if not twice:
        return Finding(Verdict.PROVED, "Each panel has its own description.")
    sentence = (
        f"Two panels are described alike ({twice[0]}); Section 4.2 describes real and imaginary parts, or two ranges "
        f"of distance, that these may be. {_MACHINE_READ}"
    )
    return Finding(Verdict.SLIP, sentence)


def first_distance(claim: Claim) -> Finding:
    """Section 4.1: d̂ = 1χ and d̂ = 10χ for a printed χ."""
    chi = Fraction(claim.number("chi"))
    wrong = []
    for factor, printed in zip(claim.values("factor"), claim.values("distance"), strict=True):
        if Fraction(factor) * chi != Fraction(printed):
            wrong.append(f"{factor}χ = {float(Fraction(factor) * chi):g}, printed {printed}")
    if not wrong:
        return Finding(Verdict.PROVED, "Each is the multiple of χ that it says.")
    return Finding(Verdict.SLIP, f"{'; '.join(wrong)}. {_MACHINE_READ}")


def section_that_explains(claim: Claim) -> Finding:
    """Section 4.1 refers to a section for the role of high damping: whether that one has damping at all."""
    named, damped = claim.number("section"), claim.number("damped")
    if named == damped:
        return Finding(Verdict.PROVED, f"Section {damped} is the one on damped cases.")
    return Finding(
        Verdict.SLIP, f"Section {named} has no damping at all; the explanation stands in Section {damped}."
    )


def static_displacement(claim: Claim) -> Finding:
    """After (10): w_st = P χ/(2k) is the largest static displacement: ŵ = 1 at rest."""
    p, factor = sp.Symbol("p", real=True), Fraction(claim.number("factor"))
    rest = (
        dispersion().expression.subs(dict.fromkeys(dispersion().arguments[1:], 0)).subs(dispersion().arguments[0], p)
    )
    kernel = sp.integrate(1 / rest, (p, -sp.oo, sp.oo))  # K(0, 0) at rest; w = (4/π) K(0, 0) P χ/(2k) by (36)
    right = sp.simplify(4 / sp.pi * kernel - 2 * sp.Rational(factor.numerator, factor.denominator)) == 0
    numbers = (("K(0, 0) at rest (exact)", str(kernel)),)
    verdict = Verdict.PROVED if right else Verdict.REFUTED
    return Finding(
        verdict, "By (36) at q = 0 and α = 0 the deflection at the force is (4/π) K(0, 0) P χ/(2k).", numbers
    )


def critical_speed(claim: Claim) -> Finding:
    """After (10): the two forms of v_cr."""
    _, _, _, wave, speed, _ = derived("(10)").statement
    k, m = sp.symbols("k m", positive=True)
    other = sp.sqrt(k / m) / wave.rhs
    printed = Fraction(claim.number("factor"))
    right = sp.simplify(speed.rhs - other * sp.Rational(printed.numerator, printed.denominator)) == 0
    return Finding(
        Verdict.PROVED if right else Verdict.REFUTED, "Exact identity of the two forms." if right else "Not equal."
    )


def sine_phase(claim: Claim) -> Finding:
    """After (2): Re exp(i(x + shift)) = sin x."""
    x, wrong = sp.Symbol("x", real=True), []
    for text in claim.values("shift"):
        value = sp.re(sp.expand_complex(sp.exp(sp.I * (x + sp.sympify(text)))))
        if sp.simplify(sp.expand_trig(value) - sp.sin(x)) != 0:
            wrong.append(text)
    return Finding(
        Verdict.REFUTED if wrong else Verdict.PROVED, f"Not for {', '.join(wrong)}." if wrong else "Exact identity."
    )


def critical_velocities_agree(claim: Claim) -> Finding:
    """Section 3: without damping α_cr,ex = α_C; with damping they differ."""
    numbers, apart = [], []
    for eta_b in claim.values("eta_b"):
        for axial in claim.values("eta_n"):
            case = Case(alpha="0", eta_b=eta_b, eta_m=1, eta_n=axial)
            cut = critical_velocity_ratio(case)
            with precision(128):
                extended = (1 - rational_ball(case.axial.as_fraction())).sqrt()
                same = bool(cut.overlaps(extended))
            numbers.append(
                (f"η_b = {eta_b}, η_N = {axial}: α_C, α_cr,ex", f"{shown(cut, 10)}, {shown(extended, 10)}")
            )
            apart += [] if same else [eta_b]
    if apart:
        return Finding(Verdict.REFUTED, f"They differ for η_b = {', '.join(apart)}.", numbers)
    A, beta, z = sp.symbols("A beta z", positive=True)
    double = sp.expand(sp.discriminant(z**2 - 4 * A * z + 4 * beta**2, z) - 16 * (A - beta) * (A + beta)) == 0
    sentence = (
        "q_lm = 0 where p⁴ − 4Ap² + 4β² has a double root, A = N + α² = β [discriminant]: α_C² = β − N, for η_b = 0 "
        "the same as α_cr,ex² = 1 − N."
    )
    return Finding(Verdict.PROVED if double else Verdict.UNDECIDABLE, sentence, numbers)


_FIGURE_2 = (
    "η_M = 70, d̂ = 0.5:0.5:1.5", "η_M = 40, d̂ = 0.5:0.5:1.5", "η_M = 40, d̂ = 2:0.5:4.5", "η_M = 40, d̂ = 2:0.5:4.5",
    "η_M = 10, d̂ = 0.5:0.5:1.5",
)  # fmt: skip

CLAIMS = (
    Claim("fig-2", "Figure 2, caption", "Induced frequencies: a) to e): {panels}.",
          distinct_captions, {"panels": _FIGURE_2}),
    Claim("fig-10b", "Figure 10, caption", "b) as function of η_M for η_b = {values}.", distinct_values,
          {"values": ("0.05", "0.1", "0.1", "0.5")}),
    Claim("4.1-distances", "Section 4.1", "χ = {chi} 1/m: the tested distances range from {factor} times χ = "
    "{distance}.",
          first_distance, {"chi": ("0.445",), "factor": ("1", "10"), "distance": ("0.455", "4.45")}),
    Claim("4.1-reference", "Section 4.1", "Very high values of η_b are important for the instability analysis, as "
    "explained later in Section {section}.", section_that_explains, {"section": ("4.2",)}, {"damped": ("4.3",)}),
    Claim("3-static", "Section 3, after Eq. (10)", "w_st = {factor} P_C1 χ/k is the maximum static displacement.",
          static_displacement, {"factor": ("1/2",)}),
    Claim("3-v_cr", "Section 3, after Eq. (10)", "v_cr = (4kEI/m²)^(1/4) = {factor} (1/χ)√(k/m).", critical_speed,
          {"factor": ("1",)}),
    Claim("2-sine", "Section 2, after Eq. (2)", "Re exp(i(ωt + φ + shift)) = sin(ωt + φ) with shift "
    "{shift}.", sine_phase,
          {"shift": ("3*pi/2", "-pi/2")}),
    Claim("3-alpha_C", "Section 3", "In the undamped case, α_cr,ex = α_C (η_b = {eta_b}).", critical_velocities_agree,
          {"eta_b": ("0",)}, {"eta_n": ("0", "0.3", "-0.4")}),
)  # fmt: skip
