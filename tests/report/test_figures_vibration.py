"""Pictures and films of a motion in SI: curves as computed, pale after the lift-off, frames as the rail stands."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mpsolve import InputError, Problem, response, tracks, vehicles
from mpsolve.report.figures import figure_of
from mpsolve.report.figures_vibration import draw_curves, save_comparison, save_film, save_motion

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PROBLEM = Problem(TRACK, [vehicles.Mass(10_000).at(0), vehicles.Mass(10_000).at("3.4")], v=250)
FOUND = response(PROBLEM, times=np.linspace(0, 1, 41), places=[0, "1.7", "3.4"])
SVG = "{http://www.w3.org/2000/svg}"


def test_curves_are_pale_after_the_lift_off() -> None:
    assert FOUND.lift_off is not None
    row = FOUND.rail[0]
    ax: Any = figure_of(lambda ax: draw_curves(FOUND, {"rail": row}, ax, "w", ["#000000"])).axes[0]
    first, second, mark = ax.lines
    assert np.array_equal(first.get_ydata(), row[FOUND.within])
    assert (first.get_alpha(), second.get_alpha()) == (None, 0.25)
    assert mark.get_xdata()[0] == FOUND.lift_off.time
    later = np.where(FOUND.within, row, 100 * row)
    wild: Any = figure_of(lambda ax: draw_curves(FOUND, {"rail": later}, ax, "w", ["#000000"])).axes[0]
    assert wild.get_ylim() == ax.get_ylim()  # what is beyond the model stretches no axis


def test_a_film_moves_the_rail_as_it_was_computed(tmp_path: Path) -> None:
    root = ET.parse(save_film(FOUND, tmp_path / "a.svg", "A & B")).getroot()
    shapes = next(one for one in root.iter(f"{SVG}animate") if one.attrib["attributeName"] == "d")
    frames = shapes.attrib["values"].split(";")
    assert len(frames) == len(FOUND.times)
    heights = [float(frame.split("L")[1].split(",")[1]) for frame in frames][: int(FOUND.within.sum())]
    assert np.corrcoef(heights, FOUND.rail[1, : len(heights)])[0, 1] > 0.9999
    assert "A & B" in [text.text for text in root.iter(f"{SVG}text")]


def test_files_have_a_panel_for_each_place_and_one_of_forces(tmp_path: Path) -> None:
    text = save_motion(FOUND, tmp_path / "a.svg").read_text("utf-8")
    assert text.count('<g id="axes_') == 4
    one = save_comparison(FOUND, {"a": FOUND.rail[0], "b": FOUND.steady[0]}, tmp_path / "b.svg").read_text("utf-8")
    assert one.count('<g id="axes_') == 1


def test_what_cannot_be_drawn_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"does not end in \.svg"):
        save_film(FOUND, tmp_path / "a.png")
    alone = response(PROBLEM, times=[0, "0.1"], places=[0])
    with pytest.raises(InputError, match="two places"):
        save_film(alone, tmp_path / "a.svg")
    many = response(PROBLEM, times=[0, "0.1"], places=np.linspace(0, 3, 30).round(3).tolist())
    with pytest.raises(InputError, match="has 30 places"):
        save_motion(many, tmp_path / "a.svg")
