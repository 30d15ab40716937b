"""Section 4.3 and conclusions (iv), (v), (vi), (x): two equal masses, and one, with damping."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import Any

from mpsolve import onset as proved_onset
from mpsolve import unstable_ranges
from mpsolve.certificate.format import Certificate
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, decimal, first_on_grid, grid, places, shown
from mpsolve.errors import PrecisionError

from .cases import certificate, lowest, pair, single, spectrum
from .limits import critical_velocity_ratio
from .theory import one_damped_mass_is_stable

_DIGITS = 20


@lru_cache(maxsize=64)
def onset(eta_b: str, eta_m: str, d: str | None, alpha: tuple[str, str] = ("0", "2")) -> Any:
    """The proved onset (`Onset`); d None: one mass. PrecisionError if it is open."""
    case = single("0.5", eta_b, eta_m) if d is None else pair("0.5", eta_b, eta_m, d)
    found = proved_onset(case, over={"v": alpha}, digits=_DIGITS)
    if not found.proved:
        raise PrecisionError(str(found.reason))
    if found.value is None:
        raise PrecisionError(f"no onset lies between α = {alpha[0]} and {alpha[1]}")
    return found


def onsets_on_the_grid(claim: Claim) -> Finding:
    """Section 4.3: the first unstable α of the grid for each distance."""
    eta_b, eta_m = claim.number("eta_b"), claim.number("eta_m")
    numbers, wrong, certificates = [], [], []
    alpha_C = critical_velocity_ratio(pair("0", eta_b, eta_m, "1"))
    step = Fraction(1, 10 ** min(places(printed) for printed in claim.values("alpha")))
    for d, printed in zip(claim.values("d"), claim.values("alpha"), strict=True):
        found = onset(eta_b, eta_m, d)
        first = first_on_grid(found.value, step)
        if not spectrum(pair(decimal(first), eta_b, eta_m, d)).unstable:
            return Finding(Verdict.UNDECIDABLE, f"d = {d}: stable again at {decimal(first)}, next above the onset.")
        numbers.append((f"d = {d}: stable below α", shown(found.value, 18)))
        if first != Fraction(printed) or not below(found.value, alpha_C):
            wrong.append(f"d = {d}: printed {printed}, proved {decimal(first)}")
        certificates.append((f"{claim.id}_d{d}", found.certificate))
        certificates += [
            (f"{claim.id}_d{d}_alpha{alpha}", certificate(pair(alpha, eta_b, eta_m, d)))
            for alpha in (decimal(first - step), decimal(first))
        ]
    numbers.append(("α_C", shown(alpha_C, 12)))
    if wrong:
        return Finding(Verdict.REFUTED, "; ".join(wrong), numbers, certificates=certificates)
    sentence = f"The printed α are the first unstable ones of the grid {decimal(step)}; all below are proved stable."
    return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)


def damping_destabilises(claim: Claim) -> Finding:
    """Conclusion (x): an onset below α_C, where without damping nothing is unstable."""
    eta_b, eta_m, d = claim.numbers("eta_b", "eta_m", "d")
    found, case = onset(eta_b, eta_m, d), pair("0", eta_b, eta_m, d)
    sub = below(found.value, critical_velocity_ratio(case)) and below(found.value, 1)
    numbers = (
        ("onset α", shown(found.value, 18)),
        ("α_C", shown(critical_velocity_ratio(case), 12)),
        ("q there", shown(found.q, 15)),
    )
    certificates = [(f"{claim.id}_onset", found.certificate)]
    if sub == (claim.number("range") == "subcritical"):
        sentence = (
            "Certified example of Section 4.3; without damping the same masses are stable for every α < 1 (theorem)."
        )
        return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)
    return Finding(Verdict.REFUTED, "The onset lies on the other side of α_C.", numbers, certificates=certificates)


def one_mass_is_supercritical(claim: Claim) -> Finding:
    """Section 4.4: damping always shifts the onset of one mass into the supercritical range."""
    proof, numbers, certificates, wrong = one_damped_mass_is_stable(), [], [], []
    for eta_m in claim.values("eta_m"):
        found = onset(claim.number("eta_b"), eta_m, None)
        numbers.append((f"η_M = {eta_m}: onset α", shown(found.value, 15)))
        certificates.append((f"{claim.id}_eta{eta_m}", found.certificate))
        if not below(1, found.value):
            wrong.append(eta_m)
    if wrong or claim.number("range") != "supercritical":
        return Finding(Verdict.REFUTED, f"Onset for η_M = {', '.join(wrong)} below 1.", numbers, proof.steps)
    sentence = "One damped mass is stable at every α ≤ 1, for every η_M and every η_b > 0 (N = 0): theorem."
    verdict = Verdict.PROVED if proof.holds else Verdict.UNDECIDABLE
    return Finding(verdict, sentence, numbers, proof.steps, certificates=certificates)


def one_mass_onset_grows(claim: Claim) -> Finding:
    """Section 4.3: for one mass a higher η_b gives a larger onset α."""
    numbers, wrong = [], []
    certificates: list[tuple[str, Certificate | None]] = []
    for eta_m in claim.values("eta_m"):
        onsets = [(eta_b, onset(eta_b, eta_m, None)) for eta_b in claim.values("eta_b")]
        certificates += [(f"{claim.id}_eta{eta_m}_eta_b{b}", at.certificate) for b, at in onsets]
        found = [(eta_b, at.value) for eta_b, at in onsets]
        wrong += [f"η_M = {eta_m}, η_b = {b}" for (_, x), (b, y) in pairwise(found) if not below(x, y)]
        numbers += [(f"η_M = {eta_m}, η_b = {b}: onset α", shown(x, 12)) for b, x in found]
    if wrong:
        sentence = f"The onset does not grow at {'; '.join(wrong)}."
        return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
    sentence = (
        "The proved onsets grow along this list of damping ratios, for each mass; between them it is not proved."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


def never_real(claim: Claim) -> Finding:
    """Section 4.3: in the damped case the imaginary part is always non-zero."""
    found = onset(claim.number("eta_b"), claim.number("eta_m"), claim.number("d"))
    alpha_C = critical_velocity_ratio(pair("0", claim.number("eta_b"), claim.number("eta_m"), claim.number("d")))
    numbers = (("α", shown(found.value, 18)), ("q (real)", shown(found.q, 18)), ("α_C", shown(alpha_C, 12)))
    sentence = "At the onset itself a pair of induced frequencies is real: that is what an onset is."
    return Finding(Verdict.REFUTED, sentence, numbers, certificates=[(claim.id, found.certificate)])


def stable_and_unstable(claim: Claim) -> Finding:
    """Which graphs of a figure show instability, one velocity ratio at a time."""
    eta_b, eta_m = claim.number("eta_b"), claim.number("eta_m")
    numbers, found = [], []
    certificates: list[tuple[str, Certificate | None]] = []
    for alpha in claim.values("alpha"):
        for d in grid(claim.number("d")):
            case = pair(alpha, eta_b, eta_m, d)
            unstable = spectrum(case).unstable
            numbers.append((f"α = {alpha}, d = {d}: least Im q", shown(lowest(case), 10)))
            certificates.append((f"{claim.id}_alpha{alpha}_d{d}", certificate(case)))
            if unstable:
                found.append(f"{alpha} {d}")
    good = tuple(found) == claim.values("unstable")
    sentence = f"Unstable (α, d): {'; '.join(found) or 'none'}; the others are stable."
    return Finding(Verdict.PROVED if good else Verdict.REFUTED, sentence, numbers, certificates=certificates)


def heavier_decays_slower(claim: Claim) -> Finding:
    """Section 4.3: the decrease of the amplitudes is slower for a higher η_M."""
    eta_b = claim.number("eta_b")
    light, heavy = claim.values("eta_m")
    numbers, wrong = [], []
    certificates: list[tuple[str, Certificate | None]] = []
    for alpha in claim.values("alpha"):
        for d in claim.values("d"):
            cases = [pair(alpha, eta_b, m, d) for m in (light, heavy)]
            least = [lowest(case) for case in cases]
            numbers.append((f"α = {alpha}, d = {d}: least Im q", f"{shown(least[0], 8)}, {shown(least[1], 8)}"))
            falls = below(least[1], least[0])
            wrong += [] if falls else [f"α = {alpha}, d = {d}"]
            if not falls or d == claim.values("d")[-1]:
                certificates += [
                    (f"{claim.id}_alpha{alpha}_eta{m}_d{d}", certificate(case))
                    for m, case in zip((light, heavy), cases, strict=True)
                ]
    if wrong:
        sentence = f"Not at {'; '.join(wrong)}."
        return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
    sentence = (
        "Certified at all of these cases, each with the same α, d and η_b for both masses; "
        "as a general statement it is not proved."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


def lighter_masses_stay_stable(claim: Claim) -> Finding:
    """Section 4.3: onset below α_c 'when η_M = 70': the lighter masses of Figure 9b have none."""
    eta_b, eta_m = claim.number("eta_b"), claim.number("eta_m")
    numbers, wrong, certificates = [], [], []
    for d in claim.values("d"):
        found = unstable_ranges(pair("0.5", eta_b, eta_m, d), over={"v": (0, claim.number("alpha"))}, digits=15)
        if not found.proved:
            return Finding(Verdict.UNDECIDABLE, str(found.reason))
        numbers.append((f"d = {d}: unstable ranges below α = {claim.number('alpha')}", str(len(found.intervals))))
        certificates.append((f"{claim.id}_d{d}", found.certificate))
        if found.intervals:
            wrong.append(f"d = {d}: from α = {shown(found.intervals[0].start, 10)}")
    if wrong:
        return Finding(Verdict.REFUTED, "; ".join(wrong), numbers, certificates=certificates)
    sentence = "Proved stable on the whole range, at each of the distances."
    return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)
