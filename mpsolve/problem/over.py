"""A range of one parameter as it is written: "v=0..400 km/h", "track.k=1e6..", "gap[0]=1..5 m"."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.model import Quantity, rational, shown
from mpsolve.numbers.spoken import rounded
from mpsolve.numbers.units import factor, split
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem

_OF_FILE = re.compile(r"vehicle\[\d+\](.*)")
_EXAMPLE = "write PATH=LOW..HIGH, such as v=0..400km/h"


@dataclass(frozen=True)
class Over:
    """The parameter at `path` from `low` to `high`, both exact and in `si`; high is None where the end is open.

    si: the unit in which the model takes the parameter, "" for a bare number. unit: the one that was written.
    """

    path: str
    low: Fraction
    high: Fraction | None
    si: str
    unit: str

    def shown(self, value: Any) -> Any:
        """A value in `si`, a rational or a ball, as one in `unit`."""
        ratio = factor(self.si)[0] / factor(self.unit)[0]
        return value * ratio if isinstance(value, Fraction) else value * ratio.numerator / ratio.denominator

    def told(self, value: Any) -> str:
        """A value in `si` with the unit that was written, in few figures: "463.6 km/h"."""
        return f"{rounded(self.shown(value))} {self.unit}".strip()

    def holds(self, value: Fraction) -> bool:
        """Whether the value lies in the range, its ends included."""
        return self.low <= value and (self.high is None or value <= self.high)

    def outside(self, problem: Problem) -> Reason | None:
        """A warning where the problem's own value is not in the range."""
        own = problem.parameters.get(self.path)
        if own is None or self.path.startswith("scale.") or self.holds(own):
            return None
        end = "" if self.high is None else shown(self.shown(self.high))
        told = f"{self.path} is {shown(self.shown(own))} {self.unit}".strip()
        stated = f"{told}, outside the range from {shown(self.shown(self.low))} to {end or '∞'} {self.unit}".strip()
        return Reason(
            "value-outside-range", stated, {}, "the answer is about the range; the file's own value is not used"
        )


def parse_over(text: str, problem: Problem, key: str = "--over") -> Over:
    """The range that `text` names, for the problem's parameters by path (`Problem.parameters`).

    An end without a unit has that of the other one, "0..400 km/h" being 0 to 400 km/h; without any, both are in the
    model's own unit. The upper end may be left out: "v=0..". InputError under `key` quotes the text that is at fault.

    >>> from mpsolve import tracks, vehicles
    >>> over = parse_over("v=0..360km/h", Problem(tracks.String(T=1, m=1), vehicles.Mass(2), v=0))
    >>> over.path, over.low, over.high, over.unit
    ('v', Fraction(0, 1), Fraction(100, 1), 'km/h')
    """
    path, equals, ends = text.partition("=")
    path = path.strip()
    if not equals or not path:
        raise InputError(key, f"is {text!r}, which names no parameter: {_EXAMPLE}")
    low, dots, high = ends.partition("..")
    if not dots or not low.strip():
        raise InputError(key, f"is {text!r}, which has no {'lower end' if dots else 'range'}: {_EXAMPLE}")
    quantity = _quantity(problem, path, key)
    unit = split(low)[1] or split(high)[1]
    given_high = split(high)[1] or unit
    start = _end(low, unit, quantity, key)
    end = _end(high, given_high, quantity, key) if high.strip() else None
    if end is not None and not start < end:
        raise InputError(key, f"is {text!r}, whose ends do not ascend: write the lower one first")
    return Over(path, start, end, quantity.unit, given_high or quantity.unit)


def parse_overs(texts: Iterable[str], problem: Problem, key: str = "--over") -> tuple[Over, ...]:
    """Several ranges, each of another parameter; InputError where one is named twice."""
    found: dict[str, Over] = {}
    for text in texts:
        over = parse_over(text, problem, key)
        if over.path in found:
            raise InputError(key, f"names {over.path} twice: give one range for each parameter")
        found[over.path] = over
    return tuple(found.values())


def _quantity(problem: Problem, path: str, key: str) -> Quantity:
    of_file = _OF_FILE.fullmatch(path)
    if of_file:
        inner, rear = of_file[1], "vehicles are counted from 0 here, from the rear, trains one by one"
        raise InputError(
            key, f"names {path!r}: {rear}, so write vehicles[0]{inner} for the rearmost, or vehicles{inner}"
        )
    try:
        return problem.quantity(path)
    except InputError as error:
        raise InputError(key, f"names {path!r}, which {error.said}") from None


def _end(text: str, unit: str, quantity: Quantity, key: str) -> Fraction:
    """One end in the model's unit; a bound that excludes its own value, as of a mass, may be an end."""
    number = text.strip() if split(text)[1] or not unit else f"{text.strip()} {unit}"
    value = rational(number, key, quantity.unit, quantity.meaning)
    least = quantity.above if quantity.above is not None else quantity.at_least
    if least is not None and value < least:
        raise InputError(key, f"starts or ends at {text.strip()!r}, but must not go below {least}: {quantity.told}")
    return value
