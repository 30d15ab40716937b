"""Read a case from a TOML file: the numbers exactly as they are written, every mistake named by its key."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.problem import toml
from mpsolve.problem.case import Case
from mpsolve.problem.checked import errors_under
from mpsolve.problem.physical import Mass, PhysicalCase
from mpsolve.vehicles.load import Load

PHYSICAL = {
    "EI": "the bending stiffness of the beam in N m²",
    "m": "the mass of the beam in kg/m",
    "k": "the stiffness of the foundation in N/m²",
    "v": "the velocity in m/s",
    "c": "the damping of the foundation in N s/m²",
    "kp": "the Pasternak modulus in N",
    "N": "the axial force in N, compression positive",
}
MASS = {
    "M": "the mass in kg",
    "position": "the position in m",
    "P": "the constant force in N",
    "P_A": "the amplitude of the harmonic force in N",
    "omega_f": "the excitation frequency in rad/s",
    "phi_f": "the phase in rad",
}
DIMENSIONLESS = {
    "alpha": "the velocity ratio",
    "eta_b": "the damping ratio",
    "eta_m": "the list of mass ratios",
    "positions": "the list of positions",
    "eta_n": "the axial force ratio, compression positive",
    "eta_s": "the Pasternak modulus ratio",
}
LOAD = {
    "constant": "the constant force ratio",
    "amplitude": "the amplitude ratio of the harmonic force",
    "frequency": "the dimensionless excitation frequency",
    "phase": "the phase in rad",
}
UNITS = {
    "physical": {"EI": "N m²", "m": "kg/m", "k": "N/m²", "v": "m/s", "c": "N s/m²", "kp": "N", "N": "N"},
    "mass": {"M": "kg", "position": "m", "P": "N", "P_A": "N", "omega_f": "rad/s", "phi_f": "rad"},
}
_SECTIONS = ("physical", "mass", "dimensionless", "load")
_TOP = {"title": "a text", "source": toml.SOURCE} | dict.fromkeys(_SECTIONS, "a section")
REQUIRED = frozenset(("EI", "m", "k", "v", "M", "position", "alpha", "eta_b", "eta_m", "positions"))


@frozen
class InputFile:
    """A case that has passed every check, with the title ("" if none), the path of its file, and its loads.

    loads: those of [[load]], one for each mass, or None; the forces of a physical case are those of its masses.
    sources: where its numbers come from, as it says.
    """

    case: Case | PhysicalCase
    title: str
    path: Path
    loads: tuple[Load, ...] | None = None
    sources: tuple[str, ...] = ()

    @property
    def given(self) -> Case | PhysicalCase:
        """What the file describes."""
        return self.case


def read_case(path: str | Path) -> Case | PhysicalCase:
    """Return the admissible case in the TOML file at `path`; errors as for `read_input`."""
    return read_input(path).case


def read_input(path: str | Path) -> InputFile:
    """Return the admissible case in the TOML file at `path`, each number exactly as written (0.1 is 1/10).

    The file holds either [physical] (EI, m, k, v; c, kp, N default to 0; SI units) with one or more [[mass]]
    (M, position; P, P_A, omega_f, phi_f default to 0), or [dimensionless] (alpha, eta_b, eta_m, positions;
    eta_n, eta_s default to 0) with no [[load]] or one for each mass (constant defaults to 1; amplitude, frequency,
    phase to 0), and may have a title. Raises InputError under the key at fault, such as
    physical.EI, mass[2].M or dimensionless.eta_m[1] (counted from 1), or under the path if the file cannot
    be read.
    """
    file = Path(path)
    content = toml.parsed(toml.text_of(file), toml.name_of(file))
    toml.refuse_other_kind(content, _TOP, file)
    return input_of(content, file)


def input_of(content: Mapping[str, Any], file: Path) -> InputFile:
    """The case in the tables of a file, as `read_input` reads it."""
    toml.check_keys(content, _TOP, "")
    title = toml.title_of(content)
    if "dimensionless" in content:
        case = _dimensionless(content)
        return InputFile(case, title, file, _loads(content, case), toml.sources_of(content))
    if "load" in content:
        raise InputError("load", "stands without [dimensionless]: give P, P_A, omega_f, phi_f in [[mass]]")
    if "physical" in content:
        return InputFile(_physical(content), title, file, sources=toml.sources_of(content))
    if "mass" in content:
        raise InputError("physical", f"is missing: add [physical] with {', '.join(PHYSICAL)}")
    raise InputError(toml.name_of(file), "holds no case: add [physical] with [[mass]], or [dimensionless]")


def _dimensionless(content: Mapping[str, Any]) -> Case:
    for other in ("physical", "mass"):
        if other in content:
            raise InputError(other, "stands beside [dimensionless]: keep only one of the two descriptions")
    table = _table(content["dimensionless"], "dimensionless", DIMENSIONLESS)
    with errors_under("dimensionless."):
        for name in ("eta_m", "positions"):
            if not isinstance(table[name], list):
                raise InputError(name, f"is {toml.kind(table[name])}, not a list: write {name} = [ … ]")
        return Case(**table)


def _loads(content: Mapping[str, Any], case: Case) -> tuple[Load, ...] | None:
    loads = loads_in(content, LOAD, {}, " mass")
    if loads is not None and len(loads) != case.count:
        raise InputError("load", f"is given for {len(loads)}, not {case.count} masses: give one [[load]] for each")
    return loads


def loads_in(
    content: Mapping[str, Any], known: Mapping[str, str], units: Mapping[str, str], each: str = ""
) -> tuple[Load, ...] | None:
    """The sections [[load]]; None where there is none."""
    if "load" not in content:
        return None
    loads = []
    for j, entry in enumerate(toml.sections(content, "load", each), 1):
        table = toml.section(entry, f"load[{j}]", known, units)
        with errors_under(f"load[{j}]."):
            loads.append(Load(**table))
    return tuple(loads)


def _physical(content: Mapping[str, Any]) -> PhysicalCase:
    table = _table(content["physical"], "physical", PHYSICAL)
    entries = toml.sections(content, "mass", " mass")
    if not entries:
        raise InputError("mass", "is missing: add [[mass]] with M and position for each mass")
    masses = [_mass(entry, f"mass[{j}]") for j, entry in enumerate(entries, 1)]
    try:
        return PhysicalCase(**table, masses=masses)
    except InputError as error:
        with errors_under("" if error.key.startswith("mass[") else "physical."):
            raise


def _mass(entry: object, key: str) -> Mass:
    table = _table(entry, key, MASS)
    with errors_under(f"{key}."):
        return Mass(**table)


def _table(value: object, key: str, known: Mapping[str, str]) -> dict[str, Any]:
    """Return a table that has every required key and no unknown one; its values are not looked at."""
    table = toml.section(value, key, known, UNITS.get(key.partition("[")[0]))
    for name, meaning in known.items():
        if name in REQUIRED and name not in table:
            raise InputError(f"{key}.{name}", f"is missing: give {meaning}")
    return table
