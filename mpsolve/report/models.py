"""Every track and vehicle in text, from the descriptions in their classes."""

from __future__ import annotations

from difflib import get_close_matches
from fractions import Fraction
from typing import Any

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.numbers.model import Quantity, defaults, quantities, shown

_OWN = """\
Any other track is written in Python, as a sympy matrix of its equations of motion in p and Omega:
tracks.Waveguide(matrix, loaded). Any other vehicle is given by its matrices, as above.
"""
_PLACES = """\
Each [[vehicle]] has a position besides: where its middle is, in m ahead (0 if left out); count and spacing make a
train of it, whose rearmost one stands there. Masses are per modelled rail.
"""

_ONE_RAIL = """\
Rail tracks: everything for one rail and per metre of it: half a sleeper, one pad, half a wheelset, half a bogie.
Some damping must be above 0; only masses on the paper's beam are decided without any.
"""


def listing(name: str | None = None) -> str:
    """The model with this name, or all of them; InputError for a name that no model has."""
    known = {model.name: (model, "tracks") for model in tracks.CATALOGUE}
    known |= {model.name: (model, "vehicles") for model in vehicles.CATALOGUE}  # type: ignore[misc]
    if name is not None:
        if name not in known:
            near = get_close_matches(name.lower(), known, n=1, cutoff=0.5)
            advice = f"did you mean {near[0]}?" if near else f"the models are {', '.join(known)}"
            raise InputError("name", f"is {name[:40]!r}, which is unknown: {advice}")
        rail = "EI" in quantities(known[name][0])
        return "\n".join([_entry(*known[name]), *([_ONE_RAIL] if rail else [])])
    parts = ["TRACKS: [track] with model = and the parameters\n", _ONE_RAIL]
    parts += [_entry(model, "tracks") for model in tracks.CATALOGUE]
    parts += ["VEHICLES: [[vehicle]] with model = and the parameters\n", _PLACES]
    parts += [_entry(model, "vehicles") for model in vehicles.CATALOGUE]
    return "\n".join([*parts, _OWN])


def _entry(model: Any, module: str) -> str:
    head = f"{model.name}  ({module}.{model.__name__})"
    optional = defaults(model)
    rows = [(name, quantity.unit or "–", *_said(quantity, name in optional, optional.get(name)))
            for name, quantity in quantities(model).items()]  # fmt: skip
    widths = [max(len(row[k]) for row in rows) for k in range(3)]
    table = [
        "  " + "  ".join(cell.ljust(width) for cell, width in zip(row, [*widths, 0], strict=True)) for row in rows
    ]
    says = "  " + model.__doc__.strip().splitlines()[0]
    return "\n".join([head, says, "", model.drawing.rstrip("\n"), "", *(line.rstrip() for line in table)]) + "\n"


def _said(quantity: Quantity, optional: bool, default: Fraction | None) -> tuple[str, str]:
    """The meaning, and what may be given."""
    if isinstance(default, Fraction):
        given = f"{shown(default)} if left out"
    else:
        given = "may be left out" if optional else "must be given"
    return quantity.meaning, ", ".join(part for part in (given, quantity.bound) if part)
