"""The axes of a study: which values each path of the problem's parameters takes, in exact numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import prod
from typing import Any

from mpsolve.errors import ContradictionError, InputError
from mpsolve.numbers.model import Quantity, rational, whole
from mpsolve.numbers.units import measured
from mpsolve.numbers.written import Measured
from mpsolve.problem import specs
from mpsolve.problem.parameters import quantity_of
from mpsolve.problem.problem import Problem
from mpsolve.studies.design import Axis, Listed, Parts, Span, Steps, Value

MAX_CASES = 10**12
_SPAN = {"low": "the least value", "high": "the bound above"}
_PARTS = 10**6
_AXIS = {"start", "stop", "step", "low", "high"}


def read_axes(given: Any, design: str, problem: Problem) -> dict[str, Axis]:
    """The axis of each path. design: that of the study, or "parts" where an entry is a part of a box."""
    if not isinstance(given, Mapping):
        raise InputError("parameters", "is no section: give paths and their values in it")
    flat = dict(_flattened(given, ""))
    if not flat:
        raise InputError("parameters", "is empty: give at least one path, such as v or track.k")
    asked = {path: _quantity(problem, path) for path in flat}
    axes = {
        path: _axis(_measured(value, asked[path], f"parameters.{path}"), path, design) for path, value in flat.items()
    }
    for path, axis in axes.items():
        for value in axis.extremes:
            try:
                problem.changed(path, value)
            except InputError as error:
                raise error.under(f"parameters.{path}") from None
    return axes


def _quantity(problem: Problem, path: str) -> Quantity:
    try:
        return quantity_of(problem.track, problem.vehicles, problem.v, path)
    except InputError as error:
        raise error.under(f"parameters.{path}") from None


def _measured(given: Any, asked: Quantity, key: str) -> Any:
    """Texts with units, in lists and tables too, in the parameter's own unit."""
    if isinstance(given, Mapping):
        return {name: _measured(value, asked, f"{key}.{name}") for name, value in given.items()}
    if isinstance(given, (list, tuple)):
        return [_measured(value, asked, f"{key}[{j}]") for j, value in enumerate(given, 1)]
    number = measured(given, asked.unit, key, asked.meaning)
    if isinstance(number, Measured) and not key.endswith(".step"):
        asked.end(given, key)
    return number


def _flattened(table: Mapping[str, Any], prefix: str) -> Iterator[tuple[str, Any]]:
    """track.k = … in TOML is a table in a table: paths again."""
    for name, value in table.items():
        if isinstance(value, Mapping) and not _AXIS & value.keys():
            yield from _flattened(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def _axis(given: Any, name: str, design: str) -> Axis:
    key, drawn = f"parameters.{name}", design in ("random", "quasi-random")
    if design == "parts":
        return _parts(given, key)
    if isinstance(given, Mapping) and ({"low", "high"} & given.keys()):
        if not drawn:
            raise InputError(key, f'is a range, but a {design} draws nothing: give design = {{kind = "random", …}}')
        return _span(given, key)
    if drawn and isinstance(given, (Mapping, list, tuple)):
        raise InputError(key, f"is several values, but a {design} design draws: give {{low, high}} or one number")
    if isinstance(given, Mapping):
        return Steps(*specs.steps(given, key))
    if not isinstance(given, (list, tuple)):
        return Listed((rational(given, key),))
    if not given:
        raise InputError(key, "is empty: give at least one value")
    values = [rational(one, f"{key}[{j}]") for j, one in enumerate(given, 1)]
    seen: set[Value] = set()
    for j, value in enumerate(values, 1):
        if design == "grid" and value in seen:
            raise InputError(f"{key}[{j}]", f"is {value}, which is there already: drop one")
        seen.add(value)
    return Listed(tuple(values))


def _span(given: Mapping[str, Any], key: str) -> Span:
    span = Span(**specs.rationals(given, key, _SPAN))
    if not span.low < span.high:
        raise InputError(f"{key}.high", "is not above low: give the bounds in order")
    return span


def _parts(given: Any, key: str) -> Axis:
    """A range in parts, or one number."""
    if isinstance(given, (list, tuple)) or (isinstance(given, Mapping) and "low" not in given):
        raise InputError(key, 'is several values, but kind = "stable" is about ranges: give {low, high, parts}')
    if not isinstance(given, Mapping):
        return Listed((rational(given, key),))
    count = whole(given.get("parts", 1), f"{key}.parts", 1, _PARTS)
    span = _span({name: value for name, value in given.items() if name != "parts"}, key)
    return Parts(span.low, span.high, count)


def total_of(axes: Mapping[str, Axis], design: str, count: int) -> int:
    if count:
        return count
    lengths = {name: counted(axis).count for name, axis in axes.items()}
    longest = max(lengths, key=lambda name: lengths[name])
    if design == "list":
        for name, length in lengths.items():
            if length not in (1, lengths[longest]):
                stated = f"has {length} values, and {longest} has {lengths[longest]}"
                raise InputError(f"parameters.{name}", f"{stated}: give as many, or one for all entries")
    total = lengths[longest] if design == "list" else prod(lengths.values())
    if total > MAX_CASES:
        raise InputError("parameters", f"make more than {MAX_CASES} entries: give at most so many")
    return total


def counted(axis: Axis) -> Listed | Steps | Parts:
    if isinstance(axis, Span):
        raise ContradictionError("a range between bounds has no values of its own, and was counted")
    return axis
