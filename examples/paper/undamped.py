"""Section 4.2 and conclusions (i), (ii), (iii), (v), (vi): two equal masses without damping."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from mpsolve.certificate.format import Certificate
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, decimal, grid, last_on_grid, shown

from .cases import DISTANCES, MASSES, ahead, certificate, gap_ends, higher_end, pair, single
from .theory import lines_in_the_gap

_STEP = Fraction(1, 100)
_KEPT = (
    (MASSES[0], DISTANCES[0]),
    (MASSES[1], DISTANCES[4]),
    (MASSES[-1], DISTANCES[-1]),
)  # certificates of 27 cases


def last_velocities(claim: Claim) -> Finding:
    """The last α of the grid 0.01 with both pairs, for each distance of the claim."""
    eta_m, printed = claim.number("eta_m"), claim.values("alpha")
    distances = grid(claim.number("d"))
    numbers, wrong, certificates = [], [], []
    for d, text in zip(distances, printed, strict=True):
        end = higher_end(eta_m, d)
        last = last_on_grid(end, _STEP)
        numbers.append((f"d = {d}: the higher line ends at α", shown(end, 15)))
        if last != Fraction(text):
            wrong.append(f"d = {d}: printed {text}, proved {decimal(last)}")
        for alpha, pairs in ((last, 2), (last + _STEP, 1)):
            name, case = f"{claim.id}_d{d}_alpha{decimal(alpha)}", pair(decimal(alpha), "0", eta_m, d)
            certificates.append((name, certificate(case)))
            if len(ahead(case)) != pairs:
                return Finding(Verdict.UNDECIDABLE, f"{name}: not {pairs} pairs, against the proved end of the line.")
    if wrong:
        return Finding(Verdict.REFUTED, "; ".join(wrong), numbers, certificates=certificates)
    sentence = (
        "Each higher line has exactly one end in 0.01 ≤ α ≤ 0.999, between the printed α and the next 0.01: two "
        "pairs are certified at the one, one pair at the other."
    )
    return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)


def cut_at_the_limit(claim: Claim) -> Finding:
    """Conclusion (ii)."""
    proof, ends = lines_in_the_gap(), []
    for eta_m in MASSES:
        for d in DISTANCES:
            ends += [(eta_m, d, point) for point in gap_ends(eta_m, d)]
    if claim.number("limit") != "q_lm":
        return Finding(Verdict.REFUTED, "The gap ends at q_lm.")
    if not proof.holds or any(point.side != "gap" or point.appears for _, _, point in ends):
        return Finding(Verdict.UNDECIDABLE, "A step of the proof, or a cut point, was not confirmed.")
    numbers = tuple((f"η_M = {m}, d = {d}: ends at α", shown(point.value, 12)) for m, d, point in ends)
    sentence = (
        "Below α_C every root is real and lies in the gap |q| < q_lm, where Δ is analytic, so a line can end at q_lm "
        f"only (theorem). In the 27 cases of the paper {len(ends)} lines do, each once, and none begins: the "
        "numbers of pairs beside some of these ends are certified."
    )
    return Finding(Verdict.PROVED, sentence, numbers, proof.steps[:2], certificates=_before_and_after(claim.id))


def _before_and_after(name: str) -> list[tuple[str, Certificate | None]]:
    """Certificates just before and after the end of the higher line, for a few of the cases."""
    found = []
    for eta_m, d in _KEPT:
        last = last_on_grid(higher_end(eta_m, d), _STEP)
        found += [
            (f"{name}_eta{eta_m}_d{d}_alpha{decimal(alpha)}", certificate(pair(decimal(alpha), "0", eta_m, d)))
            for alpha in (last, last + _STEP)
        ]
    return found


def two_pairs_then_one(claim: Claim) -> Finding:
    """Conclusion (v), first sentence, without damping."""
    proof, numbers, wrong = lines_in_the_gap(), [], []
    many, few = claim.number("low"), claim.number("high")
    for eta_m in MASSES:
        for d in DISTANCES:
            ends = gap_ends(eta_m, d)
            below, above = (len(ahead(pair(alpha, "0", eta_m, d))) for alpha in ("0.05", "0.98"))
            if len(ends) != 1 or (str(below), str(above)) != (many, few):
                wrong.append(f"η_M = {eta_m}, d = {d}: {below} pairs at α = 0.05, {above} at 0.98, {len(ends)} ends")
            numbers.append((f"η_M = {eta_m}, d = {d}: two pairs up to α", shown(ends[0].value, 10)))
    if wrong:
        return Finding(Verdict.REFUTED, "; ".join(wrong), numbers)
    sentence = (
        "Two equal masses have one or two pairs at every α < α_C (theorem). For the 27 (η_M, d) of the paper and "
        "0.01 ≤ α ≤ 0.999 it is two up to one proved α and one from there on; for other masses and distances, and "
        "for the rest of the range, how often it changes is not proved."
    )
    verdict = Verdict.CONDITIONAL if proof.holds else Verdict.UNDECIDABLE
    certificates = _before_and_after(claim.id)
    return Finding(verdict, sentence, numbers, proof.steps, certificates=certificates)


def embedded(claim: Claim) -> Finding:
    """Conclusion (v), second sentence, and (vi), first: the order of the four lines."""
    proof, eta_m = lines_in_the_gap(), "40"
    numbers, right, certificates = [], True, []
    for alpha, d in (("0.5", "1"), ("0.8", "3")):
        case = pair(alpha, "0", eta_m, d)
        certificates.append((f"{claim.id}_alpha{alpha}_d{d}", certificate(case)))
        low, high = ahead(case)
        (one,), (both,) = ahead(single(alpha, "0", eta_m)), ahead(single(alpha, "0", "80"))
        right = right and all(below(x.real, y.real) for x, y in pairwise((both, low, one, high)))
        lines = (("doubled", both), ("lower", low), ("single", one), ("higher", high))
        numbers += [(f"α = {alpha}, d = {d}: q {name}", shown(q.real, 12)) for name, q in lines]
    lower, higher = claim.number("lower") == "between", claim.number("higher") == "outside"
    if not (right and lower and higher):
        return Finding(Verdict.REFUTED, "The order of the lines is doubled < lower < single < higher.", numbers)
    sentence = (
        "For every α < α_C, η_M and d: q_doubled < q_lower ≤ q_single ≤ q_higher (theorem; equality only where K(d) "
        "vanishes). The two examples confirm it."
    )
    return Finding(_if(proof.holds), sentence, numbers, proof.steps, certificates=certificates)


def closer_with_distance(claim: Claim) -> Finding:
    """Conclusion (v), third and fourth sentence: a search for a counterexample among the distances of the box."""
    proof = lines_in_the_gap()
    for alpha in claim.values("alpha"):
        for eta_m in MASSES:
            lower = [(d, ahead(pair(alpha, "0", eta_m, d))[0].real) for d in DISTANCES]
            for (near, q), (far, other) in pairwise(lower):
                if other < q:
                    (one,) = ahead(single(alpha, "0", eta_m))
                    numbers = (
                        (f"q_lower at d = {near}", shown(q, 12)),
                        (f"q_lower at d = {far}", shown(other, 12)),
                        ("q_single", shown(one.real, 12)),
                    )
                    certificates = [
                        (f"{claim.id}_alpha{alpha}_eta{eta_m}_d{d}", certificate(pair(alpha, "0", eta_m, d)))
                        for d in (near, far)
                    ]
                    sentence = (
                        f"At α = {alpha}, η_M = {eta_m} the lower line of d = {far} is farther from that of the "
                        f"single mass than the line of d = {near}: |K(d)|, which separates them, does not fall with "
                        "d."
                    )
                    return Finding(Verdict.REFUTED, sentence, numbers, proof.steps[-2:], certificates=certificates)
    return Finding(Verdict.UNDECIDABLE, "No counterexample among the cases looked at, and no proof.")


def ends_by_mass(claim: Claim) -> Finding:
    """Conclusion (vi): a lower mass, a lower α, at each distance."""
    found, proof = _ordered([[(m, d) for m in MASSES] for d in DISTANCES], "mass", claim.id), lines_in_the_gap()
    if found.verdict is not Verdict.PROVED:
        return found  # refuted at a mass and a distance, or not told apart
    if not proof.holds:
        return replace(found, verdict=Verdict.UNDECIDABLE)
    if claim.number("way") != "lower":
        return replace(found, verdict=Verdict.REFUTED)
    nested = (
        "The higher pair exists at α if and only if η_M g(α) > 1, where (2q²/π)(K(0) − |K(d)|) grows to g(α) as q → "
        "q_lm: if it exists for a mass, it exists for every heavier one. So where each line has one end, the ends "
        "grow with η_M."
    )
    sentence = (
        f"Where the higher pair exists for a mass it exists for every heavier one (theorem). {found.sentence} Only "
        "the numbers of pairs beside some ends are certified."
    )
    ends = tuple((f"η_M = {m}, d = {d}: ends at α", shown(higher_end(m, d), 12)) for d in DISTANCES for m in MASSES)
    certificates = _before_and_after(claim.id)
    return replace(found, sentence=sentence, numbers=ends, steps=(*proof.steps, nested), certificates=certificates)


def ends_by_distance(claim: Claim) -> Finding:
    """Conclusion (vi): a lower distance, a lower α, at each mass."""
    return _ordered([[(m, d) for d in DISTANCES] for m in MASSES], "distance", claim.id)


def _ordered(rows: list[list[tuple[str, str]]], what: str, name: str) -> Finding:
    numbers, against, certificates = [], [], []
    for row in rows:
        for first, second in pairwise(row):
            a, b = higher_end(*first), higher_end(*second)
            if a > b:
                (m, d), (n, e) = first, second
                against.append(f"η_M = {m}, d = {d} ends above η_M = {n}, d = {e}")
                numbers += [(f"η_M = {k}, d = {x}: ends at α", shown(v, 15)) for k, x, v in ((m, d, a), (n, e, b))]
                middle = decimal(Fraction(round(float(a + b) * 5000), 10000))
                certificates += [
                    (f"{name}_eta{k}_d{x}_alpha{middle}", certificate(pair(middle, "0", k, x)))
                    for k, x in (first, second)
                ]
            elif not a < b:
                return Finding(Verdict.UNDECIDABLE, "Two ends cannot be told apart.")
    if against:
        return Finding(Verdict.REFUTED, "; ".join(against), numbers, certificates=certificates)
    return Finding(
        Verdict.PROVED, f"In all 27 cases of the paper the end grows with the {what}; all ends are proved."
    )


def only_one_pair(claim: Claim) -> Finding:
    """Which of the listed distances have no higher pair at a velocity ratio."""
    eta_m, alpha = claim.number("eta_m"), claim.number("alpha")
    numbers, alone, certificates = [], [], []
    for d in grid(claim.number("d")):
        case = pair(alpha, "0", eta_m, d)
        pairs = len(ahead(case))
        numbers.append((f"d = {d}: pairs", str(pairs)))
        certificates.append((f"{claim.id}_d{d}", certificate(case)))
        if pairs == 1:
            alone.append(d)
    good = tuple(alone) == claim.values("alone")
    sentence = f"One pair, and so a constant amplitude, at d = {', '.join(alone) or 'none'}; two pairs at the others."
    verdict = Verdict.PROVED if good else Verdict.REFUTED
    return Finding(verdict, sentence, numbers, certificates=certificates)


def _if(holds: bool) -> Verdict:
    return Verdict.PROVED if holds else Verdict.UNDECIDABLE
