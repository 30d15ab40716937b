"""The checks: complete lists of critical velocities, and proved ranges of velocities of one and of two masses."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from mpsolve import Problem, certify, critical_velocities, crossings, receptance, tracks, vehicles
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, shown
from mpsolve.errors import PrecisionError

_RAIL = {"EI": "6.4e6", "m": 60}
_THREE = {**_RAIL, "k_pad": "1e8", "m_sleeper": 250}


def critical(track: Any) -> list[Any]:
    """All critical velocities of a constant force. PrecisionError if the list is not proved complete."""
    answer = critical_velocities(track)
    if not answer.status.holds:
        raise PrecisionError(str(answer.reason))
    return [one.value for one in answer.velocities]


def _listed(what: str, values: list[Any]) -> tuple[str, str]:
    return f"{what}: critical velocities, m/s", ", ".join(shown(v, 7) for v in values)


def missing(claim: Claim) -> Finding:
    numbers, counts = [], set()
    rows = list(zip(*(claim.values(name) for name in ("k_ballast", "k_ground", "m_ballast")), strict=True))
    for shear in claim.values("shear"):
        for ballast, ground, mass in rows:
            track = tracks.ThreeLayer(**_THREE, k_ballast=ballast, m_ballast=mass, shear=shear, k_ground=ground)
            found = critical(track)
            counts.add(len(found))
            numbers.append(_listed(f"k_ballast {ballast}, k_ground {ground}, m_ballast {mass}, shear {shear}", found))
    if min(counts) >= 3 or max(counts) < 3:
        return Finding(Verdict.UNDECIDABLE, f"These tracks have {sorted(counts)} critical velocities.", numbers)
    sentence = (
        f"Of these {len(numbers)} three-layer tracks some have three or more critical velocities and some only "
        f"{min(counts)} (each list is proved complete)."
    )
    return Finding(Verdict.PROVED, sentence, numbers)


def finite(claim: Claim) -> Finding:
    layers = {**_THREE, "k_ballast": "1e8", "m_ballast": 500, "shear": "0", "k_ground": "5e7"}
    [only] = critical(tracks.ThreeLayer(**layers))
    numbers = [_listed("without damping", [only])]
    for v in claim.values("v"):
        if not below(int(v), only):
            raise PrecisionError(f"v = {v} is not below the critical velocity")
        # under the load, in float64: as the damping goes it must settle
        deflections = [
            abs(
                complex(receptance(tracks.ThreeLayer(**layers, c_pad=c, c_ballast=c), xi=[0], omega=[0.0], v=v)[0, 0])
            )
            for c in claim.values("c")
        ]
        numbers.append((f"v = {v}: deflection per N for c = {', '.join(claim.values('c'))}",
                        ", ".join(f"{w:.6g}" for w in deflections)))  # fmt: skip
        if not deflections[-1] < 1.01 * deflections[-2]:
            return Finding(Verdict.DISAGREES, f"At v = {v} the deflection grows as the damping goes.", numbers)
    sentence = (
        f"This track has one critical velocity, {shown(only, 6)} m/s (proved). At every other one below it the "
        "undamped track has no double real wavenumber under a constant force, so that its deflection is "
        "finite (proved)."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)


def two_layer_irregular(claim: Claim) -> Finding:
    numbers, counts = [], set()
    for pad, sleeper, ballast in zip(*(claim.values(n) for n in ("k_pad", "m_sleeper", "k_ballast")), strict=True):
        found = critical(tracks.TwoLayer(**_RAIL, k_pad=pad, m_sleeper=sleeper, k_ballast=ballast))
        counts.add(len(found))
        numbers.append(_listed(f"k_pad {pad}, m_sleeper {sleeper}, k_ballast {ballast}", found))
    if len(counts) == 1:
        return Finding(Verdict.UNDECIDABLE, f"All of these tracks have {counts.pop()}.", numbers)
    sentence = (
        f"Tracks of two layers have {' or '.join(map(str, sorted(counts)))} of them (each list proved complete)."
    )
    return Finding(Verdict.PROVED, sentence, numbers)


def _track(claim: Claim) -> Any:
    pad, sleeper, ballast, c = claim.numbers("k_pad", "m_sleeper", "k_ballast", "c")
    return tracks.TwoLayer(**_RAIL, k_pad=pad, m_sleeper=sleeper, k_ballast=ballast, c_pad=c, c_ballast=c)


def _undamped(claim: Claim) -> Any:
    pad, sleeper, ballast = claim.numbers("k_pad", "m_sleeper", "k_ballast")
    [only] = critical(tracks.TwoLayer(**_RAIL, k_pad=pad, m_sleeper=sleeper, k_ballast=ballast))
    return only


def _along(problem: Problem, ends: tuple[str, ...]) -> Any:
    low, high = ends
    found = crossings(problem, over={"v": (low, high)}, check=False)
    if not found.proved or found.counts is None:
        raise PrecisionError(str(found.reason))
    return found


def _windows(found: Any, ends: tuple[str, ...]) -> str:
    marks = [ends[0], *(shown(one.value, 7) for one in found.crossings), ends[1]]
    spans = [f"{a} to {b}" for a, b, n in zip(marks, marks[1:], found.counts, strict=False) if n]
    return "; ".join(spans) or "nowhere"


def one_mass(claim: Claim) -> Finding:
    only, track, ends = _undamped(claim), _track(claim), claim.values("v")
    numbers, irregular = [_listed("without damping", [only])], []
    for M in claim.values("M"):
        found = _along(Problem(track, vehicles.Mass(M), v=ends[0]), ends)
        numbers.append((f"M = {M} kg: unstable, m/s", _windows(found, ends)))
        if found.crossings and below(found.crossings[0].value, only) and 0 in found.counts[1:]:
            irregular.append(M)
    if not irregular:
        return Finding(Verdict.UNDECIDABLE, "None of these masses is unstable below the critical velocity.", numbers)
    certificate = certify(
        Problem(track, vehicles.Mass(irregular[0]), v=600), region="unstable", digits=15
    ).certificate
    sentence = (
        f"One mass of {', '.join(irregular)} kg is unstable well below the one critical velocity and stable again "
        "above that, before it becomes unstable for good (proved over the range)."
    )
    return Finding(Verdict.PROVED, sentence, numbers, certificates=[(claim.id, certificate)])


def two_masses(claim: Claim) -> Finding:
    only, track = _undamped(claim), _track(claim)
    M, gap = claim.numbers("M", "gap")
    numbers, certificates, counts = [_listed("without damping", [only])], [], {}
    for v in claim.values("v"):
        for masses in (1, 2):
            vehicle = [vehicles.Mass(M).at(k * Fraction(gap)) for k in range(masses)]
            found = certify(Problem(track, vehicle, v=v), region="unstable", digits=15)
            if not found.proved:
                raise PrecisionError(str(found.reason))
            counts[v, masses] = found.unstable
            certificates.append((f"{claim.id}_v{v}_{masses}", found.certificate))
        numbers.append((f"v = {v} m/s: growing roots of one, of two masses", f"{counts[v, 1]}, {counts[v, 2]}"))
    early = [v for v in claim.values("v") if below(int(v), only) and counts[v, 2] and not counts[v, 1]]
    calm = [v for v in claim.values("v") if early and int(v) > int(early[0]) and not counts[v, 2]]
    if not (early and calm):
        return Finding(Verdict.UNDECIDABLE, "The two masses are not unstable below the critical velocity.", numbers)
    sentence = (
        f"Two masses of {M} kg, {gap} m apart, are unstable at {early[0]} m/s, below the one critical velocity, "
        f"where one alone is stable, and stable at {calm[0]} m/s (certified)."
    )
    return Finding(Verdict.PROVED, sentence, numbers, certificates=certificates)
