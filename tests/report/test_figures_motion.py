"""Pictures of a motion: curves as computed, in the units that are asked for, pale after the lift-off."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mpsolve import Case, InputError, Load, PhysicalCase, Problem, response, tracks, vehicles
from mpsolve.report.figures import figure_of
from mpsolve.report.figures_motion import draw_curves, draw_forces, draw_place, save_comparison, save_motion, scene
from mpsolve.vibration.case_motion import Scale

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PROBLEM = Problem(TRACK, [vehicles.Mass(10_000).at(0), vehicles.Mass(10_000).at("3.4")], v=250)
FOUND = response(PROBLEM, times=np.linspace(0, 1, 41), places=[0, "1.7", "3.4"])


def test_curves_are_pale_after_the_lift_off() -> None:
    shown, event, row = scene(FOUND), FOUND.lift_off, FOUND.rail[0]
    assert event is not None
    ax: Any = figure_of(lambda ax: draw_curves(shown, {"rail": row}, ax, "w")).axes[0]
    first, second, mark = ax.lines
    assert np.array_equal(first.get_ydata(), row[FOUND.within])
    assert (first.get_alpha(), second.get_alpha()) == (None, 0.25)
    assert mark.get_xdata()[0] == event.time
    later = np.where(FOUND.within, row, 100 * row)
    wild: Any = figure_of(lambda ax: draw_curves(shown, {"rail": later}, ax, "w")).axes[0]
    assert wild.get_ylim() == ax.get_ylim()  # what is beyond the model stretches no axis
    assert "beyond the model" in ax.get_title()


def test_deflections_point_down_and_forces_press() -> None:
    shown = scene(FOUND)
    below: Any = figure_of(lambda ax: draw_place(shown, 1, ax)).axes[0]
    assert below.yaxis_inverted()
    assert np.array_equal(below.lines[0].get_ydata(), 1e3 * FOUND.rail[1, FOUND.within])
    forces: Any = figure_of(lambda ax: draw_forces(shown, ax)).axes[0]
    assert np.array_equal(forces.lines[2].get_ydata(), 1e-3 * FOUND.contact_force[1, FOUND.within])


def test_a_case_in_millimetres_is_that_of_a_load_at_rest() -> None:
    """A constant force P at rest on a Winkler beam sinks by Pχ/(2k), with χ⁴ = k/(4EI)."""
    beam = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=0, c=7750, masses=[(100, 0)])
    shown = scene(response(beam, [Load(constant=50_000)], tau=[0, 400]), Scale.of(beam))
    chi = (1e6 / (4 * 6.4e6)) ** 0.25
    assert abs(shown.parts["complete"][0, -1] - 1e3 * 50_000 * chi / 2e6) < 1e-6
    assert abs(shown.forces[0, -1] - 50) < 1e-6
    assert abs(shown.times[-1] - 400 / np.sqrt(1e6 / 60)) < 1e-9
    assert (shown.time_label, shown.length_label, shown.force_label) == ("$t$ [s]", "$w$ [mm]", "contact force [kN]")


def test_a_case_in_its_own_units_tells_when_contact_is_lost() -> None:
    """The mass leaves the rail early."""
    found = response(Case(alpha="1.2", eta_b="0.05", eta_m="40"), tau=np.linspace(0, 60, 61))
    lost = found.lift_off
    assert lost is not None
    assert scene(found).lost == (lost.time, f"contact 1 lifts off at τ = {lost.time:.4g}")
    assert scene(replace(found, contact_loss=(None,), motion=None)).lost is None


def test_files_have_a_panel_for_each_place_and_one_of_forces(tmp_path: Path) -> None:
    text = save_motion(FOUND, tmp_path / "a.svg").read_text("utf-8")
    assert text.count('<g id="axes_') == 4
    one = save_comparison(FOUND, {"a": FOUND.rail[0], "b": FOUND.steady[0]}, tmp_path / "b.svg").read_text("utf-8")
    assert one.count('<g id="axes_') == 1
    many = response(PROBLEM, times=[0, "0.1"], places=np.linspace(0, 3, 30).round(3).tolist())
    with pytest.raises(InputError, match="has 30 places"):
        save_motion(many, tmp_path / "a.svg")
