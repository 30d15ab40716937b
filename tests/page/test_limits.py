"""How far a case may go: the steps of the velocity, the distance that is meant, a box that is proved stable."""

from __future__ import annotations

from fractions import Fraction
from types import SimpleNamespace

import pytest

from mpsolve import Problem, certify, read_problem, tracks, vehicles
from mpsolve.page import limits
from mpsolve.page.limits import distance_margin, distance_path, mass_margin, reach_of, stable_box
from mpsolve.ranges.onset import Kind

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=100)
BOGIE = read_problem("examples/two_layer_bogie.toml").problem


def test_further_steps_find_where_a_bogie_on_layers_becomes_unstable() -> None:
    """From almost 0 through twice its own velocity to the waves, by two steps; certified beside the end."""
    found = reach_of(BOGIE, 60.0)
    assert found.kind is Kind.CROSSES, found.reason
    assert (found.high, found.reason) == (1600, None)
    assert 0 < found.low < 1
    value = found.value.mid()
    for v, count in ((float(value) - 1, 0), (float(value) + 1, 2)):
        assert certify(BOGIE.changed("v", v), region="unstable", digits=15).unstable == count


def test_a_step_that_fails_leaves_what_was_known(monkeypatch: pytest.MonkeyPatch) -> None:
    steps = [limits.Reach(Kind.STABLE, Fraction(0), Fraction(5))]

    def step(*_: object) -> limits.Reach:
        if not steps:
            raise limits.MpsolveError("no")
        return steps.pop()

    monkeypatch.setattr(limits, "_step", step)
    monkeypatch.setattr(limits, "velocity_ranges", lambda _: SimpleNamespace(steps=((0, 5), (5, 9))))
    found = reach_of(PAIR, 1.0)
    assert (found.kind, found.high, str(found.reason)) == (Kind.STABLE, 5, "no")


def test_a_gap_at_a_wave_speed_ends_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "_step", lambda *_: limits.Reach(Kind.STABLE, Fraction(0), Fraction(5)))
    monkeypatch.setattr(limits, "velocity_ranges", lambda _: SimpleNamespace(steps=((0, 5), (6, 9))))
    found = reach_of(PAIR, 1.0)
    assert found.reason is not None
    assert (found.high, found.reason.code) == (5, "wave-speed")


def test_it_crosses_where_certify_sees_a_change() -> None:
    found = reach_of(PAIR, 20.0)
    assert found.kind is Kind.CROSSES
    at = float(found.value.mid())
    seen = [certify(PAIR.changed("v", f"{at + d:.6f}"), region="unstable", check=False).stable for d in (-0.01, 0.01)]
    assert seen == [True, False]


@pytest.mark.parametrize(
    ("problem", "path"),
    [
        (PAIR, "gap[0]"),
        (Problem(TRACK, vehicles.train(vehicles.Mass(1), 3, 2), v=1), "scale.gap"),
        (BOGIE, "vehicles[0].wheelbase"),
        (Problem(TRACK, vehicles.Mass(1), v=1), None),
    ],
)
def test_the_distance_that_is_meant(problem: Problem, path: str | None) -> None:
    assert distance_path(problem) == path


def test_vehicles_are_not_pushed_into_each_other() -> None:
    coaches = read_problem("examples/train_8_coaches.toml").problem
    factor = limits._nearest(coaches, "scale.gap")
    moved = coaches.changed("scale.gap", factor)
    assert len(set(moved.pencil.places)) == len(moved.pencil.places)
    assert Fraction(1, 2) < factor < 1
    assert limits._nearest(PAIR, "gap[0]") == Fraction(1, 2)
    assert distance_margin(PAIR, "gap[0]", 10).over == (Fraction("1.7"), Fraction("6.8"))


def test_the_box_is_stable_at_its_corners_and_keeps_off_the_limits() -> None:
    box = stable_box(PAIR, reach_of(PAIR, 20), mass_margin(PAIR, 20), 20)
    assert box is not None
    assert box["v"] == (50, 150)
    for v in box["v"]:
        for factor in box["scale.mass"]:
            corner = PAIR.changed("v", v).changed("scale.mass", factor)
            assert certify(corner, region="unstable", digits=15, check=False).stable
    near = PAIR.changed("v", 185)
    narrow = stable_box(near, reach_of(near, 20), None, 20)
    assert narrow is not None
    assert 185 < narrow["v"][1] < 192
    assert stable_box(PAIR.changed("v", 0), None, None, 5) is None
