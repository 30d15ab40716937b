"""Designs: every case by its index alone, in exact numbers."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve.studies.design import FINE, STREAMS, Span, Steps, draws, radical_inverse
from mpsolve.studies.spec import read_spec

PAIR = {"alpha": "0.5", "eta_b": "0.05", "eta_m": [40, 40], "positions": [0, 1]}


def spec_of(parameters: dict[str, Any], **study: Any) -> Any:
    return read_spec({"study": {"kind": "float64", **study}, "dimensionless": PAIR, "parameters": parameters})


def test_a_grid_is_the_product_of_its_axes() -> None:
    axes = {"v": ["0.1", "0.2", "0.3"], "track.c": ["0.05"], "vehicles.M": [50, 70], "gap[0]": ["3/4", 1, "3/2"]}
    spec = spec_of(axes | {"track.N": {"start": 0, "stop": "0.5", "step": "0.2"}})
    listed = [[Fraction(x) for x in axis] for axis in axes.values()]
    expected = list(product(*listed, [Fraction(0), Fraction(1, 5), Fraction(2, 5)]))
    assert spec.total == len(expected) == 54
    assert [tuple(spec.values(k).values()) for k in range(spec.total)] == expected


def test_a_list_takes_values_together() -> None:
    spec = spec_of({"v": ["0.1", "0.2"], "track.c": "0.05", "vehicles.M": [50, 50]}, design={"kind": "list"})
    assert [spec.values(k)["v"] for k in range(spec.total)] == [Fraction(1, 10), Fraction(1, 5)]
    assert [spec.values(k)["vehicles.M"] for k in range(spec.total)] == [50, 50]


@pytest.mark.parametrize("kind", ["random", "quasi-random"])
def test_a_design_of_any_size_makes_only_the_entry_that_is_asked_for(kind: str) -> None:
    ranges = {"v": {"low": "0.1", "high": "1.2"}, "vehicles.M": {"low": 1, "high": 100}}
    spec = spec_of(ranges, design={"kind": kind, "count": 10**12, "seed": 3})
    last, grid = (
        spec.values(10**12 - 1),
        spec_of(
            {"v": {"start": 0, "stop": 1, "step": "1e-6"}, "vehicles.M": {"start": 1, "stop": 100_000, "step": "0.1"}}
        ),
    )
    assert last == spec.values(10**12 - 1) != spec.values(10**12 - 2)
    assert grid.values(grid.total - 1)["v"] == 1
    assert grid.indices(grid.blocks - 1)[-1] == grid.total - 1 > 10**11


@given(st.sampled_from(["random", "quasi-random"]), st.integers(0, 2**63 - 1), st.integers(0, 10**12))
@settings(max_examples=50)
def test_drawn_values_are_short_decimals_in_their_range(kind: str, seed: int, index: int) -> None:
    span = Span(Fraction("-0.25"), Fraction("1.5"))
    for k in draws(kind, seed, index, STREAMS):
        value = span.at(k)
        assert span.low <= value < span.high
        assert value == span.low + (span.high - span.low) * Fraction(k, FINE)
        assert Fraction(repr(float(value))) == value  # float64 and exact work see the same number


def test_random_draws_are_uniform_and_independent_of_their_neighbours() -> None:
    """Mean, variance and correlations of 20,000 draws of a uniform variable, within five standard deviations."""
    number = 20_000
    drawn = [[k / FINE - 0.5 for k in draws("random", 1, index, STREAMS)] for index in range(number)]
    columns = list(zip(*drawn, strict=True))
    for column in columns:
        assert abs(sum(column) / number) < 5 * (1 / 12 / number) ** 0.5
        assert abs(sum(x * x for x in column) / number - 1 / 12) < 5 * (1 / 180 / number) ** 0.5
        assert abs(sum(x * y for x, y in pairwise(column)) / number) < 5 / 12 / number**0.5
    for one, other in pairwise(columns):
        assert abs(sum(x * y for x, y in zip(one, other, strict=True)) / number) < 5 / 12 / number**0.5


def test_the_seed_makes_another_design() -> None:
    for kind in ("random", "quasi-random"):
        assert draws(kind, 1, 5, 3) != draws(kind, 2, 5, 3)


@pytest.mark.parametrize(("stream", "base", "power"), [(0, 2, 10), (1, 3, 6), (2, 5, 4), (3, 7, 3), (6, 17, 2)])
def test_quasi_random_points_are_equally_spaced(stream: int, base: int, power: int) -> None:
    """base^power points of Halton's sequence leave gaps of base^−power on the circle, whatever their shift."""
    number = base**power
    places = sorted(draws("quasi-random", 9, index, STREAMS)[stream] for index in range(number))
    gaps = [after - before for before, after in pairwise([*places, places[0] + FINE])]
    assert all(abs(gap - Fraction(FINE, number)) <= 1 for gap in gaps)  # rounded down to 1/FINE


@given(st.integers(0, 10**12), st.sampled_from([2, 3, 5, 17]))
@settings(max_examples=50)
def test_radical_inverse(index: int, base: int) -> None:
    exact, power, rest = Fraction(0), base, index
    while rest:
        rest, digit = divmod(rest, base)
        exact, power = exact + Fraction(digit, power), power * base
    assert radical_inverse(index, base) == exact * FINE // 1


def test_steps_meet_their_end() -> None:
    axis = Steps(Fraction(1), Fraction(-1, 4), 5)
    assert [axis.at(k) for k in range(axis.count)] == [1, Fraction(3, 4), Fraction(1, 2), Fraction(1, 4), 0]
    assert axis.canonical == {"start": "1", "stop": "0", "step": "-1/4"}
