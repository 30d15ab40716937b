"""Conclusions (viii), (ix) and Section 4.2: two single masses, or one doubled mass, in place of the pair; "
"undamped."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from mpsolve.certificate.format import Certificate
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, shown
from mpsolve.numbers.balls import precision

from .cases import certificate, pair, single
from .harmonic import harmonic, superposed

Rows = list[tuple[str, str]]
Certificates = list[tuple[str, Certificate | None]]


def apart(case: Any, d: str, what: str) -> tuple[Any, Rows]:
    """By what part the frequency differs from that of the pair's lower line; the comparison in numbers."""
    found, alpha, eta_m = harmonic(case), str(case.alpha), str(case.eta_m[0])
    with precision(96):
        sizes, frequency = found.amplitudes, found.frequencies[0]
        top = sum(sizes[1:], sizes[0])
        if what == "superposed":
            alone = single(alpha, "0", eta_m)
            other, q = superposed(alone, d), harmonic(alone).frequencies[0]
        else:
            both = harmonic(pair(alpha, "0", eta_m, "0").merged)
            other, q = 2 * both.amplitudes[0], both.frequencies[0]  # it carries both forces
        part, size = abs(q / frequency - 1), abs(other - top) / top
        depth = 1 - abs(sizes[0] - sizes[-1]) / top
    numbers = [
        (f"η_M = {eta_m}, α = {alpha}, d = {d}: frequency apart by", shown(part, 5)),
        ("  amplitude apart by", shown(size, 5)),
    ]
    if len(sizes) > 1:
        numbers.append(("  envelope of the pair falls by", shown(depth, 5)))
    return part, numbers


def _table(claim: Claim, what: str, distances: tuple[str, ...]) -> tuple[dict[tuple[str, str, str], Any], Any, Any]:
    """The parts for each (d, η_M, α), the numbers and the certificates."""
    parts, numbers, certificates = {}, [], []
    for d in distances:
        for eta_m in claim.values("eta_m"):
            for alpha in claim.values("alpha"):
                case = pair(alpha, "0", eta_m, d)
                parts[d, eta_m, alpha], rows = apart(case, d, what)
                numbers += rows
                certificates.append((f"{claim.id}_eta{eta_m}_alpha{alpha}_d{d}", certificate(case)))
    return parts, numbers, certificates


def _percent(parts: list[Any]) -> str:
    return f"{100 * min(float(x.lower()) for x in parts):.1f} to {100 * max(float(x.upper()) for x in parts):.1f} %"


def not_close(claim: Claim) -> Finding:
    """Section 4.2 and conclusion (viii): how far a replacement is from the pair at the printed distance."""
    d, what = claim.number("d"), claim.number("what")
    parts, numbers, certificates = _table(claim, what, (d,))
    least, largest = (float(choose(parts.values(), key=float)) for choose in (min, max))
    sentence = (
        f"No tolerance is stated. The frequency differs by {_percent(list(parts.values()))} from that of the "
        f"pair's lower line at d = {d}: in opposite phase after {0.5 / largest:.0f} to {0.5 / least:.0f} periods; "
        "the amplitudes differ as listed (all proved)."
    )
    verdict = Verdict.CONDITIONAL if all(below(0, x) for x in parts.values()) else Verdict.UNDECIDABLE
    return Finding(verdict, sentence, numbers, certificates=certificates)


def boundary(claim: Claim) -> Finding:
    """Conclusion (viii): whether superposition begins to be possible at the printed distance."""
    near, d = claim.number("near"), claim.number("d")
    parts, numbers, certificates = _table(claim, "superposed", (near, d))
    models = [(eta_m, alpha) for eta_m in claim.values("eta_m") for alpha in claim.values("alpha")]
    worse = [f"η_M = {m}, α = {a}" for m, a in models if below(parts[near, m, a], parts[d, m, a])]
    here, before = ([parts[x, m, a] for m, a in models] for x in (d, near))
    sentence = (
        f"No tolerance is stated. At d = {near} the frequency differs by {_percent(before)} from that of the "
        f"pair's lower line, at d = {d} by {_percent(here)}"
    )
    if worse:
        sentence += f", and more than at d = {near} for {'; '.join(worse)}"
    sentence += (
        f" (all proved): nothing changes at d = {d}. Read as 'possible from d = {d} on' it contradicts Section 4.2 "
        f"and the Appendix, by which superposition is not acceptable at d = {d} itself."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


def in_the_limit(claim: Claim) -> Finding:
    """Conclusion (ix): for a large distance both lines go to that of the single mass; what is left of the beat."""
    eta_m, numbers, open_ = claim.number("eta_m"), [], []
    certificates: Certificates = []
    beats = []
    for alpha in claim.values("alpha"):
        (one,), gaps = harmonic(single(alpha, "0", eta_m)).frequencies, []
        for d in claim.values("d"):
            case = pair(alpha, "0", eta_m, d)
            low, high = harmonic(case).frequencies
            with precision(96):
                gap = high - low
                sizes = harmonic(case).amplitudes
                depth = 1 - abs(sizes[0] - sizes[1]) / (sizes[0] + sizes[1])
                off = abs(low - one)
            gaps.append(gap)
            beats.append(6.283 / float(gap.mid()))
            numbers.append((f"α = {alpha}, d = {d}: lower line from the single mass's", shown(off, 5)))
            numbers += [("  higher − lower", shown(gap, 5)), ("  envelope falls by", shown(depth, 5))]
            certificates.append((f"{claim.id}_alpha{alpha}_d{d}", certificate(case)))
        open_ += [alpha for x, y in pairwise(gaps) if not below(y, x)]
    if open_:
        sentence = f"The two lines do not approach each other at α = {', '.join(open_)}."
        return Finding(Verdict.UNDECIDABLE, sentence, numbers, certificates=certificates)
    sentence = (
        "Undamped, for times that are short against the beat: with d the two lines approach that of the single mass "
        f"(proved along this list), but the envelope still rises and falls, once in a time τ of "
        f"{min(beats):.0f} to {max(beats):.1g}, which superposition never does. With damping the vibration may "
        "have ceased before."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


_MODELS = {"alpha": ("0.5", "0.8", "0.9"), "eta_m": ("40", "70")}

CLAIMS = (
    Claim(
        "viii-superposition", "Section 5 (viii)",
        "Superposition is not possible below d̂ = {d}, and is from there on.",
        boundary, {"d": ("4.5",)}, {**_MODELS, "near": ("4",)},
    ),
    Claim(
        "4.2-superposition", "Section 4.2, Appendix",
        "At d̂ = {d} superposition cannot be used.",
        not_close, {"d": ("4.5",)}, {**_MODELS, "what": ("superposed",)},
    ),
    Claim(
        "viii-doubled", "Section 5 (viii)",
        "substitution by one doubled mass is not possible in the full subcritical velocity range, even for d̂ = {d}",
        not_close, {"d": ("0.5",)}, {**_MODELS, "what": ("doubled",)},
    ),
    Claim(
        "ix-superposition", "Section 5 (ix)",
        "Superposition is possible where d̂ is large.",
        in_the_limit, {}, {"alpha": ("0.5", "0.8"), "eta_m": ("40",), "d": ("4.5", "9", "18", "27")},
    ),
)  # fmt: skip
