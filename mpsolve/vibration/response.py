"""The public verb: the motion in time of a Problem, or of a case of the paper."""

from __future__ import annotations

from typing import Any

from mpsolve.problem.case import Case
from mpsolve.problem.physical import PhysicalCase
from mpsolve.vibration.case_balls import balls_of_case, numbers_of_case
from mpsolve.vibration.of_case import motion_of_case
from mpsolve.vibration.vibrate import vibrate


def response(problem: Any, *arguments: Any, **options: Any) -> Any:
    """The motion in time: of a Problem by `vibrate`, of a Case or PhysicalCase by the paper's formulas.

    response(problem, loads=None, *, times, places=None, irregularities=None, initial="rest", spectrum=None,
    effort=None, progress=None) for a Problem, see `vibrate`; response(case, loads=None, xi=None, tau=(0,),
    spectrum=None, *, effort=None, progress=None) for the others, in the units of the paper, see `motion_of_case`;
    of these with balls=True, or
    digits, in proved balls, or numbers right to so many decimals, see `balls_of_case`.
    """
    if not isinstance(problem, (Case, PhysicalCase)):
        return vibrate(problem, *arguments, **options)
    balls, digits = options.pop("balls", False), options.pop("digits", None)
    if balls or digits is not None:
        compute: Any = balls_of_case if balls else numbers_of_case
        return compute(problem, *arguments, **options, digits=15 if digits is None else digits)
    return motion_of_case(problem, *arguments, **options)
