"""The plain sentence says what the spectrum holds; the scope names one rail and the sleepers."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from mpsolve import Problem, certify, read_problem, tracks, vehicles
from mpsolve.page.budget import Part
from mpsolve.page.parts import Parts
from mpsolve.page.plain import plain, scope

NONE: Part[Any] = Part("x", reason="it is not asked for")
BOGIE = read_problem("examples/two_layer_bogie.toml").problem
PAIR = Problem(
    tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770), vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=250
)


def parts(problem: Problem, region: Any) -> Parts:
    found = certify(problem, region=region, digits=15, check=False)
    return Parts(problem, problem, "", problem.v, found, NONE, NONE, NONE, NONE, NONE, NONE)


def test_vibrations_below_the_cuts() -> None:
    made = parts(BOGIE, ("below", 50))
    right = [root for root in made.spectrum.roots if not root.q.real < 0]
    assert plain(made).startswith(f"{len(right)} vibrations decay more slowly than 50 1/s")
    assert plain(made).endswith("none grows.")


@pytest.mark.parametrize(("v", "said"), [(100, "No vibration grows."), (250, "Of all vibrations")])
def test_the_half_plane(v: int, said: str) -> None:
    assert plain(parts(PAIR.changed("v", v), "unstable")).startswith(said)


def test_what_no_contact_feels_is_no_vibration_of_the_sentence() -> None:
    """A second body on a spring of its own, to the ground, swings for ever: it is listed apart."""
    alone = vehicles.Vehicle(M=[[9, 0], [0, 1]], C=[[0, 0], [0, 0]], K=[[0, 0], [0, 5]], B=[[1], [0]], places=[0])
    problem = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1"), alone, v="0.5")
    told = (
        ("0.001", "No vibration that a contact feels decays more slowly"),
        ("0.04", "1 vibration that a contact feels decays"),
    )
    for height, said in told:
        assert plain(parts(problem, ("below", height))).startswith(said)


def test_one_rail_and_smeared_sleepers() -> None:
    made = parts(BOGIE, "unstable")
    one, sleepers = scope(made)
    assert "one rail" in one
    assert "0.6 m apart" in sleepers
    assert len(scope(replace(made, problem=PAIR))) == 1
