"""The worst distance against limiting masses at given distances, which are proved in another way."""

from __future__ import annotations

from functools import cache

import pytest
from flint import arb
from hypothesis import given, settings
from oracle import grid

from mpsolve import InputError, limiting_mass
from mpsolve.fields import ball_arithmetic
from mpsolve.stability.limiting import LimitingMass

RANGES = {"inside": ("1.05", "1.2"), "at the end": ("0.8", "0.9"), "at the start": ("1.4", "1.5")}
ranges = pytest.mark.parametrize("place", RANGES)


@cache
def worst(place: str) -> LimitingMass:
    return limiting_mass("0.99", "0.5", d=RANGES[place], digits=25)


def at(d: str) -> LimitingMass:
    return limiting_mass("0.99", "0.5", (0, d), digits=25)


@ranges
def test_no_distance_is_worse(place: str) -> None:
    low, high = map(float, RANGES[place])
    found = worst(place)
    assert found.proved
    for k in range(5):
        assert at(f"{low + (high - low) * k / 4:.4f}").eta >= found.eta.lower()


@ranges
def test_at_the_worst_distance_the_limiting_mass_is_that_of_the_answer(place: str) -> None:
    found = worst(place)
    d = found.d.mid().str(30, radius=False)
    with ball_arithmetic(200):
        assert abs(at(d).eta - found.eta) < arb(10) ** -22  # it is stationary there, or d is exact
        assert abs(at(d).q - found.q) < arb(10) ** -20
        assert found.eta.rad() < arb(10) ** -23
        assert found.d.rad() < arb(10) ** -23


def test_inside_it_is_a_minimum_and_at_an_end_it_is_not() -> None:
    with ball_arithmetic(128):
        assert worst("inside").d > arb("1.06")
        assert worst("inside").d < arb("1.19")
        assert worst("at the end").d.overlaps(arb("0.9"))
        assert worst("at the start").d.overlaps(arb("1.4"))


@pytest.mark.parametrize(
    ("low", "high"),
    # beside the worst distance 1.22530013 of all: t rises from the start, however narrow or wide the range
    [("1.24", "1.2402"), ("1.2283", "1.2284"), ("1.235", "1.2351"), ("1.2353", "1.2853"), ("1.2453", "1.2953")],
)
def test_beside_the_minimum_the_start_of_the_range_is_worst(low: str, high: str) -> None:
    found = limiting_mass("0.99", "0.1", d=(low, high), digits=15)
    assert found.proved
    with ball_arithmetic(100):
        assert found.d.overlaps(arb(low))
        start, end = (limiting_mass("0.99", "0.1", (0, d), digits=15) for d in (low, high))
        assert found.eta.overlaps(start.eta)
        assert found.eta < end.eta


@pytest.mark.parametrize("high", ["1.2253", "1.2254", "1.226"])
def test_next_to_an_end_it_is_undecided(high: str) -> None:
    found = limiting_mass("0.99", "0.1", d=("1.2", high), digits=15)
    assert (found.proved, found.eta) == (False, None)
    assert "end of the range" in found.reason


@settings(max_examples=3)
@given(low=grid(0.9, 1.6), width=grid(0.001, 0.3))
def test_no_answer_lies_above_a_mass_of_the_range(low: float, width: float) -> None:
    found = limiting_mass("0.99", "0.1", d=(low, low + width), digits=15)
    if found.proved:
        with ball_arithmetic(100):
            assert low <= found.d.upper()
            assert found.d.lower() <= low + width
            for d in (low, low + width / 2, low + width):
                assert not limiting_mass("0.99", "0.1", (0, d), digits=15).eta < found.eta


def test_more_digits_lie_within_fewer() -> None:
    few, many = worst("inside"), limiting_mass("0.99", "0.5", d=RANGES["inside"], digits=60)
    with ball_arithmetic(300):
        assert few.eta.overlaps(many.eta)
        assert few.d.overlaps(many.d)
        assert many.d.rad() < arb(10) ** -58


def test_undamped_and_subcritical_no_mass_is_unstable() -> None:
    found = limiting_mass("0.9", 0, d=(1, 2))
    assert (found.proved, found.eta, found.d) == (True, None, None)
    assert limiting_mass("1.1", 0, d=(1, 2)).reason.startswith("without damping")


def test_what_was_not_seen_is_undecided() -> None:
    found = limiting_mass("0.2", "0.5", d=("1", "1.1"))
    assert not found.proved
    assert "no proof" in found.reason


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        ({}, "positions"),
        ({"positions": (0, 1), "d": (1, 2)}, "positions"),
        ({"d": (0, 1)}, "d"),
        ({"d": (2, 1)}, "d"),
        ({"d": (1, 2), "proportions": (1,)}, "proportions"),
        ({"d": (1, 2), "digits": 3}, "digits"),
    ],
)
def test_bad_input(arguments: dict[str, object], key: str) -> None:
    with pytest.raises(InputError) as caught:
        limiting_mass("0.99", "0.5", **arguments)  # type: ignore[arg-type]
    assert caught.value.key == key
