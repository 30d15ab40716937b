"""Many digits: against the float version, itself with more digits, and inversion by mpmath."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from image_truth import Image as Truth

from mpsolve import InputError, Load, Problem, response, response_mp, tracks, vehicles

BEAM = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.2"), vehicles.Mass(3), v="0.5")
STRING = tracks.String(T=9, m=1, k=4, c=1)
LOADS = [Load("0.5", 1, 2, "0.3")]
TIMES = [2, 9]


def test_the_digits_are_those_of_a_more_precise_run_and_of_float64() -> None:
    few = response_mp(BEAM, LOADS, times=TIMES, places=[0, "0.5", -3], digits=15)
    more = response_mp(BEAM, LOADS, times=TIMES, places=[0, "0.5", -3], digits=18)
    size = np.abs(more.rail).max()
    assert np.abs(few.rail - more.rail).max() < 1e-14 * size
    assert max(few.error) < 1e-12
    assert few.reason is None
    assert more.error[0] < 1e-15
    floats = response(BEAM, LOADS, times=[float(t) for t in TIMES], places=[0, "0.5", -3])
    assert np.abs(floats.rail - more.rail.astype(float)).max() < floats.error.rail + 1e-12 * float(size)
    assert np.abs(floats.harmonic - more.harmonic.astype(float)).max() < 1e-9 * float(size)
    for name, row in floats.vehicle.items():
        assert np.abs(row - more.vehicle[name].astype(float)).max() < 1e-8 * float(size)


def test_inversion_by_mpmath() -> None:
    problem = Problem(STRING, vehicles.Mass(2), v=1)
    found = response_mp(problem, [Load(3)], times=["0.7"], digits=18)
    truth = Truth(problem, [([1.0], 3.0, 0.0, 0.0, 0.0)], [Fraction(0)])
    known = truth.inverted(0.7, degree=40)
    assert float(found.rail[0, 0]) == pytest.approx(known[-1], rel=1e-9)


def test_digits_that_are_not_reached_next_to_a_front_are_told() -> None:
    """Behind a front on a string, which is smoothed away; float64 follows its line until it is not."""
    wire = Problem(tracks.String(T="1.6", m="1.4", k=2, c="0.1"), vehicles.Mass("0.001"), v="0.6")
    near = response_mp(wire, [Load(1)], times=["0.82"], places=["-1.3"], digits=15)
    floats = response(wire, [Load(1)], times=[0.82], places=["-1.3"]).rail[0, 0]
    assert abs(float(near.rail[0, 0]) - floats) > 1e-4 * abs(floats)
    assert near.error[0] > 1e-4
    assert near.reason is not None
    assert near.reason.code == "digits"


@pytest.mark.parametrize(
    ("key", "options"),
    [("digits", {"digits": 14}), ("digits", {"digits": 1000}), ("times", {"times": [0]}), ("times", {"times": []})],
)
def test_what_cannot_be_is_refused(key: str, options: dict[str, Any]) -> None:
    with pytest.raises(InputError) as error:
        response_mp(BEAM, LOADS, **({"times": [1], "digits": 20} | options))
    assert error.value.key.startswith(key)
