"""A crossing in a ball: as sharp as asked, alone, and in the direction in which the certified count changes."""

from __future__ import annotations

import pytest
from ranges_of_a_pair import PAIR, over_velocity

from mpsolve import certify
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import arb, precision
from mpsolve.ranges.enclosed import Crossing, enclose

SEED, SIZE = (0.2, 0.35), (1e-4, 1e-4)


@pytest.fixture(scope="module")
def seed() -> tuple[float, float]:
    """Near the crossing: by halving with certified counts, and the real part of the root there."""
    scope = over_velocity()
    low, high = 150.0, 230.0
    for _ in range(20):
        v = (low + high) / 2
        unstable = certify(PAIR.changed("v", v), region="unstable", digits=15, check=False).unstable
        low, high = (low, v) if unstable else (v, high)
    roots = certify(PAIR.changed("v", high), region="unstable", check=False).roots
    q = abs(float(roots[0].q.real)) / float(scope.family.frequency_unit)
    return q, high / float(scope.family.units[0])


def found(seed: tuple[float, float], digits: int) -> Crossing:
    return enclose(over_velocity().proved, seed, SIZE, digits)


def test_more_digits_lie_inside_fewer(seed: tuple[float, float]) -> None:
    short, long = found(seed, 15), found(seed, 60)
    with precision(300):
        assert long.x.rad() < abs(long.x) * arb(10) ** -60
        assert short.x.contains(long.x)
        assert short.q.contains(long.q)
    assert abs(float(long.x) - seed[1]) < 1e-4


def test_the_direction_is_that_of_the_counts(seed: tuple[float, float]) -> None:
    one = found(seed, 15)
    v = float(one.x) * float(over_velocity().family.units[0])
    counts = [certify(PAIR.changed("v", v + d), region="unstable", check=False).unstable for d in (-1e-3, 1e-3)]
    assert counts == [0, one.gained]


def test_where_no_root_crosses_none_is_enclosed(seed: tuple[float, float]) -> None:
    q, x = seed
    with pytest.raises(PrecisionError):
        enclose(over_velocity().proved, (2 * q, x), SIZE, 15)
