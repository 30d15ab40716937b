"""Limits of effort, and what comes back when they are spent."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Effort, InputError, Load, Problem, response, response_mp, tracks, vehicles
from mpsolve.errors import EffortError
from mpsolve.vibration import vibrate as verb
from mpsolve.vibration.image import Image
from mpsolve.vibration.poles import _searched

BOGIE = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=100)
ONE = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.2"), vehicles.Mass(3), v="0.5")
TIMES = np.linspace(0.001, 0.05, 40)


@pytest.fixture(autouse=True)
def forgotten() -> None:
    _searched.cache_clear()


def counted(monkeypatch: pytest.MonkeyPatch, ask: Any) -> int:
    """At how many σ the equations are set up."""
    seen = [0]

    def counting(_: Image, evaluations: int) -> None:
        seen[0] += evaluations

    with monkeypatch.context() as patch:
        patch.setattr(Image, "spend", counting)
        ask()
    return seen[0]


def test_enough_effort_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    free = response(BOGIE, times=TIMES)
    _searched.cache_clear()
    needed = counted(monkeypatch, lambda: response(BOGIE, times=TIMES))
    _searched.cache_clear()
    found = response(BOGIE, times=TIMES, effort=Effort(evaluations=needed))
    assert (found.reason, free.reason) == (None, None)
    assert np.array_equal(found.rail, free.rail)
    _searched.cache_clear()
    assert response(BOGIE, times=TIMES, effort=Effort(evaluations=needed - 1)).reason.code == "effort"


@pytest.mark.parametrize("effort", [Effort(evaluations=50), Effort(seconds=1e-9)])
def test_nothing_is_known_where_effort_ends_early(effort: Effort) -> None:
    found = response(BOGIE, times=TIMES, places=[0, 1], effort=effort)
    assert found.reason.code == "effort"
    assert found.rail.shape == (2, len(TIMES))
    parts = (found.rail, found.steady, found.harmonic, found.transient, found.contact_force, *found.vehicle.values())
    assert all(np.isnan(part).all() for part in parts)
    assert found.error.rail == found.error.contact_force == min(found.error.vehicle.values()) == np.inf
    with pytest.raises(EffortError, match="effort of"):
        _ = found.lift_off


def test_what_is_there_comes_back_with_its_own_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """The line is stopped before it reaches as far as is worked for: the error is larger, and holds."""
    problem, late = Problem(DAMPED["euler-bernoulli"], TYPICAL["coach"], v=20), np.array([0.05])
    truth = response(problem, times=late)
    needed = counted(monkeypatch, lambda: response(problem, times=late))  # without the search for roots
    errors = []
    for part in (0.4, 0.6, 0.9):
        found = response(problem, times=late, effort=Effort(evaluations=int(part * needed)))
        assert found.reason.code == "effort"
        errors.append(found.error.contact_force)
        off = np.abs(found.contact_force - truth.contact_force).max()
        assert off <= found.error.contact_force + truth.error.contact_force
        assert found.lift_off is None
    assert errors[0] > errors[-1] > truth.error.contact_force
    assert errors[0] < 0.01 * np.abs(truth.contact_force).max()


def test_times_that_are_not_reached_are_nan(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = response(BOGIE, times=TIMES)
    monkeypatch.setattr(verb, "_CHUNK", 10)
    heard: list[tuple[str, float]] = []

    work = Effort(evaluations=10**8)
    monkeypatch.setattr(verb, "begun", lambda _: work)

    def stopping(stage: str, part: float) -> None:
        heard.append((stage, part))
        if (stage, part) == ("times", 0.5):
            work.spent = 10**9

    found = response(BOGIE, times=TIMES, progress=stopping)
    assert heard == [("frequencies", 0.0), ("integral", 0.0), ("times", 0.25), ("times", 0.5)]
    assert found.reason.code == "effort"
    assert found.rail[:, :20] == pytest.approx(whole.rail[:, :20], rel=1e-12)
    assert np.isnan(found.rail[:, 20:]).all()
    assert np.isnan(found.contact_force[:, 20:]).all()


def test_many_digits() -> None:
    heard: list[str] = []
    options: dict[str, Any] = {"times": [2], "digits": 15, "progress": lambda stage, _: heard.append(stage)}
    found = response_mp(ONE, [Load(1)], effort=Effort(evaluations=1200), **options)
    assert found.reason.code == "effort"
    assert found.rail.shape == (1, 1)
    assert all(mpmath.isnan(x) for x in (found.rail[0, 0], found.transient[0, 0], found.vehicle["wheel"][0]))
    assert found.error == (np.inf, np.inf)
    assert list(dict.fromkeys(heard)) == ["frequencies", "residues", "integral"]
    free = response_mp(ONE, [Load(1)], **options)
    much = response_mp(ONE, [Load(1)], effort=Effort(seconds=1000), **options)
    assert (free.reason, much.reason) == (None, None)
    assert free.rail[0, 0] == much.rail[0, 0]


def test_many_digits_where_the_roots_take_it_all() -> None:
    found = response_mp(ONE, [Load(1)], times=[2], digits=15, effort=Effort(evaluations=3))
    assert (found.reason.code, found.error) == ("effort", (np.inf, np.inf))


@pytest.mark.parametrize("verb", [response, response_mp])
def test_what_is_no_effort(verb: Any) -> None:
    with pytest.raises(InputError, match="effort: is of type int"):
        verb(ONE, times=[2], effort=3, **({"digits": 15} if verb is response_mp else {}))
