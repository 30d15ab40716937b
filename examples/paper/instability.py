"""Sections 1 and 5 in passing: how many induced frequencies there are, and whether instability fills one interval."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from mpsolve import Unstable, unstable_ranges
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import shown
from mpsolve.errors import PrecisionError

from .cases import certificate, listed, pair, spectrum


def more_frequencies(claim: Claim) -> Finding:
    """Section 5: two masses have more induced frequencies than one."""
    numbers, certificates, wrong = [], [], []
    for where, name, two in listed(claim):
        one = replace(two, eta_m=two.eta_m[:1], positions=two.positions[:1])
        counts = [sum(root.multiplicity for root in spectrum(case).roots) for case in (two, one)]
        numbers.append((f"{where}: induced frequencies of two masses, of one", f"{counts[0]}, {counts[1]}"))
        if counts[0] <= counts[1]:
            wrong.append(where)
            alone = f"{name.rpartition('_d')[0]}_single"
            certificates += [(name, certificate(two)), (alone, certificate(one))]
    if not wrong:
        return Finding(Verdict.UNDECIDABLE, "No case of the list has no more, and there is no proof.", numbers)
    sentence = f"Not at {'; '.join(wrong)}: there two masses have no more than one (certified)."
    return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)


def one_interval(claim: Claim) -> Finding:
    """Section 1: the unstable velocities constitute one interval, and its lowest is the onset."""
    eta_b, eta_m, d, top = claim.numbers("eta_b", "eta_m", "d", "alpha")
    found = unstable_ranges(pair("0.5", eta_b, eta_m, d), over={"v": (0, top)}, digits=15)
    if not found.proved:
        raise PrecisionError(str(found.reason))
    ranges = _joined(found.intervals)
    numbers = [
        (f"unstable range {k}: α from, to", f"{shown(start, 12)}, {shown(end, 12)}")
        for k, (start, end) in enumerate(ranges, 1)
    ]
    certificates = [(claim.id, found.certificate)]
    if len(ranges) < 2:
        sentence = "One interval, or none, in this case; in general it is not proved."
        return Finding(Verdict.UNDECIDABLE, sentence, numbers, certificates=certificates)
    sentence = (
        f"With η_b = {eta_b}, η_M = {eta_m}, d = {d} there are {len(ranges)} unstable ranges up to α = {top}, and "
        "every α between them is stable (all proved). The lowest unstable velocity is the onset, but it does not "
        "tell all."
    )
    return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)


def _joined(intervals: Sequence[Unstable]) -> list[tuple[Any, Any]]:
    """The ends of the ranges; parts with other numbers of roots that meet at one crossing are one."""
    out: list[tuple[Any, Any]] = []
    for one in intervals:
        start = out.pop()[0] if out and out[-1][1] is one.start else one.start
        out.append((start, one.end))
    return out


CLAIMS = (
    Claim(
        "5-more-frequencies", "Section 5",
        "Two equal masses always have more induced frequencies than one.",
        more_frequencies, {}, {"cases": ("0 0.5 40 0.5", "0 0.8 40 0.5", "0.05 0.98 10 3")},
    ),
    Claim(
        "1-interval", "Section 1",
        "The unstable velocities constitute one interval.",
        one_interval, {}, {"eta_b": ("0.05",), "eta_m": ("50",), "d": ("1.5",), "alpha": ("2",)},
    ),
)  # fmt: skip
