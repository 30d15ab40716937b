"""The roots to the right of a line: found in floats, or certified; nearly double ones are told by their number."""

from __future__ import annotations

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem, certify, vehicles
from mpsolve.vibration.image import Image
from mpsolve.vibration.poles import certified, searched


@pytest.mark.parametrize(("track", "vehicle", "v"), [("two-layer", "bogie", 100), ("slab", "oscillator", 60)])
def test_the_roots_are_the_certified_ones(track: str, vehicle: str, v: int) -> None:
    problem = Problem(DAMPED[track], TYPICAL[vehicle], v=v)
    found, known = searched(problem), certified(Image(problem, ()), certify(problem, check=False))
    assert found.complete
    assert known.complete
    mine, theirs = (
        np.sort_complex([p.sigma for p in poles.poles if p.sigma.real > found.floor * 0.99])
        for poles in (found, known)
    )
    assert mine == pytest.approx(theirs, rel=1e-9)
    assert found.cut == known.cut < known.floor < 0


def test_roots_that_grow_are_found_where_cuts_touch_the_axis() -> None:
    """A Rayleigh beam damped by its foundation: the cuts come down to the axis far out."""
    problem = Problem(DAMPED["rayleigh"], vehicles.Mass(5000), v=420)
    found = searched(problem)
    (root,) = [
        1j * complex(x.q.mid()) for x in certify(problem, region="unstable", check=False).roots if x.q.real > 0
    ]
    assert found.cut == 0 < found.growth
    assert found.poles[0].sigma * Image(problem, ()).rate == pytest.approx(root, rel=1e-9)


def test_two_bogies_far_apart_have_nearly_double_roots() -> None:
    found = searched(Problem(DAMPED["two-layer"], TYPICAL["coach"], v=20))
    assert found.complete
    assert sorted(pole.multiplicity for pole in found.poles) == [1, 1, 1, 1, 2, 2, 2]
