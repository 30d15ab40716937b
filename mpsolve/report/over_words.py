"""What an onset over a range of one parameter means, in the unit that the user wrote."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from flint import arb

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.spoken import rounded
from mpsolve.problem.over import Over

_BITS = 128


def stable_throughout(over: Over) -> str:
    """The verdict where no root grows in the range."""
    end = "on" if over.high is None else f"to {over.told(over.high)}"
    return f"STABLE for every {over.path} from {over.told(over.low)} {end}."


def unstable_from_start(over: Over) -> str:
    """The verdict where a root grows at the lower end already."""
    return f"UNSTABLE already at {over.path} = {over.told(over.low)}, where the range begins."


def unstable_beyond(over: Over, value: Any) -> str:
    """The verdict where a root grows behind values that are left out: `value` is a ball that holds all of them."""
    with precision(_BITS):
        start, end = (over.told(arb(x)) for x in (value.lower(), value.upper()))
    return f"STABLE for {over.path} from {over.told(over.low)} to {start}, UNSTABLE just beyond {end}."


def onset_at(over: Over, value: Any, q: Any, unit: str = "Hz") -> str:
    """The verdict where the first root begins to grow at `value`, a ball in SI, with the frequency q in rad/s.

    q: a ball ≥ 0; where it is 0 the deflection grows without oscillation. unit: of q/2π.
    """
    with precision(_BITS):
        motion = "a deflection" if q == 0 else f"a vibration at {rounded(abs(q) / (2 * arb.pi()))} {unit}"
        return (
            f"STABLE for {over.path} from {over.told(over.low)} to {over.told(value)}, where {motion} begins to grow."
        )


def margin(over: Over, value: Any, own: Fraction) -> str:
    """How far the file's own value is from the onset: on which side is decided in balls."""
    with precision(_BITS):
        away = value - rational_ball(own)
        stated = f"{over.path} is {over.told(own)}"
        if not (away > 0 or away < 0):
            return f"{stated}, which cannot be told from the onset."
        share = rounded(abs(away) / value * 100, 3)
        side = "below the onset" if away > 0 else "above the onset: certify says whether it is unstable there"
        return f"{stated}, {over.told(abs(away))} ({share} %) {side}."
