"""What a claim of the paper is, and what a check finds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum

from mpsolve.certificate.format import Certificate

Printed = Mapping[str, tuple[str, ...]]
"""The numbers of a claim as printed, by name; a check reads them from here only."""


class Verdict(Enum):
    """What became of a claim."""

    PROVED = "proved"
    REFUTED = "refuted"
    CONDITIONAL = "true with a condition"
    UNDECIDABLE = "not decidable"
    SLIP = "a slip of the print"
    AGREES = "computed, agrees"
    DISAGREES = "computed, disagrees"


@dataclass(frozen=True)
class Finding:
    """The outcome of a check.

    numbers: (what, value), every digit of a value proved unless the verdict says computed. steps: the lines of a
    proof, each confirmed when the check runs. search: what parameters would reproduce a number that is not confirmed.
    certificates: (file name without suffix, certificate). stopped: the check did not come to its end.
    """

    verdict: Verdict
    sentence: str
    numbers: tuple[tuple[str, str], ...] = ()
    steps: tuple[str, ...] = ()
    search: tuple[str, ...] = ()
    certificates: tuple[tuple[str, Certificate], ...] = ()
    stopped: bool = False


@dataclass(frozen=True)
class Claim:
    """One claim: where it is printed, its words (with {name} for printed numbers), and the function that checks it.

    at: the cases that the check looks at, where the paper's words do not name them.
    """

    id: str
    place: str
    words: str
    check: Callable[[Claim], Finding]
    printed: Printed = field(default_factory=dict)
    at: Printed = field(default_factory=dict)

    @property
    def text(self) -> str:
        """The claim as printed."""
        values = {name: "; ".join(numbers) for name, numbers in self.printed.items()}
        return self.words.format(**values) if values else self.words

    def values(self, name: str) -> tuple[str, ...]:
        """The printed numbers of this name, or the cases that are looked at."""
        return self.printed[name] if name in self.printed else self.at[name]

    def number(self, name: str) -> str:
        """The same where there is only one."""
        (value,) = self.values(name)
        return value
