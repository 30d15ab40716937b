"""Crossings in a range of masses without an upper end: all up to some mass, and none from there on (`heavy`)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import isfinite
from time import process_time
from typing import Any

from mpsolve.errors import InputError
from mpsolve.outcome import Reason, Status
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import Covered
from mpsolve.ranges.answer import Interval, Proof
from mpsolve.ranges.default import rounded_up
from mpsolve.ranges.heavy import ONLY_MASSES, Heavy, SeenError
from mpsolve.ranges.scope import OpenError, scope_of

_TRIES, _BOXES = 40, 30_000  # masses from which on it is tried; boxes for each
_MASSES = ("scale.mass", "vehicles", "eta_m")  # paths that may be factors of all masses
_BEYOND = 2  # times the heaviest mass at which a root seems to be real


@dataclass(frozen=True)
class Beyond:
    """From `mass` on no root is real, by `proofs`; reason: why that is not proved of any mass."""

    mass: Fraction
    proofs: tuple[Proof, ...] = ()
    reason: Reason | None = None


def beyond(problem: Problem, path: str, low: Fraction, budget: Effort) -> Beyond:
    """A mass above `low` from which on no root is real however heavy it is, and why."""
    mass = max(2 * low, problem.parameters.get(path, Fraction(1)))
    over = {path: (mass, 2 * mass)}
    heavy = Heavy(scope_of(problem, over), path)
    family = heavy.scope.family
    unit = family.units[0]
    found: tuple[Covered, ...] = ()
    for _ in range(_TRIES):
        part = Effort(seconds=budget.seconds, evaluations=min(_BOXES, budget.evaluations or _BOXES))
        try:
            found = heavy.cover(mass / unit, part)
        except SeenError as error:
            if not isfinite(error.x):
                break
            mass = rounded_up(Fraction(error.x) * unit * _BEYOND)
            continue
        finally:
            budget.spent += part.spent
        reason = next((one.reason for one in found if one.reason is not None), None)
        if reason is None:
            over = {path: (mass, mass)}
            X, q = heavy.scope.X, family.frequency_unit
            return Beyond(mass, tuple(Proof(over, family.units, q, X, one) for one in found))
        break
    stated = "it is not decided whether roots are real for masses without end"
    remedy = "give an upper end, or a velocity farther from where heavy masses become unstable"
    return Beyond(mass, reason=Reason("endless", stated, {}, remedy))


def require_mass(path: str) -> None:
    """InputError for a range without an upper end of what cannot be a factor of all masses."""
    if not path.startswith(_MASSES):
        raise InputError(path, ONLY_MASSES)


def endless(
    problem: Problem,
    over: Mapping[str, Interval],
    find: Callable[[dict[str, Interval]], Any],
    undecided: Callable[[Reason], Any],
    budget: Effort,
    progress: Progress,
) -> Any:
    """The answer of `find` over as much of the range as needs it, said of the whole."""
    started = process_time()
    ((path, (low, _)),) = over.items()
    progress("heavy", 0.0)
    try:
        rest = beyond(problem, path, low, budget)
    except OpenError as error:
        return undecided(error.reason)
    seconds = process_time() - started
    found = find({path: (low, rest.mass)})
    cost = replace(found.cost, seconds=found.cost.seconds + seconds, boxes=found.cost.boxes + budget.spent)
    if not found.proved or rest.reason is not None:
        known = {**found.known, "up to": rest.mass} if found.proved else found.known
        reason = found.reason or rest.reason
        return replace(found, over=dict(over), status=Status.UNDECIDED, reason=reason, known=known, cost=cost,
                       certificate=None, counts=None)  # fmt: skip
    note = f"no certificate says what holds without end, as the theorem of {path} ≥ {float(rest.mass):.6g} does"
    if found.certificate is not None:
        note += ", and the certificate is of the range up to there"
    return replace(
        found, over=dict(over), status=Status.UNVERIFIED, note=note, proofs=(*found.proofs, *rest.proofs), cost=cost
    )
