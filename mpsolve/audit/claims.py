"""What a claim of the paper is, and what a check finds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum

from mpsolve.audit.quotes import QUOTES
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


COMPUTED = (Verdict.AGREES, Verdict.DISAGREES)


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

    at: the cases that the check looks at, where the paper's words do not name them. The words are the paper's own, or
    say what is tried where `quotes` holds those.
    """

    id: str
    place: str
    words: str
    check: Callable[[Claim], Finding]
    printed: Printed = field(default_factory=dict)
    at: Printed = field(default_factory=dict)

    @property
    def text(self) -> str:
        """What is tried."""
        values = {name: "; ".join(numbers) for name, numbers in self.printed.items()}
        return self.words.format(**values) if values else self.words

    @property
    def quote(self) -> str:
        """The claim as printed."""
        return QUOTES.get(self.id, self.text)

    def values(self, name: str) -> tuple[str, ...]:
        """The printed numbers of this name, or the cases that are looked at."""
        return self.printed[name] if name in self.printed else self.at[name]

    def without_certificate(self, finding: Finding) -> str:
        """What stands in place of certificates where the finding has none."""
        if finding.certificates:
            return ""
        how = "computed, not proved" if finding.verdict in COMPUTED else "proved by computation"
        if finding.verdict is Verdict.UNDECIDABLE:
            how = "nothing is proved"
        return f"No certificate: {how}; recompute with mpsolve audit --only {self.id}"

    def number(self, name: str) -> str:
        """The same where there is only one."""
        (value,) = self.values(name)
        return value
