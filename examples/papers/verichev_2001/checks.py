"""The checks: certified spectra, and proved ranges of the oscillator's parameters."""

from __future__ import annotations

from typing import Any

from mpsolve import Problem, certify, critical_velocities, crossings, tracks, vehicles
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, shown
from mpsolve.errors import PrecisionError

TRACK = tracks.Timoshenko(EI="6.4e6", m=60, S="2.5e8", J="0.24", k="1e6", c=770)
_SUSPENSION: dict[str, Any] = {"k": "1e6", "c": "1e4"}


def oscillator(v: str, wheel: str) -> Problem:
    """A body of 10 t on a sprung wheel."""
    return Problem(TRACK, vehicles.Oscillator(wheel=wheel, body=10000, **_SUSPENSION), v=v)


def bogie(v: str, wheel: str) -> Problem:
    """Two wheels under a frame."""
    frame = vehicles.Bogie(wheel=wheel, frame=3000, inertia=3000, wheelbase="3.4", **_SUSPENSION)
    return Problem(TRACK, frame, v=v)


def certified(problem: Problem) -> Any:
    """The growing frequencies. PrecisionError if their number is not proved."""
    found = certify(problem, region="unstable", digits=15)
    if not found.proved:
        raise PrecisionError(str(found.reason))
    return found


def grows(claim: Claim) -> Finding:
    v, wheel = claim.numbers("v", "wheel")
    return _growing(claim, certified(oscillator(v, wheel)), f"wheel {wheel} kg, v = {v} m/s")


def bogie_grows(claim: Claim) -> Finding:
    v, wheel = claim.numbers("v", "wheel")
    return _growing(claim, certified(bogie(v, wheel)), f"wheels of {wheel} kg, v = {v} m/s")


def _growing(claim: Claim, found: Any, what: str) -> Finding:
    if not found.unstable:
        return Finding(Verdict.UNDECIDABLE, f"Nothing grows here: {what}.")
    numbers = [
        (f"growth −Im q of Re q = {shown(root.q.real, 6)}, 1/s", shown(-root.q.imag, 10))
        for root in found.roots
        if below(0, root.q.real)
    ]
    sentence = f"For {what} exactly {found.unstable} roots grow (certified)."
    return Finding(Verdict.PROVED, sentence, numbers, certificates=[(claim.id, found.certificate)])


def domains(claim: Claim) -> Finding:
    v = claim.number("v")
    numbers, mixed = [], []
    for name, unit in (("wheel", "kg"), ("k", "N/m"), ("c", "N s/m")):
        low, high = claim.values(name)
        found = crossings(oscillator(v, "1000"), over={f"vehicles[0].{name}": (low, high)})
        if not found.proved or found.counts is None:
            raise PrecisionError(str(found.reason))
        numbers += [(f"{name}: a boundary, {unit}", shown(one.value, 12)) for one in found.crossings]
        numbers.append((f"  growing roots from {low} to {high}", ", ".join(map(str, found.counts))))
        mixed.append(0 in found.counts and any(found.counts))
    if not all(mixed):
        return Finding(Verdict.UNDECIDABLE, f"One of them decides nothing at v = {v} m/s.", numbers)
    sentence = (
        f"At v = {v} m/s, a wheel of 1 t: along each of wheel mass, stiffness and damping of the suspension both "
        "stable and unstable values occur, and every boundary between them is proved."
    )
    return Finding(Verdict.PROVED, sentence, numbers)


def bogie_below(claim: Claim) -> Finding:
    wheel = claim.number("wheel")
    answer = critical_velocities(TRACK)
    least = answer.velocities[0].value
    numbers = [("least velocity of a wave with the force, m/s", shown(least, 12))]
    certificates, slower = [], []
    for v in claim.values("v"):
        found = certified(bogie(v, wheel))
        numbers.append((f"v = {v} m/s: growing roots", str(found.unstable)))
        certificates.append((f"{claim.id}_v{v}", found.certificate))
        if found.unstable and below(int(v), least):
            slower.append(v)
    if not slower:
        return Finding(Verdict.UNDECIDABLE, "No case below that velocity is unstable here.", numbers)
    sentence = (
        f"On the damped track a bogie with wheels of {wheel} kg is unstable at v = {', '.join(slower)} m/s "
        f"(certified), below the {shown(least, 5)} m/s at which waves first run with it."
    )
    return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
