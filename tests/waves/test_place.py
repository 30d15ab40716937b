"""Velocities at which a polynomial vanishes: exact at the ends of a range, irrational ones told apart."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq_poly

from mpsolve.errors import ContradictionError
from mpsolve.numbers.exact import Exact
from mpsolve.waves.place import places_of, still


def test_the_ends_belong_to_the_range_and_multiplicities_are_told() -> None:
    """(v² − 4)² (v² − 2) (v² + 1) = 0 over w = v²."""
    w = fmpq_poly([0, 1])
    f = (w - 4) ** 2 * (w - 2) * (w + 1)
    found = list(places_of(f, True, Fraction(0), Fraction(2), 100))
    assert sorted((place.exact, power) for place, power in found) == [(Exact.sqrt(2), 1), (Exact(2), 2)]
    for low, high in ((0, Fraction(2) - Fraction(1, 10**30)), (Fraction(2) + Fraction(1, 10**30), 3)):
        assert all(power == 1 for _, power in places_of(f, True, Fraction(low), Fraction(high), 60))
    assert not list(places_of(fmpq_poly([3]), True, Fraction(0), Fraction(9), 60))


def test_in_v_itself_the_right_root_is_taken() -> None:
    """v (v⁴ − 10 v² + 1): v² = 5 ± 2√6, v = √3 ± √2; x is v, and polynomials in v vanish there exactly."""
    f = fmpq_poly([0, 1, 0, -10, 0, 1])
    small, large = sorted((place for place, _ in places_of(f, False, Fraction(0), Fraction(9), 80)),
                          key=lambda place: float(place.x.ball(80)))  # fmt: skip
    for place, value in ((small, 3**0.5 - 2**0.5), (large, 3**0.5 + 2**0.5)):
        assert float(place.x.ball(80)) == pytest.approx(value, rel=1e-14)
        assert place.velocity(80).overlaps(place.x.ball(80))
        assert place.annuls(f)
        assert not place.annuls(fmpq_poly([-3, 1]))
        assert place.exact is None
    with pytest.raises(ContradictionError):
        list(places_of(fmpq_poly([1, 1, 1]), False, Fraction(0), Fraction(9), 80))


def test_at_rest() -> None:
    assert still().annuls(fmpq_poly([0, 5]))
    assert not still().annuls(fmpq_poly([1]))
    assert still().velocity(60) == 0
