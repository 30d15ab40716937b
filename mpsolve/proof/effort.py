"""How much work an answer may take: evaluations, seconds of processor time, or both."""

from __future__ import annotations

from dataclasses import dataclass, field
from time import process_time

from mpsolve.errors import EffortError


@dataclass
class Effort:
    """A budget that proofs spend; EffortError when it is spent. None: no limit."""

    seconds: float | None = None
    evaluations: int | None = None
    spent: int = 0
    started: float = field(default_factory=process_time)

    def spend(self, evaluations: int) -> None:
        """Count evaluations of the characteristic function."""
        self.spent += evaluations
        if self.evaluations is not None and self.spent > self.evaluations:
            raise EffortError(f"the effort of {self.evaluations} evaluations is spent")
        if self.seconds is not None and process_time() - self.started > self.seconds:
            raise EffortError(f"the effort of {self.seconds:g} s of processor time is spent")
