"""Public answers share one base: status, proved, reason, known, certificate, cost; they pickle, and are no truths."""

from __future__ import annotations

import json
import pickle
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from html import escape
from typing import Any

import pytest
from flint import acb, arb

import mpsolve
from mpsolve import Case, Effort, Problem, Rectangle, Status, tracks, vehicles
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
PAIR = Problem(BEAM, vehicles.train(vehicles.Mass(70), 2, "1.5"), v="0.6")
OVER: dict[str, Any] = {"v": ("0.66", "0.67")}
CELL: dict[str, Any] = {"rows": {"gap[0]": ["1.5"]}, "columns": {"scale.mass": [1]}, "workers": 1}
ANSWERS: dict[str, Callable[[], Any]] = {
    "Spectrum": lambda: mpsolve.certify(PAIR, region="unstable", digits=15),
    "Zeros": lambda: mpsolve.roots("z**2 - 2", Rectangle(-3, 3, -1, 1)),
    "CriticalVelocities": lambda: mpsolve.critical_velocities(tracks.EulerBernoulli(EI=1, m=1, k=1)),
    "PassivityVelocity": lambda: mpsolve.passivity_velocity(BEAM, over={"v": (0, "0.5")}),
    "PassivityBand": lambda: mpsolve.passivity_band(PAIR),
    "InfiniteTrain": lambda: mpsolve.infinite_train(
        Case(alpha="0.1", eta_b="0.05", eta_m=40, positions=0), "1.5", effort=Effort(seconds=3)
    ),
    "TrainVelocities": lambda: mpsolve.train_velocities(PAIR, "3", (0, "0.2"), effort=Effort(evaluations=10)),
    "Amplification": lambda: mpsolve.amplification(PAIR),
    "Onset": lambda: mpsolve.onset(PAIR, over=OVER),
    "UnstableRanges": lambda: mpsolve.unstable_ranges(PAIR, over=OVER),
    "Crossings": lambda: mpsolve.crossings(PAIR, over=OVER),
    "Robust": lambda: mpsolve.prove_stable(PAIR, over={"v": ("0.5", "0.51")}),
    "Worst": lambda: mpsolve.worst(PAIR, over={"v": ("0.66", "0.67")}, effort=Effort(evaluations=50)),
    "CutPoints": lambda: mpsolve.cut_points(PAIR, over=OVER, effort=Effort(evaluations=50)),
    "FrequencyLines": lambda: mpsolve.frequency_lines(PAIR, over=OVER, points=2, effort=Effort(evaluations=2000)),
    "ProvedVibration": lambda: mpsolve.response_balls(PAIR, times=["1"], digits=3, effort=Effort(evaluations=50)),
    "Sensitivity": lambda: mpsolve.sensitivity(PAIR, region=("below", "0.04"), digits=15),
    "Chart": lambda: mpsolve.stability_chart(PAIR, over={**OVER, "scale.mass": (1, "1.1")}, depth=2),
    "Table": lambda: mpsolve.stability_table(PAIR, over=OVER, **CELL),
}


def test_every_public_answer_is_made_below() -> None:
    """A public class with a status that is no array is an answer."""
    public = {name: getattr(mpsolve, name) for name in mpsolve.__all__}
    answers = {name for name, one in public.items() if isinstance(one, type) and issubclass(one, Result)}
    assert answers == set(ANSWERS)
    stated = {
        name
        for name, one in public.items()
        if isinstance(one, type) and "status" in getattr(one, "__annotations__", ())
    }
    assert stated - answers == {"Frequencies"}, "its status is an array: float64 proves nothing"


@pytest.mark.parametrize("name", ANSWERS)
def test_an_answer(name: str) -> None:
    found = ANSWERS[name]()
    assert type(found).__name__ == name
    assert isinstance(found.status, Status)
    assert found.proved is found.status.holds
    assert found.reason is None or isinstance(found.reason, Reason)
    assert (found.reason is None) is found.proved
    assert isinstance(found.known, Mapping)
    assert hasattr(found, "certificate")
    assert hasattr(found, "cost")
    with pytest.raises(TypeError, match=r"has no truth value: ask for \.proved"):
        bool(found)
    data = json.loads(found.to_json())
    assert data == json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert data["status"] == found.status.value
    assert name in ("Spectrum", "Table") or escape(str(found).splitlines()[0]) in found._repr_html_()
    assert str(found).startswith(name)
    assert found.trust in str(found)
    assert len(str(found).splitlines()) <= 1 + bool(list(found.records())) + len(list(found.records()))
    assert all(isinstance(row, Mapping) for row in found.records())
    if found.proved and found.certificate is None:
        assert found.trust.startswith("proved, without certificate")
        assert "without certificate" in found.to_json()
    elif found.proved:
        assert found.trust.startswith("proved, with a certificate")
    else:
        assert str(found.reason) in found.trust
    again = pickle.loads(pickle.dumps(found))
    assert type(again) is type(found)
    assert (again.status, again.reason, again.cost) == (found.status, found.reason, found.cost)


@dataclass(frozen=True)
class Made(Result):
    status: Status
    value: Any
    reason: Reason | None = None


def test_balls_travel_whole() -> None:
    made = Made(Status.PROVED, (arb("0.1", "1e-9"), {"q": acb(1, 2)}))
    again = pickle.loads(pickle.dumps(made))
    assert again.value[0].contains(made.value[0])
    assert again.value[1]["q"] == acb(1, 2)
    assert (made.known, made.certificate, made.cost, made.proved) == ({}, None, None, True)
    assert not Made(Status.REFUTED, 1).proved


def test_verdicts_have_no_truth_value_either() -> None:
    """`if verify(path)` would take a refused file for a valid one."""
    for module in ("verify2", "verify_ranges", "verify_roots"):
        verdict = __import__(f"mpsolve.certificate.{module}", fromlist=["Verdict"]).Verdict(False, "no")
        with pytest.raises(TypeError, match=r"ask for \.valid"):
            bool(verdict)


def test_print_shows_the_answer() -> None:
    """A list that is empty says so; a long one ends; a row for each root, velocity and zero."""
    none = mpsolve.crossings(PAIR, over={"v": ("0.1", "0.2")})
    assert str(none).startswith("Crossings over v from 0.1 to 0.2: none, proved")
    spectrum = mpsolve.certify(PAIR, region="sheet", digits=15)
    assert len(str(spectrum).splitlines()) == 2 + len(spectrum.roots)
    assert f"{spectrum.roots[0].q.real.mid().str(8, radius=False)}" in str(spectrum)
    assert "1.4142136" in str(ANSWERS["Zeros"]())
    assert len(str(ANSWERS["CriticalVelocities"]()).splitlines()) == 3
