"""What a claim of a paper is, what a check of it finds, and a paper as data."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING

from mpsolve.certificate.format import Certificate
from mpsolve.errors import InputError

if TYPE_CHECKING:
    from mpsolve.derivation.step import Step


class Verdict(Enum):
    """What became of a claim."""

    PROVED = "proved"
    REFUTED = "refuted"
    CONDITIONAL = "true with a condition"
    UNDECIDABLE = "not decidable"
    SLIP = "a slip of the print"
    AGREES = "computed, agrees"
    DISAGREES = "computed, disagrees"

    @property
    def tone(self) -> str:
        """One word for how it is shown: good, bad, half, open or slip."""
        tones = {"REFUTED": "bad", "DISAGREES": "bad", "CONDITIONAL": "half", "UNDECIDABLE": "open", "SLIP": "slip"}
        return tones.get(self.name, "good")


@dataclass(frozen=True)
class Finding:
    """The outcome of a check.

    numbers: (what, value), every digit of a value proved unless the verdict says computed. steps: the lines of a
    proof, each confirmed when the check runs. search: what parameters would reproduce a number that is not confirmed.
    certificates: (file name without suffix, certificate); those that could not be made are given as None, and left
    out. stopped: the check did not come to its end. Lists are kept as tuples.
    """

    verdict: Verdict
    sentence: str
    numbers: Sequence[tuple[str, str]] = ()
    steps: Sequence[str] = ()
    search: Sequence[str] = ()
    certificates: Sequence[tuple[str, Certificate | None]] = ()
    stopped: bool = False

    def __post_init__(self) -> None:
        for name in ("numbers", "steps", "search"):
            object.__setattr__(self, name, tuple(getattr(self, name)))
        object.__setattr__(self, "certificates", tuple(one for one in self.certificates if one[1] is not None))

    @property
    def uncertified(self) -> str:
        """How the finding was reached where it has no certificate; empty where it has one."""
        if self.certificates:
            return ""
        if self.verdict is Verdict.UNDECIDABLE:
            return "nothing is proved"
        computed = self.verdict in (Verdict.AGREES, Verdict.DISAGREES)
        return "computed, not proved" if computed else "proved by computation"


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


@dataclass(frozen=True)
class Paper:
    """The claims of a paper in the order of the report.

    citation: one line that names the paper. quotes: the paper's own words for a claim, by its name. notation: what a
    reader has to know of the signs in them. slow: names of the claims whose checks take longest: they begin first.
    where: the folder or module that it was loaded from. derivation: its equations in order, as steps of sympy, for
    so many masses; None where it derives nothing.
    """

    title: str
    citation: str
    claims: Sequence[Claim]
    quotes: Mapping[str, str] = field(default_factory=dict)
    notation: str = ""
    slow: Sequence[str] = ()
    where: str = ""
    derivation: Callable[[int], Sequence[Step]] | None = None

    def __post_init__(self) -> None:
        """InputError for a name that two claims have, or that no claim has."""
        names = [claim.id for claim in self.claims]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise InputError("claims", f"{', '.join(twice)} is the name of two claims: give each its own")
        if strange := [name for name in (*self.quotes, *self.slow) if name not in names]:
            raise InputError("claims", f"{', '.join(strange)} has a quote or a place in `slow` but is no claim")

    def derived(self, masses: int) -> Sequence[Step]:
        """The steps of its derivation; InputError where there is none."""
        if self.derivation is None:
            raise InputError("paper", f"{self.title!r} derives nothing: let its PAPER say derivation=…")
        return self.derivation(masses)

    def claim(self, name: str) -> Claim:
        """The claim of exactly this name."""
        return next(claim for claim in self.claims if claim.id == name)

    def quote(self, claim: Claim) -> str:
        """The claim as printed."""
        return self.quotes.get(claim.id, claim.text)

    def chosen(self, only: Sequence[str]) -> tuple[Claim, ...]:
        """The claims of these names, and of names that go on with "-", as "xii" has xii-a. InputError if none has."""
        for name in only:
            if not any(_named(claim, name) for claim in self.claims):
                known = ", ".join(claim.id for claim in self.claims)
                raise InputError(
                    "only", f"{name!r} is no claim: give one of {known}, or the beginning up to a hyphen"
                )
        return tuple(claim for claim in self.claims if not only or any(_named(claim, name) for name in only))

    @property
    def command(self) -> str:
        """The command line that checks it again."""
        here = Path.cwd()
        folder = Path(self.where)
        return f"mpsolve audit {folder.relative_to(here) if folder.is_relative_to(here) else self.where or 'FOLDER'}"


def _named(claim: Claim, name: str) -> bool:
    return claim.id == name or claim.id.startswith(f"{name}-")
