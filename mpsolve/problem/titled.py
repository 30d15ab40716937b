"""What a file says of its velocity besides the number: in its title, or by no unit at all."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from mpsolve.numbers.spoken import rounded, spoken
from mpsolve.outcome import Reason
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.plausible import on_rails
from mpsolve.problem.problem import Problem
from mpsolve.problem.warned import FASTEST

_IN_TITLE = re.compile(r"([0-9]+(?:\.[0-9]+)?) ?(?:km/h|kmh|kph)")
_ORDINARY = 85  # m/s, 306 km/h: what runs faster has a unit beside it, or is meant in km/h


class Title(str):
    """The title of a file. bare: its velocity has no unit, and none in the comment beside it."""

    bare: bool

    def __new__(cls, text: str, bare: bool = False) -> Title:
        title = super().__new__(cls, text)
        title.bare = bare
        return title


def titled(given: Given, title: str) -> tuple[Reason, ...]:
    """That the velocity is likely to be one in km/h, by the title or by the missing unit; empty where it is not."""
    if isinstance(given, Case):
        return ()
    return tuple(_likely(as_problem(given), title))


def _likely(problem: Problem, title: str) -> Iterator[Reason]:
    v = problem.v
    stated = f"v is {rounded(v)} m/s, which is {spoken(v, 'm/s')}"
    meant = f'write v = "{rounded(v)} km/h", if that is meant'
    said = [Fraction(number) for number in _IN_TITLE.findall(title)]
    if v and v in said and v * Fraction(18, 5) not in said:
        stated = f"{stated}, but the title says {rounded(v)} km/h"
        yield Reason("velocity-unlike-title", stated, {"v": str(v)}, meant)
    elif getattr(title, "bare", False) and _ORDINARY < v <= FASTEST and on_rails(problem):
        stated = f"v stands without a unit: {stated.removeprefix('v is ')}"
        yield Reason("velocity-without-unit", stated, {"v": str(v)}, f'{meant}, or v = "{rounded(v)} m/s"')
