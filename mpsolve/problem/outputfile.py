"""Write a problem as a TOML file that reads back to the same problem, each number exactly."""

from __future__ import annotations

import json
from fractions import Fraction

from mpsolve.errors import InputError
from mpsolve.numbers.model import Model, Part
from mpsolve.numbers.spoken import decimal
from mpsolve.problem.problem import Problem
from mpsolve.tracks.waveguide import Track


def problem_toml(problem: Problem, title: str = "") -> str:
    """The text of an input file; units and meanings stand in comments.

    InputError for a track of bare equations (`tracks.Waveguide`), which no file can hold.
    """
    if not isinstance(problem.track, Track):
        raise InputError("track", "is given by bare equations, which an input file cannot hold: keep it in a program")
    lines = [f"title = {json.dumps(title, ensure_ascii=False)}", ""] if title else []
    lines += [f"v = {number(problem.v)}  # m/s", "", "[track]", *_model(problem.track)]
    for placed in problem.vehicles:
        lines += ["", "[[vehicle]]", *_model(placed.vehicle, f"position = {number(placed.position)}  # m")]
    return "\n".join(lines) + "\n"


def number(x: Fraction) -> str:
    """A decimal where there is one, else a ratio in quotes."""
    said = decimal(x)
    return f'"{said}"' if "/" in said else said


def _model(model: Model, *more: str) -> list[str]:
    lines = [_named(model), *more]
    parts: list[str] = []
    for name, quantity, value in model.described:
        if value is None:
            continue
        if isinstance(quantity, Part):
            parts.append(f"{name} = {{ {', '.join(_inline(value))} }}  # {quantity.meaning}")
        else:
            lines.append(f"{name} = {_value(value)}  # {quantity.told}")
    return lines + parts


def _named(model: Model) -> str:
    return f'model = "{model.name}"'  # type: ignore[attr-defined]


def _inline(model: Model) -> list[str]:
    return [_named(model), *(f"{name} = {_value(value)}" for name, value in model.parameters.items())]


def _value(value: Fraction) -> str:
    if isinstance(value, Fraction):
        return number(value)
    if isinstance(value, tuple):
        return "[" + ", ".join(_value(x) for x in value) + "]"
    if isinstance(value, Model):
        return f"{{ {', '.join(_inline(value))} }}"
    return json.dumps(value, ensure_ascii=False)
