"""Between the steps of a march a motion is read as cubics, and falls of forces are found."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.finite.answer import Answer, hermite


def test_the_first_fall_of_a_force() -> None:
    """Samples that are hardly above 0 do not hide it, and a contact that nothing has pressed yet does not fall."""
    nothing = np.zeros((2, 5))
    forces = np.array([[-1, 0, 3e-8, -1, 0], [0, 1, 1e-8, -1e-8, 0]])
    answer = Answer(nothing, nothing, nothing, np.arange(5.0), forces)
    assert answer.first_fall() == (2.5, 2)
    assert Answer(nothing, nothing, nothing, np.arange(5.0), np.abs(forces) + 1).first_fall() is None


def test_cubics_are_kept_as_they_are():
    nodes, times = np.array([0.0, 0.5, 2.0]), np.linspace(0, 2, 9)
    cubic, slope = (lambda t: t**3 - 2 * t + 1), (lambda t: 3 * t**2 - 2)
    assert hermite(nodes, cubic(nodes)[None], slope(nodes)[None], times)[0] == pytest.approx(cubic(times), abs=1e-14)
