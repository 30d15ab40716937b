"""Tubes: the root is where they say at every value, and two roots are never taken for one."""

from fractions import Fraction

import numpy as np
import pytest
from free_cases import BEAM, PAIR, pair_over_velocity

from mpsolve import Problem, certify
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.loci.tube import tubes

PROBLEM = Problem(BEAM, PAIR, v="0.9")
FAMILY = pair_over_velocity("0.5", "0.9")
MATRIX = FreeMatrix(FAMILY)


def _roots(v: float) -> list[complex]:
    spectrum = certify(PROBLEM.changed("v", Fraction(v)), region=("below", "0.046"), check=False)
    unit = float(FAMILY.frequency_unit)
    return [complex(root.q) / unit for root in spectrum.roots if root.q.real > 0]


@pytest.mark.parametrize("length", [2.0**-6, 2.0**-9])
def test_the_root_is_in_its_tube_at_every_value(length: float) -> None:
    unit = float(FAMILY.units[0])
    low = 0.625
    start = np.array(_roots(low * unit))
    found = tubes(MATRIX, np.full(2, low), np.full(2, low + length), start, np.full(2, 0.008))
    assert found.good.all()
    assert (found.inner < 0.5 * found.outer).all()
    for share in (0.0, 0.3, 1.0):
        x = low + share * length
        for k, root in enumerate(_roots(x * unit)):
            assert abs(root - found.centre(x)[k]) <= found.inner[k]
        assert np.allclose(found.guess(x), _roots(x * unit), atol=1e-5)
    ends = np.array(_roots((low + length) * unit))
    assert np.allclose(found.near[1], ends, atol=1e-4)
    assert np.allclose(found.speed[0], (ends - start) / length, rtol=0.3)


def test_no_tube_holds_two_roots_or_none() -> None:
    low = 0.625
    first, second = _roots(low * float(FAMILY.units[0]))
    middles = np.array([(first + second) / 2, first + 0.02])
    sizes = np.array([abs(first - second), 0.005])
    assert not tubes(MATRIX, np.full(2, low), np.full(2, low + 2.0**-9), middles, sizes).good.any()


def test_a_disc_is_held_only_inside() -> None:
    root = np.array(_roots(0.625 * float(FAMILY.units[0])))[:1]
    tube = tubes(MATRIX, np.array([0.625]), np.array([0.626]), root, np.array([0.004]))
    x = np.array([0.6255])
    assert tube.good.all()
    assert tube.holds(tube.centre(x), 0.9 * tube.outer, x).all()
    assert not tube.holds(tube.centre(x), 1.1 * tube.outer, x).any()
    assert not tube.holds(tube.centre(x) + 1.01 * tube.outer, 0.0, x).any()
    assert not tube.mirrored.any()
