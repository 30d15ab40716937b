"""A proof beside the page ends with its answer, and can be stopped."""

from __future__ import annotations

import time
from typing import Any

from mpsolve import read_problem, tracks, vehicles, verify
from mpsolve.explorer.proving import Proving, report
from mpsolve.problem.problem import Problem

PROBLEM = read_problem("examples/two_layer_bogie.toml").problem


def waited(proving: Proving, seconds: float = 60) -> Proving:
    end = time.monotonic() + seconds
    while proving.running and time.monotonic() < end:
        proving.poll()
        time.sleep(0.02)
    return proving


def test_it_is_proved_and_verified(tmp_path: object) -> None:
    proving = Proving(PROBLEM)
    proving.start()
    waited(proving)
    assert proving.answer.proved
    assert proving.answer.stable
    assert verify(proving.answer.certificate.save(f"{tmp_path}/a.json")).valid


def test_it_can_be_stopped() -> None:
    proving = Proving(PROBLEM)
    proving.start()
    proving.stop()
    assert not proving.running
    assert proving.failure == "stopped"
    proving.poll()


def test_a_killed_process_is_told() -> None:
    proving = Proving(PROBLEM)
    proving.start()
    proving._process.kill()
    assert "stopped" in waited(proving).failure


def test_a_refusal_is_told() -> None:
    track = tracks.EulerBernoulli(EI=1, m=1, k=1, c="0.1", N=10)
    proving = Proving(Problem(track, vehicles.Mass(1), v=1))
    proving.start()
    assert "buckles" in waited(proving).failure


def test_a_region_round_the_point_follows_the_answer() -> None:
    proving = waited(begun(more=("v", "track.k_pad")))
    assert proving.ended
    assert set(proving.region) == {"v", "track.k_pad"}
    low, high = proving.region["v"]
    assert low < PROBLEM.v < high


def test_a_report_is_written_beside_it() -> None:
    writing = waited(begun(work=report, seconds=3.0, more=("Bogie",)))
    assert writing.answer.startswith("<!DOCTYPE html>")
    assert "<h1>Bogie</h1>" in writing.answer
    assert "STABLE" in writing.answer


def begun(**more: Any) -> Proving:
    proving = Proving(PROBLEM, **more)
    proving.start()
    return proving
