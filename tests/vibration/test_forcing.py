"""Tones are loads and irregularities: their transforms against integrals, their motion against the sines."""

from __future__ import annotations

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Irregularity, Load, Problem
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.forcing import tones, transform
from mpsolve.vibration.image import Image

IMAGE = Image(Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=10), ())


def test_the_transform_is_the_integral_of_the_force() -> None:
    loads = [Load(3, 2, 4096, "0.7"), Load(0, 1, -8192, "0.2")]
    acting = tones(IMAGE, outer_forces(IMAGE.pencil, loads), ())
    assert [tone.frequency * IMAGE.rate for tone in acting] == [0, 4096, 8192]
    sigma, rows = 0.8 + 0.3j, IMAGE.size + IMAGE.contacts
    nodes, weights = np.polynomial.legendre.leggauss(400)
    t = 30 * (nodes + 1)
    forces = [3 + 2 * np.sin(4096 * t / IMAGE.rate + 0.7), np.sin(-8192 * t / IMAGE.rate + 0.2)]
    unit = [IMAGE.column(np.eye(IMAGE.size)[j], np.zeros(2)) for j in (0, 1)]
    known = sum(
        30 * (weights * f * np.exp(-sigma * t)).sum() * column for f, column in zip(forces, unit, strict=True)
    )
    assert transform(acting, np.array([sigma]), rows)[0] == pytest.approx(known, rel=1e-10)


def test_an_irregularity_begins_where_it_is() -> None:
    rough = (Irregularity(2.0, 4096.0, 0.5), Irregularity(0.0, 1.0))
    acting = tones(IMAGE, outer_forces(IMAGE.pencil, [Load(0), Load(0)]), rough)
    unit = IMAGE.column(np.zeros(IMAGE.size), np.array([1.0, 0.0]))
    for t in (0.0, 0.3, 2.0):
        value = sum((tone.column * np.exp(1j * tone.frequency * t)).real for tone in acting)
        assert value == pytest.approx(2 * (np.sin(t + 0.5) - np.sin(0.5)) * unit, abs=1e-12 * np.abs(unit).max())


def test_nothing_acts_where_all_is_0() -> None:
    assert tones(IMAGE, outer_forces(IMAGE.pencil, [Load(0), Load(0)]), ()) == ()
    assert not transform((), np.ones(3), 7).any()
