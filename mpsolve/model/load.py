"""The forces on the masses: a constant and a harmonic part of each, (2), in the ratios of (10) and (12)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass
from fractions import Fraction

from mpsolve.errors import InputError
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.numbers.exact import Exact, Number

GRAVITY = Exact.parse("9.80665")  # m/s², the standard acceleration
_LEAST, _MOST = Fraction(1, 10**150), Fraction(10**150)  # what float64 can square


@dataclass(frozen=True, init=False)
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


def loads_of(case: Case | PhysicalCase, loads: Iterable[Load] | None = None) -> tuple[Load, ...]:
    """The loads of the masses of `case`, one for each.

    Without `loads`: the forces of a PhysicalCase in units of 1 N, P and P_A of its masses, with ω_f made
    dimensionless by (10), or, if it gives none, the weights of its masses; for a Case one unit constant force on each
    mass. Raises InputError where `case` is none or `loads` are not one `Load` for each mass.
    """
    if not isinstance(case, (Case, PhysicalCase)):
        raise InputError("case", f"is {type(case).__name__}: give a Case or a PhysicalCase")
    physical = isinstance(case, PhysicalCase)
    count = len(case.masses) if isinstance(case, PhysicalCase) else case.count
    if loads is None:
        return _forces(case) if isinstance(case, PhysicalCase) else (Load(),) * count
    if isinstance(loads, (str, bytes, Mapping, Set)) or not isinstance(loads, Iterable):
        raise InputError("loads", f"is {type(loads).__name__}: give a sequence with one Load for each mass")
    given = tuple(loads)
    for j, load in enumerate(given, 1):
        if not isinstance(load, Load):
            raise InputError(f"loads[{j}]", f"is {type(load).__name__}, not a Load: write Load(constant=…)")
    if len(given) != count:
        unit_said = ", in units of 1 N" if physical else ""
        raise InputError("loads", f"has {len(given)} loads for {count} masses: give one for each{unit_said}")
    return given


def gives_forces(case: PhysicalCase) -> bool:
    """Whether a force acts on any of its masses; otherwise `loads_of` takes their weights."""
    return any(mass.P or mass.P_A for mass in case.masses)


def _forces(case: PhysicalCase) -> tuple[Load, ...]:
    unit, weigh = case.time_scale, not gives_forces(case)
    found = []
    for j, mass in enumerate(case.masses, 1):
        try:
            given = (mass.M * GRAVITY,) if weigh else (mass.P, mass.P_A, mass.omega_f / unit, mass.phi_f)
            found.append(Load(*given))
        except InputError as error:
            key = (
                "M"
                if weigh
                else {"constant": "P", "amplitude": "P_A", "frequency": "omega_f"}.get(error.key, "phi_f")
            )
            raise InputError(f"mass[{j}].{key}", str(error).partition(": ")[2]) from None
    return tuple(found)
