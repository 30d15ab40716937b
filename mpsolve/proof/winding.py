"""How often a function turns round 0 along a closed path, as a whole number."""

from __future__ import annotations

from flint import arb

from mpsolve.errors import PrecisionError


def number_of_zeros(turns: arb, what: str) -> int:
    """The only whole number in the real ball; PrecisionError if there is none, more than one, or one below 0."""
    number = turns.unique_fmpz()
    if number is None or int(number) < 0:
        raise PrecisionError(f"the turn of {what} is {turns.str(5)}, which is not one number of roots")
    return int(number)
