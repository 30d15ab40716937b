"""The certified roots at one point of a range, from which all others in it are counted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from mpsolve.certificate.solve import certify_problem
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.scope import OpenError, Scope
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


@dataclass
class Question:
    """Ranges under proof, with the effort that is left, and the spectrum from which roots are counted."""

    problem: Problem
    over: dict[str, Interval]
    scope: Scope
    digits: int
    budget: Effort
    progress: Progress
    check: bool
    base: Any = None

    def answer(self) -> Any:
        """What is proved; `OpenError` where it stays open."""
        raise NotImplementedError

    def told(self, started: float, code: str, remedy: str) -> tuple[Any, Reason | None, Spent]:
        """(the answer, None) or (None, why it stays open), and what was spent from this processor time on."""
        found = reason = None
        try:
            found = self.answer()
        except (OpenError, EffortError) as error:
            reason = error.reason
        except PrecisionError as error:
            reason = Reason(code, str(error), {}, remedy)
        return found, reason, Spent.since(started, self.base, boxes=self.budget.spent)
