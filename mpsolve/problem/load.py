"""The forces on the masses of a case of the paper, (2), in the ratios of (10) and (12)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set

from mpsolve.errors import InputError
from mpsolve.problem.case import Case
from mpsolve.problem.physical import PhysicalCase
from mpsolve.vehicles.load import GRAVITY, Load


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
            raise error.under(f"mass[{j}].{key}") from None
    return tuple(found)
