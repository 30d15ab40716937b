"""Section 4.3 and conclusion (vi): the lines of Figure 9, two equal masses with damping."""

from __future__ import annotations

import math
from fractions import Fraction

from mpsolve.certificate.format import Certificate
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, decimal, first_on_grid, grid, shown

from .cases import ahead, certificate, cuts, lowest, pair, spectrum

Certificates = list[tuple[str, Certificate | None]]
_STEP = Fraction(1, 100)


def no_duplication(claim: Claim) -> Finding:
    """Section 4.3: with q, only −q̄ is a root, not q̄ and −q as without damping: all roots of a case are compared."""
    numbers, twice = [], []
    certificates: Certificates = []
    for text in claim.values("lines"):
        eta_m, d = text.split()
        for alpha in claim.values("alpha"):
            case = pair(alpha, claim.number("eta_b"), eta_m, d)
            roots = [root.q for root in spectrum(case).roots]
            where = f"α = {alpha}, η_M = {eta_m}, d = {d}"
            twice += [where for x in roots for y in roots if x.conjugate().overlaps(y)]
            numbers.append((f"{where}: roots", str(len(roots))))
            certificates.append((f"{claim.id}_eta{eta_m}_d{d}_alpha{alpha}", certificate(case)))
    if twice:
        sentence = f"A root may be the conjugate of another at {'; '.join(dict.fromkeys(twice))}."
        return Finding(Verdict.UNDECIDABLE, sentence, numbers, certificates=certificates)
    sentence = (
        f"At {len(numbers)} certified cases of Figure 9 no root is the conjugate of a root, so each stands for the "
        "pair q, −q̄ alone; for other parameters it is not proved."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


def rapidly_damped(claim: Claim) -> Finding:
    """Section 4.3: how long the unsteady part of the lighter masses lasts, beside that of the heavy ones."""
    eta_b, numbers, longest = claim.number("eta_b"), [], {}
    certificates: Certificates = []
    for eta_m, distances in zip(claim.values("eta_m"), claim.values("d"), strict=True):
        times = []
        for alpha in claim.values("alpha"):
            for d in grid(distances):
                case = pair(alpha, eta_b, eta_m, d)
                slowest = lowest(case)
                numbers.append((f"η_M = {eta_m}, α = {alpha}, d = {d}: least Im q", shown(slowest, 8)))
                certificates.append((f"{claim.id}_eta{eta_m}_alpha{alpha}_d{d}", certificate(case)))
                times.append(math.log(100) / float(slowest.lower()) if slowest > 0 else math.inf)
        longest[eta_m] = max(times)
    light, heavy = (longest[eta_m] for eta_m in claim.values("eta_m"))
    against = f"{heavy:.0f}" if math.isfinite(heavy) else "never (some grow)"
    sentence = (
        f"'Rapidly' has no number. For η_M = {claim.values('eta_m')[0]} e^(−τ Im q) falls to 1 % within τ = "
        f"{light:.0f} in every case, for η_M = {claim.values('eta_m')[1]}: {against}."
    )
    verdict = Verdict.CONDITIONAL if light < heavy else Verdict.UNDECIDABLE
    return Finding(verdict, sentence, numbers, certificates=certificates)


def usually_cut(claim: Claim) -> Finding:
    """Conclusion (vi): where the lines of Figure 9 end below α_C; the higher one, if the line that goes on is "
    "lower."""
    eta_b = claim.number("eta_b")
    cut: list[str] = []
    not_cut: list[str] = []
    numbers, certificates = [], []
    for text in claim.values("lines"):
        eta_m, d = text.split()
        found = cuts(pair("0.5", eta_b, eta_m, d), claim.number("from"), claim.number("to"))
        name, higher = f"η_M = {eta_m}, d = {d}", False
        for point in found.points:
            after = decimal(first_on_grid(point.value, _STEP))
            case = pair(after, eta_b, eta_m, d)
            left = ahead(case)
            higher = higher or any(below(q.real, point.q.real) for q in left)
            numbers.append(
                (f"{name}: a line ends at α, with Re q", f"{shown(point.value, 10)}, {shown(point.q.real, 8)}")
            )
            numbers.append((f"  left at α = {after}, Re q", "; ".join(shown(q.real, 8) for q in left) or "none"))
            certificates.append((f"{claim.id}_eta{eta_m}_d{d}_alpha{after}", certificate(case)))
        (cut if higher else not_cut).append(name)
    sentence = (
        f"'Usually' has no number. Of the {len(cut) + len(not_cut)} cases of Figure 9, for {claim.number('from')} "
        f"≤ α ≤ {claim.number('to')}, the higher line is cut in {len(cut)} ({'; '.join(cut) or 'none'}); in the "
        f"others ({'; '.join(not_cut) or 'none'}) the lower line is cut, if any, and the higher goes on. Where a "
        "line is cut, it is at Im q = η_b (conclusion (iv))."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


_LINES = ("70 0.5", "70 1", "70 1.5", "10 1.5", "10 3", "10 4.5")
_MODEL = {"eta_b": ("0.05",)}

CLAIMS = (
    Claim(
        "4.3-no-duplication", "Section 4.3, Figure 9",
        "With damping no induced frequency is the conjugate of another.",
        no_duplication, {}, {**_MODEL, "lines": _LINES, "alpha": ("0.5", "0.9", "1.2")},
    ),
    Claim(
        "4.3-rapidly", "Section 4.3, before Figure 11",
        "For η_M = 10 and η_b = {eta_b} the unsteady part of the vibrations is rapidly damped.",
        rapidly_damped, _MODEL,
        {"eta_m": ("10", "70"), "d": ("1.5:1.5:4.5", "0.5:0.5:1.5"), "alpha": ("0.5", "0.8", "0.9")},
    ),
    Claim(
        "vi-cut-damped", "Section 5 (vi)",
        "In the damped case the higher line, too, is usually cut at Im q = η_b.",
        usually_cut, {}, {**_MODEL, "lines": _LINES, "from": ("0.3",), "to": ("0.99",)},
    ),
)  # fmt: skip
