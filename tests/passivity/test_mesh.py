"""Cells run in order through the place where the power turns, and are fine at each wave."""

from __future__ import annotations

import numpy as np
import pytest
from passive_subjects import TRACKS, reduced_and_envelope

from mpsolve.characteristic.floats import Receptance
from mpsolve.passivity.mesh import cells, wavenumbers


@pytest.mark.parametrize("name", TRACKS)
def test_cells(name: str) -> None:
    reduced, envelope = reduced_and_envelope(name, 1)
    v, q = float(reduced.guide.v), np.array([0.3, 1.0, 7.0])
    ends = cells(envelope.subject, q, np.zeros((3, 0)), np.zeros(3), 12)
    assert (np.diff(ends, axis=1) >= 0).all()
    roots = wavenumbers(envelope.subject, q, np.full(3, v), np.zeros((3, 0)))
    for row in range(3):
        assert q[row] / v > ends[row, -1] or np.abs(ends[row] - q[row] / v).min() == 0
        for root in roots[row]:
            if abs(root.real) < ends[row, -1] and abs(root.imag) > 1e-4:
                assert np.abs(ends[row] - root.real).min() < 1e-9 * max(abs(root), 1)


@pytest.mark.parametrize("name", TRACKS)
def test_wavenumbers(name: str) -> None:
    reduced, envelope = reduced_and_envelope(name, 1)
    q = np.array([0.3, 2.0])
    mine = wavenumbers(envelope.subject, q, np.full(2, float(reduced.guide.v)), np.zeros((2, 0)))
    theirs = Receptance(reduced.guide).roots(1j * q) / 1j
    for a, b in zip(mine, theirs, strict=True):
        assert np.sort(np.abs(a)) == pytest.approx(np.sort(np.abs(b)), rel=1e-8)


def test_wavenumbers_far_out_are_those_of_the_rail_alone() -> None:
    """EI p⁴ = m q²: at q = 10⁸ no coefficient may be lost beside q²."""
    reduced, envelope = reduced_and_envelope("rail", 1)
    guide, q = reduced.guide, 1e8
    found = wavenumbers(envelope.subject, np.array([q]), np.array([float(guide.v)]), np.zeros((1, 0)))
    assert np.abs(found) == pytest.approx((q * q * float(guide.D_rest[0, 2] / guide.D_rest[4, 0])) ** 0.25, rel=1e-3)
