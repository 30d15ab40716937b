"""Processes that share work: what they do on Ctrl-C."""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from mpsolve.errors import MpsolveError
from mpsolve.parallel.pool import run

ROOT = Path(__file__).parents[2]
SCRIPT = """
import os
import signal
import time
from pathlib import Path

import click

from mpsolve.parallel.pool import run

def work(k):
    Path(f"worker-{os.getpid()}").touch()
    while len(list(Path().glob("worker-*"))) < 2:  # until each of the two is at work
        time.sleep(0.01)
    time.sleep(SECONDS * k)
    return k

@click.command()
def command():
    print(run(work, [0, 1], 2, lambda *_: Path("one-is-idle").touch()))

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.HANDLER)
    command()
"""


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="a terminal sends Ctrl-C to a group of processes")
@pytest.mark.parametrize(
    ("handler", "seconds", "ends"),
    [("default_int_handler", 60, (1, "", ["Aborted!"])), ("SIG_IGN", 1, (0, "[0, 1]\n", []))],
)
def test_ctrl_c_ends_all_processes_at_once_and_without_a_traceback_or_none(
    tmp_path: Path, handler: str, seconds: int, ends: tuple[int, str, list[str]]
) -> None:
    """None where it is ignored, as by what a shell runs in the background."""
    (tmp_path / "script.py").write_text(SCRIPT.replace("HANDLER", handler).replace("SECONDS", str(seconds)))
    environment, start = os.environ | {"PYTHONPATH": str(ROOT)}, time.monotonic()
    streams: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "start_new_session": True}
    command = [sys.executable, "script.py"]
    with subprocess.Popen(command, cwd=tmp_path, env=environment, text=True, **streams) as process:
        try:
            while not (tmp_path / "one-is-idle").exists():
                assert process.poll() is None
                assert time.monotonic() - start < 60
                time.sleep(0.01)
            os.killpg(process.pid, signal.SIGINT)
            output, errors = process.communicate(timeout=30)
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
    assert (process.returncode, output, errors.split()) == ends


def test_a_worker_that_dies_is_named() -> None:
    with pytest.raises(MpsolveError, match="a worker process ended"):
        run(os._exit, [3, 3], workers=2)


def test_an_error_of_a_worker_comes_through() -> None:
    with pytest.raises(ValueError):  # noqa: PT011 (its words are Python's)
        run(math.sqrt, [1.0, -1.0, 4.0], workers=2)
    assert run(math.sqrt, [4.0, 1.0], workers=1) == [2.0, 1.0]
