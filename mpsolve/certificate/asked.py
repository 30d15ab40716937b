"""The region that is counted, from what was asked for; refusals name a height that is allowed."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Literal

from mpsolve.errors import InputError
from mpsolve.numbers.decimals import outward
from mpsolve.numbers.model import shown
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given
from mpsolve.problem.line import line_height
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Region, checked_region
from mpsolve.spectrum.solve import default_height
from mpsolve.tracks.at_rest import lowest_cut
from mpsolve.vehicles.mass import Mass

FEW = 2
"""Up to so many masses the whole sheet of a beam is what is asked for by default."""


def default_region(given: Given, meant: Problem) -> Literal["sheet"] | None:
    """What tells most: "sheet" for few masses on a beam, or None, below a height near the lowest cut."""
    if not has_whole_sheet(meant):
        return None
    few = len({placed.position for placed in meant.vehicles}) <= FEW
    return "sheet" if few or not is_damped(meant) or isinstance(given, Case) else None


def has_whole_sheet(problem: Problem) -> bool:
    """Whether masses alone run on a beam whose cuts lie on one line."""
    masses = all(isinstance(placed.vehicle, Mass) for placed in problem.vehicles)
    return masses and line_height(problem.track) is not None


def is_damped(problem: Problem) -> bool:
    """Whether the track is no undamped beam; other undamped tracks are refused anyway."""
    return line_height(problem.track) != 0


def asked_region(reduced: Reduced, region: object) -> Region:
    """Im q < 0, below a height, or a rectangle; None is the one below a height near the lowest cut, if it is above 0.

    InputError for a region that a cut reaches into.
    """
    if region == "unstable":
        return HalfPlane()
    low, _ = lowest_cut(reduced.problem.track)
    if region is None:
        return Below(default_height(reduced, low)) if low > 0 else HalfPlane()
    if isinstance(region, HalfPlane):
        return region
    given = checked_region(region)
    if isinstance(given, Below) and given.height > low:
        raise InputError("region", f"reaches up to {shown(given.height)}, but {_cut_words(low)}: {_lower('h', low)}")
    if isinstance(given, Rectangle) and given.im_max > max(low, Fraction(0)):
        stated = f"is {shown(given.im_max)}, but {_cut_words(low)}"
        raise InputError("region.im_max", f"{stated}: {_lower('im_max', low)}")
    if isinstance(given, (Below, Rectangle)):
        return given
    raise InputError("region", f'is {region!r}: give "unstable", ("below", h) or a Rectangle')


def _cut_words(low: Fraction) -> str:
    where = f"begin at Im q = {float(low):.6g}" if low > 0 else "come down to Im q = 0"
    return f"the branch cuts of this track {where}"


def _lower(name: str, low: Fraction) -> str:
    """What to give instead."""
    if low > 0:
        return f"give {name} up to {outward(math.nextafter(float(low), 0), 5, up=False)}"
    return 'ask for "unstable"' if name == "h" else f"give {name} up to 0"
