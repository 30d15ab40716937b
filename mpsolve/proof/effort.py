"""How much work an answer may take: evaluations, seconds of processor time, or both."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from time import process_time
from typing import Any

from mpsolve.errors import EffortError, InputError
from mpsolve.outcome import Reason
from mpsolve.proof.stopping import end_if_asked

MORE_EFFORT = "allow more effort, with effort=Effort(seconds=…)"
_LEAST = 0.1  # of the seconds, left for a proof that concludes what is known


@dataclass
class Effort:
    """How much work an answer may take: seconds of processor time, evaluations of Δ, or both. None: no limit.

    One object may serve any number of questions: each starts from 0.
    """

    seconds: float | None = None
    evaluations: int | None = None
    spent: int = field(default=0, init=False, repr=False, compare=False)
    started: float = field(default_factory=process_time, init=False, repr=False, compare=False)
    whole: Effort | None = field(default=None, init=False, repr=False, compare=False)
    """That of which this is a part: its limits are told, as they were asked for."""

    def __post_init__(self) -> None:
        _check("seconds", self.seconds, (int, float), "number")
        _check("evaluations", self.evaluations, int, "whole number")

    def anew(self) -> Effort:
        """The same limits with nothing spent, from now on."""
        return self._part(self.seconds, self.evaluations, self.whole)

    def half(self) -> Effort:
        """Half of both limits, with nothing spent."""
        seconds = None if self.seconds is None else self.seconds / 2
        return self._part(seconds, None if self.evaluations is None else max(self.evaluations // 2, 1))

    def share(self, evaluations: int) -> Effort:
        """A part of so many evaluations, within the same time."""
        part = Effort(self.seconds, evaluations)
        part.started = self.started
        return part

    def left(self) -> Effort:
        """The same limits without the seconds that have passed; some are left in any case."""
        seconds = self.seconds
        if seconds is not None:
            seconds = max(seconds - (process_time() - self.started), _LEAST * seconds)
        return self._part(seconds, self.evaluations)

    def rest(self) -> Effort | None:
        """The seconds that are left, for a proof within the one under way; None: no limit."""
        return None if self.seconds is None else self._part(self.left().seconds, None)

    def _part(self, seconds: float | None, evaluations: int | None, whole: Effort | None = None) -> Effort:
        part = Effort(seconds, evaluations)
        part.whole = whole or self.whole or self
        return part

    def spend(self, evaluations: int) -> None:
        """Count evaluations of the characteristic function; EffortError where they are too many, or after Ctrl-C."""
        end_if_asked()
        self.spent += evaluations
        asked = self.whole or self
        if self.evaluations is not None and self.spent > self.evaluations:
            many = asked.evaluations or self.evaluations
            self._end(f"{many} evaluations", {"evaluations": str(many)})
        if self.seconds is not None and process_time() - self.started > self.seconds:
            seconds = asked.seconds or self.seconds
            self._end(f"{seconds:g} s of processor time", {"seconds": f"{seconds:g}"})

    @staticmethod
    def _end(limit: str, numbers: dict[str, str]) -> None:
        raise EffortError(Reason("effort", f"the effort of {limit} is spent", numbers, MORE_EFFORT))


def begun(effort: Effort | None, evaluations: int | None = None) -> Effort:
    """The same limits, of which nothing is spent; for None so many evaluations. InputError for what is no Effort."""
    if effort is not None and not isinstance(effort, Effort):
        raise InputError("effort", f"is of type {type(effort).__name__}: give Effort(seconds=…, evaluations=…)")
    return Effort(evaluations=evaluations) if effort is None else effort.anew()


def _check(name: str, value: Any, kind: Any, wanted: str) -> None:
    if value is None:
        return
    if isinstance(value, bool) or not isinstance(value, kind) or not 0 < value < math.inf:
        raise InputError(f"effort.{name}", f"is {value!r}: give a {wanted} above 0, or None for no limit")
