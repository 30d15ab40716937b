"""The region in which roots are counted, in the problem's own units.

What a user gives is "sheet", "unstable", ("below", h) or a `Rectangle`; what an answer holds is one of these classes.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Literal

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.model import rational, shown
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, refuse_units
from mpsolve.zeros.regions import Rectangle


@frozen
class Sheet:
    """The whole physical sheet: the q-plane without the branch cuts."""

    def __str__(self) -> str:
        return "the whole physical sheet"


@frozen
class HalfPlane:
    """Im q < 0; where `radius` is given, only |q| < radius."""

    radius: Fraction | None = None

    def __str__(self) -> str:
        return "Im q < 0" if self.radius is None else f"Im q < 0, |q| < {float(self.radius):.6g}"


@frozen
class Below:
    """Im q < 0, and with it Im q < height as far as |Re q| < reach; with a `radius`, below 0 only |q| < radius."""

    height: Fraction
    reach: Fraction | None = None
    radius: Fraction | None = None

    def __str__(self) -> str:
        reach = "" if self.reach is None else f" where |Re q| < {float(self.reach):.6g}"
        lower = "Im q < 0" if self.radius is None else f"Im q < 0, |q| < {float(self.radius):.6g}"
        return f"Im q < {float(self.height):.6g}{reach}, or {lower}"


Region = HalfPlane | Below | Rectangle
"""What the general engine counts in."""
Answered = Region | Sheet
"""What an answer may speak of."""


def checked_region(given: object, problem: Given | None = None) -> Literal["sheet", "unstable"] | Below | Rectangle:
    """A region as a user gives it, ("below", h) as `Below`; InputError where it is none.

    Texts may have units, unless the problem is a Case.
    """
    if isinstance(problem, Case):
        bounds = vars(given) if isinstance(given, Rectangle) else {}
        for name, bound in bounds.items():
            refuse_units(bound, f"region.{name}")
        if isinstance(given, tuple):
            refuse_units(given[-1], "region")
    if isinstance(given, Rectangle) or (isinstance(given, str) and given in ("sheet", "unstable")):
        return given  # type: ignore[return-value]
    if isinstance(given, Below):
        return replace(given, height=_height(given.height))
    if isinstance(given, tuple) and len(given) == 2 and isinstance(given[0], str) and given[0] == "below":
        return Below(_height(given[1]))
    stated = f"is {str(given)[:60]!r}"
    raise InputError("region", f'{stated}: give "sheet", "unstable", ("below", h) with a number h, or a Rectangle')


def _height(given: object) -> Fraction:
    height = rational(given, "region", "rad/s", "height")
    if height <= 0:
        raise InputError("region", f'ends below {shown(height, given)}, which must be above 0: "unstable" ends at 0')
    return height


__all__ = ["Answered", "Below", "HalfPlane", "Rectangle", "Region", "Sheet", "checked_region"]
