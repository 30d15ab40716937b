"""A slider for a parameter: by factors round a positive value, from 0 up where it is 0; and the text of a field."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from math import log10

from mpsolve.errors import InputError
from mpsolve.numbers.spoken import decimal, rounded
from mpsolve.numbers.units import factor
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import scale_guide

ENDS = 100
"""A slider goes from −100 to 100 round a positive value, and from 0 to 100 where the value is 0."""
_LONGEST = 12


@dataclass(frozen=True)
class Knob:
    """base: the value in the middle, 0 for a parameter that is 0; reach: then the value at the right end."""

    base: Fraction
    reach: Fraction

    @property
    def least(self) -> int:
        return 0 if not self.base else -ENDS

    def value(self, position: float) -> str:
        """Four figures: base · 10^(position/100), or reach · (position/100)³."""
        part = position / ENDS
        x = float(self.base) * 10**part if self.base else float(self.reach) * part**3
        return rounded(x, 4)

    def position(self, value: Fraction) -> float:
        """Where the slider stands for a value, at an end for one beyond it."""
        if value <= 0:
            return float(self.least)
        part = log10(value / self.base) if self.base else float(value / self.reach) ** (1 / 3)
        return float(min(max(round(ENDS * part), self.least), ENDS))


def knobs(problem: Problem, values: dict[str, Fraction]) -> dict[str, Knob]:
    """A slider for each parameter that is not negative; what is 0 goes up to the problem's own size of its unit."""
    found = {}
    for path, value in values.items():
        if value >= 0:
            found[path] = Knob(value, Fraction(0) if value else own_size(problem, problem.quantity(path).unit))
    return found


def own_size(problem: Problem, unit: str) -> Fraction:
    """The power of ten nearest to what length, time and mass of the track make of a unit."""
    try:
        guide = scale_guide(problem)
        length, time = 2.0**guide.length, 2.0**guide.time
        sizes = (2.0**-guide.length / float(guide.g) * time**2 * 2.0**guide.length, length, time)
        _, powers = factor(unit or "rad")
    except InputError:
        return Fraction(1)
    logs = sum(power * log10(size) for power, size in zip(powers, sizes, strict=True))
    return Fraction(10) ** round(logs)


def field_text(value: Fraction) -> str:
    """A value as it is typed: 69.4444, 6.38043e6, 300e6. What is no short decimal has six figures."""
    exact = decimal(value)
    text = exact if "/" not in exact and len(exact) <= _LONGEST else rounded(value, 6)
    plain = re.fullmatch(r"(-?)(\d{7,})(?:\.\d+)?", text)
    if plain is None:
        return text
    power = 3 * ((len(plain[2]) - 1) // 3)
    return f"{decimal(Fraction(text) / 10**power)}e{power}"
