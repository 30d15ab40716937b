"""The force on one contact: a constant and a harmonic part."""

from __future__ import annotations

from fractions import Fraction

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.exact import Exact, Number

GRAVITY = Exact.parse("9.80665")  # m/s², the standard acceleration
_LEAST, _MOST = Fraction(1, 10**150), Fraction(10**150)  # what float64 can square


@frozen
class Load:
    """The force constant + amplitude · sin(frequency · τ + phase) on one mass, in units of the unit force.

    constant, amplitude: η_C, η_A of (12); frequency: ω̂_f of (10), per unit of τ; phase: φ in rad. All exact and
    rational or fourth roots, as `Exact` reads them. InputError names the argument that cannot be used: sizes are 0 or
    from 1e-150 to 1e150.

    >>> Load(amplitude="0.5", frequency="0.3").constant
    Exact('1')
    """

    constant: Exact
    amplitude: Exact
    frequency: Exact
    phase: Exact

    def __init__(self, constant: Number = 1, amplitude: Number = 0, frequency: Number = 0, phase: Number = 0) -> None:
        given = {"constant": constant, "amplitude": amplitude, "frequency": frequency, "phase": phase}
        for name, value in given.items():
            number = Exact.parse(value, name)
            if number and not _LEAST <= abs(number) <= _MOST:
                stated = f"is {number.short()}, not within 1e-150 to 1e150 in size"
                raise InputError(name, f"{stated}: give 0 or a moderate number, the motion is linear in the forces")
            vars(self)[name] = number
