"""A motion of many digits of which nothing is known has its shapes, and no number."""

from __future__ import annotations

from fractions import Fraction

import mpmath
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem
from mpsolve.outcome import Reason
from mpsolve.vibration.image import Image
from mpsolve.vibration.precise_motion import unknown_precise

PROBLEM = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=20)
IMAGE = Image(PROBLEM, (Fraction(1),))


def test_every_number_is_nan_and_every_error_infinite() -> None:
    why = Reason("effort", "it is spent")
    found = unknown_precise(IMAGE, mpmath.MPContext(), [Fraction(1), Fraction(2)], why)
    assert (found.reason, found.error) == (why, (mpmath.inf, mpmath.inf))
    assert (found.rail.shape, found.contact_force.shape) == ((1, 2), (IMAGE.contacts, 2))
    assert list(found.vehicle) == list(IMAGE.pencil.names)
    tables = (found.rail, found.steady, found.harmonic, found.transient, found.contact_force, *found.vehicle.values())
    assert all(mpmath.isnan(x) for table in tables for x in table.ravel())
