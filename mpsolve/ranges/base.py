"""The certified roots at one point of a range, from which all others in it are counted."""

from __future__ import annotations

from typing import Any

from mpsolve.certificate.solve import certify_problem
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.regions import HalfPlane
from mpsolve.spectrum.spectrum import Spectrum

_DIGITS = 15


def base_at(problem: Problem, effort: Effort | None, check: bool, region: object = "unstable") -> Spectrum:
    """The certified roots of the problem, with so much effort."""
    return certify_problem(problem, region=region, digits=_DIGITS, effort=effort, check=check)


def growing(base: Spectrum) -> int | None:
    """The certified number of roots in the whole half-plane Im q < 0; None where only a part of it is counted."""
    return base.unstable if base.proved and base.region == HalfPlane() else None


def uncounted(base: Any, where: str) -> Reason:
    """Why the roots at a point, from which all others are counted, are not counted: as its own spectrum says."""
    why = getattr(base, "note", "")
    stated = f"whether a root grows {where} is open"
    return base.reason or Reason("base", f"{stated}: {why}" if why else stated, {}, "")
