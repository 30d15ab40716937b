"""The quickly made classes against those of the standard library, which has another way to every function."""

from __future__ import annotations

import copy
import pickle
from dataclasses import FrozenInstanceError, dataclass, field, fields, is_dataclass, replace
from functools import cached_property
from typing import Any

import pytest

from mpsolve.frozen import frozen


class Body:
    a: int
    b: list[int] = field(default_factory=list, compare=False)
    c: str = field(default="x", repr=False)

    @cached_property
    def twice(self) -> int:
        return 2 * self.a


@frozen
class Ours(Body):
    a: int
    b: list[int] = field(default_factory=list, compare=False)
    c: str = field(default="x", repr=False)


@dataclass(frozen=True)
class Theirs(Body):
    a: int
    b: list[int] = field(default_factory=list, compare=False)
    c: str = field(default="x", repr=False)


@pytest.mark.parametrize("made", [Ours, Theirs])
def test_values_of_both_kinds_behave_alike(made: Any) -> None:
    one, other = made(1), made(a=1, b=[3])
    assert is_dataclass(made)
    assert [x.name for x in fields(one)] == ["a", "b", "c"]
    assert one == other != made(1, c="y")
    assert hash(one) == hash(other)
    assert len({one, other, made(2)}) == 2
    assert repr(other) == f"{made.__qualname__}(a=1, b=[3])"
    assert one.twice == 2
    assert replace(one, a=5).twice == 10
    assert pickle.loads(pickle.dumps(other)) == copy.deepcopy(other) == other
    assert pickle.loads(pickle.dumps(other)).b == [3]
    assert one != (1, [], "x")
    for change in ("a", "c", "new"):
        with pytest.raises(FrozenInstanceError, match="cannot assign to field"):
            setattr(one, change, 7)
    with pytest.raises(FrozenInstanceError):
        del one.a
    with pytest.raises(TypeError):
        made()
    assert one.a == 1


def test_own_functions_are_kept() -> None:
    @frozen
    class Told:
        a: int

        def __repr__(self) -> str:
            return "told"

        def __post_init__(self) -> None:
            object.__setattr__(self, "a", self.a + 1)

    assert repr(Told(1)) == "told"
    assert Told(1).a == 2
    assert Told(1) == Told(1) != Told(2)


def test_a_class_may_have_its_own_init() -> None:
    @frozen
    class Own:
        a: int
        b: int = 4

        def __init__(self, text: str) -> None:
            object.__setattr__(self, "a", int(text))

    assert Own("3") == Own(" 3 ") != Own("4")
    assert (Own("3").b, hash(Own("3"))) == (4, hash(Own("3")))
    with pytest.raises(FrozenInstanceError):
        Own("3").a = 5  # type: ignore[misc]
