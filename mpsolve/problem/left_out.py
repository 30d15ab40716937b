"""Parameters that a problem leaves out (a rigid contact has no spring): which there are, and how they come and go.

Some come only together, as a body and the spring under it: several are put in at once, and checked once.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from mpsolve.numbers.model import Model, Part, Quantity
from mpsolve.problem.checked import errors_under
from mpsolve.problem.parameters import ascending, filled
from mpsolve.problem.problem import Problem
from mpsolve.vehicles.vehicle import Placed


def left_out(problem: Problem) -> dict[str, Quantity]:
    """The numbers that are left out, by path, as they are described."""
    return {f"{root}.{path}": quantity for root, model in _models(problem) for path, quantity in _absent(model)}


def put_in(problem: Problem, values: Mapping[str, object]) -> Problem:
    """The problem with all these parameters changed together; None leaves one out.

    InputError names what cannot be: a path that there is not, a value, or parameters that exclude each other.
    """
    for path in values:
        problem.quantity(path)
    rest = dict(values)
    new: dict[str, Any] = {}
    for root, model in _models(problem):
        own = {path.removeprefix(f"{root}."): rest.pop(path) for path in list(rest) if path.startswith(f"{root}.")}
        with errors_under(f"{root}."):
            new[root] = filled(model, own)
    placed = ascending(problem.vehicles)
    vehicles = [Placed(new.get(_vehicle(k), one.vehicle), one.position) for k, one in enumerate(placed)]
    problem = Problem(new.get("track", problem.track), vehicles, problem.v)
    for path, value in rest.items():
        problem = problem.changed(path, value)
    return problem


def _models(problem: Problem) -> Iterator[tuple[str, Model]]:
    """The track and the vehicles that describe their parameters, under the beginning of their paths."""
    named = [
        ("track", problem.track),
        *((_vehicle(k), one.vehicle) for k, one in enumerate(ascending(problem.vehicles))),
    ]
    return ((root, model) for root, model in named if isinstance(model, Model))


def _vehicle(k: int) -> str:
    return f"vehicles[{k}]"


def _absent(model: Model) -> Iterator[tuple[str, Quantity]]:
    for name, quantity, value in model.described:
        if isinstance(quantity, Part) and value is not None:
            yield from ((f"{name}.{path}", inner) for path, inner in _absent(value))
        elif value is None and type(quantity) is Quantity:
            yield name, quantity
