"""Dimensions have names that are read back as what they were."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from mpsolve.numbers.unit_names import unit_of
from mpsolve.numbers.units import factor

POWERS = st.integers(-8, 8)


@given(st.tuples(POWERS, POWERS, POWERS))
def test_names_are_read_back(dimension: tuple[int, int, int]) -> None:
    assert factor(unit_of(dimension)) == (1, dimension)


def test_names_that_engineers_use() -> None:
    assert [unit_of(d) for d in ((1, 1, -2), (1, -1, -2), (0, 1, -1), (0, 0, -1), (0, 0, 0))] == [
        "N",
        "N/m²",
        "m/s",
        "1/s",
        "",
    ]
