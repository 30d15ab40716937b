"""The result: its parts, its frequencies, what it says of itself."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem, certify, response
from mpsolve.outcome import Reason
from mpsolve.vibration.image import Image
from mpsolve.vibration.motion import unknown_precise

PROBLEM = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=100)
FOUND = response(PROBLEM, times=np.linspace(0, 0.3, 31), places=[0, 2])


def test_the_harmonic_part_is_the_sum_of_its_frequencies() -> None:
    total = sum((part.rail[:, None] * np.exp(1j * part.q * FOUND.times)).real for part in FOUND.induced)
    assert FOUND.harmonic == pytest.approx(total, abs=1e-9 * np.abs(FOUND.rail).max())
    known = [complex(root.q.mid()) for root in certify(PROBLEM, check=False).roots if root.q.real >= 0]
    assert np.sort_complex([part.q for part in FOUND.induced]) == pytest.approx(np.sort_complex(known), rel=1e-9)
    assert set(FOUND.induced[0].vehicle) == set(FOUND.vehicle)
    assert FOUND.induced[0].contact_force.shape == (2,)


def test_it_prints_a_row_for_each_time() -> None:
    headline, names, *rows = str(FOUND).splitlines()
    assert headline.startswith("Vibration at 31 times: largest deflection of the rail 0.000")
    assert names.split("  ")[0] == "t"
    assert len(rows) == 31
    assert next(iter(FOUND.records())).keys() == {"t", "rail at 0", "rail at 2", "contact force 1", "contact force 2"}
    assert list(FOUND.records())[7]["contact force 2"] == FOUND.contact_force[1, 7]


def test_shapes_and_errors() -> None:
    assert FOUND.rail.shape == FOUND.steady.shape == FOUND.harmonic.shape == FOUND.transient.shape == (2, 31)
    assert not FOUND.steady_harmonic.any()
    assert set(FOUND.error.vehicle) == set(FOUND.vehicle)
    assert FOUND.within.all()


PROBLEM_precise_motion = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=20)
IMAGE = Image(PROBLEM_precise_motion, (Fraction(1),))


def test_every_number_is_nan_and_every_error_infinite() -> None:
    why = Reason("effort", "it is spent")
    found = unknown_precise(IMAGE, mpmath.MPContext(), [Fraction(1), Fraction(2)], why)
    assert (found.reason, found.error) == (why, (mpmath.inf, mpmath.inf))
    assert (found.rail.shape, found.contact_force.shape) == ((1, 2), (IMAGE.contacts, 2))
    assert list(found.vehicle) == list(IMAGE.pencil.names)
    tables = (found.rail, found.steady, found.harmonic, found.transient, found.contact_force, *found.vehicle.values())
    assert all(mpmath.isnan(x) for table in tables for x in table.ravel())
