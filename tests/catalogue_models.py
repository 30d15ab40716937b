"""Models made from their own descriptions, with parameters about 1: a new one in the catalogue is tested unasked."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.model import Entries, Part, Quantity, Texts, defaults, quantities


def made(model: type[Any]) -> Any:
    """Each parameter is 1, or 1/4 where it may be 0; what is optional, or excludes what is needed, is left out."""
    described, free = quantities(model), defaults(model)
    values = {name: _value(quantity) for name, quantity in described.items() if name not in free}
    one = model(**values) if set(described) == set(values) else None
    for name in [name for name in free if name in described and not described[name].optional]:
        try:
            one = model(**values, **{name: _value(described[name])})
        except InputError:
            continue
        values[name] = getattr(one, name)
    return one or model(**values)


def _value(quantity: Quantity) -> Any:
    if isinstance(quantity, Part):
        return made(quantity.kind)
    if isinstance(quantity, (Entries, Texts)):
        return [[1]] if getattr(quantity, "depth", 1) == 2 else [0]
    if quantity.above is not None:
        return Fraction(1)
    return Fraction(0) if quantity.at_least is None else Fraction(1, 4)
