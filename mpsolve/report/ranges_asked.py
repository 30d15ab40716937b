"""A question about ranges as it was asked: what the file holds, and the ranges in the user's own units."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from mpsolve.errors import InputError
from mpsolve.outcome import Reason
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.over import Over, parse_overs
from mpsolve.problem.problem import Problem
from mpsolve.problem.warned import titled, warned

_NO_END = "has no upper end, which only onset and crossings may have: give one, such as {path}=0..{example}"


@dataclass(frozen=True)
class Asked:
    """given: of the file; problem: the same as a Problem; overs: the ranges, by default where the user gave none.

    slower: of an answer that speaks of v only from a small velocity on, though it was asked from 0 on.
    skipped: the velocities before a default range of which nothing is asked, round a wave speed.
    """

    given: Given
    problem: Problem
    title: str
    overs: tuple[Over, ...]
    by_default: bool = False
    slower: bool = False
    skipped: tuple[Fraction, Fraction] | None = None

    @property
    def over(self) -> dict[str, tuple[Fraction, Fraction | None]]:
        """The ranges as the library takes them; an end that is open is None."""
        return {one.path: (one.low, one.high) for one in self.overs}

    @property
    def si(self) -> bool:
        """Whether quantities are in SI; a Case has the paper's ratios."""
        return not isinstance(self.given, Case)

    @property
    def warnings(self) -> tuple[Reason, ...]:
        """What looks like a mistake in the problem, and each given range that does not hold the file's own value."""
        free = {one.path for one in self.overs}
        found = (*titled(self.given, self.title), *warned(self.given))
        own = [reason for reason in found if not free & reason.numbers.keys()]
        outside = () if self.by_default else (one.outside(self.problem) for one in self.overs)
        return (*own, *(reason for reason in outside if reason is not None))

    @property
    def ranges(self) -> str:
        """The ranges in words: "v from 0 km/h to 400 km/h"."""
        return ", ".join(
            f"{one.path} from {one.told(one.low)} {'on' if one.high is None else f'to {one.told(one.high)}'}"
            for one in self.overs
        )

    def by_itself(self, over: Mapping[str, tuple[Fraction, Fraction]]) -> Asked:
        """The same question over ranges that the user did not give; velocities are told in km/h."""
        return replace(self, overs=tuple(self._of(path, *ends) for path, ends in over.items()), by_default=True)

    def second(self, texts: Iterable[str]) -> Asked:
        """The same question over another range: of a parameter that is left to its worst value."""
        return asked(self.given, self.title, texts, "--worst")

    def answered(self, over: Mapping[str, tuple[Fraction, Fraction]]) -> Asked:
        """The same question over the ranges of which an answer speaks."""
        slower = any(one.path == "v" and one.low == 0 and over["v"][0] > 0 for one in self.overs)
        overs = tuple(replace(one, low=over[one.path][0], high=over[one.path][1]) for one in self.overs)
        return replace(self, overs=overs, slower=slower or self.slower)

    def _of(self, path: str, low: Fraction, high: Fraction) -> Over:
        unit = self.problem.quantity(path).unit if self.si else ""
        return Over(path, low, high, unit, "km/h" if unit == "m/s" else unit)


def asked(given: Given, title: str, texts: Iterable[str], key: str = "--over", endless: bool = False) -> Asked:
    """What `texts` ask, such as "v=0..400 km/h"; InputError for units of a ratio.

    endless: whether a range may have no upper end; InputError where it has none, and may not.
    """
    problem = as_problem(given)
    overs = parse_overs(texts, problem, key)
    for one in overs:
        if one.high is None and not endless:
            example = "400km/h" if one.path == "v" and not isinstance(given, Case) else "10"
            raise InputError(key, f"names {one.path}, which {_NO_END.format(path=one.path, example=example)}")
    if isinstance(given, Case):
        for one in overs:
            if one.unit != one.si:
                stated = f"gives {one.path} in {one.unit}, but the file holds the paper's ratios"
                raise InputError(key, f"{stated}: give numbers without units, v being α")
        overs = tuple(replace(one, si="", unit="") for one in overs)
    return Asked(given, problem, title, overs)
