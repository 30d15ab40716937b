"""Figures 3 to 8, A.1 to A.5 and conclusions (vii), (ix): amplitudes of the unsteady harmonic part, in balls.

How far the harmonic solution (36) is from rest at τ = 0 is the paper's own measure of the truly transient part.
"""

from __future__ import annotations

from itertools import pairwise, product
from typing import Any

from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, grid, shown
from mpsolve.numbers.balls import precision

from .cases import ball, certificate, higher_end, pair
from .harmonic import Harmonic, harmonic


def share(found: Harmonic) -> Any:
    """The amplitude of the higher pair over that of the lower; 0 where there is no higher pair."""
    with precision(96):
        sizes = found.amplitudes
        return sizes[1] / sizes[0] if len(sizes) > 1 else sizes[0] * 0


def start_share(found: Harmonic) -> Any:
    """The displacement at τ = 0 over the sum of the amplitudes."""
    with precision(96):
        return found.start / sum(found.amplitudes[1:], found.amplitudes[0])


def higher_pair_matters(claim: Claim) -> Finding:
    """Conclusion (vii)."""
    alpha, eta_m, d = claim.numbers("alpha", "eta_m", "d")
    case = pair(alpha, "0", eta_m, d)
    low, high = harmonic(case).amplitudes
    numbers = (("amplitude of the lower pair", shown(low, 10)), ("amplitude of the higher pair", shown(high, 10)))
    certificates = [(claim.id, certificate(case))]
    if high > low:
        sentence = f"At α = {alpha}, η_M = {eta_m}, d = {d} the higher pair has the larger amplitude."
        return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)
    return Finding(
        Verdict.UNDECIDABLE, "The higher pair is the smaller one here.", numbers, certificates=certificates
    )


def influence_grows(claim: Claim) -> Finding:
    """Section 4.2 after Figure 3: by increasing d and α the influence of the second pair increases."""
    alphas, distances, eta_m = claim.values("alpha"), grid(claim.number("d")), claim.number("eta_m")
    table = {(a, d): share(harmonic(pair(a, "0", eta_m, d))) for a in alphas for d in distances}
    numbers = tuple((f"α = {a}, d = {d}: higher over lower", _or_none(x)) for (a, d), x in table.items())
    wrong = [
        f"from {name} {first} to {second} at {where}"
        for name, steps in (("α", _steps(alphas, distances)), ("d", _steps(distances, alphas)))
        for first, second, other in steps
        for before, after, where in [_cells(table, name, first, second, other)]
        if not below(before, after)
    ]
    if not wrong:
        return Finding(Verdict.PROVED, "It grows along each row and column of the figure.", numbers)
    certificates = [(f"{claim.id}_alpha{a}_d{d}", certificate(pair(a, "0", eta_m, d))) for a, d in table]
    sentence = (
        f"It falls {'; '.join(wrong)}: the second pair is not even present there, so the amplitude is constant."
    )
    gone = any(x == 0 for x in table.values())
    sentence = sentence if gone else f"It falls {'; '.join(wrong)}."
    return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)


def _steps(values: tuple[str, ...], others: tuple[str, ...]) -> list[tuple[str, str, str]]:
    return [(values[k], values[k + 1], other) for other in others for k in range(len(values) - 1)]


def _cells(table: dict[tuple[str, str], Any], name: str, first: str, second: str, other: str) -> tuple[Any, Any, str]:
    if name == "α":
        return table[first, other], table[second, other], f"d = {other}"
    return table[other, first], table[other, second], f"α = {other}"


def _or_none(x: Any) -> str:
    return shown(x, 8) if x > 0 else "no higher pair"


def minimum_vanishes(claim: Claim) -> Finding:
    """Figure 7: the envelope's minimum is zero for some α, if the amplitudes change their order between two α."""
    eta_m, d = claim.number("eta_m"), claim.number("d")
    numbers, signs = [], []
    certificates = []
    for alpha in claim.values("alpha"):
        case = pair(alpha, "0", eta_m, d)
        low, high = harmonic(case).amplitudes
        numbers.append(
            (f"α = {alpha}: amplitudes of the lower and higher pair", f"{shown(low, 8)}, {shown(high, 8)}")
        )
        signs.append(True if low > high else False if low < high else None)
        certificates.append((f"{claim.id}_alpha{alpha}", certificate(case)))
    both = all(higher_end(eta_m, d) > ball(alpha) for alpha in claim.values("alpha"))
    if both and sorted(signs, key=str) == [False, True]:
        sentence = (
            f"At d = {d} the lower pair's amplitude is the smaller one at one α and the larger at the other; both "
            "are continuous in between, where both pairs exist, so for some α the minimum is exactly 0."
        )
        return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)
    return Finding(
        Verdict.UNDECIDABLE, "No change of order is proved between these two.", numbers, certificates=certificates
    )


def starts(eta_b: str, eta_m: str, alpha: str, distances: tuple[str, ...]) -> list[Any]:
    """|ŵ| of the harmonic solution at τ = 0 for each distance."""
    return [harmonic(pair(alpha, eta_b, eta_m, d)).start for d in distances]


def disagreement_band(claim: Claim) -> Finding:
    """Figure A.2: noticeable from one distance on, recovered from another on."""
    eta_m, alpha, distances = claim.number("eta_m"), claim.number("alpha"), grid(claim.number("d"))
    first, last = claim.number("first"), claim.number("last")
    values = starts("0", eta_m, alpha, distances)
    numbers = tuple((f"d = {d}: |ŵ| at τ = 0", shown(x, 8)) for d, x in zip(distances, values, strict=True))
    inside = [x for d, x in zip(distances, values, strict=True) if float(first) <= float(d) < float(last)]
    outside = [x for d, x in zip(distances, values, strict=True) if not float(first) <= float(d) < float(last)]
    if all(x > y for x in inside for y in outside):
        sentence = (
            f"By the deviation at τ = 0 (static displacement 1) every d from {first} to below {last} "
            f"exceeds all others."
        )
        return Finding(Verdict.AGREES, sentence, numbers)
    return Finding(Verdict.DISAGREES, "The deviations at τ = 0 do not separate these distances.", numbers)


def agreement_is_excellent(claim: Claim) -> Finding:
    """Figures A.1, A.3 to A.5: the harmonic solution agrees with the full one."""
    limit, numbers, worst = float(claim.number("limit")), [], 0.0
    for alpha in claim.values("alpha"):
        for d in grid(claim.number("d")):
            found = harmonic(pair(alpha, claim.number("eta_b"), claim.number("eta_m"), d))
            part = start_share(found)
            numbers.append(
                (
                    f"α = {alpha}, d = {d}: |ŵ| at τ = 0, and over the amplitude",
                    f"{shown(found.start, 5)}, {shown(part, 4)}",
                )
            )
            worst = max(worst, float(part.upper()))
    sentence = (
        f"The harmonic solution starts within {100 * worst:.2g} % of its amplitude from rest; no tolerance is stated."
    )
    verdict = Verdict.AGREES if worst < limit else Verdict.DISAGREES
    return Finding(verdict, sentence, numbers)


def differences_by_mass(claim: Claim) -> Finding:
    """Conclusion (ix): the differences increase with a decreasing η_M in the vicinity of α_c."""
    falls, right = [], []
    numbers: list[tuple[str, str]] = []
    for alpha in claim.values("alpha"):
        table, rows = _starts(claim, alpha)
        numbers += rows
        found = [
            (alpha, d, light, heavy)
            for d in claim.values("d")
            for light, heavy in pairwise(claim.values("eta_m"))
            if not below(table[heavy, d], table[light, d])
        ]
        falls += found
        right += [] if found else [alpha]
    where = f"at every d looked at for α = {', '.join(right)} (proved)" if right else "nowhere throughout"
    if not falls:
        sentence = f"{_MEASURE} grows {where}; between them it is open."
        return Finding(Verdict.CONDITIONAL, sentence, numbers)
    wrong = "; ".join(f"from η_M = {heavy} to {light} at α = {alpha}, d = {d}" for alpha, d, light, heavy in falls)
    certificates = [
        (f"{claim.id}_alpha{alpha}_eta{m}_d{d}", certificate(pair(alpha, "0", m, d)))
        for alpha, d, *masses in falls
        for m in masses
    ]
    sentence = f"{_MEASURE} falls {wrong} (proved); it grows {where}."
    return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)


def differences_by_distance(claim: Claim) -> Finding:
    """Conclusion (ix): and with an increasing d up to a limit, following which they fall."""
    alpha, steps, wrong = claim.number("alpha"), list(pairwise(claim.values("d"))), []
    table, numbers = _starts(claim, alpha)
    certificates = []
    for m in claim.values("eta_m"):
        rises = [below(table[m, a], table[m, b]) for a, b in steps]
        first = rises.index(False) if False in rises else None
        again = next((k for k, rise in enumerate(rises) if first is not None and k > first and rise), None)
        if first is None or (again is None and first == 0):
            wrong.append(f"η_M = {m}: no limit lies between these distances")
        elif again is not None:
            (a, b), (c, d) = steps[first], steps[again]
            wrong.append(f"η_M = {m}: it falls from d = {a} to {b}, but rises from {c} to {d}")
            certificates += [(f"{claim.id}_eta{m}_d{x}", certificate(pair(alpha, "0", m, x))) for x in (a, b, c, d)]
    if wrong:
        sentence = f"{_MEASURE} does not: {'; '.join(wrong)} (proved)."
        return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
    sentence = (
        f"{_MEASURE} rises up to one of these distances and falls from there on (proved); in general it is open."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)


_MEASURE = "By the paper's own measure, |ŵ| of the harmonic solution at τ = 0, it"


def _starts(claim: Claim, alpha: str) -> tuple[dict[tuple[str, str], Any], tuple[tuple[str, str], ...]]:
    """The deviation at τ = 0 for each (η_M, d), undamped, and as numbers."""
    masses, distances = claim.values("eta_m"), claim.values("d")
    table = {(m, d): harmonic(pair(alpha, "0", m, d)).start for m in masses for d in distances}
    return table, tuple(
        (f"α = {alpha}, η_M = {m}, d = {d}: |ŵ| at τ = 0", shown(x, 8)) for (m, d), x in table.items()
    )


def damping_does_not_matter(claim: Claim) -> Finding:
    """Section 5: the importance of the truly transient part is not affected by damping or other factors."""
    alpha, eta_m, d = claim.numbers("alpha", "eta_m", "d")
    values = [(b, harmonic(pair(alpha, b, eta_m, d)).start) for b in claim.values("eta_b")]
    numbers = tuple((f"η_b = {b}: |ŵ| at τ = 0", shown(x, 8)) for b, x in values)
    certificates = [(f"{claim.id}_eta_b{b}", certificate(pair(alpha, b, eta_m, d))) for b, _ in values]
    (_, first), *rest = values
    if any(first > x or first < x for _, x in rest):
        sentence = f"The difference at τ = 0 changes with η_b (α = {alpha}, η_M = {eta_m}, d = {d})."
        return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
    return Finding(Verdict.UNDECIDABLE, "The balls do not tell them apart.", numbers, certificates=certificates)


def usually_omitted(claim: Claim) -> Finding:
    """Sections 4.1 and 5: the truly transient part can be omitted in most cases."""
    limit, small, large, largest = ball(claim.number("limit")), 0, 0, 0.0
    models = list(product(*(claim.values(name) for name in ("alpha", "eta_m", "d"))))
    for alpha, eta_m, d in models:
        part = start_share(harmonic(pair(alpha, claim.number("eta_b"), eta_m, d)))
        small, large = small + bool(part < limit), large + bool(part > limit)
        largest = max(largest, float(part.mid()))
    percent = 100 * float(limit.mid())
    numbers = (
        ("cases looked at", str(len(models))),
        (f"deviation at τ = 0 proved below {percent:g} % of the amplitude", str(small)),
        (f"proved above {percent:g} %", str(large)),
        ("largest deviation over the amplitude (float64)", f"{largest:.3g}"),
    )
    sentence = (
        f"'Most' and 'can be omitted' have no number. In {small} of {len(models)} cases of the box the deviation at "
        f"τ = 0 is proved to be below {percent:g} % of the amplitude."
    )
    if 2 * small > len(models):
        return Finding(Verdict.CONDITIONAL, sentence, numbers)
    return Finding(Verdict.REFUTED if 2 * large >= len(models) else Verdict.UNDECIDABLE, sentence, numbers)


def misled_by_one_velocity(claim: Claim) -> Finding:
    """Section 4.2: at α = 0.34 (0.344 in Sections 4.1 and 5) and a small distance the changes were negligible."""
    eta_m, limit, numbers, right = claim.number("eta_m"), claim.number("limit"), [], []
    certificates = []
    alphas = (*claim.values("alpha"), *claim.values("elsewhere"))
    for alpha in alphas:
        parts = [(d, share(harmonic(pair(alpha, "0", eta_m, d)))) for d in claim.values("d")]
        numbers += [(f"α = {alpha}, d = {d}: higher over lower amplitude", shown(x, 6)) for d, x in parts]
        near, far = parts[0][1], parts[-1][1]
        right.append(below(near, ball(limit)) and below(near, far))
        certificates += [(f"{claim.id}_alpha{alpha}_d{d}", certificate(pair(alpha, "0", eta_m, d))) for d, _ in parts]
    if not all(right):
        return Finding(Verdict.REFUTED, "The higher pair is no small part there.", numbers, certificates=certificates)
    sentence = (
        f"If a part below {limit} is negligible: at the smallest distance the higher pair is one, at the largest "
        f"it is not, for α = {' and '.join(alphas)} (all proved). No tolerance is stated. The velocity is printed "
        f"as {alphas[0]} here and as {alphas[-1]} in Sections 4.1 and 5."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)
