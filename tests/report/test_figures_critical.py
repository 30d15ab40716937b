"""The chart of critical velocities: its lines touch the branches where they say, and the peak is near."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mpsolve import InputError, critical_velocities, tracks
from mpsolve.report.figures import figure_of
from mpsolve.report.figures_critical import draw_deflection, draw_dispersion, save_critical

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=500)
FOUND = critical_velocities(TRACK, over={"v": (0, 1000)})
CRITICAL = (4 * 6.4e6 * 1e6 / 60**2) ** 0.25
"""The least velocity of a force that runs with its wave, on a beam on springs."""


def test_the_line_of_the_force_touches_the_branch() -> None:
    ax: Any = figure_of(lambda ax: draw_dispersion(TRACK, FOUND, ax)).axes[0]
    assert len(FOUND) == 1
    (line,) = [one for one in ax.lines if one.get_linestyle() == "--"]
    p, omega = line.get_data()
    assert -np.polyfit(p, omega, 1)[0] == pytest.approx(CRITICAL, rel=1e-9)
    branch = np.sqrt((6.4e6 * p**4 + 1e6) / 60)
    apart = np.abs(branch - np.abs(omega))
    assert apart.min() < 1e-3 * branch.min()  # it touches, from below
    assert (branch - np.abs(omega)).min() > -1e-6 * branch.max()


def test_the_deflection_is_greatest_near_the_critical_velocity() -> None:
    ax: Any = figure_of(lambda ax: draw_deflection(TRACK, FOUND, ax)).axes[0]
    v, size = max((one.get_data() for one in ax.lines), key=lambda data: len(data[0]))
    assert v[int(np.argmax(size))] == pytest.approx(CRITICAL, rel=0.05)


def test_both_panels_are_written_and_other_names_refused(tmp_path: Path) -> None:
    assert save_critical(TRACK, FOUND, tmp_path / "a.svg", "A track").read_text("utf-8").count('id="axes_') == 2
    with pytest.raises(InputError, match=r"does not end in \.png"):
        save_critical(TRACK, FOUND, tmp_path / "a.gif")
