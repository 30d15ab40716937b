"""The loss at q → 0: its velocity to many digits, its neighbourhood, and none where there is none."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import tracks
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, precision
from mpsolve.passivity.corner import corner, unscaled, velocity_of_loss
from mpsolve.passivity.cover import Moving
from mpsolve.problem.reduced import track_guide
from mpsolve.proof.effort import Effort

BEAM = Moving(track_guide(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=1), Fraction(0)), 2)


def test_its_velocity() -> None:
    value = velocity_of_loss(BEAM, 1.19, 700)
    assert value.rel_accuracy_bits() >= 690
    with precision(800):
        low, high = (BEAM.germ(acb(0), value.mid() + s * value.rad() * 8, 1).value[1].real for s in (-1, 1))
        assert low < 0 < high


def test_its_neighbourhood() -> None:
    found = corner(BEAM, velocity_of_loss(BEAM, 1.19, 100), Effort())
    assert found is not None
    assert found.below < 1.1899 < found.value
    for q in (0.3, 0.6, 1.0):
        for share in (0.0, 0.5, 0.999):
            v = found.below + share * (float(found.value) - found.below)
            with precision(80):
                assert -BEAM.germ(acb(0, q * found.reach), v, 0).value[0].imag > 0


def test_there_is_none_elsewhere() -> None:
    with pytest.raises(PrecisionError):
        velocity_of_loss(BEAM, 0.3, 100)


def test_units() -> None:
    moving = Moving(track_guide(tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="770"), Fraction(0)), 2)
    value = velocity_of_loss(moving, 296.2 / float(unscaled(moving)), 100)
    assert float(value) * float(unscaled(moving)) == pytest.approx(296.2027396)
