"""What a check finds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from mpsolve.certificate.format import Certificate


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
