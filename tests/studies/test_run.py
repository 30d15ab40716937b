"""Running a study: the same bytes whoever computes, nothing twice, and nothing lost."""

from __future__ import annotations

import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import Executor, Future
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from mpsolve import InputError, StudyError, certify, open_study, study
from mpsolve.studies.blocks import Block
from mpsolve.studies.export import KINDS, export
from mpsolve.studies.spec import read_spec

ROOT = Path(__file__).parents[2]
MASS: dict[str, Any] = {"alpha": "0.5", "eta_b": "0.05", "eta_m": [40], "positions": [0]}
FLOAT64: dict[str, Any] = {
    "study": {"kind": "float64", "region": "sheet", "design": {"kind": "random", "count": 2100, "seed": 7}},
    "dimensionless": MASS,
    "parameters": {"v": {"low": "0.4", "high": "0.5"}, "vehicles[0].M": {"low": 40, "high": 45}},
}


class Here(Executor):
    """Does each block at once, and counts them and those that nobody has fetched yet."""

    def __init__(self, stop: int = 10**9) -> None:
        self.numbers: list[int] = []
        self.stop = stop

    def submit(self, function: Callable[..., Any], /, *arguments: Any, **_: Any) -> Future[Any]:
        if len(self.numbers) == self.stop:
            raise KeyboardInterrupt
        self.numbers.append(arguments[1])
        future: Future[Any] = Future()
        future.set_result(function(*arguments))
        return future


def stored(path: Path) -> list[tuple[Any, ...]]:
    """Every row of every table, in order."""
    with closing(sqlite3.connect(path)) as connection:
        names = ("study", "blocks", "entries", "roots", "certificates")
        rows = [connection.execute(f"SELECT * FROM {name} ORDER BY 1, 2").fetchall() for name in names]
    return [row for table in rows for row in table]


def exported(path: Path) -> list[bytes]:
    """The bytes of all exports that need no further package."""
    files = [open_study(path).save(path.with_suffix(f".{kind}")) for kind in KINDS if kind != "parquet"]
    return [file.read_bytes() for file in files]


def test_one_process_two_processes_and_another_executor_make_the_same_bytes(tmp_path: Path) -> None:
    plain = {"study": {"kind": "certified"}, "dimensionless": MASS}
    plain["parameters"] = {"v": ["0.4", "0.5"], "vehicles[0].M": [40, 41]}
    for name, spec in (("certified", plain), ("float64", FLOAT64)):
        places = [tmp_path / f"{name}{k}.sqlite" for k in range(3)]
        first = study(spec, store=places[0], workers=1)
        assert first.answered
        assert first.finished == first.total == read_spec(spec).total
        study(spec, store=places[1], workers=2)
        study(spec, Here(), store=places[2], ahead=1)
        for other in places[1:]:
            assert stored(other) == stored(places[0])
            assert exported(other) == exported(places[0])


def test_what_is_finished_is_not_done_again(tmp_path: Path, certified: dict[str, Any]) -> None:
    path, first, second, third = tmp_path / "study.sqlite", Here(stop=2), Here(), Here()
    with pytest.raises(KeyboardInterrupt):
        study(certified, first, store=path, ahead=1)
    assert open_study(path).finished == 2
    assert not open_study(path).complete
    told: list[tuple[int, int]] = []
    made = study(certified, second, store=path, progress=lambda *numbers: told.append(numbers))
    assert (first.numbers, second.numbers) == ([0, 1], [2, 3])
    assert told == [(3, 4), (4, 4)]
    assert made.complete
    assert not made.answered
    assert made.tally == {"proved": 2, "refused": 2}
    before = stored(path)
    study(certified, third, store=path)
    assert third.numbers == []
    assert stored(path) == before


def test_damaged_blocks_are_computed_anew(tmp_path: Path, certified: dict[str, Any]) -> None:
    path, again = tmp_path / "study.sqlite", Here()
    study(certified, Here(), store=path)
    before = stored(path)
    with closing(sqlite3.connect(path)) as connection:
        connection.execute('UPDATE entries SET count = 7 WHERE "index" = 1')
        connection.execute("UPDATE blocks SET tally = '{\"proved\": 5}' WHERE number = 2")
        connection.commit()
    with pytest.raises(StudyError, match="damaged results of the entries 1 to 1: run the study again on this file"):
        list(open_study(path).results())
    study(certified, again, store=path)
    assert again.numbers == [1, 2]
    assert stored(path) == before


def test_results_come_in_order_with_their_exact_parameters(tmp_path: Path) -> None:
    made = study(FLOAT64, Here(), store=tmp_path / "study.sqlite")
    spec = read_spec(FLOAT64)
    for start in (0, 2047, 2048, 2099):
        found = list(made.results(start))
        assert [index for index, _, _ in found] == list(range(start, 2100))
        assert found[0][1] == spec.values(start)
        assert found[0][2].count == len(found[0][2].roots) == 2


def test_what_float64_says_can_be_certified_afterwards(tmp_path: Path) -> None:
    pair = {"alpha": "0.6", "eta_b": "0.05", "eta_m": [70, 70], "positions": [0, "1.5"]}
    spec = {"study": {"kind": "float64"}, "dimensionless": pair, "parameters": {"v": ["0.66", "0.67"]}}
    made = study(spec, store=tmp_path / "study.sqlite", workers=1)
    growing = [index for index, _, result in made.results() if result.unstable]
    assert growing == [1]
    assert certify(made.problem(1), region="unstable", digits=15).unstable == 2


def test_few_blocks_are_under_way_at_a_time(tmp_path: Path, wide: dict[str, Any], block: Any) -> None:
    """However large the study, an executor is handed `ahead` blocks, and its results are stored as they come."""

    class Lazy(Executor):
        """Answers the first of the waiting blocks whenever as many wait as it was told."""

        def __init__(self) -> None:
            self.waiting: list[tuple[int, Future[Block]]] = []
            self.most = self.done = 0

        def submit(self, _function: Callable[..., Any], /, *arguments: Any, **_: Any) -> Future[Any]:
            future: Future[Block] = Future()
            self.waiting.append((arguments[1], future))
            self.most = max(self.most, len(self.waiting))
            if len(self.waiting) == 5:
                number, first = self.waiting.pop(0)
                first.set_result(block(number))
                self.done += 1
            if self.done == 100:
                raise KeyboardInterrupt
            return future

    path, lazy = tmp_path / "study.sqlite", Lazy()
    with pytest.raises(KeyboardInterrupt):
        study(wide, lazy, store=path, ahead=5)
    assert lazy.most == 5
    assert open_study(path).finished >= 99


def test_a_worker_that_dies_is_an_error_that_says_how_to_go_on(tmp_path: Path, certified: dict[str, Any]) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "import os, signal, sys\n"
        "from mpsolve import study\n"
        "from mpsolve.studies import blocks, run\n"
        "def dies(text, number, place):\n"
        "    if number == 1:\n"
        "        os.kill(os.getpid(), signal.SIGKILL)\n"
        "    return blocks.work(text, number, place)\n"
        "if __name__ == '__main__':\n"
        "    run.work = dies\n"
        f"    study({certified!r}, store='study.sqlite', workers=2)\n"
    )
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, script], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert "StudyError: a worker process ended" in done.stderr
    assert "what is finished is stored, and the same call goes on" in done.stderr
    assert study(certified, Here(), store=tmp_path / "study.sqlite").complete


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the workers are found through /proc")
def test_killed_at_random_moments_it_goes_on_to_the_same_bytes(tmp_path: Path) -> None:
    """kill -9 of the command in mid-work, and its workers end with it; the last run completes the study."""
    parameters = "v = { start = 0.4, stop = 0.5, step = 0.0025 }\n"
    problem = "[dimensionless]\nalpha = 0.4\neta_b = 0.05\neta_m = [40]\npositions = [0]\n"
    (tmp_path / "s.toml").write_text(f'[study]\nkind = "certified"\n{problem}[parameters]\n{parameters}')
    killed, whole = tmp_path / "killed.sqlite", tmp_path / "whole.sqlite"
    moments, finished = random.Random(2), [0]
    for _ in range(2):
        kill_after(finished[-1] + moments.randint(1, 4), killed)
        finished.append(rows(killed))
    assert 0 < finished[1] < finished[2] < 41
    study(tmp_path / "s.toml", store=killed, workers=1)
    study(tmp_path / "s.toml", store=whole, workers=1)
    assert rows(whole) == 41
    assert stored(killed) == stored(whole)
    assert exported(killed) == exported(whole)


def kill_after(count: int, store: Path) -> None:
    """Runs the command on s.toml beside the store, and kills it as soon as so many blocks are in the store."""
    command = [sys.executable, "-m", "mpsolve", "study", "s.toml", "--workers", "2", "-o", store.name]
    environment, until = os.environ | {"PYTHONPATH": str(ROOT)}, time.monotonic() + 120
    with subprocess.Popen(command, cwd=store.parent, env=environment, stdout=subprocess.DEVNULL) as process:
        try:
            while rows(store) < count:
                assert process.poll() is None, "it ended by itself"
                assert time.monotonic() < until, "it does not go on"
                time.sleep(0.01)
            workers = children(process.pid)
        finally:
            process.kill()
    assert process.returncode == -signal.SIGKILL, "it ended by itself"
    assert workers
    while any(map(alive, workers)):
        assert time.monotonic() < until, "a worker outlived its parent"
        time.sleep(0.01)


def rows(path: Path) -> int:
    """The number of blocks in a store that somebody may be making."""
    try:
        with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True, timeout=10)) as connection:
            return int(connection.execute("SELECT count(*) FROM blocks").fetchone()[0])
    except sqlite3.OperationalError:
        return 0


def children(process: int) -> list[int]:
    return [int(child) for child in Path(f"/proc/{process}/task/{process}/children").read_text().split()]


def alive(process: int) -> bool:
    """Whether it runs; a zombie whose new parent has not looked yet does not."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


@pytest.mark.parametrize(("option", "value"), [("ahead", 0), ("ahead", True), ("workers", 0), ("workers", "two")])
def test_an_option_that_cannot_be(tmp_path: Path, certified: dict[str, Any], option: str, value: Any) -> None:
    path = tmp_path / "study.sqlite"
    with pytest.raises(InputError) as caught:
        study(certified, store=path, **{option: value})
    assert caught.value.key == option
    assert not path.exists()


def test_only_results_of_another_version(
    tmp_path: Path, certified: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "study.sqlite"
    with monkeypatch.context() as older:
        older.setattr("mpsolve.studies.store.ENGINE", "mpsolve 0.0, results 0")
        study(certified, Here(), store=path)
    with pytest.raises(StudyError, match=r"of another version only \(mpsolve 0\.0, results 0\)"):
        open_study(path)
    assert study(certified, Here(), store=path).complete


@pytest.mark.parametrize(
    ("given", "key"),
    [
        ({"store": "a\0b"}, "store"),
        ({"store": 5}, "store"),
        ({"store": b"study.sqlite"}, "store"),
        ({"executor": "notanexecutor"}, "executor"),
    ],
)
def test_what_is_no_store_or_executor_is_named(
    given: dict[str, Any], key: str, certified: dict[str, Any], tmp_path: Path
) -> None:
    with pytest.raises(InputError) as caught:
        study(certified, **{"store": tmp_path / "s.sqlite", **given})
    assert caught.value.key == key
    assert repr(given[key]) in str(caught.value)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["x" * 300, "a\0b", 5, None])
def test_what_is_no_study_is_named(name: Any, tmp_path: Path) -> None:
    for act in (open_study, lambda path: export(path, tmp_path / "a.csv")):
        with pytest.raises(InputError) as caught:
            act(name)
        assert caught.value.key == "store"
