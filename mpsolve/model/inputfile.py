"""Read a case from a TOML file: the numbers exactly as they are written, every mistake named by its key."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.model.load import Load
from mpsolve.model.parameters import Case, Mass, PhysicalCase, errors_under

MAX_BYTES = 1_000_000
"""Largest file that is read; a case of a thousand masses takes a tenth of it."""

_PHYSICAL = {
    "EI": "the bending stiffness of the beam in N m²",
    "m": "the mass of the beam in kg/m",
    "k": "the stiffness of the foundation in N/m²",
    "v": "the velocity in m/s",
    "c": "the damping of the foundation in N s/m²",
    "kp": "the Pasternak modulus in N",
    "N": "the axial force in N, compression positive",
}
_MASS = {
    "M": "the mass in kg",
    "position": "the position in m",
    "P": "the constant force in N",
    "P_A": "the amplitude of the harmonic force in N",
    "omega_f": "the excitation frequency in rad/s",
    "phi_f": "the phase in rad",
}
_DIMENSIONLESS = {
    "alpha": "the velocity ratio",
    "eta_b": "the damping ratio",
    "eta_m": "the list of mass ratios",
    "positions": "the list of positions",
    "eta_n": "the axial force ratio, compression positive",
    "eta_s": "the Pasternak modulus ratio",
}
_LOAD = {
    "constant": "the constant force ratio",
    "amplitude": "the amplitude ratio of the harmonic force",
    "frequency": "the dimensionless excitation frequency",
    "phase": "the phase in rad",
}
_SECTIONS = ("physical", "mass", "dimensionless", "load")
_TOP = {"title": "a text"} | dict.fromkeys(_SECTIONS, "a section")
_REQUIRED = frozenset(("EI", "m", "k", "v", "M", "position", "alpha", "eta_b", "eta_m", "positions"))


class _Written(str):
    """A TOML float as it stands in the file, told apart from a TOML string."""

    __slots__ = ()


@dataclass(frozen=True)
class InputFile:
    """A case that has passed every check, with the title ("" if none), the path of its file, and its loads.

    loads: those of [[load]], one for each mass, or None; the forces of a physical case are those of its masses.
    """

    case: Case | PhysicalCase
    title: str
    path: Path
    loads: tuple[Load, ...] | None = None


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
    content = _toml(_text(file), str(file))
    _check_keys(content, _TOP, "")
    title = content.get("title", "")
    if type(title) is not str:
        raise InputError("title", f'is {_kind(title)}, not a text: write title = "…"')
    if "dimensionless" in content:
        case = _dimensionless(content)
        return InputFile(case, title, file, _loads(content, case))
    if "load" in content:
        raise InputError("load", "stands without [dimensionless]: give P, P_A, omega_f, phi_f in [[mass]]")
    if "physical" in content:
        return InputFile(_physical(content), title, file)
    if "mass" in content:
        raise InputError("physical", f"is missing: add [physical] with {', '.join(_PHYSICAL)}")
    raise InputError(str(file), "holds no case: add [physical] with [[mass]], or [dimensionless]")


def _text(file: Path) -> str:
    """Return the text of a regular UTF-8 file of at most `MAX_BYTES`."""
    try:
        content = _bytes(file)
        return content.decode("utf-8-sig")
    except OSError as error:
        reason = f"cannot be read ({error.strerror}): give the path of a readable TOML file"
    except UnicodeDecodeError as error:
        reason = f"is not UTF-8 at byte {error.start}: save it as UTF-8 text"
    raise InputError(str(file), reason)


def _bytes(file: Path) -> bytes:
    if not file.is_file():
        state = "does not exist"
        if file.exists():
            state = "is a directory" if file.is_dir() else "is not a regular file"
        raise InputError(str(file), f"{state}: give the path of a TOML file")
    with file.open("rb") as stream:
        content = stream.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise InputError(str(file), f"is longer than {MAX_BYTES} bytes: give a file with one case")
    return content


def _toml(text: str, key: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text, parse_float=_Written)
    except tomllib.TOMLDecodeError as error:
        raise InputError(key, f"is not valid TOML ({error}): correct it there") from None
    except ValueError:  # Python refuses to read integers beyond its own limit of digits
        raise InputError(key, "has an integer with too many digits: give at most 400") from None
    except RecursionError:
        raise InputError(key, "is nested too deeply: lists in lists have no meaning here") from None


def _dimensionless(content: Mapping[str, Any]) -> Case:
    for other in ("physical", "mass"):
        if other in content:
            raise InputError(other, "stands beside [dimensionless]: keep only one of the two descriptions")
    table = _table(content["dimensionless"], "dimensionless", _DIMENSIONLESS)
    with errors_under("dimensionless."):
        for name in ("eta_m", "positions"):
            if not isinstance(table[name], list):
                raise InputError(name, f"is {_kind(table[name])}, not a list: write {name} = [ … ]")
        return Case(**table)


def _loads(content: Mapping[str, Any], case: Case) -> tuple[Load, ...] | None:
    if "load" not in content:
        return None
    entries = content["load"]
    if not isinstance(entries, list):
        raise InputError("load", f"is {_kind(entries)}: write [[load]] in double brackets for each mass")
    loads = []
    for j, entry in enumerate(entries, 1):
        table = _table(entry, f"load[{j}]", _LOAD)
        with errors_under(f"load[{j}]."):
            loads.append(Load(**table))
    if len(loads) != case.count:
        raise InputError("load", f"has {len(loads)} entries for {case.count} masses: give one [[load]] for each")
    return tuple(loads)


def _physical(content: Mapping[str, Any]) -> PhysicalCase:
    table = _table(content["physical"], "physical", _PHYSICAL)
    entries = content.get("mass", [])
    if not isinstance(entries, list):
        raise InputError("mass", f"is {_kind(entries)}: write [[mass]] in double brackets for each mass")
    if not entries:
        raise InputError("mass", "is missing: add [[mass]] with M and position for each mass")
    masses = [_mass(entry, f"mass[{j}]") for j, entry in enumerate(entries, 1)]
    try:
        return PhysicalCase(**table, masses=masses)
    except InputError as error:
        with errors_under("" if error.key.startswith("mass[") else "physical."):
            raise


def _mass(entry: object, key: str) -> Mass:
    table = _table(entry, key, _MASS)
    with errors_under(f"{key}."):
        return Mass(**table)


def _table(value: object, key: str, known: Mapping[str, str]) -> dict[str, Any]:
    """Return a table that has every required key and no unknown one; its values are not looked at."""
    if not isinstance(value, dict):
        raise InputError(key, f"is {_kind(value)}, not a section: give {', '.join(known)} in it")
    _check_keys(value, known, f"{key}.")
    for name, meaning in known.items():
        if name in _REQUIRED and name not in value:
            raise InputError(f"{key}.{name}", f"is missing: give {meaning}")
    return value


def _check_keys(table: Mapping[str, Any], known: Mapping[str, str], prefix: str) -> None:
    for name in table:
        if name not in known:
            lower = {candidate.lower(): candidate for candidate in known}
            near = get_close_matches(name.lower(), lower, n=1, cutoff=0.5)
            advice = f"did you mean {lower[near[0]]}?" if near else f"the keys here are {', '.join(known)}"
            shown = name if name.isidentifier() and len(name) <= 40 else repr(name[:40])
            raise InputError(f"{prefix}{shown}", f"is unknown: {advice}")


def _kind(value: object) -> str:
    """Return the name that TOML has for the type of `value`."""
    kinds = {bool: "a boolean", int: "a number", _Written: "a number", str: "a text", list: "a list"}
    return "a table" if isinstance(value, dict) else kinds.get(type(value), "a date or time")
