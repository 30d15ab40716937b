"""A slider for a parameter: by factors round a positive value, from 0 up where it is 0, to both sides of 0 where it
may be negative; and the text of a field.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import log10

from mpsolve.errors import InputError
from mpsolve.numbers.spoken import decimal, rounded
from mpsolve.numbers.units import factor
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import scale_guide

ENDS = 100
"""A slider goes from −100 to 100, or from 0 to 100 for a value that is 0 and cannot be negative."""
_LONGEST = 12


@dataclass(frozen=True)
class Knob:
    """base: the value in the middle, 0 for a parameter that is 0 or may be negative.

    reach: then the value at the right end; both: whether it goes as far below 0.
    """

    base: Fraction
    reach: Fraction
    both: bool = False

    @property
    def least(self) -> int:
        return -ENDS if self.base or self.both else 0

    def value(self, position: float) -> str:
        """Four figures: base · 10^(position/100), or reach · (position/100)³; linear where it may be negative."""
        part = position / ENDS
        power = 1 if self.both else 3
        x = float(self.base) * 10**part if self.base else float(self.reach) * part**power
        return rounded(x, 4)

    def position(self, value: Fraction) -> float:
        """Where the slider stands for a value, at an end for one beyond it."""
        if self.both:
            part = float(value / self.reach)
        elif value <= 0:
            return float(self.least)
        else:
            part = log10(value / self.base) if self.base else float(value / self.reach) ** (1 / 3)
        return float(min(max(round(ENDS * part), self.least), ENDS))


def knobs(problem: Problem, values: Mapping[str, Fraction | None]) -> dict[str, Knob]:
    """A slider for each parameter; what is 0 goes up to the problem's own size of its unit.

    What is left out (None) begins at that size, or at the largest value of its unit in the same vehicle.
    """
    return {path: _knob(problem, path, values) for path in values}


def _knob(problem: Problem, path: str, values: Mapping[str, Fraction | None]) -> Knob:
    value, quantity, nothing = values[path], problem.quantity(path), Fraction(0)
    if value is None:
        root = path.split(".")[0]
        alike = [
            x for one, x in values.items() if x and one.startswith(root) and _unit(problem, one) == quantity.unit
        ]
        return Knob(max([own_size(problem, quantity.unit), *alike]), nothing)
    if not quantity.bound:
        return Knob(nothing, max(own_size(problem, quantity.unit), 2 * abs(value)), both=True)
    return Knob(value, nothing if value else own_size(problem, quantity.unit))


def _unit(problem: Problem, path: str) -> str:
    return problem.quantity(path).unit


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
