"""Growing motions are proved where they are, and none where there is none."""

from __future__ import annotations

import numpy as np
import pytest
from endless_rows import brute_sum, masses

from mpsolve import Problem, tracks, vehicles
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.growing import find_growing, prove_growing
from mpsolve.endless.infinite_train import reach_of
from mpsolve.endless.row import row_of
from mpsolve.numbers.balls import acb, arb


def test_a_growing_motion_is_a_root_by_brute_force() -> None:
    row = masses("0.4")
    found = find_growing(row, 1.0)
    assert found is not None
    assert found.q.imag < 0
    assert float(found.q.rad()) < 1e-6
    q = complex(found.q)
    z = np.exp(1j * found.theta)
    G = complex(row.reduced.guide.g) * brute_sum(row, row.step * 0, z, 1j * q, 600)
    assert abs(1 - 40 * q**2 * G) < 1e-5  # the spring of the track against a mass of 40


def test_below_the_threshold_none_is_found() -> None:
    assert find_growing(masses("0.18"), 1.0) is None


def test_a_root_that_decays_is_not_said_to_grow() -> None:
    """The same root at a κ where it decays: proved as a root, refused as growing."""
    row = masses("0.4")
    bloch, theta = Bloch(row), np.array([0.3])
    sigma = np.array([-0.001 + 0.3j])
    for _ in range(60):
        value, slope = bloch.delta(sigma, np.exp(1j * theta))
        sigma = sigma - value / slope
    assert sigma[0].real < 0
    assert prove_growing(row, 0.3, complex(sigma[0])) is None


def test_the_ball_holds_the_root_of_another_start() -> None:
    row = masses("0.5")
    found = find_growing(row, 1.0)
    assert found is not None
    again = prove_growing(row, found.theta, 1j * complex(found.q) * (1 + 1e-4))
    assert again is not None
    assert again.q.overlaps(found.q)
    assert not again.q.overlaps(found.q + acb(arb(0), arb(1e-4)))


@pytest.mark.parametrize("spacing", ["0.8", "1.1"])
def test_newton_may_end_at_a_matrix_that_is_singular_in_floats(spacing: str) -> None:
    row = row_of(
        Problem(tracks.Rayleigh(EI=1, m=1, J="0.107", k=1, c="1.3"), vehicles.Mass("3.06"), v="1.53"), spacing
    )
    found = find_growing(row, reach_of(row))
    assert found is not None
    q = complex(found.q)
    sigma = 1j * q * 2.0**row.reduced.guide.time
    G = complex(row.reduced.guide.g) * brute_sum(row, row.step * 0, np.exp(1j * found.theta), sigma, 60)
    assert abs(1 - 3.06 * q**2 * G) < 1e-9
