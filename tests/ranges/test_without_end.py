"""Ranges of masses without an upper end: heavier and heavier wheels have the counts that are said."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case, Problem, certify, crossings, onset, unstable_ranges
from mpsolve.errors import InputError
from mpsolve.problem.cases import as_problem
from mpsolve.ranges.onset import Kind
from mpsolve.tracks import EulerBernoulli
from mpsolve.vehicles import Mass, Oscillator

PAIR = Case(alpha="0.9", eta_b="0.05", eta_m=(1, 1), positions=(0, "1.5"))


def one(alpha: str, eta_b: str) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(1,), positions=(0,))


def unstable(problem: Any, mass: int) -> int | None:
    heavy = as_problem(problem).changed("scale.mass", mass)
    return certify(heavy, region="unstable", digits=15, check=False).unstable


def test_all_masses_of_a_pair() -> None:
    found = crossings(PAIR, over={"scale.mass": (0, None)}, check=False)
    assert (found.proved, found.counts) == (True, (0, 2)), found.reason
    assert float(found.crossings[0].value) == pytest.approx(52.8719407968311, rel=1e-14)
    assert found.over == {"scale.mass": (Fraction(0), None)}
    assert [unstable(PAIR, mass) for mass in (52, 53, 10**4)] == [0, 2, 2]
    assert "without end" in found.note
    assert json.loads(found.to_json())["over"]["scale.mass"][1] is None


def test_the_certificate_is_of_the_part_with_an_end() -> None:
    found = crossings(PAIR, over={"eta_m": (1, None)})
    assert (found.proved, found.counts) == (True, (0, 2)), found.reason
    assert found.certificate.content["range"][0][0] == "1"
    assert "up to there" in found.note


def test_the_answers_read_from_crossings() -> None:
    (part,) = unstable_ranges(PAIR, over={"scale.mass": (1, None)}, check=False).intervals
    assert (part.end, part.upper, part.roots) == (None, math.inf, 2)
    found = onset(PAIR, over={"scale.mass": (60, None)}, check=False)
    assert found.kind is Kind.UNSTABLE_FROM_START


@pytest.mark.parametrize(
    ("alpha", "eta_b", "counts"), [("1.02", "0.05", (0,)), ("1.0202", "0.05", (0, 2)), ("1.1899", "0.5", (0,))]
)
def test_next_to_the_passivity_velocity(alpha: str, eta_b: str, counts: tuple[int, ...]) -> None:
    """1.02012857710541 and 1.1899209702954: above it heavy masses grow, and their crossing runs to q = 0."""
    found = crossings(one(alpha, eta_b), over={"scale.mass": (1, None)}, check=False)
    assert (found.proved, found.counts) == (True, counts), found.reason
    assert unstable(one(alpha, eta_b), 10**6) == counts[-1]


def test_sprung_wheels() -> None:
    track = EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
    problem = Problem(track, (Oscillator(wheel=1, k=1, c="0.2", body=4, k_contact=9).at(0), Mass(2).at(3)), v="1.2")
    found = crossings(problem, over={"scale.mass": (0, None)}, check=False)
    assert found.counts is not None, found.reason
    last = float(found.crossings[-1].value)
    for mass in (math.ceil(last * 1.01), 10**4):
        assert unstable(problem, mass) == found.counts[-1]


@pytest.mark.parametrize("path", ["v", "track.k", "track.c", "gap[0]", "vehicles[0].M"])
def test_other_paths_say_which_may(path: str) -> None:
    with pytest.raises(InputError, match=r"only a factor of all masses, such as scale\.mass"):
        crossings(PAIR, over={path: (1, None)})
