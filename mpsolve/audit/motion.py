"""Figures 3 to 8, A.1 to A.5 and conclusions (vii), (viii), (ix): amplitudes of the unsteady harmonic part, in balls.

How far the harmonic solution (36) is from rest at τ = 0 is the paper's own measure of the truly transient part.
"""

from __future__ import annotations

from itertools import pairwise, product
from typing import Any

from mpsolve.audit.cases import ball, certificate, higher_end, pair, single
from mpsolve.audit.claims import Claim, Finding, Verdict
from mpsolve.audit.harmonic import Harmonic, harmonic, superposed
from mpsolve.audit.values import below, grid, named, shown
from mpsolve.fields import ball_arithmetic


def share(found: Harmonic) -> Any:
    """The amplitude of the higher pair over that of the lower; 0 where there is no higher pair."""
    with ball_arithmetic(96):
        sizes = found.amplitudes
        return sizes[1] / sizes[0] if len(sizes) > 1 else sizes[0] * 0


def start_share(found: Harmonic) -> Any:
    """The displacement at τ = 0 over the sum of the amplitudes."""
    with ball_arithmetic(96):
        return found.start / sum(found.amplitudes[1:], found.amplitudes[0])


def higher_pair_matters(claim: Claim) -> Finding:
    """Conclusion (vii)."""
    alpha, eta_m, d = (claim.number(name) for name in ("alpha", "eta_m", "d"))
    case = pair(alpha, "0", eta_m, d)
    low, high = harmonic(case).amplitudes
    numbers = (("amplitude of the lower pair", shown(low, 10)), ("amplitude of the higher pair", shown(high, 10)))
    certificates = named([(claim.id, certificate(case))])
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
    certificates = named((f"{claim.id}_alpha{a}_d{d}", certificate(pair(a, "0", eta_m, d))) for a, d in table)
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
    certs = named(certificates)
    both = all(higher_end(eta_m, d) > ball(alpha) for alpha in claim.values("alpha"))
    if both and sorted(signs, key=str) == [False, True]:
        sentence = (
            f"At d = {d} the lower pair's amplitude is the smaller one at one α and the larger at the other; both "
            "are continuous in between, where both pairs exist, so for some α the minimum is exactly 0."
        )
        return Finding(Verdict.PROVED, sentence, tuple(numbers), certificates=certs)
    return Finding(
        Verdict.UNDECIDABLE, "No change of order is proved between these two.", tuple(numbers), certificates=certs
    )


def no_superposition(claim: Claim) -> Finding:
    """Conclusion (viii): superposition of single masses against the pair, undamped."""
    return _compared(claim, "superposed")


def no_doubled_mass(claim: Claim) -> Finding:
    """Conclusion (viii): one doubled mass against the pair, undamped."""
    return _compared(claim, "doubled")


def _compared(claim: Claim, what: str) -> Finding:
    d, numbers, gaps, certificates = claim.number("d"), [], [], []
    for eta_m in claim.values("eta_m"):
        for alpha in claim.values("alpha"):
            case, found = pair(alpha, "0", eta_m, d), harmonic(pair(alpha, "0", eta_m, d))
            with ball_arithmetic(96):
                sizes, frequency = found.amplitudes, found.frequencies[0]
                top = sum(sizes[1:], sizes[0])
                if what == "superposed":
                    other, q = (
                        superposed(single(alpha, "0", eta_m), d),
                        harmonic(single(alpha, "0", eta_m)).frequencies[0],
                    )
                else:
                    both = harmonic(pair(alpha, "0", eta_m, "0").merged)
                    # the doubled mass carries both forces
                    other, q = 2 * both.amplitudes[0], both.frequencies[0]
                apart, size = abs(q / frequency - 1), abs(other - top) / top
                depth = 1 - abs(sizes[0] - sizes[-1]) / top
            numbers.append((f"η_M = {eta_m}, α = {alpha}: frequency apart by", shown(apart, 5)))
            numbers.append(("  amplitude apart by", shown(size, 5)))
            if len(sizes) > 1:
                numbers.append(("  envelope of the pair falls by", shown(depth, 5)))
            gaps.append(float(apart.lower()))
            certificates.append((f"{claim.id}_eta{eta_m}_alpha{alpha}", certificate(case)))
    least, largest = min(gaps), max(gaps)
    sentence = (
        f"No tolerance is stated. The frequency differs by {100 * least:.1f} to {100 * largest:.1f} % from that of "
        f"the pair's lower line at d = {d}: in opposite phase after {0.5 / largest:.0f} to {0.5 / least:.0f} "
        "periods; the amplitudes differ as listed (all proved)."
    )
    verdict = Verdict.CONDITIONAL if least > 0 else Verdict.UNDECIDABLE
    return Finding(verdict, sentence, tuple(numbers), certificates=named(certificates))


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
    return Finding(verdict, sentence, tuple(numbers))


def differences_by_mass(claim: Claim) -> Finding:
    """Conclusion (ix): the differences increase with a decreasing η_M in the vicinity of α_c."""
    return _trend(claim, "mass")


def differences_by_distance(claim: Claim) -> Finding:
    """Conclusion (ix): and with an increasing d up to a limit."""
    return _trend(claim, "distance")


def _trend(claim: Claim, along: str) -> Finding:
    alpha, masses, distances = claim.number("alpha"), claim.values("eta_m"), claim.values("d")
    table = {(m, d): harmonic(pair(alpha, "0", m, d)).start for m in masses for d in distances}
    numbers = tuple((f"η_M = {m}, d = {d}: |ŵ| at τ = 0", shown(x, 8)) for (m, d), x in table.items())
    if along == "mass":
        rows = [[(m, d) for m in sorted(masses, key=int, reverse=True)] for d in distances]
    else:
        rows = [[(m, d) for d in distances] for m in masses]
    falls = [[(a, b) for a, b in pairwise(row) if not table[a] < table[b]] for row in rows]
    if not any(falls):
        return Finding(Verdict.AGREES, "So it is at these cases; in general it is not proved.", numbers)
    wrong = [f"from η_M = {a[0]}, d = {a[1]} to η_M = {b[0]}, d = {b[1]}" for row in falls for a, b in row]
    certificates = named((f"{claim.id}_eta{m}_d{d}", certificate(pair(alpha, "0", m, d))) for m, d in sorted(table))
    sentence = f"The deviation at τ = 0 falls {'; '.join(wrong)}"
    if all(falls):
        return Finding(Verdict.REFUTED, f"{sentence}.", numbers, certificates=certificates)
    return Finding(
        Verdict.CONDITIONAL, f"{sentence}; it grows in the other rows.", numbers, certificates=certificates
    )


def damping_does_not_matter(claim: Claim) -> Finding:
    """Section 5: the importance of the truly transient part is not affected by damping or other factors."""
    alpha, eta_m, d = (claim.number(name) for name in ("alpha", "eta_m", "d"))
    values = [(b, harmonic(pair(alpha, b, eta_m, d)).start) for b in claim.values("eta_b")]
    numbers = tuple((f"η_b = {b}: |ŵ| at τ = 0", shown(x, 8)) for b, x in values)
    certificates = named((f"{claim.id}_eta_b{b}", certificate(pair(alpha, b, eta_m, d))) for b, _ in values)
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
    """Section 4.2: at α = 0.34 and a small distance the additional changes were negligible."""
    alpha, eta_m = claim.number("alpha"), claim.number("eta_m")
    parts = [(d, share(harmonic(pair(alpha, "0", eta_m, d)))) for d in claim.values("d")]
    numbers = tuple((f"d = {d}: higher over lower amplitude", shown(x, 6)) for d, x in parts)
    near, far = parts[0][1], parts[-1][1]
    certificates = named((f"{claim.id}_d{d}", certificate(pair(alpha, "0", eta_m, d))) for d, _ in parts)
    if near < ball(claim.number("limit")) and far > near:
        sentence = (
            f"If a part below {claim.number('limit')} is negligible: at the smallest distance the higher pair is "
            "one, at the largest it is not (both proved). No tolerance is stated."
        )
        return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)
    return Finding(Verdict.REFUTED, "The higher pair is no small part there.", numbers, certificates=certificates)
