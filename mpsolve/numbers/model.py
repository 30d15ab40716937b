"""What every track and vehicle is: a frozen record of exact rationals that describes its own parameters.

The description (unit, meaning, bound, default) stands once, in the annotations of the class: validation, error
messages, the reader of input files, `mpsolve models` and the documentation all read it there.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from fractions import Fraction
from functools import cache
from numbers import Integral
from typing import Annotated, Any, TypeAlias, get_args, get_origin, get_type_hints

import msgspec

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.exact import Exact, Number
from mpsolve.numbers.spoken import decimal
from mpsolve.numbers.units import in_unit
from mpsolve.numbers.written import as_given

Rational: TypeAlias = Any
"""An exact number: int, Fraction, decimal or ratio in a text, or a float, which stands for its shortest decimal."""


@frozen
class Quantity:
    """One parameter: its unit, what it means, and the least value that it may have.

    without: what it means that an optional one is left out.
    """

    unit: str
    meaning: str
    above: int | None = None
    at_least: int | None = None
    optional: bool = False
    without: str = ""

    def checked(self, value: object, key: str) -> Fraction:
        """The exact value of `value`; InputError under `key` where it breaks a bound."""
        return self._held(value, key, False)

    def end(self, value: object, key: str) -> Fraction:
        """The same as an end of a range, which may be a bound that excludes its own value."""
        return self._held(value, key, True)

    def _held(self, value: object, key: str, end: bool) -> Fraction:
        number, least = (
            rational(value, key, self.unit, self.meaning),
            self.at_least if self.above is None else self.above,
        )
        if least is not None and (number < least or (number == self.above and not end)):
            must = "not be below" if self.above is None else "be above"
            raise InputError(key, f"is {shown(number, value)}, but must {must} {least}: give the {self.told}")
        return number

    @property
    def bound(self) -> str:
        """The least value in words, empty for a parameter without any."""
        if self.above is not None:
            return f"above {self.above}"
        return "" if self.at_least is None else f"at least {self.at_least}"

    @property
    def told(self) -> str:
        """What the parameter is, and its unit."""
        return f"{self.meaning} in {self.unit}" if self.unit else self.meaning


@frozen
class Entries(Quantity):
    """A list of numbers, or a matrix as a list of rows (depth 2).

    alike: units that an entry may have besides: rotations stand in one matrix with displacements.
    """

    depth: int = 1
    alike: tuple[str, ...] = ()

    def checked(self, value: object, key: str) -> Any:
        """The exact entries as nested tuples; InputError names the entry that is none."""
        return self._level(value, key, self.depth)

    def _level(self, value: object, key: str, depth: int) -> Any:
        if not depth:
            return self._entry(value, key)
        value = value.toarray() if hasattr(value, "toarray") else value  # of scipy's sparse matrices
        if isinstance(value, (str, bytes, Mapping, Set)) or not isinstance(value, Iterable):
            wanted = "a list of rows" if depth == 2 else "a list of numbers"
            raise InputError(key, f"is of type {type(value).__name__}: give {wanted}, the {self.told}")
        return tuple(self._level(entry, f"{key}[{j}]", depth - 1) for j, entry in enumerate(value, 1))

    def _entry(self, value: object, key: str) -> Fraction:
        for unit in self.alike:
            try:
                return rational(value, key, unit)
            except InputError:
                continue
        return rational(value, key, self.unit, self.meaning)


@frozen
class Texts(Quantity):
    """A list of texts."""

    def checked(self, value: object, key: str) -> Any:
        """The texts as a tuple; InputError where one is none."""
        if isinstance(value, str) or not isinstance(value, Iterable):
            raise InputError(key, f"is of type {type(value).__name__}: give a list of texts, the {self.told}")
        texts = tuple(value)
        for j, text in enumerate(texts, 1):
            if not isinstance(text, str) or not text:
                raise InputError(f"{key}[{j}]", "is no text: give a name in quotes")
        return texts


@frozen
class Part(Quantity):
    """Another model of the kind that the parameter is declared as."""

    kind: type[Any] = object

    def checked(self, value: object, key: str) -> Any:
        """The model itself; InputError where it is none of this kind."""
        if not isinstance(value, self.kind):
            raise InputError(key, f"is of type {type(value).__name__}: give a {self.kind.__name__}, the {self.told}")
        return value


def positive(unit: str, meaning: str) -> Quantity:
    return Quantity(unit, meaning, above=0)


def nonnegative(unit: str, meaning: str) -> Quantity:
    return Quantity(unit, meaning, at_least=0)


def real(unit: str, meaning: str) -> Quantity:
    return Quantity(unit, meaning)


def contact_spring() -> Quantity:
    """Stiffness of a contact spring; None means a tight contact."""
    told = "stiffness of each contact spring (none: tight contact)"
    return Quantity("N/m", told, above=0, optional=True, without="rigid contact")


class Model(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Base of tracks and vehicles whose parameters are numbers; each field is Annotated with its Quantity."""

    def __post_init__(self) -> None:
        for name, quantity, value in self.described:
            if value is None and quantity.optional:
                continue
            msgspec.structs.force_setattr(self, name, quantity.checked(value, name))
        self.check()

    def check(self) -> None:
        """Raise InputError where the parameters exclude each other; the base accepts them."""

    def __repr__(self) -> str:
        """As it is typed; what has its default is left out."""
        usual = defaults(type(self))
        values = ((name, value) for name, _, value in self.described if name not in usual or value != usual[name])
        told = (f"{name}={typed(value)}" for name, value in values)
        return f"{type(self).__name__}({', '.join(told)})"

    @property
    def described(self) -> list[tuple[str, Quantity, Any]]:
        """Name, description and value of each parameter, in the order of the class."""
        return [(name, quantity, getattr(self, name)) for name, quantity in quantities(type(self)).items()]

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters by name, in the order of the class; what is absent is left out."""
        return {name: value for name, _, value in self.described if value is not None}


@cache
def quantities(model: type[Any]) -> dict[str, Quantity]:
    """The described parameters of a model by name, in the order of its arguments."""
    out: dict[str, Quantity] = {}
    for name, hint in get_type_hints(model, include_extras=True).items():
        if get_origin(hint) is Annotated:
            out[name] = next(note for note in get_args(hint)[1:] if isinstance(note, Quantity))
    return out


def defaults(model: type[Any]) -> dict[str, Fraction | None]:
    """The values of the parameters that may be left out."""
    fields = msgspec.structs.fields(model)
    return {field.name: field.default for field in fields if field.default is not msgspec.NODEFAULT}


def whole(value: object, key: str, least: int, most: int) -> int:
    """The whole number; InputError under `key` where it is none, or out of its bounds."""
    if isinstance(value, bool) or not isinstance(value, Integral) or not least <= int(value) <= most:
        raise InputError(key, f"is {value!r}: give a whole number from {least} to {most}")
    return int(value)


def rational(value: Number | object, key: str, unit: str | None = None, told: str = "") -> Fraction:
    """The exact rational that `value` stands for; InputError under `key` where it is none.

    unit: what it is measured in; a text may then have a unit of its own, which is converted ("12.5 t" for kg).
    """
    if unit is not None:
        return in_unit(value, unit, key, told)
    exact = Exact.parse(value, key)
    if not exact.is_rational:
        raise InputError(key, f"is {exact.short()}, which is irrational: give a decimal or a ratio p/q")
    return exact.as_fraction()


def typed(value: Any) -> str:
    """An exact value as Python that makes it again: whole numbers bare, others in quotes."""
    if isinstance(value, (tuple, list)):
        return f"[{', '.join(map(typed, value))}]"
    if not isinstance(value, Fraction):
        return repr(value)
    return str(value) if value.denominator == 1 else repr(decimal(value))


def shown(number: Fraction, given: object = None) -> str:
    """A short text of an exact number for messages, or the text with a unit that gave it."""
    return as_given(given, Exact.parse(number).short())


def checked_range(
    value: Any, key: str, unit: str | None = None, least: int | None = None
) -> tuple[Fraction, Fraction]:
    """Two rational ends in order, none below `least`; texts may have units where `unit` is one."""
    try:
        first, last = value
    except (TypeError, ValueError):
        raise InputError(key, f"is {value!r}: give a range (lo, hi)") from None
    low, high = (rational(end, key, unit) for end in (first, last))
    if not low < high:
        stated = f"ends at {shown(high, last)}, not above its start {shown(low, first)}"
        raise InputError(key, f"{stated}: give the ends in order")
    if least is not None and low < least:
        raise InputError(key, f"starts at {shown(low, first)}, below {least}: give {least} or more")
    return low, high


def velocities(over: Any, example: str) -> tuple[Fraction, Fraction]:
    """The range of {"v": (low, high)}, 0 ≤ low < high; example: what a message shows of it."""
    if not isinstance(over, Mapping) or list(over) != ["v"]:
        raise InputError("over", f"is {over!r}: give the range of velocities, {example}")
    return checked_range(over["v"], "over['v']", "m/s", 0)
