"""The checks: ranges of velocities and of compression, proved, and certified spectra inside them."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve import Problem, certify, crossings, onset, receptance, tracks, vehicles
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, grid, shown
from mpsolve.errors import PrecisionError
from mpsolve.ranges.onset import Kind

_PLACES = np.linspace(-15.0, 10.0, 1001)  # about the load, where its greatest deflection is looked for


def problem(c: str, N: str, M: str, v: str) -> Problem:
    """One mass; the beam in units in which it has EI = 1/4, m = k = 1."""
    return Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=c, N=N), vehicles.Mass(M), v=v)


@lru_cache(maxsize=32)
def first(c: str, N: str, M: str, low: str, high: str) -> Any:
    """The velocity at which instability starts between two velocities. PrecisionError if that is not proved."""
    found = onset(problem(c, N, M, high), over={"v": (low, high)})
    if found.kind is not Kind.CROSSES:
        raise PrecisionError(f"no onset is proved for c = {c}, N = {N}: {found.kind.value}, {found.reason}")
    return found


def along(given: Problem, path: str, ends: tuple[str, ...]) -> Any:
    """All crossings over one parameter, with the numbers of growing roots between. PrecisionError if not proved."""
    low, high = ends
    found = crossings(given, over={path: (low, high)})
    if not found.proved or found.counts is None:
        raise PrecisionError(str(found.reason))
    return found


def from_one_on(counts: tuple[int, ...]) -> bool | None:
    """Whether it is stable first, and never again once unstable; None where it is never unstable."""
    if not any(counts):
        return None
    return counts[0] == 0 and all(counts[next(k for k, n in enumerate(counts) if n) :])


def starts(claim: Claim) -> Finding:
    c, M = claim.numbers("c", "M")
    ends = claim.values("v")
    found = along(problem(c, "0", M, ends[1]), "v", ends)
    numbers = [(f"{_seen(found)}; the roots change at v", shown(one.value, 14)) for one in found.crossings]
    certificates = _sides(claim, "1.25", "1.27")
    answer = from_one_on(found.counts)
    if answer is None:
        return Finding(Verdict.UNDECIDABLE, f"Nothing is unstable up to v = {ends[1]}.", numbers)
    if not answer:
        sentence = "The unstable velocities are not all from one on."
        return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
    sentence = (
        f"For M = {M}, c = {c}, N = 0 every velocity from {ends[0]} to the onset is stable, and every one from there "
        f"to {ends[1]} unstable (proved); for faster ones and other parameters it is not proved."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)


def grows(claim: Claim) -> Finding:
    c, M, v = claim.numbers("c", "M", "v")
    found = certify(problem(c, "0", M, v), region="unstable", digits=15)
    growing = [root for root in found.roots if below(root.q.imag, 0) and below(0, root.q.real)]
    if not (found.proved and growing):
        return Finding(Verdict.UNDECIDABLE, "No growing vibration is proved at this velocity.")
    numbers = [(f"v = {v}: a growing frequency q, with its mirror −q̄", shown(root.q.real, 12)) for root in growing]
    numbers += [("  growth, −Im q", shown(-root.q.imag, 12)) for root in growing]
    sentence = (
        f"For M = {M}, c = {c}, v = {v} exactly {found.unstable} frequencies have Im q < 0 (proved): as e^(iqt) they "
        "grow exponentially, with these rates."
    )
    return Finding(Verdict.PROVED, sentence, numbers, certificates=[(claim.id, found.certificate)])


def falls(claim: Claim) -> Finding:
    c, M = claim.numbers("c", "M")
    low, high = claim.values("v")
    found = [first(c, N, M, low, high) for N in claim.values("N")]
    numbers = [(f"N = {N}: onset v", shown(one.value, 14)) for N, one in zip(claim.values("N"), found, strict=True)]
    if not all(below(y.value, x.value) for x, y in pairwise(found)):
        return Finding(Verdict.REFUTED, "The onset does not fall from each compression to the next.", numbers)
    sentence = (
        f"For M = {M}, c = {c} the proved onset falls from each of these compressions to the next, down to "
        f"{shown(found[-1].value, 4)} of the critical velocity without compression."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)


def falls_between(claim: Claim) -> Finding:
    c, M = claim.numbers("c", "M")
    ends, numbers = claim.values("N"), []
    for v in claim.values("v"):
        found = along(problem(c, "0", M, v), "track.N", ends)
        numbers += [(f"v = {v}: {_seen(found)}; they change at N", shown(one.value, 12)) for one in found.crossings]
        answer = from_one_on(found.counts)
        if answer is None:
            return Finding(Verdict.UNDECIDABLE, f"At v = {v} no compression up to {ends[1]} is unstable.", numbers)
        if not answer:
            return Finding(Verdict.REFUTED, f"At v = {v} the unstable compressions are not all from one on.", numbers)
    sentence = (
        f"For M = {M}, c = {c} at each of these velocities every compression from N = {ends[0]} to a limit is "
        f"stable, every one from there to {ends[1]} unstable (proved for all N between)."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)


def overcritical(claim: Claim) -> Finding:
    M = claim.number("M")
    low, high = claim.values("v")
    numbers, certificates = [], []
    for c in claim.values("c"):
        numbers.append((f"c = {c}: onset v", shown(first(c, "0", M, low, high).value, 14)))
        there = certify(problem(c, "0", M, high), region="unstable", digits=15)
        if not (there.proved and there.unstable):
            return Finding(Verdict.UNDECIDABLE, f"No growing vibration is proved for c = {c}.", numbers)
        numbers.append((f"  growing frequencies at v = {high}", str(there.unstable)))
        certificates.append((f"{claim.id}_c{c}", there.certificate))
    sentence = (
        f"For M = {M} without compression the mass becomes unstable at these velocities (proved): at the critical "
        "viscosity, 2, and above it. They are higher than with little viscosity."
    )
    return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)


def no_resonance(claim: Claim) -> Finding:
    velocities = grid(claim.number("v"))
    peaks = {c: greatest(c, velocities) for c in (*claim.values("c"), claim.number("c_light"))}
    numbers = [
        (f"c = {c}: greatest deflection under a constant force, over that at rest", f"{max(w) / w[0]:.4g}")
        for c, w in peaks.items()
    ]
    light = peaks[claim.number("c_light")]
    amplified = [c for c in claim.values("c") if max(peaks[c]) > peaks[c][0]]
    if amplified:
        return Finding(Verdict.DISAGREES, f"It is amplified for c = {', '.join(amplified)}.", numbers)
    sentence = (
        f"At {len(velocities)} velocities up to {velocities[-1]} the deflection is nowhere greater than at rest, and "
        f"it is {max(light) / light[0]:.2g} times as great for c = {claim.number('c_light')} (in float64)."
    )
    return Finding(Verdict.AGREES, sentence, numbers)


def greatest(c: str, velocities: tuple[str, ...]) -> list[float]:
    """The greatest deflection under a constant unit force at each velocity, in float64."""
    track = problem(c, "0", "1", "0").track
    return [float(np.abs(receptance(track, xi=_PLACES, omega=[0.0], v=v)).max()) for v in velocities]


def _sides(claim: Claim, stable: str, unstable: str) -> list[tuple[str, Any]]:
    """Certificates of both sides of the onset."""
    c, M = claim.numbers("c", "M")
    return [
        (f"{claim.id}_v{v}", certify(problem(c, "0", M, v), region="unstable", digits=15).certificate)
        for v in (stable, unstable)
    ]


def _seen(found: Any) -> str:
    return f"growing roots {', '.join(map(str, found.counts))}"
