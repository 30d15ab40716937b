"""The forces on the masses: a constant and a harmonic part of each, (2), in the ratios of (10) and (12)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass

from mpsolve.errors import InputError
from mpsolve.model.exact import Exact, Number
from mpsolve.model.parameters import Case, PhysicalCase


@dataclass(frozen=True, init=False)
class Load:
    """The force constant + amplitude · sin(frequency · τ + phase) on one mass, in units of the unit force.

    constant, amplitude: η_C, η_A of (12); frequency: ω̂_f of (10), per unit of τ; phase: φ in rad. All exact and
    rational or fourth roots, as `Exact` reads them. InputError names the argument that cannot be used.

    >>> Load(amplitude="0.5", frequency="0.3").constant
    Exact('1')
    """

    constant: Exact
    amplitude: Exact
    frequency: Exact
    phase: Exact

    def __init__(self, constant: Number = 1, amplitude: Number = 0, frequency: Number = 0, phase: Number = 0) -> None:
        given = {"constant": constant, "amplitude": amplitude, "frequency": frequency, "phase": phase}
        vars(self).update({name: Exact.parse(value, name) for name, value in given.items()})

    @property
    def harmonic(self) -> bool:
        """Whether a part of the force changes with time."""
        return bool(self.amplitude) and bool(self.frequency)


def loads_of(case: Case | PhysicalCase, loads: Iterable[Load] | None = None) -> tuple[Load, ...]:
    """The loads of the masses of `case`, one for each.

    Without `loads`: the forces of a PhysicalCase in units of 1 N, P and P_A of its masses, with ω_f made
    dimensionless by (10); for a Case one unit constant force on each mass. Raises InputError where `loads` are not
    one `Load` for each mass.
    """
    physical = isinstance(case, PhysicalCase)
    count = len(case.masses) if isinstance(case, PhysicalCase) else case.count
    if loads is None:
        if isinstance(case, PhysicalCase):
            unit = case.time_scale
            return tuple(Load(mass.P, mass.P_A, mass.omega_f / unit, mass.phi_f) for mass in case.masses)
        return (Load(),) * count
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
