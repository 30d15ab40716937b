"""The public verb: the motion in time of a Problem, or of a case of the paper."""

from __future__ import annotations

from inspect import signature
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
    compute: Any = vibrate
    of, known = "a Problem", signature(vibrate)
    if isinstance(problem, (Case, PhysicalCase)):
        balls = options.pop("balls", False)
        options = {name: one for name, one in options.items() if name != "digits" or one is not None}
        compute = balls_of_case if balls else numbers_of_case if "digits" in options else motion_of_case
        of, known = "a case of the paper", signature(balls_of_case if "digits" in options else compute)
    try:
        known.bind(problem, *arguments, **options)
    except TypeError as error:
        names = ", ".join(list(known.parameters)[1:])
        raise TypeError(f"response() of {of} {error}: its arguments are {names}") from None
    return compute(problem, *arguments, **options)
