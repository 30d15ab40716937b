"""What Sections 2, 3 and 4.1 say in passing of the beam, its frequencies and its matrices: by exact identities."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import shown
from mpsolve.problem.case import Case

from .derivation import dispersion
from .limits import limiting_frequency
from .modal import MATRICES, entry
from .theory import undamped_roots_are_real

_p, _q, _alpha, _eta_b, _axial, _shear = dispersion().arguments
_D = dispersion().expression


def _same(a: Any, b: Any) -> bool:
    return bool(sp.expand(a - b) == 0)


def _judged(right: bool, sentence: str, otherwise: str) -> Finding:
    return Finding(Verdict.PROVED, sentence) if right else Finding(Verdict.REFUTED, otherwise)


def pasternak_is_axial(claim: Claim) -> Finding:
    """Section 2: what axial force the Pasternak modulus stands for: D is a function of η_N − η_S, or of η_N + η_S."""
    sign = {"tension": -1, "compression": 1}[claim.number("force")]
    alone = _D.subs({_shear: 0, _axial: _axial + sign * _shear}, simultaneous=True)
    return _judged(_same(_D, alone), "D depends on η_N − η_S only (identity).", "D depends on η_N − η_S.")


def buckling(claim: Claim) -> Finding:
    """After (11): N_cr is where the static stiffness EI p⁴ − N p² + k of a wave first vanishes."""
    square, N, EI, k = sp.symbols("s N EI k", positive=True)
    forces = sp.solve(sp.discriminant(EI * square**2 - N * square + k, square), N)
    factor = Fraction(claim.number("factor"))
    right = [_same(force, sp.Rational(factor.numerator, factor.denominator) * sp.sqrt(k * EI)) for force in forces]
    sentence = "EI p⁴ − N p² + k has its first real zero at N = 2√(kEI), where its discriminant vanishes (exact)."
    return _judged(right == [True], sentence, "EI p⁴ − N p² + k has its first real zero at N = 2√(kEI).")


def beam_frequency(claim: Claim) -> Finding:
    """After (11): whether axial force and Pasternak modulus leave the beam's frequency as it is."""
    uniform = _same(_D.subs({_p: 0, _eta_b: 0}), 4 - 4 * _q**2)
    numbers, lower = [], []
    for axial in claim.values("eta_n"):
        least = limiting_frequency(Case(alpha="0", eta_b="0", eta_m="1", eta_n=axial))
        numbers.append((f"η_N − η_S = {axial}: lowest frequency of a free wave over √(k/m)", shown(least, 12)))
        lower += [axial] if least < 1 else []
    if not uniform:
        return Finding(Verdict.REFUTED, "The beam as a whole has another frequency.", numbers)
    if not lower:
        return Finding(Verdict.PROVED, "No wave is slower than the beam as a whole here.", numbers)
    sentence = (
        "For the beam as a whole (p = 0) it is √(k/m), whatever the axial force (identity). But under compression, "
        f"η_N − η_S = {', '.join(lower)}, waves with p² = 2(η_N − η_S) have the lower frequency √(1 − (η_N − η_S)²)."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)


def axial_force_and_frequency(claim: Claim) -> Finding:
    """Section 4.1: what the axial force does to the square of a natural frequency, (p⁴ − 4Np² + 4)/4."""
    square = sp.solve(_D.subs({_alpha: 0, _eta_b: 0}), _q**2)
    slopes = [sp.sign(sp.diff(square[0], by).subs(_p, sp.Symbol("p", positive=True))) for by in (_axial, _shear)]
    expected = {"decreases": [-1, 1], "increases": [1, -1]}[claim.number("way")]
    sentence = "q² = (p⁴ − 4(η_N − η_S)p² + 4)/4 falls with η_N and grows with η_S, for every p ≠ 0 (exact)."
    return _judged(slopes == expected, sentence, sentence)


def not_symmetrical(claim: Claim) -> Finding:
    """Section 4.1: which of the printed matrices (42) to (44) differ from their transpose."""
    texts = {name: claim.at[name][0] for name in ("M", "C", "K")}
    wrong = [name for name, text in texts.items() if not _same(entry(text, 1, 2), entry(text, 2, 1))]
    sentence = f"Not equal to their transpose: {', '.join(wrong) or 'none'} (exact, entries 12 and 21)."
    return _judged(tuple(wrong) == claim.values("matrices"), sentence, sentence)


def doubled_roots(claim: Claim) -> Finding:
    """After (38): of which function all p-roots are double."""
    power = int(claim.number("power"))
    distinct = sp.discriminant(_D.subs({_axial: 0, _shear: 0}), _p) != 0
    double = power == 2 and distinct
    if double:
        return Finding(Verdict.PROVED, "D² has each of the four roots of D twice; the discriminant of D is not 0.")
    sentence = (
        "It is D², the denominator of (38), whose roots are double; D itself has four distinct ones in general."
    )
    return Finding(Verdict.SLIP if distinct else Verdict.UNDECIDABLE, sentence)


def four_distinct_roots(claim: Claim) -> Finding:
    """After (39): whether D can have a double p-root at an induced frequency."""
    proof, known = undamped_roots_are_real(), sp.symbols("x y", real=True)
    twice = sp.Poly(sp.expand((_p**2 - 2 * known[0] * _p + known[0] ** 2 + known[1] ** 2) ** 2), _p)
    even = twice.coeff_monomial(_p**3) == -4 * known[0] and _same(twice.coeff_monomial(_p).subs(known[0], 0), 0)
    linear = _same(sp.Poly(_D.subs(_eta_b, 0), _p).coeff_monomial(_p), 8 * _alpha * _q)
    if claim.number("number") != "four":
        return Finding(Verdict.REFUTED, "D is a quartic: it has four p-roots.")
    if not (proof.holds and even and linear):
        return Finding(Verdict.UNDECIDABLE, "An identity was not confirmed.")
    steps = (
        *proof.steps[-1:],
        "In the gap D is real in p without a real root: its roots are a, ā, b, b̄. Two of them are equal only if "
        "D = ((p − x)² + y²)². Its p³ term −4x p³ asks for x = 0, and then its p term is 0 [identities].",
        "The p term of D is 8αq p [identity], and q = 0 is no root of Δ (Δ(0) = 1): no double root for α > 0.",
    )
    sentence = (
        "Proved without damping below α_C, for α > 0. Elsewhere two upper p-roots, or two lower ones, may meet at "
        "some q; nothing keeps an induced frequency from it, and there (37) and (39), for simple poles, do not hold."
    )
    return Finding(Verdict.CONDITIONAL, sentence, steps=steps)


_AFTER_11 = "Section 3, after Eq. (11)"

CLAIMS = (
    Claim(
        "2-pasternak", "Section 2, after Eq. (1)",
        "The Pasternak modulus has the same effect as the {force} axial force.",
        pasternak_is_axial, {"force": ("tension",)},
    ),
    Claim(
        "3-buckling", _AFTER_11, "N_cr = {factor}√(kEI) is the buckling critical force.", buckling, {"factor": ("2",)}
    ),
    Claim(
        "3-frequency", _AFTER_11,
        "The frequency of the infinite beam, independently of the Pasternak modulus and axial force, is √(k/m).",
        beam_frequency, {}, {"eta_n": ("-0.5", "0.5")},
    ),
    Claim(
        "3-doubled", "Section 3, after Eq. (38)", "All roots of D(p, q) are duplicated (D to the power {power}).",
        doubled_roots, {"power": ("1",)},
    ),
    Claim(
        "3-distinct", "Section 3, after Eq. (39)",
        "The induced frequencies are always located within the regions where D(p, q) has {number} distinct complex "
        "roots.",
        four_distinct_roots, {"number": ("four",)},
    ),
    Claim(
        "4.1-axial", "Section 4.1, after Eq. (45)",
        "The axial force {way} the natural frequency, whereas the Pasternak modulus has the opposite effect.",
        axial_force_and_frequency, {"way": ("decreases",)},
    ),
    Claim(
        "4.1-symmetry", "Section 4.1, after Eq. (45)", "The matrices {matrices} are not symmetrical.",
        not_symmetrical, {"matrices": ("C", "K")}, MATRICES,
    ),
)  # fmt: skip
