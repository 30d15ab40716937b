"""The drawing is made from the equations: wheels where contacts are, layers where fields are."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest
from hypothesis import assume, given

from mpsolve import Problem, read_problem, tracks, vehicles
from mpsolve.pictures.model import boxes_of, layers_of, model_picture
from tests.oracle_general.package import as_problem, known
from tests.oracle_general.problems import problems


def test_a_bogie_is_two_wheels_and_a_frame() -> None:
    pencil = read_problem("examples/two_layer_bogie.toml").problem.pencil
    boxes = boxes_of(pencil)
    assert sorted(box.level for box in boxes) == [0, 0, 1]
    (frame,) = [box for box in boxes if box.level == 1]
    assert [pencil.names[i] for i in frame.coordinates] == ["frame bounce", "frame pitch"]
    assert (frame.left, frame.right) == (-1.28, 1.28)


def test_a_coach_has_three_levels() -> None:
    pencil = read_problem("examples/train_8_coaches.toml").problem.vehicles[0].vehicle.pencil
    boxes = boxes_of(pencil)
    assert [sum(box.level == k for box in boxes) for k in range(3)] == [4, 2, 1]
    assert sum(len(box.coordinates) for box in boxes) == pencil.size


def test_layers_are_the_fields_of_the_track() -> None:
    track = read_problem("examples/two_layer_bogie.toml").problem.track
    rail, sleepers = layers_of(track.waveguide.matrix)
    assert rail.bends
    assert rail.tied == ((1, True, True),)
    assert not sleepers.bends
    assert sleepers.heavy
    assert sleepers.tied == ((-1, True, True),)


def test_an_undamped_foundation_has_no_dampers() -> None:
    (wire,) = layers_of(tracks.String(T=1, m=1, k=1).waveguide.matrix)
    assert wire.tied == ((-1, True, False),)


@given(problems())
def test_every_problem_can_be_drawn(plain: dict[str, object]) -> None:
    assume(known(plain))
    problem = as_problem(plain)
    tree = ET.fromstring(model_picture(problem))
    drawn = [e for e in tree.iter("circle") if e.get("class") == "body"]
    assert len(drawn) <= problem.pencil.contacts
    assert "nan" not in ET.tostring(tree, encoding="unicode")


def test_lengths_are_to_scale() -> None:
    track = tracks.String(T=1, m=1, k=1, c=1)
    row = [vehicles.Mass(1).at(0), vehicles.Mass(1).at(1), vehicles.Mass(1).at(4)]
    tree = ET.fromstring(model_picture(Problem(track, row, v=1)))
    a, b, c = sorted(float(e.attrib["cx"]) for e in tree.iter("circle"))
    assert (c - b) / (b - a) == pytest.approx(3, rel=0.01)
