"""Exact numbers as arguments: parsed, held against their bounds, and errors that name the argument."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import contextmanager
from itertools import pairwise

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.written import as_given

BUCKLED = "so the beam buckles without any load: lower the compression"


@contextmanager
def errors_under(prefix: str) -> Iterator[None]:
    """Put `prefix` before the key of every InputError that is raised inside."""
    try:
        yield
    except InputError as error:
        raise error.under(prefix + error.key) from None


def above_zero(value: object, key: str, meaning: str) -> Exact:
    exact = Exact.parse(value, key)
    if exact.sign <= 0:
        raise InputError(key, f"is {as_given(value, exact.short())}, but must be above 0: give the {meaning}")
    return exact


def at_least_zero(value: object, key: str, meaning: str) -> Exact:
    exact = Exact.parse(value, key)
    if exact.sign < 0:
        raise InputError(key, f"is {as_given(value, exact.short())}, but must not be below 0: give the {meaning}")
    return exact


def parsed(values: object, key: str) -> tuple[Exact, ...]:
    """Return the numbers of a sequence, or one bare number as a sequence of one."""
    if isinstance(values, Iterable) and not isinstance(values, (str, bytes, Mapping, Set)):
        return tuple(Exact.parse(value, f"{key}[{j}]") for j, value in enumerate(values, 1))
    return (Exact.parse(values, key),)


def check_ascending(places: Iterable[Exact], key: str) -> None:
    """Refuse a place below the one before it; `key` names the place with number {j}."""
    for j, (before, place) in enumerate(pairwise(places), 2):
        if place < before:
            stated = f"is {place.short()}, below the {before.short()} before it"
            raise InputError(key.format(j=j), f"{stated}: list the masses by ascending position")
