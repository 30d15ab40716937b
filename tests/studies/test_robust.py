"""A box proved part by part: killed it goes on, by any executor, each part with a certificate; open ones return."""

from __future__ import annotations

import os
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import Executor, Future
from contextlib import closing
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from mpsolve import Case, Effort, InputError, Problem, certify, open_study, prove_stable, study, tracks, vehicles
from mpsolve.certificate.verify_ranges import verify_bytes
from mpsolve.outcome import Status
from mpsolve.studies import robust
from mpsolve.studies.spec import read_spec, spec_of

ROOT = Path(__file__).parents[2]
BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
PROBLEM = Problem(BEAM, [vehicles.Mass(40).at(0)], v="0.5")
OVER = {"v": ("0.2", "0.3"), "track.c": ("0.08", "0.12")}
SPEC: dict[str, Any] = {
    "study": {"kind": "stable", "boxes": 5000, "certificates": False},
    "dimensionless": {"alpha": "0.5", "eta_b": "0.05", "eta_m": [40], "positions": [0]},
    "parameters": {"v": {"low": "0.2", "high": "0.4", "parts": 2}, "track.k": 1},
}


@pytest.fixture(autouse=True)
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(robust, "_PARTS", 4)


class Here(Executor):
    """Does each block at once, and counts them."""

    def __init__(self) -> None:
        self.numbers: list[int] = []

    def submit(self, function: Callable[..., Any], /, *arguments: Any, **_: Any) -> Future[Any]:
        self.numbers.append(arguments[1])
        future: Future[Any] = Future()
        future.set_result(function(*arguments))
        return future


def test_each_part_has_a_certificate_and_together_they_are_the_range(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(robust, "_PARTS", 2)
    told: list[float] = []
    over = {"v": OVER["v"]}
    found = prove_stable(PROBLEM, over=over, store=tmp_path / "s", progress=lambda _, share: told.append(share))
    assert (found.stable, found.status, found.certificate) == (True, Status.UNVERIFIED, None)
    assert "2 of its 2 parts have one each" in found.note
    assert told == [0.5, 1.0]
    ends = []
    for _, _, result in open_study(tmp_path / "s").results():
        assert (result.status, result.unstable) == ("proved", 0)
        content = result.certificate
        assert content is not None
        assert verify_bytes(content.text.encode("ascii")).valid
        ends.append([Fraction(x) for x in content.content["range"][0]])
    assert ends == [[Fraction("0.2"), Fraction("0.25")], [Fraction("0.25"), Fraction("0.3")]]


def test_killed_it_goes_on(tmp_path: Path) -> None:
    store = tmp_path / "killed.sqlite"
    script = tmp_path / "box.py"
    script.write_text(
        "from mpsolve import Problem, prove_stable, tracks, vehicles\n"
        "from mpsolve.studies import robust\n"
        "robust._PARTS = 4\n"
        "beam = tracks.EulerBernoulli(EI='1/4', m=1, k=1, c='0.1')\n"
        "problem = Problem(beam, [vehicles.Mass(40).at(0)], v='0.5')\n"
        f"prove_stable(problem, over={OVER!r}, store='killed.sqlite', check=False)\n"
    )
    environment, until = os.environ | {"PYTHONPATH": str(ROOT)}, time.monotonic() + 120
    with subprocess.Popen([sys.executable, script], cwd=tmp_path, env=environment) as process:
        try:
            while stored(store) < 1:
                assert process.poll() is None, "it ended by itself"
                assert time.monotonic() < until, "it does not go on"
                time.sleep(0.005)
        finally:
            process.kill()
    assert process.returncode == -signal.SIGKILL, "it ended by itself"
    kept = stored(store)
    assert 0 < kept < 4
    again = Here()
    assert prove_stable(PROBLEM, over=OVER, store=store, executor=again, check=False).stable is True
    assert again.numbers == list(range(kept, 4))
    once_more = Here()
    assert prove_stable(PROBLEM, over=OVER, store=store, executor=once_more, check=False).stable is True
    assert once_more.numbers == []


def stored(path: Path) -> int:
    try:
        with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True, timeout=10)) as connection:
            return int(connection.execute("SELECT count(*) FROM blocks").fetchone()[0])
    except sqlite3.OperationalError:
        return 0


def test_open_parts_are_told_and_tried_again_with_more_effort(tmp_path: Path) -> None:
    few = {"over": OVER, "store": tmp_path / "s", "check": False}
    found = prove_stable(PROBLEM, effort=Effort(evaluations=25), **few)
    assert (found.stable, found.status) == (None, Status.UNDECIDED)
    assert found.reason is not None
    assert found.known["proved"] == 4 - len(found.open) < 4
    assert all(box["v"][1] - box["v"][0] == Fraction("0.05") for box in found.open)
    again = Here()
    assert prove_stable(PROBLEM, effort=Effort(evaluations=50_000), executor=again, **few).stable is True
    assert len(again.numbers) == len(found.open)


def test_a_part_in_which_something_grows_gives_the_counterexample(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where the first look at the whole box shows nothing."""
    monkeypatch.setattr(robust, "at_first_sight", lambda *_: None)
    pair = Case(alpha="0.5", eta_b="0.05", eta_m=[70, 70], positions=[0, "1.5"])
    over = {"alpha": ("0.66", "0.69")}
    found = prove_stable(pair, over=over, store=tmp_path / "s", check=False)
    assert found.stable is False
    assert found.over == {"alpha": (Fraction("0.66"), Fraction("0.69"))}
    assert found.counterexample is not None
    at = Case(alpha=found.counterexample["alpha"], eta_b="0.05", eta_m=[70, 70], positions=[0, "1.5"])
    assert certify(at, region="unstable").unstable == 2


def test_what_cannot_be_asked(tmp_path: Path) -> None:
    store = tmp_path / "s"
    with pytest.raises(InputError, match="executor: is given without a store"):
        prove_stable(PROBLEM, over=OVER, executor=Here())
    with pytest.raises(InputError, match="effort: has seconds"):
        prove_stable(PROBLEM, over=OVER, store=store, effort=Effort(seconds=1))
    with pytest.raises(InputError, match="v: ends at"):
        prove_stable(PROBLEM, over={"v": (1, 0)}, store=store)
    study(SPEC, store=store, workers=1)
    with pytest.raises(InputError, match="belongs to another study"):
        prove_stable(PROBLEM, over=OVER, store=store)


def test_a_study_of_parts_in_a_file() -> None:
    spec = read_spec(SPEC)
    assert (spec.total, spec.blocks) == (2, 2)
    assert spec.part(1) == {"v": (Fraction("0.3"), Fraction("0.4"))}
    assert spec.values(1) == {"v": Fraction("0.35"), "track.k": 1}
    assert spec_of(spec.text).part(1) == spec.part(1)
    text, _, place = spec.job(1)
    alone = spec_of(text)
    assert (alone.total, alone.part(place), alone.values(place)) == (1, spec.part(1), spec.values(1))
    assert alone.asked == spec.asked == read_spec(SPEC | {"study": SPEC["study"] | {"boxes": 7}}).asked


@pytest.mark.parametrize(
    ("section", "key", "value", "named"),
    [
        ("study", "digits", 20, "study.digits"),
        ("study", "design", {"kind": "list"}, "study.design"),
        ("study", "region", {"below": 1}, "study.region"),
        ("study", "boxes", 0, "study.boxes"),
        ("parameters", "v", [1, 2], "parameters.v"),
        ("parameters", "v", {"low": 1, "high": 2, "parts": 0}, "parameters.v.parts"),
        ("parameters", "v", {"low": 2, "high": 1}, "parameters.v.high"),
        ("parameters", "v", {"start": 1, "stop": 2, "step": 1}, "parameters.v"),
    ],
)
def test_what_a_study_of_parts_cannot_have(section: str, key: str, value: Any, named: str) -> None:
    with pytest.raises(InputError) as caught:
        read_spec(SPEC | {section: SPEC[section] | {key: value}})
    assert caught.value.key == named
