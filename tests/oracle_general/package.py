"""A plain problem as the package's own Problem: for tests that hold the two against each other."""

from __future__ import annotations

from typing import Any

from mpsolve import tracks, vehicles
from mpsolve.problem.problem import Problem


def _named(module: Any) -> dict[str, Any]:
    """The classes of a module by the name of their model."""
    classes = [entry for entry in vars(module).values() if isinstance(entry, type)]
    return {entry.name: entry for entry in classes if getattr(entry, "name", "")}  # type: ignore[attr-defined]


def known(problem: dict[str, Any]) -> bool:
    """Whether the package has all models of the problem."""
    kinds = _named(vehicles)
    return problem["track"]["model"] in _named(tracks) and all(v["model"] in kinds for v in problem["vehicles"])


def as_problem(problem: dict[str, Any]) -> Problem:
    values = dict(problem["track"])
    guide = _named(tracks)[values.pop("model")](**values)
    return Problem(guide, [_vehicle(data) for data in problem["vehicles"]], v=problem["v"])


def _vehicle(data: dict[str, Any]) -> Any:
    values, kinds = dict(data), _named(vehicles)
    kind, place = values.pop("model"), values.pop("at", "0")
    if "bogie" in values:
        values["bogie"] = kinds["bogie"](**{key: value for key, value in values["bogie"].items() if key != "model"})
    return kinds[kind](**values).at(place)
