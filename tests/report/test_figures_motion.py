"""Displacements, envelopes and contact forces are drawn as they are, in the units that are asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
from figure_parts import placed

from mpsolve import PhysicalCase
from mpsolve.report import figures_motion
from mpsolve.report.figures import figure_of
from mpsolve.vibration.of_case import motion_of_case as response


def test_the_envelope_bounds_the_harmonic_part_and_is_reached(motion: Any) -> None:
    bound = motion.envelope
    assert np.all(abs(motion.harmonic) <= bound * (1 + 1e-12))
    for row, edge in zip(motion.harmonic, bound, strict=True):
        assert np.max(abs(row) / edge) > 0.99
    ax: Any = figure_of(lambda ax: figures_motion.displacements(motion, ax)).axes[0]
    (line,) = [one for one in ax.lines if one.get_gid() == "w-2"]
    assert np.array_equal(line.get_ydata(), motion.w[1])
    assert ax.yaxis_inverted()


def test_displacements_in_millimetres_are_those_of_a_load_at_rest() -> None:
    """A constant force P at rest on a Winkler beam sinks by Pχ/(2k), with χ⁴ = k/(4EI)."""
    from mpsolve.vehicles.load import Load

    beam = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=0, c=7750, masses=[(100, 0)])
    found = response(beam, [Load(constant=50_000)], tau=[0, 400])
    ax: Any = figure_of(lambda ax: figures_motion.displacements(found, ax, figures_motion.Scale.of(beam))).axes[0]
    (line,) = [one for one in ax.lines if one.get_gid() == "w-1"]
    chi = (1e6 / (4 * 6.4e6)) ** 0.25
    assert abs(line.get_ydata()[-1] - 1e3 * 50_000 * chi / 2e6) < 1e-6
    assert abs(line.get_xdata()[-1] - 400 / np.sqrt(1e6 / 60)) < 1e-9


def test_contact_forces_and_where_they_vanish(motion: Any) -> None:
    ax: Any = figure_of(lambda ax: figures_motion.contact_forces(motion, ax)).axes[0]
    for k, loss in enumerate(motion.contact_loss, 1):
        (line,) = [one for one in ax.lines if one.get_gid() == f"force-{k}"]
        below = 1 + np.flatnonzero(line.get_ydata()[1:] <= 0)  # at τ = 0 the mass alone takes the load
        assert (loss is None) == (len(below) == 0)
        if loss is not None:
            x, y = placed(ax, f"loss-{k}")
            assert motion.tau[below[0] - 1] <= x <= motion.tau[below[0]]
            assert y == 0
