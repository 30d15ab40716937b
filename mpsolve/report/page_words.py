"""The sentences of a page about margins: what may change by how much, in the units of the case."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.errors import known
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.decimals import proved_digits
from mpsolve.numbers.exact import Exact
from mpsolve.report.answer import Source, number
from mpsolve.report.page_margins import DIGITS, Margin
from mpsolve.report.remedies import for_reader
from mpsolve.report.rows import shown

_PLACES = 5
_BITS = 160
_SYMBOL = {"velocity": "α", "mass": "η_M", "distance": "d"}
_QUESTION = {
    "velocity": "Velocity, all else as it is",
    "mass": "All masses, in their proportions",
    "distance": "Distance of neighbouring masses",
}

_STATE = {True: "stable", False: "unstable"}


@dataclass(frozen=True)
class Card:
    """A margin in words. figure: the signed margin with its unit, or what stands in its place."""

    name: str
    question: str
    figure: str
    sentence: str
    status: str


def card(margin: Margin, source: Source, stable: bool | None) -> Card:
    """The margin to the nearest change of stability; stable: of the case itself, None where undecided."""
    question = _QUESTION[margin.name]
    if not margin.applies:
        reason = for_reader(margin.reason, margin.name)
        return Card(margin.name, question, "none", f"Does not apply: {reason}.", "none")
    if not margin.proved:
        return _open(margin, source, stable)
    with ball_arithmetic(_BITS):
        near = margin.nearest
        if near is None:
            figure = "no limit" if margin.high is None else "no change"
            return Card(margin.name, question, figure, _nothing(margin, source, stable), "proved")
        shift = near - margin.here
        sign, text = ("+" if shift > 0 else "−"), _shift(margin, source, abs(shift))
        return Card(margin.name, question, f"{sign}{text}", _changes(margin, source, stable), "proved")


def _open(margin: Margin, source: Source, stable: bool | None) -> Card:
    """What is proved all the same of a margin that is open, and why it is."""
    question, reason = _QUESTION[margin.name], for_reader(margin.reason, margin.name)
    reason = reason[:1].upper() + reason[1:]
    with ball_arithmetic(_BITS):
        least = margin.at_least
        if margin.free is None or least is None:
            return Card(margin.name, question, "undecided", f"{reason}.", "undecided")
        low, high = (_value(margin, source, end) for end in margin.free)
        said = f"{_stays(stable)} from {low} to {high}; what happens beyond is undecided. {reason}."
        return Card(margin.name, question, f"at least {_shift(margin, source, least)}", said, "undecided")


def margin_data(margin: Margin, source: Source) -> dict[str, Any]:
    """For machines: here, below, above, and the distance of the nearer from here, in the parameter and in `unit`.

    at_least: where that is open, a distance within which stability is proved not to change, or null.
    """
    with ball_arithmetic(_BITS):
        near, least = margin.nearest, margin.at_least
        factor, unit = _unit(margin, source)

        def both(ball: Any | None) -> dict[str, Any] | None:
            if ball is None or not margin.applies:
                return None
            return {"parameter": number(ball, 15), "in_unit": number(ball * factor, 15)}

        return {
            "name": margin.name,
            "status": "proved" if margin.proved else "undecided" if margin.applies else "does not apply",
            "reason": margin.reason,
            "unit": unit,
            "range": {"start": str(margin.low), "end": None if margin.high is None else str(margin.high)},
            "here": both(margin.here),
            "below": both(margin.below),
            "above": both(margin.above),
            "margin": None if near is None else both(near - margin.here),
            "at_least": both(least),
        }


def _unit(margin: Margin, source: Source) -> tuple[Any, str]:
    """The ball by which the parameter is multiplied, and the unit: km/h, kg (of the largest mass), m; or "", and 1.

    The parameter of a dimensionless mass margin is multiplied by the largest mass ratio.
    """
    physical = source.physical
    if margin.name == "velocity":
        return (Exact.parse(1).ball(), "") if physical is None else (physical.v_cr.ball() * 18 / 5, "km/h")
    if margin.name == "mass":
        sizes = source.case.eta_m if physical is None else tuple(mass.M for mass in physical.masses)
        return max(sizes).ball(), "" if physical is None else "kg"
    return (Exact.parse(1).ball(), "") if physical is None else (1 / physical.chi.ball(), "m")


def _value(margin: Margin, source: Source, ball: Any, places: int = _PLACES) -> str:
    """A value of the parameter, such as 360.00 km/h or α = 0.67000."""
    return _named(margin, *_number(margin, source, ball, places))


def _named(margin: Margin, number: str, unit: str) -> str:
    return f"{number} {unit}" if unit else f"{_SYMBOL[margin.name]} = {number}"


def _shift(margin: Margin, source: Source, ball: Any) -> str:
    """A difference of the parameter, such as 328.26 km/h or 0.0030810 in α."""
    number, unit = _number(margin, source, ball)
    return f"{number} {unit}" if unit else f"{number} in {_SYMBOL[margin.name]}"


def _number(margin: Margin, source: Source, ball: Any, places: int = _PLACES) -> tuple[str, str]:
    factor, unit = _unit(margin, source)
    return proved_digits(ball * factor, places), unit


def _places(margin: Margin, near: Any) -> int:
    """Digits that tell `near` from the case's own value."""
    share = abs(float(near - margin.here)) / (float(margin.here) or 1.0)
    return max(_PLACES, 2 - math.floor(math.log10(share)) if share else DIGITS)


def _of(margin: Margin, source: Source) -> str:
    """Of which mass the figure in kg is."""
    same = len(set(source.case.eta_m)) == 1
    if margin.name != "mass" or source.case.count == 1:
        return ""
    return " for each mass" if same else " for the largest mass"


def _changes(margin: Margin, source: Source, stable: bool | None) -> str:
    near = known(margin.nearest, "the nearest change")
    up = bool(near > margin.here)
    becomes = {True: "becomes unstable", False: "becomes stable", None: "changes its stability"}[stable]
    ratio = ""
    if margin.here > 0:
        ratio = f" ({proved_digits(100 * abs(near - margin.here) / margin.here, 3)} %)"
    step = f"{_shift(margin, source, abs(near - margin.here))}{ratio} {'more' if up else 'less'} than now"
    place = f"{'above' if up else 'below'} {_value(margin, source, near, _places(margin, near))}{_of(margin, source)}"
    said = f"The case {becomes} {place}, which is {step}."
    other = margin.below if up else margin.above
    if other is not None:
        said += f" On the other side it changes at {_value(margin, source, other)}."
    return said


def _nothing(margin: Margin, source: Source, stable: bool | None) -> str:
    if margin.high is None:
        whole = {"mass": "for every size of the masses", "distance": "at every distance"}[margin.name]
        return f"{_stays(stable)} {whole}, so there is no limit."
    low, high = (_value(margin, source, end.ball()) for end in (margin.low, margin.high))
    return f"{_stays(stable)} all the way from {low} to {high}, the range that was searched."


def _stays(stable: bool | None) -> str:
    """What does not change over a range."""
    if stable is None:
        return "Whether the case is stable or unstable is undecided, but it is one of the two throughout,"
    return f"The case stays {_STATE[stable]}"


def here_text(margin: Margin, source: Source) -> str:
    """The case's own value, as it is typed."""
    if not margin.applies:
        return ""
    with ball_arithmetic(_BITS):
        unit = _unit(margin, source)[1]
    return _named(margin, shown(_here(margin, source)), unit) + _of(margin, source)


def _here(margin: Margin, source: Source) -> Exact:
    """The case's own value in the unit of the margin, exactly."""
    case, physical = source.case, source.physical
    if margin.name == "velocity":
        return case.alpha if physical is None else physical.v * Fraction(18, 5)
    if margin.name == "mass":
        return max(case.eta_m if physical is None else (mass.M for mass in physical.masses))
    places = list(dict.fromkeys(case.positions if physical is None else (mass.position for mass in physical.masses)))
    return places[1] - places[0]
