"""The region in which roots are counted: the whole physical sheet, its unstable part, or a rectangle."""

from __future__ import annotations

from typing import Literal, TypeAlias

from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.limits import limiting_frequency, require_cuts_on_line
from mpsolve.numbers.balls import rational_ball
from mpsolve.problem.case import Case
from mpsolve.spectrum.regions import Rectangle

Region: TypeAlias = Literal["sheet", "unstable"] | Rectangle


def checked_region(case: Case, region: object) -> Region:
    """`region`, or InputError where no count can be defined in it for this case."""
    if isinstance(region, Rectangle):
        _check_rectangle(case, region)
        return region
    if region == "sheet":
        require_cuts_on_line(case)
        return "sheet"
    if region == "unstable":
        return "unstable"
    raise InputError("region", f'is {region!r}: give "sheet", "unstable" or a Rectangle')


def _check_rectangle(case: Case, box: Rectangle) -> None:
    """The closed rectangle must lie off the cuts: beside the line Im q = η_b, in the gap, or in Im q ≤ 0."""
    if not case.cuts_on_line:
        if box.im_max > 0:
            stated = "is above 0, where the branch cuts of this case are not on a line"
            raise InputError("region.im_max", f"{stated}: stay in Im q ≤ 0")
        return
    if not (box.im_max < case.eta_b or box.im_min > case.eta_b or _in_gap(case, box)):
        stated = f"and im_min hold the cut line Im q = eta_b = {case.eta_b.short()} between them"
        raise InputError(
            "region.im_max", f"{stated}, beyond the gap: take one rectangle below the line and one above it"
        )


def _in_gap(case: Case, box: Rectangle) -> bool:
    """The rectangle crosses the cut line only where it is not cut, |Re q| < q_lm, as proved by balls."""
    with ball_arithmetic(128) as field:
        try:
            limit = limiting_frequency(case, field)
        except PrecisionError:
            return False
        return bool(rational_ball(box.re_max) < limit and rational_ball(-box.re_min) < limit)
