"""The first crossing as floats see it, against the onsets of certified answers."""

from __future__ import annotations

import signal
from fractions import Fraction
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
import pytest
from free_cases import BEAM, BOGIE, PAIR, RAIL
from ranges_of_a_pair import lowest, over_velocity

from mpsolve import Case, Effort, Problem, Status, certify, frequencies, onset, read_problem
from mpsolve.presets.written import input_file
from mpsolve.problem.cases import as_problem
from mpsolve.problem.family import family_of
from mpsolve.problem.reduced import reduce_problem
from mpsolve.ranges.onset import Kind
from mpsolve.ranges.seen import BEYOND, Shorter, corners_and_more, count_seen, first_seen, least_seen, up_to_first
from mpsolve.spectrum.candidates import Area


@pytest.mark.parametrize(
    ("masses", "places", "q", "v"),
    [((70, 70), (0, "1.5"), 0.15620777798806, 0.66691895728455),
     ((50,), (0,), 0.16433862942823, 1.09029890169583),
     ((3, 3), (0, 2), 0.87360051044724, 1.39803362800436)],
)  # fmt: skip
def test_the_least_value(masses: Any, places: Any, q: float, v: float) -> None:
    problem = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=masses, positions=places))
    family = family_of(problem, {"v": (Fraction(0), Fraction(2))})
    seen = first_seen(family)
    assert seen is not None
    assert seen[0] * float(family.frequency_unit) == pytest.approx(q, rel=1e-4)
    assert seen[1] * float(family.units[0]) == pytest.approx(v, rel=1e-4)


def test_nothing_where_nothing_crosses() -> None:
    problem = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=70))
    assert first_seen(family_of(problem, {"v": (Fraction(0), Fraction("0.9"))})) is None


CASE = Case(alpha="0.5", eta_b="0.0001", eta_m=(70, 70), positions=(0, "1.5"))
PROBLEM = as_problem(CASE)


def test_up_to_a_little_beyond_the_first() -> None:
    found = up_to_first(PROBLEM, {"v": (Fraction(0), Fraction(2))})
    assert found is not None
    low, high = found.over["v"]
    assert low == 0
    assert 0.6703394654 < high < 0.6703394654 * (1 + 1 / 32)
    assert found.near[1] == pytest.approx(0.670339465413233, rel=1e-6)


@pytest.mark.parametrize("high", [None, Fraction("0.6")])
def test_where_there_is_nothing_to_try(high: Any) -> None:
    assert up_to_first(PROBLEM, {"v": (Fraction(0), high)}) is None


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no such timer here")
def test_all_of_the_effort_is_for_it_and_its_verifier(monkeypatch: pytest.MonkeyPatch) -> None:
    def slow(*_: object) -> None:
        while True:
            pass

    monkeypatch.setattr("mpsolve.certificate.verify_ranges.verify_bytes", slow)
    started = process_time()
    answer = onset(CASE, over={"alpha": (0, 1)}, effort=Effort(seconds=1.5))
    assert (answer.proved, answer.status, answer.kind) == (True, Status.UNVERIFIED, Kind.CROSSES)
    assert "the effort of 1.5 s of processor time was spent before the verifier was through" in answer.note
    assert 1.2 < process_time() - started < 3


def test_an_onset_of_hardly_any_damping() -> None:
    """Faster than its waves the beam is open after any number of boxes, which the onset does not ask."""
    answer = onset(CASE, over={"alpha": (0, 2)}, check=False)
    assert (answer.proved, answer.kind) == (True, Kind.CROSSES), answer.reason
    assert float(answer.value) == pytest.approx(0.670339465413233, rel=1e-14)
    assert BEYOND in answer.note
    assert answer.over["alpha"][1] == 2


@pytest.mark.parametrize(
    ("end", "near"),
    [("0.5", (0.1562, 0.45)), ("0.9", (0.3, 0.8)), ("0.9", (0.1562077, 0.66691895))],
    ids=["nothing crosses up to there", "a crossing that there is not", "right"],
)
def test_what_floats_see_decides_nothing(end: str, near: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    false = Shorter({"v": (Fraction("0.01"), Fraction(end))}, near)
    monkeypatch.setattr("mpsolve.ranges.onset.up_to_first", lambda *_: false)
    answer = onset(case, over={"v": ("0.01", "0.95")}, check=False)
    assert answer.kind is Kind.CROSSES
    assert float(answer.value) == pytest.approx(0.66691895728454, rel=1e-12)


def test_bogies_far_apart_have_crossings_close_together(tmp_path: Path) -> None:
    """The first two of a coach differ by 7e-5, in a range ten thousand times as wide; floats count beside them."""
    (tmp_path / "coach.toml").write_text(input_file("ballasted"), "utf-8")
    problem = read_problem(tmp_path / "coach.toml").problem
    found = onset(problem, over={"v": (140, 1600)}, check=False)
    assert found.kind is Kind.CROSSES, found.reason
    assert found.lower == pytest.approx(683.653465209185, rel=1e-14)
    assert frequencies(problem, over={"v": np.array([600, 683.65, 683.66, 683.71])}).count.tolist() == [0, 0, 2, 4]


@pytest.mark.parametrize("v", ["0.5", "0.75", "0.9", "1.1"])
def test_of_the_pair(v: str) -> None:
    problem = Problem(BEAM, PAIR, v=v)
    assert count_seen(reduce_problem(problem), 20.0) == certify(problem, region="unstable", check=False).unstable


@pytest.mark.parametrize("v", [100, 350])
def test_of_a_bogie(v: int) -> None:
    problem = Problem(RAIL, BOGIE, v=v)
    assert count_seen(reduce_problem(problem), 20.0) == certify(problem, region="unstable", check=False).unstable


def test_points_lie_in_their_box() -> None:
    points = corners_and_more((np.array([0.0, 1.0]), np.array([1.0, 3.0])))
    assert len(points) == 16
    assert all(0 <= x <= 1 <= y <= 3 for x, y in points)


def test_it_is_the_lowest_certified_root_of_the_points_looked_at() -> None:
    scope = over_velocity()
    unit, frequency = float(scope.family.units[0]), float(scope.family.frequency_unit)
    seen = least_seen(scope.family, float(scope.low[0]), float(scope.high[0]), Area(0.0, 2.0, -1.0, 0.02))
    assert seen is not None
    v = seen.x * unit
    assert abs(seen.q * frequency - lowest(Fraction(v))) < 1e-6
    for beside in (v - seen.step * unit, v + seen.step * unit):
        if 150 <= beside <= 230:
            assert lowest(Fraction(beside)).imag > seen.q.imag * frequency
