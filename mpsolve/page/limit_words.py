"""The limits as rows of a table: what is asked, this case, where it becomes unstable, and what is to spare."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.spoken import rounded, spoken
from mpsolve.page.budget import Part
from mpsolve.page.limits import distance_path
from mpsolve.page.parts import Parts
from mpsolve.page.words import least, speech
from mpsolve.problem.case import Case
from mpsolve.ranges.margin import Margin
from mpsolve.ranges.onset import Kind
from mpsolve.report.remedies import on_command_line
from mpsolve.vehicles.mass import Mass

Say = Callable[[Any], str]


@dataclass(frozen=True)
class Row:
    """status: "proved" or "open"."""

    name: str
    own: str
    limit: str
    spare: str
    status: str


def limit_rows(parts: Parts) -> list[Row]:
    """Velocity, mass, and the distance where there is one."""
    rows = [_velocity(parts), _mass(parts)]
    if parts.distance is not None:
        rows.append(_distance(parts, parts.distance))
    return [replace(row, limit=on_command_line(row.limit)) for row in rows]


def _velocity(parts: Parts) -> Row:
    speak, v = speech(parts), parts.problem.v
    name, own, found = "velocity", speak.velocity(v), parts.reach.value
    if found is None:
        return _missing(name, own, parts.reach)
    if found.kind is Kind.UNDECIDED:
        return Row(name, own, f"undecided: {found.reason}", "", "open")
    if found.kind is Kind.UNSTABLE_FROM_START:
        return Row(name, own, f"unstable already at {least(found.low, found.high, speak.velocity)}", "", "proved")
    if not found.low <= v <= found.high and (v or found.low >= found.high):
        why = found.reason or "it lies outside of the range that was looked at"
        return Row(name, own, f"undecided: {why}", "", "open")
    with precision(128):
        over = None if found.value is None else rational_ball(v) - found.value
        if over is not None and over > 0:  # the first limit: a stable part may begin anywhere above it
            beyond = {True: "above it, and stable again", False: "too much", None: "above it"}[parts.spectrum.stable]
            limit, spare = f"stable below {speak.velocity(found.value)}", f"{speak.velocity(over)} {beyond}"
            return Row(name, own, limit, spare, "proved")
    return told(name, Margin("v", v, (found.low, found.high), True, None, found.value), speak.velocity)


def _mass(parts: Parts) -> Row:
    name, say = mass_named(parts)
    own, found = say(Fraction(1)), parts.mass.value
    return _missing(name, own, parts.mass) if found is None else told(name, found, say)


def mass_named(parts: Parts) -> tuple[str, Say]:
    """What a factor on all masses means: tonnes of all bodies, or a mass ratio."""
    if isinstance(parts.given, Case):
        etas = {eta.short() for eta in parts.given.eta_m}
        if len(etas) == 1:
            eta = Fraction(float(parts.given.eta_m[0])).limit_denominator(10**9)
            return "mass ratio η_M of each", lambda x: rounded(x * eta.numerator / eta.denominator)
        return "factor on all masses", _bare
    pencil, placed = parts.problem.pencil, parts.problem.vehicles
    total = sum((pencil.M[k][k] for k, name in enumerate(pencil.names) if "pitch" not in name), Fraction(0))
    name = "mass of all bodies, changed alike"
    if len({one.vehicle for one in placed}) == 1 and isinstance(placed[0].vehicle, Mass):
        total, name = total / len(placed), "mass" if len(placed) == 1 else f"each of the {len(placed)} masses"
    return name, lambda x: spoken(x * total.numerator / total.denominator, "kg")


def _bare(x: Any) -> str:
    return rounded(x)


def _distance(parts: Parts, part: Part[Margin]) -> Row:
    path = distance_path(parts.problem) or ""
    say: Say = _bare
    own = parts.problem.parameters[path]
    name = "factor on all distances"
    if path != "scale.gap":
        name, say = ("distance" if path.startswith("gap") else "wheelbase"), speech(parts).length
    return _missing(name, say(own), part) if part.value is None else told(name, part.value, say)


def told(name: str, found: Margin, say: Say) -> Row:
    """One margin in words."""
    own, (low, high) = say(found.own), found.over
    if found.stable is None:
        return Row(name, own, f"undecided: {found.reason}", "", "open")
    with precision(256):
        here = rational_ball(found.own)
        below = None if found.below is None else (say(found.below), say(here - found.below))
        above = None if found.above is None else (say(found.above), say(found.above - here))
    if below is None and above is None:
        word = "stable" if found.stable else "unstable"
        return Row(
            name,
            own,
            f"{word} all the way from {least(low, high, say)} to {say(high)}",
            "no limit in this range",
            "proved",
        )
    limits = [
        f"{'unstable' if found.stable else 'stable'} just {side} {one[0]}"
        for side, one in (("below", below), ("above", above))
        if one
    ]
    words = ("down to spare", "to spare") if found.stable else ("too much", "too little")
    spare = [f"{one[1]} {word}" for one, word in ((below, words[0]), (above, words[1])) if one]
    return Row(name, own, ", ".join(limits), ", ".join(spare), "proved")


def _missing(name: str, own: str, part: Part[Any]) -> Row:
    return Row(name, own, "not in time" if part.late else f"not available: {part.reason}", "", "open")
