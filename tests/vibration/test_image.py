"""The image against mpmath's, and against the public receptance."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from image_truth import Image as Truth
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem, receptance
from mpsolve.vibration.image import Image


@pytest.mark.parametrize("track", ["string", "two-layer", "timoshenko", "floating-ice"])
@pytest.mark.parametrize("vehicle", ["mass", "bogie"])
def test_the_channels_are_those_of_mpmath(track: str, vehicle: str) -> None:
    problem = Problem(DAMPED[track], TYPICAL[vehicle], v=20)
    places = (Fraction(-2), Fraction(3, 2))
    image = Image(problem, places)
    force = np.arange(1.0, image.size + 1)
    truth = Truth(problem, [(force, 1.0, 0.0, 0.0, 0.0)], list(places))
    sigma = np.array([1e-3 + 0.5j, 0.3 + 0.05j, 2.0 - 0j]) * image.rate
    found = image.solve(
        sigma / image.rate,
        np.broadcast_to(image.column(force, np.zeros(image.contacts)), (3, image.size + image.contacts)),
    )
    for s, row in zip(sigma, found, strict=True):
        known = np.array([complex(x * s) for x in truth.at(complex(s))])
        assert np.abs(row - known).max() <= 1e-10 * np.abs(known).max()
        assert row == pytest.approx(known, rel=1e-8)


def test_the_rail_is_the_receptance_times_the_forces() -> None:
    problem = Problem(DAMPED["three-layer"], TYPICAL["bogie"], v=30)
    places = [0.0, -3.0, 40.0]
    image = Image(problem, tuple(map(Fraction, places)))
    omega = 80.0
    row = image.solve(np.array([1j * omega / image.rate]), image.column(np.ones(5), np.zeros(2))[None])[0]
    at = [float(x) for x in problem.pencil.places]
    for place, w in zip(places, row[7:], strict=True):
        G = receptance(problem.track, [place - x for x in at], omega, 30)[:, 0]
        assert w == pytest.approx(G @ row[5:7], rel=1e-10)
