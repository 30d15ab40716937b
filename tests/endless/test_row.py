"""A row is one vehicle and a distance; finite trains of it are ordinary problems."""

from __future__ import annotations

from fractions import Fraction

import pytest
from endless_rows import BEAM, BOGIE, LAYERS, bogies, masses

from mpsolve import Case, InputError, Problem, vehicles
from mpsolve.endless.row import row_in, row_of


def test_a_train_of_the_row_has_its_vehicles_at_its_distances() -> None:
    train = masses("0.3").train(3)
    assert [str(one.position) for one in train.vehicles] == ["0", "3/2", "3"]
    assert train.v == Fraction(3, 10)
    assert train.track == BEAM


def test_the_smallest_gap_is_within_a_vehicle_or_to_the_next() -> None:
    unit = Fraction(2) ** bogies("0.3").reduced.guide.length
    assert bogies("0.3").gap * unit == Fraction(3, 2)
    assert row_of(Problem(LAYERS, BOGIE, v=1), 2).gap * unit == Fraction(1, 2)
    assert masses("0.3").gap == masses("0.3").step


@pytest.mark.parametrize(("vehicle", "spacing"), [(BOGIE, "1.5"), (BOGIE, 1), (vehicles.Mass(1), 0)])
def test_vehicles_that_overlap_are_refused(vehicle: object, spacing: object) -> None:
    with pytest.raises(InputError, match=r"spacing: is .* give the distance to the next vehicle"):
        row_of(Problem(LAYERS, vehicle, v=1), spacing)


def test_a_row_is_seen_in_a_train_of_equal_vehicles() -> None:
    row = masses("0.3")
    assert row_in(row.train(5)) == (row, 5)
    assert row_in(row.problem, "1.5") == (row, 1)
    assert row_in(row.train(2), "1.5")[1] == 2


@pytest.mark.parametrize(
    ("placed", "spacing", "said"),
    [
        ([vehicles.Mass(1)], None, "single vehicle"),
        ([vehicles.Mass(1).at(0), vehicles.Mass(2).at(1)], None, "not all equal"),
        ([vehicles.Mass(1).at(0), vehicles.Mass(1).at(1), vehicles.Mass(1).at(3)], None, "equal distances"),
        ([vehicles.Mass(1).at(0), vehicles.Mass(1).at(1)], 2, "leave it out"),
    ],
)
def test_other_trains_are_no_rows(placed: list[object], spacing: object, said: str) -> None:
    with pytest.raises(InputError, match=said):
        row_in(Problem(BEAM, placed, v="0.3"), spacing)


def test_a_spacing_in_si_may_have_a_unit() -> None:
    one = Problem(LAYERS, BOGIE, v=50)
    assert row_of(one, "2500 cm").spacing == row_in(one, "25 m")[0].spacing == 25
    with pytest.raises(InputError, match="spacing: is '25 kg', whose unit is kg"):
        row_of(one, "25 kg")
    with pytest.raises(InputError, match="spacing: '3 m' is not a number"):
        row_of(Case(alpha="0.1", eta_b="0.05", eta_m=[40], positions=[0]), "3 m")
