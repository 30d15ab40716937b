"""What a claim of a paper is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from mpsolve.claims.finding import Finding

Printed = Mapping[str, tuple[str, ...]]
"""The numbers of a claim as printed, by name; a check reads them from here only."""


@dataclass(frozen=True)
class Claim:
    """One claim: where it is printed, its words (with {name} for printed numbers), and the function that checks it.

    at: the cases that the check looks at, where the paper's words do not name them. The words are the paper's own, or
    say what is tried where the paper's `quotes` hold those.
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

    def values(self, name: str) -> tuple[str, ...]:
        """The printed numbers of this name, or the cases that are looked at."""
        return self.printed[name] if name in self.printed else self.at[name]

    def number(self, name: str) -> str:
        """The same where there is only one."""
        (value,) = self.values(name)
        return value

    def numbers(self, *names: str) -> tuple[str, ...]:
        """`number` of each."""
        return tuple(self.number(name) for name in names)
