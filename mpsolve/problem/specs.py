"""Specifications of tables and charts: fixed parameters and grids, from a mapping or a TOML file, in exact numbers.

Every mistake is an InputError under its key, as in mpsolve/problem/casefile.py.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from difflib import get_close_matches
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal, TypeAlias

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.ranges import checked_range
from mpsolve.problem.case import Case
from mpsolve.problem.toml import check_keys, kind, name_of, parsed, refuse_other_kind, text_of

PARAMETERS = {
    "alpha": "the velocity ratio",
    "eta_b": "the damping ratio",
    "eta_m": "the mass ratio of each mass",
    "d": "the distance of neighbouring masses in units of 1/χ",
    "eta_n": "the axial force ratio, compression positive",
    "eta_s": "the Pasternak modulus ratio",
}
ONE_MASS: Literal["one mass"] = "one mass"
"""Stands among the values of d for one mass alone."""

MAX_VALUES = 10_000
"""Most values of one grid."""
MAX_DIGITS = 1_000

Value: TypeAlias = "Exact | Literal['one mass']"
_FIXED = PARAMETERS | {"masses": "the number of masses, 1, 2 or 3"}
_GRID = {"parameter": "the name of the parameter", "values": "a list, or {start, stop, step}"}
_RANGE = {"start": "the first value", "stop": "the last value", "step": "the step between values"}


@dataclass(frozen=True)
class Grid:
    """The values, in order, of one parameter; "one mass" may stand among those of d."""

    parameter: str
    values: tuple[Value, ...]

    @property
    def labels(self) -> tuple[str, ...]:
        """Each value as text: a decimal where a short one is exact."""
        return tuple(map(label, self.values))


def label(value: Value) -> str:
    """The value as a decimal if 15 digits hold it, else as p/q or root4(p/q)."""
    if isinstance(value, str):
        return value
    short = value.short(15)
    return short if Exact.parse(short) == value else str(value)


def load(spec: Mapping[str, Any] | str | os.PathLike[str], known: Mapping[str, str]) -> dict[str, Any]:
    """The content of a spec, with no key at the top that is not in `known`; numbers as they are written."""
    if isinstance(spec, Mapping):
        content = dict(spec)
    elif isinstance(spec, (str, os.PathLike)):
        file = Path(spec)
        content = parsed(text_of(file), name_of(file))
        refuse_other_kind(content, known, file)
    else:
        raise InputError("spec", f"is {kind_of(spec)}: give a mapping, or the path of a TOML file")
    check_keys(content, known, "")
    return content


def title(content: Mapping[str, Any]) -> str:
    text = content.get("title", "")
    if type(text) is not str:
        raise InputError("title", f'is {kind_of(text)}, not a text: write title = "…"')
    return text


def digits(content: Mapping[str, Any], default: int = 15) -> int:
    number = content.get("digits", default)
    if isinstance(number, bool) or not isinstance(number, int) or not 1 <= number <= MAX_DIGITS:
        raise InputError("digits", f"is {number!r}: give a whole number from 1 to {MAX_DIGITS}")
    return number


def choice(content: Mapping[str, Any], key: str, allowed: tuple[str, ...]) -> str:
    """The text under `key`, one of `allowed`; InputError with the nearest of them."""
    listed = ", ".join(f'"{one}"' for one in allowed)
    if key not in content:
        raise InputError(key, f"is missing: give one of {listed}")
    value = content[key]
    if value in allowed:
        return str(value)
    near = get_close_matches(value.lower(), allowed, n=1, cutoff=0.5) if isinstance(value, str) else []
    stated = repr(str(value)[:40]) if isinstance(value, str) else kind_of(value)
    raise InputError(key, f'is {stated}: did you mean "{near[0]}"?' if near else f"is {stated}: give one of {listed}")


def grid(content: Mapping[str, Any], key: str, allowed: tuple[str, ...]) -> Grid:
    """The grid in the section `key`, over one of the parameters `allowed`."""
    if key not in content:
        raise InputError(key, f"is missing: add [{key}] with parameter and values")
    table = section(content[key], key, _GRID)
    for name in _GRID:
        if name not in table:
            raise InputError(f"{key}.{name}", f"is missing: give {_GRID[name]}")
    parameter = choice({f"{key}.parameter": table["parameter"]}, f"{key}.parameter", allowed)
    values = _values(table["values"], f"{key}.values", parameter)
    for j, value in enumerate(values):
        if value in values[:j]:
            raise InputError(f"{key}.values[{j + 1}]", f"is {label(value)}, which is there already: drop one")
    return Grid(parameter, values)


def fixed(content: Mapping[str, Any], grids: Mapping[str, Grid]) -> dict[str, Any]:
    """The section [fixed], without a parameter that a grid of these keys gives; its values are not looked at."""
    table = dict(section(content.get("fixed", {}), "fixed", _FIXED))
    for key, one in grids.items():
        if one.parameter in table:
            raise InputError(f"fixed.{one.parameter}", f"is given in {key} too: keep one of the two")
    return table


def count_of_masses(table: Mapping[str, Any]) -> int:
    number = table.get("masses", 2)
    if isinstance(number, bool) or number not in (1, 2, 3):
        raise InputError("fixed.masses", f"is {number!r}: give 1, 2 or 3")
    return int(number)


def velocity_range(table: Mapping[str, Any], default: tuple[Any, Any]) -> tuple[Exact, Exact]:
    """The range alpha = [lo, hi] of [fixed]."""
    value = table.get("alpha", default)
    if isinstance(value, str) or not isinstance(value, (list, tuple)):
        raise InputError("fixed.alpha", f"is {kind_of(value)}, but alpha is looked for: give a range [lo, hi]")
    low, high = checked_range(value, "fixed.alpha")
    if low < 0:
        raise InputError("fixed.alpha", f"starts at {low.short()}: a velocity ratio is not negative")
    return low, high


def case_of(values: Mapping[str, Any], masses: int) -> Case:
    """`masses` masses at 0, d, 2d, …; InputError under the parameter at fault.

    The first is eta_m, the others are eta_m·mass_ratio (1 if missing; 0: no other mass). A missing alpha is 0.
    """
    share = Exact.parse(values.get("mass_ratio", 1), "mass_ratio")
    if values.get("d") == ONE_MASS or not share:
        masses = 1
    places: list[Any] = [0]
    if masses > 1:
        if "d" not in values:
            raise InputError("d", "is missing: give the distance of the masses, or masses = 1")
        distance = Exact.parse(values["d"], "d")
        if distance <= 0:
            raise InputError("d", f"is {distance.short()}, but must be above 0: give a distance, or masses = 1")
        places = [distance * k for k in range(masses)]
    for name in ("eta_b", "eta_m"):
        if name not in values:
            raise InputError(name, f"is missing: give {PARAMETERS[name]}")
    ratio = Exact.parse(values["eta_m"], "eta_m")
    optional = {name: values[name] for name in ("eta_n", "eta_s") if name in values}
    return Case(
        alpha=values.get("alpha", 0),
        eta_b=values["eta_b"],
        eta_m=[ratio, *[ratio * share] * (masses - 1)],
        positions=places,
        **optional,
    )


@contextmanager
def errors_at(places: Mapping[str, str]) -> Iterator[None]:
    """Put the place in the spec for the parameter that an InputError names (fixed.NAME where none is given)."""
    try:
        yield
    except InputError as error:
        name = error.key.partition("[")[0]
        place = places.get(name, f"fixed.{name}")
        raise InputError(place, str(error).removeprefix(f"{error.key}: ")) from None


def steps(given: Mapping[Any, Any], key: str) -> tuple[Fraction, Fraction, int]:
    """start, step and number of start, start + step, … up to stop, which counts if whole steps lead there."""
    ends = rationals(given, key, _RANGE)
    start, stop, step = ends["start"], ends["stop"], ends["step"]
    if not step or (stop - start) / step < 0:
        stated = f"is {label(Exact.parse(step))}, which does not lead from start to stop"
        raise InputError(f"{key}.step", f"{stated}: change its sign or value")
    return start, step, (stop - start) // step + 1


def rationals(given: Mapping[Any, Any], key: str, known: Mapping[str, str]) -> dict[str, Fraction]:
    """The numbers in a table that has all keys of `known`, each with its meaning, and no other."""
    check_keys(given, known, f"{key}.")
    numbers = {}
    for name, meaning in known.items():
        if name not in given:
            raise InputError(f"{key}.{name}", f"is missing: give {meaning}")
        exact = Exact.parse(given[name], f"{key}.{name}")
        if not exact.is_rational:
            raise InputError(f"{key}.{name}", "is irrational: give a decimal or a ratio p/q")
        numbers[name] = exact.as_fraction()
    return numbers


def section(value: object, key: str, known: Mapping[str, str]) -> Mapping[str, Any]:
    """The table under `key`, with no key that is not in `known`."""
    if not isinstance(value, Mapping):
        raise InputError(key, f"is {kind_of(value)}, not a section: give {', '.join(known)} in it")
    check_keys(value, known, f"{key}.")
    return value


def _values(given: object, key: str, parameter: str) -> tuple[Value, ...]:
    if isinstance(given, Mapping):
        return _stepped(given, key)
    if not isinstance(given, (list, tuple)):
        raise InputError(key, f"is {kind_of(given)}: give a list, or {{start = …, stop = …, step = …}}")
    if not given:
        raise InputError(key, "is empty: give at least one value")
    if len(given) > MAX_VALUES:
        raise InputError(key, f"has {len(given)} values: give at most {MAX_VALUES}")
    return tuple(_value(one, f"{key}[{j}]", parameter) for j, one in enumerate(given, 1))


def _value(given: object, key: str, parameter: str) -> Value:
    return ONE_MASS if parameter == "d" and given == ONE_MASS else Exact.parse(given, key)


def _stepped(given: Mapping[Any, Any], key: str) -> tuple[Value, ...]:
    start, step, number = steps(given, key)
    if number > MAX_VALUES:
        raise InputError(f"{key}.step", f"makes {number} values: give a step that makes at most {MAX_VALUES}")
    return tuple(Exact.parse(start + k * step) for k in range(number))


def kind_of(value: object) -> str:
    """The name of the type of `value` in TOML, or in Python where TOML has none."""
    if isinstance(value, (dict, list, str, bool, int)):
        return kind(value)
    return f"of type {type(value).__name__}"
