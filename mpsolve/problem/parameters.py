"""The parameters of a problem by path: what they are, and the same problem with one of them changed.

Paths: `v`; `track.k`; `vehicles[0].wheel` and `vehicles[0].bogie.k`, vehicles counted from 0 in ascending order of
position; `vehicles.wheel`, all vehicles at once; `gap[0]`, the distance between the middles of vehicles 0 and 1;
`scale.mass` and `scale.gap`, factors on all masses and on all gaps (bodies stay rigid). A case of the paper has its
ratios too (`problem/ratios.py`). All values are exact.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from copy import copy
from difflib import get_close_matches
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import msgspec

from mpsolve.errors import InputError
from mpsolve.numbers.model import Entries, Model, Part, Quantity, nonnegative, positive, quantities
from mpsolve.numbers.several import Several
from mpsolve.problem.checked import errors_under
from mpsolve.problem.ratios import paths_of, ratio, ratios_of
from mpsolve.vehicles.vehicle import Placed

if TYPE_CHECKING:
    from mpsolve.tracks.euler_bernoulli import EulerBernoulli

_MASSES = ("kg", "kg m²")
_VELOCITY = nonnegative("m/s", "velocity")
_GAP = positive("m", "distance from one middle to the next")
_FACTOR = positive("", "factor")
_INDEXED = re.compile(r"(vehicles|gap)\[(\d+)\](?:\.(.+))?")


def parameters_of(track: Any, vehicles: tuple[Placed, ...], v: Fraction) -> dict[str, Fraction]:
    """Every path with its value; `vehicles.…` where all vehicles have the parameter with one value."""
    placed = ascending(vehicles)
    out = {"v": v}
    if isinstance(track, Model):
        out |= {f"track.{path}": value for path, value in _numbers(track)}
    own = [dict(_numbers(one.vehicle)) for one in placed]
    shared = [path for path in own[0] if all(values.get(path) == own[0][path] for values in own)]
    out |= {f"vehicles.{path}": own[0][path] for path in shared} if len(own) > 1 else {}
    out |= {f"vehicles[{k}].{path}": value for k, values in enumerate(own) for path, value in values.items()}
    out |= {f"gap[{k}]": b.position - a.position for k, (a, b) in enumerate(pairwise(placed))}
    out["scale.mass"] = Fraction(1)
    return out | ({"scale.gap": Fraction(1)} if len(placed) > 1 else {})


def quantity_of(track: Any, vehicles: tuple[Placed, ...], v: Fraction, path: str) -> Quantity:
    """Unit, meaning and bound of the parameter at `path`; InputError names a path that there is not."""
    placed = ascending(vehicles)
    indexed = _INDEXED.fullmatch(path)
    if (asked := ratio(track, placed, path)) is not None:
        return asked
    if path == "v":
        return _VELOCITY
    if path == "scale.mass" or (path == "scale.gap" and len(placed) > 1):
        return _FACTOR
    if indexed and indexed[1] == "gap" and not indexed[3] and int(indexed[2]) < len(placed) - 1:
        return _GAP
    found = None
    if path.startswith("track.") and isinstance(track, Model):
        found = _inner(track, path.removeprefix("track."))
    elif path.startswith("vehicles."):
        found = _inner(placed[0].vehicle, path.removeprefix("vehicles."))
    elif indexed and indexed[1] == "vehicles" and indexed[3] and int(indexed[2]) < len(placed):
        found = _inner(placed[int(indexed[2])].vehicle, indexed[3])
    if found is None:
        raise _unknown(path, parameters_of(track, vehicles, v) | ratios_of(track, placed, v))
    return found


def _inner(model: Model, path: str) -> Quantity | None:
    """The quantity of a numeric parameter, or of one of a part after a dot."""
    name, _, inner = path.partition(".")
    quantity = quantities(type(model)).get(name)
    if quantity is None or not inner:
        return quantity
    return _inner(getattr(model, name), inner) if isinstance(quantity, Part) else None


def changed(
    track: Any, vehicles: tuple[Placed, ...], v: Fraction, path: str, value: object
) -> tuple[Any, tuple[Placed, ...], Fraction]:
    """(track, vehicles, v) with the parameter at `path` set to `value`; InputError names a path that there is not.

    A value of class `Several`, a parameter that is left free, is put in as it is, unchecked.
    """
    asked = quantity_of(track, vehicles, v, path)
    placed = ascending(vehicles)
    number: Any = value if isinstance(value, Several) else asked.end(value, path)
    if ratio(track, placed, path) is not None:
        return _ratio_changed(track, placed, v, path, number)
    if path == "v":
        return track, vehicles, number
    if path.startswith("track.") and isinstance(track, Model):
        return _with(track, path.removeprefix("track."), number, path), vehicles, v
    moved = _vehicle_changed(placed, path, number)
    if moved is None:
        raise _unknown(path, parameters_of(track, vehicles, v) | ratios_of(track, placed, v))
    return track, moved, v


def _ratio_changed(
    track: EulerBernoulli, placed: Any, v: Fraction, path: str, number: Any
) -> tuple[Any, tuple[Placed, ...], Any]:
    """Through the parameters that a ratio of the paper stands for."""
    try:
        for inner, factor in paths_of(path, len(placed)):
            track, placed, v = changed(track, placed, v, inner, number * factor)
    except InputError as error:
        raise error.under(path) from None
    return track, placed, v


def _vehicle_changed(placed: tuple[Placed, ...], path: str, number: Any) -> tuple[Placed, ...] | None:
    """The vehicles with the parameter changed; None where the path names none of theirs."""
    if path.startswith("scale."):
        return _rescaled(placed, path, number)
    if path.startswith("vehicles."):
        inner = path.removeprefix("vehicles.")
        return tuple(Placed(_with(p.vehicle, inner, number, path), p.position) for p in placed)
    indexed = _INDEXED.fullmatch(path)
    if (
        not indexed
        or not int(indexed[2]) < len(placed) - (indexed[1] == "gap")
        or (indexed[1] == "gap") == bool(indexed[3])
    ):
        return None
    k = int(indexed[2])
    if indexed[1] == "gap":
        shift = _checked(number, path) - (placed[k + 1].position - placed[k].position)
        return (*placed[: k + 1], *(Placed(p.vehicle, p.position + shift) for p in placed[k + 1 :]))
    one = Placed(_with(placed[k].vehicle, indexed[3], number, path), placed[k].position)
    return (*placed[:k], one, *placed[k + 1 :])


def _rescaled(placed: tuple[Placed, ...], path: str, number: Any) -> tuple[Placed, ...] | None:
    if path == "scale.mass":
        factor = _checked(number, path)
        return tuple(Placed(_heavier(p.vehicle, factor), p.position) for p in placed)
    if path == "scale.gap" and len(placed) > 1:
        factor, first = _checked(number, path), placed[0].position
        return tuple(Placed(p.vehicle, first + factor * (p.position - first)) for p in placed)
    return None


def ascending(vehicles: tuple[Placed, ...]) -> tuple[Placed, ...]:
    return tuple(sorted(vehicles, key=lambda one: one.position))


def _numbers(model: Any) -> Iterator[tuple[str, Any]]:
    """The numeric parameters of a model, those of its parts after a dot."""
    for name, quantity, value in model.described:
        if isinstance(quantity, Part) and value is not None:
            yield from ((f"{name}.{path}", inner) for path, inner in _numbers(value))
        elif isinstance(value, (Fraction, Several)):
            yield name, value


def _with(model: Any, path: str, value: Any, key: str) -> Any:
    """The model with one of its numeric parameters changed; what it refuses is told under `key`."""
    known = dict(_numbers(model))
    if path not in known:
        advice = f"these are {', '.join(known)}" if known else "scale.mass is a factor of all masses"
        raise InputError(key, f"is no single number that the model {model.name} gives here: {advice}")
    try:
        return filled(model, {path: value})
    except InputError as error:
        raise error.under(key) from None


def filled(model: Any, values: Mapping[str, Any]) -> Any:
    """The model with these parameters, those of its parts after a dot; None leaves one out."""
    new: dict[str, Any] = {}
    for name, quantity, value in model.described if values else ():
        inner = {path.removeprefix(f"{name}."): x for path, x in values.items() if path.startswith(f"{name}.")}
        if inner:
            with errors_under(f"{name}."):
                new[name] = filled(value, inner)
        elif name in values:
            if values[name] is None and not quantity.optional:
                raise InputError(name, f"cannot be left out: give the {quantity.told}")
            new[name] = values[name]
    return _replaced(model, new) if new else model


def _heavier(model: Any, factor: Fraction) -> Any:
    """The model with all its masses and inertias multiplied."""
    new: dict[str, Any] = {}
    for name, quantity, value in model.described:
        if isinstance(quantity, Part) and value is not None:
            new[name] = _heavier(value, factor)
        elif quantity.unit in _MASSES and value is not None:
            new[name] = _scaled(value, lambda x: x * factor) if isinstance(quantity, Entries) else value * factor
    return _replaced(model, new)


def _replaced(model: Any, new: dict[str, Any]) -> Any:
    """The model with these parameters; checked where they are numbers."""
    if not any(map(_free, new.values())):
        return msgspec.structs.replace(model, **new)
    out = copy(model)
    for name, value in new.items():
        msgspec.structs.force_setattr(out, name, value)
    return out


def _free(value: Any) -> bool:
    """Whether a parameter is left free somewhere in the value."""
    if isinstance(value, tuple):
        return any(map(_free, value))
    if isinstance(value, Model):
        return any(isinstance(number, Several) for _, number in _numbers(value))
    return isinstance(value, Several)


def _scaled(value: Any, change: Callable[[Fraction], Fraction]) -> Any:
    return tuple(_scaled(entry, change) for entry in value) if isinstance(value, tuple) else change(value)


def _checked(number: Any, path: str) -> Any:
    if isinstance(number, Several):
        return number
    return positive("", "factor" if path.startswith("scale") else "distance in m").checked(number, path)


def _unknown(path: str, known: dict[str, Fraction]) -> InputError:
    lower = {name.lower(): name for name in known}
    near = get_close_matches(path.lower(), lower, n=1, cutoff=0.6)
    advice = f"did you mean {lower[near[0]]}? The" if near else "the"
    return InputError(path, f"is unknown: {advice} parameters are {', '.join(known)}")
