"""Conclusions (i) and (iii): two equal masses without damping, above the critical velocity."""

from __future__ import annotations

from itertools import pairwise

from mpsolve.audit.cases import certificate, pair, spectrum
from mpsolve.audit.claims import Claim, Finding, Verdict
from mpsolve.audit.theory import symmetries, undamped_roots_are_real
from mpsolve.audit.values import named, shown
from mpsolve.certificate.format import Certificate
from mpsolve.stability.velocities import UnstableRanges, unstable_velocities

_STRIP = 1.05  # up to where the cuts that join at α_C may leave a range open
_JUST_ABOVE = ("1.01",)


def onset_at_critical(claim: Claim) -> Finding:
    """Conclusion (i) over the box: stable below α_C by the theorem, unstable all the way above it."""
    proof, top = undamped_roots_are_real(), claim.number("alpha")
    stable, undecided, open_to = [], [], 1.0
    certificates: list[tuple[str, Certificate | None]] = []
    for eta_m in claim.values("eta_m"):
        for d in claim.values("d"):
            found = unstable_velocities(0, (eta_m, eta_m), (0, d), alpha=(0, top), digits=15)
            late = [end for _, end in found.unknown]
            open_to = max(open_to, *late) if late else open_to
            name = f"η_M = {eta_m}, d = {d}"
            stable += [f"{name}, α = {gap}" for gap in _stable_gaps(found, top)]
            if any(end > _STRIP for end in late):
                undecided.append(name)
            cases = {a: pair(a, "0", eta_m, d) for a in _JUST_ABOVE}
            stable += [f"{name}, α = {a}" for a, case in cases.items() if not spectrum(case).unstable]
        certificates.append((f"{claim.id}_eta{eta_m}_alpha{_JUST_ABOVE[0]}", _unstable(eta_m)))
    numbers = (
        ("α_C = α_cr,ex without damping", "1"),
        ("all cases proved unstable from this α on", f"{open_to:.6f}"),
        ("and at the single α", ", ".join(_JUST_ABOVE)),
    )
    certs = named(certificates)
    if stable:
        return Finding(
            Verdict.REFUTED, f"Stable above α_C: {'; '.join(stable)}", numbers, proof.steps, certificates=certs
        )
    if undecided or not proof.holds:
        return Finding(Verdict.UNDECIDABLE, f"Open above α_C: {'; '.join(undecided)}", numbers, proof.steps)
    sentence = (
        "Below α_C every root is real, for any masses (theorem). Above it all cases of the box are proved unstable "
        f"on the whole range beyond α = {open_to:.4f}, and at α = {', '.join(_JUST_ABOVE)}; the rest of the "
        f"strip just "
        "above α_C, where the cuts join, is open."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, proof.steps, certificates=certs)


def _stable_gaps(found: UnstableRanges, top: str) -> list[str]:
    """Where above the first unstable range the case is proved stable: what is not open between them, and after."""
    ends = [(float(a.end.lower()), float(b.start.upper())) for a, b in pairwise(found)]
    if not found or float(found[-1].end.upper()) < float(top):
        ends.append((float(found[-1].end.lower()) if found else 1.0, float(top)))
    gaps = ((low, high) for low, high in ends if not any(a <= high and b >= low for a, b in found.unknown))
    return [f"{low:.5g} to {high:.5g}" for low, high in gaps]


def _unstable(eta_m: str) -> Certificate | None:
    return certificate(pair(_JUST_ABOVE[0], "0", eta_m, "1"))


def four_signs(claim: Claim) -> Finding:
    """Conclusion (iii): both symmetries, and whether a root is on an axis, where only two signs are left."""
    known, numbers, wrong, count = symmetries(), [], [], 0
    certificates: list[tuple[str, Certificate | None]] = []
    for alpha in claim.values("alpha"):
        for eta_m in claim.values("eta_m"):
            for d in claim.values("d"):
                case = pair(alpha, "0", eta_m, d)
                lone = [root.q.imag for root in spectrum(case).roots if root.symmetry.value == "imaginary"]
                count += 1
                if lone:
                    wrong.append(f"α = {alpha}, η_M = {eta_m}, d = {d}")
                    numbers += [(f"{wrong[-1]}: q (real part exactly 0)", f"{shown(y, 12)}i") for y in lone]
                    certificates.append((f"{claim.id}_alpha{alpha}_eta{eta_m}_d{d}", certificate(case)))
    numbers.append(("certified cases", str(count)))
    if wrong:
        sentence = (
            f"At {'; '.join(wrong)} there are purely imaginary frequencies: with q only −q, two signs instead "
            f"of four. "
            "(Off the axes it holds: D(−p, −q̄) = conj D(p, q), and without damping D(p, q̄) = conj D(p, q).)"
        )
        return Finding(Verdict.REFUTED, sentence, tuple(numbers), certificates=named(certificates))
    if not all(known.values()):
        return Finding(Verdict.UNDECIDABLE, "A symmetry of D was not confirmed.")
    sentence = (
        "D(−p, −q̄) = conj D(p, q) and, without damping, D(p, q̄) = conj D(p, q): with q, also −q̄, q̄ and −q "
        "are roots, four "
        "provided that q is not on an axis. Real it cannot be, since the cut covers the real axis; that none "
        "is imaginary "
        f"is certified at {count} cases."
    )
    return Finding(Verdict.CONDITIONAL, sentence, tuple(numbers))
