"""Sections 4.3 and 4.4, conclusions (xi) and (xii): critical distances, limiting masses, Figures 10 and 12."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import Any

from mpsolve import onset as stability_onset
from mpsolve import worst
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, grid, places, rounded, rounds_to, shown
from mpsolve.errors import PrecisionError

from .cases import certificate, lowest, pair, spectrum
from .damped import onset
from .search import crossings, exchanged, limiting, reproductions

_BOX, _NEAR = ("0.5", "4.5"), ("0.5", "2")  # distances: all of Section 4.1, and those about the critical one


@lru_cache(maxsize=128)
def critical_at(alpha: str, eta_b: str, eta_m: str, d: tuple[str, str] = _NEAR) -> Any:
    """The critical distance in the range d, proved, inside of it. PrecisionError if it is not."""
    found = worst(pair(alpha, eta_b, eta_m, "1"), over={"d": d}, digits=15)
    if not found.proved or found.where != "inside":
        raise PrecisionError(str(found.reason or "the least Im q lies at an end of the range"))
    return found


def _there(found: Any) -> Any:
    """The certificate of the frequencies next to the critical distance."""
    return found.proofs[0].base.certificate


def critical_ends(claim: Claim) -> Finding:
    """Conclusion (xi): the critical distances at the two ends of the range of η_b."""
    numbers, wrong, certificates = [], [], []
    steps = grid(claim.number("eta_b"))
    ends_ = (steps[0], steps[-1])
    for eta_b, printed in zip(ends_, claim.values("distance"), strict=True):
        found = critical_at(claim.number("alpha"), eta_b, claim.number("eta_m"), _BOX)
        numbers += [(f"η_b = {eta_b}: d", shown(found.value, 14)), ("  least Im q", shown(found.q.imag, 12))]
        certificates.append((f"{claim.id}_eta_b{eta_b}", _there(found)))
        if not rounds_to(found.value, printed):
            wrong.append((eta_b, printed, rounded(found.value, places(printed))))
    if not wrong:
        return Finding(Verdict.PROVED, "Both round to the printed decimals.", numbers, certificates=certificates)
    text = "; ".join(f"η_b = {b}: printed {p}, proved {r}" for b, p, r in wrong)
    found = {step: [_lowest_on_grid(claim, b, step) for b in ends_] for step in claim.values("steps")}
    search = tuple(
        f"distances in steps of {step}: the least Im q at d = {', '.join(at)} (certified)"
        for step, at in found.items()
    )
    fitting = [step for step, at in found.items() if tuple(at) == claim.values("distance")]
    if fitting:
        sentence = (
            f"{text}. They are right if distances are looked at in steps of {' or '.join(fitting)} only (certified)."
        )
        return Finding(Verdict.CONDITIONAL, sentence, numbers, search=search, certificates=certificates)
    return Finding(Verdict.REFUTED, text, numbers, search=search, certificates=certificates)


def _lowest_on_grid(claim: Claim, eta_b: str, step: str) -> str:
    """The distance of the box, in such steps, at which the least Im q of all roots is lowest: every one certified."""
    alpha, eta_m, best = claim.number("alpha"), claim.number("eta_m"), None
    for d in grid(f"{_BOX[0]}:{step}:{_BOX[1]}"):
        parts = [root.q.imag for root in spectrum(pair(alpha, eta_b, eta_m, d)).roots]
        if parts:
            least = min(parts, key=float)
            best = (least, d) if best is None or below(least, best[0]) else best
    return best[1] if best else "none"


def critical_falls(claim: Claim) -> Finding:
    """Conclusion (xi): the critical distance falls smoothly with η_b: all values of the paper's grid in turn."""
    values = grid(claim.number("eta_b"))
    found = [critical_at(claim.number("alpha"), eta_b, claim.number("eta_m")) for eta_b in values]
    wrong = [b for b, (x, y) in zip(values, pairwise(found), strict=False) if not below(y.value, x.value)]
    falls = [float((x.value - y.value).mid()) for x, y in pairwise(found)]
    numbers = [(f"η_b = {b}: d", shown(f.value, 10)) for b, f in zip(values, found, strict=True)]
    numbers.append(("largest fall from one value to the next (float64)", f"{max(falls):.2g}"))
    kept = (0, len(values) // 2, -1)
    certificates = [(f"{claim.id}_eta_b{values[k]}", _there(found[k])) for k in kept]
    if wrong:
        text = f"It does not fall after η_b = {', '.join(wrong)}."
        return Finding(Verdict.REFUTED, text, numbers, certificates=certificates)
    sentence = (
        f"At all {len(values)} values the critical distance is the proved global minimum over d = {_NEAR[0]} to "
        f"{_NEAR[1]}, and it falls from each to the next; between them it is not proved. Certificates are kept for "
        "the first, the middle and the last of them."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


def one_window(claim: Claim) -> Finding:
    """Section 4.3: whether other distances than those about the critical one are unstable."""
    alpha, eta_m = claim.number("alpha"), claim.number("eta_m")
    numbers, second, certificates = [], [], []
    for eta_b in claim.values("eta_b"):
        least = []
        for d in claim.values("d"):
            case = pair(alpha, eta_b, eta_m, d)
            unstable = spectrum(case).unstable
            least.append(unstable)
            numbers.append((f"η_b = {eta_b}, d = {d}: unstable roots", str(unstable)))
            certificates.append((f"{claim.id}_eta_b{eta_b}_d{d}", certificate(case)))
        if least[0] and not least[1] and least[2]:
            second.append(eta_b)
    if second:
        sentence = (
            f"Near the critical distance it is unstable, but for η_b = {', '.join(second)} a second window of "
            f"unstable distances lies near d = {claim.values('d')[2]}, with stable ones between: one distance does "
            "not tell all."
        )
        return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)
    return Finding(Verdict.UNDECIDABLE, "No second window at the cases looked at.", numbers)


def limit_at(claim: Claim) -> Finding:
    """Conclusion (xii): the limiting mass at a printed damping ratio and distance; else what would give it."""
    alpha, eta_b, d, printed = claim.numbers("alpha", "eta_b", "d", "eta_m")
    found = crossings(alpha, eta_b, d)
    if found.counts != (0, 2):
        return Finding(Verdict.UNDECIDABLE, f"Unstable roots from mass to mass: {found.counts}, not from one on.")
    certificates = [(claim.id, found.certificate)]
    numbers = [
        (f"η_b = {eta_b}, d = {d}: limiting mass", shown(found.crossings[0].value, 14)),
        ("q there", shown(found.crossings[0].q, 12)),
    ]
    if rounds_to(found.crossings[0].value, printed):
        sentence = "The proved limiting mass rounds to the printed one; all heavier masses are unstable."
        return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)
    here = pair(alpha, eta_b, printed, d)
    certificates.append((f"{claim.id}_eta{printed}", certificate(here)))
    limit = shown(found.crossings[0].value, 5)
    if spectrum(here).unstable:
        stated = f"η_M = {printed} is unstable (certified), but so are all masses from {limit} on"
    else:
        stated = f"η_M = {printed} is stable (certified), and so is every mass up to {limit}"
    search = reproductions(alpha, printed, claim.values("dampings"))
    common = exchanged(claim, search)
    for b, x in search:
        certificates.append((f"{claim.id}_eta_b{b}_d{x}", crossings(alpha, b, x).certificate))
    lines = [f"η_b = {b}, d = {x}: limiting mass {shown(limiting(alpha, b, x), 10)}" for b, x in search]
    sentence = f"As a limiting mass {printed} is wrong: the proved one is {limit}. {stated}."
    return Finding(Verdict.REFUTED, sentence, numbers, search=(*common, *lines), certificates=certificates)


def limit_at_critical(claim: Claim) -> Finding:
    """Section 4.3: the limiting mass for masses at the critical distance."""
    alpha, eta_b, printed = claim.numbers("alpha", "eta_b", "eta_m")
    least = stability_onset(pair(alpha, eta_b, "1", "1"), over={"eta_m": ("1", "70")}, worst={"d": _NEAR}, digits=15)
    if not least.proved or least.value is None:
        return Finding(Verdict.UNDECIDABLE, str(least.reason))
    heavy = critical_at(alpha, eta_b, "70")
    place = rounded(heavy.value, 6)
    there = crossings(alpha, eta_b, place)
    numbers = (
        ("least limiting mass over d = 0.5 to 2", shown(least.value, 14)),
        ("at the distance d", shown(least.worst, 12)),
        (f"limiting mass at d = {place}, critical for η_M = 70", shown(there.crossings[0].value, 12)),
    )
    certificates = [
        (f"{claim.id}_limit", there.certificate),
        (f"{claim.id}_unstable", certificate(pair(alpha, eta_b, printed, place))),
    ]
    if rounds_to(least.value, printed) or rounds_to(there.crossings[0].value, printed):
        return Finding(Verdict.PROVED, "It is the limiting mass.", numbers, certificates=certificates)
    hits = reproductions(alpha, printed, claim.values("dampings"))
    certificates += [(f"{claim.id}_eta_b{b}_d{d}", crossings(alpha, b, d).certificate) for b, d in hits]
    search = tuple(f"η_b = {b}, d = {d}: limiting mass {shown(limiting(alpha, b, d), 10)}" for b, d in hits)
    if spectrum(pair(alpha, eta_b, printed, place)).unstable:
        sentence = (
            f"Unstable it is there (certified), but as the limiting mass it is not right: that is "
            f"{shown(there.crossings[0].value, 5)} at the critical distance, {shown(least.value, 5)} at the worst."
        )
        return Finding(Verdict.CONDITIONAL, sentence, numbers, search=search, certificates=certificates)
    sentence = f"Stable there: the limiting mass is {shown(there.crossings[0].value, 5)}."
    return Finding(Verdict.REFUTED, sentence, numbers, search=search, certificates=certificates)


def curves_cross(claim: Claim) -> Finding:
    """Section 4.4: all curves of Figure 12, onset α over η_M, cross α = 1."""
    eta_b, numbers, never, certificates = claim.number("eta_b"), [], [], []
    for d in grid(claim.number("d")):
        at_one = crossings("1", eta_b, d)
        certificates.append((f"{claim.id}_d{d}", at_one.certificate))
        if at_one.crossings:
            numbers.append((f"d = {d}: at α = 1 unstable from η_M", shown(at_one.crossings[0].value, 12)))
        else:
            numbers.append((f"d = {d}: at α = 1 unstable", "no mass"))
        below = [(limiting(a, eta_b, d), a) for a in claim.values("alpha")]
        below = [one for one in below if one[0] is not None]
        if below:
            eta, alpha = min(below, key=lambda pair_: float(pair_[0]))
            numbers.append(
                (f"d = {d}: least of the limiting masses at {len(below)} velocities below 1", shown(eta, 10))
            )
            certificates.append((f"{claim.id}_d{d}_alpha{alpha}", crossings(alpha, eta_b, d).certificate))
        if not at_one.crossings and not below:
            never.append(d)
    if never:
        text = (
            f"At d = {', '.join(never)} no mass up to η_M = 10⁶ has a real frequency at α = 1 (proved), so that "
            "curve never meets α = 1; nor is any mass unstable at the velocities below that were looked at."
        )
        return Finding(Verdict.REFUTED, text, numbers, certificates=certificates)
    sentence = (
        "For each distance masses from some value on are unstable below α = 1: the axis of η_M must reach that value."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


def one_mass_first(claim: Claim) -> Finding:
    """Figure 12: two masses become unstable at a lower velocity than one."""
    eta_b, numbers, wrong, certificates = claim.number("eta_b"), [], [], []
    for eta_m in claim.values("eta_m"):
        one = onset(eta_b, eta_m, None)
        numbers.append((f"η_M = {eta_m}: one mass", shown(one.value, 12)))
        for d in grid(claim.number("d")):
            two = onset(eta_b, eta_m, d)
            numbers.append((f"η_M = {eta_m}, d = {d}", shown(two.value, 12)))
            certificates.append((f"{claim.id}_eta{eta_m}_d{d}", two.certificate))
            if not below(two.value, one.value):
                wrong.append(f"η_M = {eta_m}, d = {d}")
    verdict = Verdict.REFUTED if wrong else Verdict.CONDITIONAL
    sentence = (
        f"Not at {'; '.join(wrong)}."
        if wrong
        else "At every one of these the pair's proved onset is the lower; for masses between them it is not proved."
    )
    return Finding(verdict, sentence, numbers, certificates=certificates)


def onset_method(claim: Claim) -> Finding:
    """Section 4.4: the root with Im q slightly below and slightly above 0 marks the onset: by certified counts."""
    eta_b, eta_m, d = claim.numbers("eta_b", "eta_m", "d")
    found = onset(eta_b, eta_m, d)
    signs, certificates, numbers = [], [], [("onset α", shown(found.value, 18)), ("q", shown(found.q, 15))]
    for side, alpha in zip(("before", "after"), claim.values("alpha"), strict=True):
        case = pair(alpha, eta_b, eta_m, d)
        signs.append(below(lowest(case), 0))
        numbers.append((f"{side}, α = {alpha}: least Im q", shown(lowest(case), 8)))
        certificates.append((f"{claim.id}_{side}", certificate(case)))
    axis = claim.number("axis")
    if signs != [False, True]:
        return Finding(Verdict.UNDECIDABLE, "The two sides were not confirmed.", numbers, certificates=certificates)
    if axis != "real":
        sentence = "The method is right, but what the root crosses is the real axis (Im q changes its sign)."
        return Finding(Verdict.SLIP, sentence, numbers, certificates=certificates)
    return Finding(Verdict.PROVED, "The root crosses the real axis.", numbers, certificates=certificates)
