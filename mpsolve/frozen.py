"""Frozen dataclasses that are quickly made: for what every start of the program loads.

`dataclass(frozen=True)` writes and compiles six functions for each class, 0.4 ms; a hundred classes are a tenth of
what `mpsolve certify` takes for two masses. Here only `__init__` is written, and the others are shared.
"""

from __future__ import annotations

from dataclasses import FrozenInstanceError, dataclass, field
from typing import Any, TypeVar, dataclass_transform

T = TypeVar("T")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(made: type[T]) -> type[T]:
    """As `dataclass(frozen=True)`: fields, defaults, `replace`, equality, hash and repr are the same.

    With `init=False` where a class has an `__init__` of its own.
    """
    named: Any = dataclass(init="__init__" not in vars(made), repr=False, eq=False)(made)
    for name, function in _SHARED.items():
        if name not in vars(made):
            setattr(named, name, function)
    return made


def _set(self: Any, name: str, value: object) -> None:
    """Once: what `__init__` does."""
    held = self.__dict__
    if name in held or name not in self.__dataclass_fields__:
        raise FrozenInstanceError(f"cannot assign to field {name!r}")
    held[name] = value


def _delete(self: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r} of {type(self).__name__}")


def _compared(self: Any) -> tuple[Any, ...]:
    return tuple(getattr(self, name) for name, one in self.__dataclass_fields__.items() if one.compare)


def _equal(self: Any, other: object) -> bool:
    return _compared(self) == _compared(other) if other.__class__ is self.__class__ else NotImplemented


def _hash(self: Any) -> int:
    return hash(_compared(self))


def _repr(self: Any) -> str:
    shown = ", ".join(
        f"{name}={getattr(self, name)!r}" for name, one in self.__dataclass_fields__.items() if one.repr
    )
    return f"{type(self).__qualname__}({shown})"


_SHARED = {"__setattr__": _set, "__delattr__": _delete, "__eq__": _equal, "__hash__": _hash, "__repr__": _repr}
