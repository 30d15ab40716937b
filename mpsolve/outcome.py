"""What became of a question: its status, and one reason from which every kind of output makes its own sentence.

A `Reason` is kept as parts, so that the terminal prints a sentence, JSON the parts, and a page may link the remedy.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import Enum
from types import MappingProxyType
from typing import Any

from mpsolve.frozen import frozen


class Status(Enum):
    """How far an answer is to be trusted."""

    PROVED = "proved"  # and the certificate passed the standalone verifier, where there is one
    UNVERIFIED = "proved, not verified"  # proved, but the verifier was not asked
    UNDECIDED = "undecided"
    REFUTED = "refuted"

    @property
    def holds(self) -> bool:
        """Whether the claim is proved."""
        return self in (Status.PROVED, Status.UNVERIFIED)


@frozen
class Reason:
    """Why an answer is undecided or refused, and what to do.

    code: a short name that programs compare, like "contour-root"; it does not change when the words do.
    message: one plain sentence without a full stop. numbers: what the sentence speaks of, as decimal strings.
    remedy: what to do, as an imperative; "" where nothing is known to help.
    """

    code: str
    message: str
    numbers: Mapping[str, str] = field(default_factory=dict)
    remedy: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "numbers", MappingProxyType(dict(self.numbers)))

    def __str__(self) -> str:
        return f"{self.message}: {self.remedy}" if self.remedy else self.message

    def __hash__(self) -> int:
        return hash((self.code, self.message, tuple(sorted(self.numbers.items())), self.remedy))

    def __reduce__(self) -> tuple[Any, ...]:
        return Reason, (self.code, self.message, dict(self.numbers), self.remedy)

    def data(self) -> dict[str, Any]:
        """The parts, for JSON."""
        return {"code": self.code, "message": self.message, "numbers": dict(self.numbers), "remedy": self.remedy}
