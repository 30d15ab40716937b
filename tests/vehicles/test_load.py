"""A force: exact parts within what float64 can square."""

from __future__ import annotations

import pytest

from mpsolve import Exact, InputError
from mpsolve.vehicles.load import GRAVITY, Load


def test_a_load_holds_its_parts_exactly() -> None:
    load = Load("0.1", "1/3", 2, "0.25")
    assert (load.constant, load.amplitude) == (Exact("1/10"), Exact("1/3"))
    assert (load.frequency, load.phase) == (Exact(2), Exact("1/4"))
    assert Load() == Load(1, 0, 0, 0)
    assert Exact("9.80665") == GRAVITY


@pytest.mark.parametrize("value", ["1e-150", "1e150", "-1e150", 0])
def test_sizes_that_float64_can_square(value: object) -> None:
    assert Load(value).constant == Exact(value)  # type: ignore[arg-type]


@pytest.mark.parametrize("key", ["constant", "amplitude", "frequency", "phase"])
@pytest.mark.parametrize("value", ["1e151", "-1e-151", "x"])
def test_others_are_refused_under_their_name(key: str, value: str) -> None:
    with pytest.raises(InputError) as caught:
        Load(**{key: value})  # type: ignore[arg-type]
    assert caught.value.key == key
