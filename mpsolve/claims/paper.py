"""A paper as data: its claims, and its words where they are quoted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from mpsolve.claims.claim import Claim
from mpsolve.errors import InputError


@dataclass(frozen=True)
class Paper:
    """The claims of a paper in the order of the report.

    citation: one line that names the paper. quotes: the paper's own words for a claim, by its name. notation: what a
    reader has to know of the signs in them. slow: names of the claims whose checks take longest: they begin first.
    where: the folder or module that it was loaded from.
    """

    title: str
    citation: str
    claims: Sequence[Claim]
    quotes: Mapping[str, str] = field(default_factory=dict)
    notation: str = ""
    slow: Sequence[str] = ()
    where: str = ""

    def __post_init__(self) -> None:
        """InputError for a name that two claims have, or that no claim has."""
        names = [claim.id for claim in self.claims]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise InputError("claims", f"{', '.join(twice)} is the name of two claims: give each its own")
        if strange := [name for name in (*self.quotes, *self.slow) if name not in names]:
            raise InputError("claims", f"{', '.join(strange)} has a quote or a place in `slow` but is no claim")

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
