"""Processes that share work: what they do on Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
SCRIPT = """
import os
import time
from pathlib import Path

import click

from mpsolve.stability.pool import run

def work(k):
    Path(f"worker-{os.getpid()}").touch()
    while len(list(Path().glob("worker-*"))) < 2:  # until each of the two is at work
        time.sleep(0.01)
    time.sleep(60 * k)

@click.command()
def command():
    run(work, [0, 1], 2, lambda *_: Path("one-is-idle").touch())

if __name__ == "__main__":
    command()
"""


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="a terminal sends Ctrl-C to a group of processes")
def test_ctrl_c_ends_all_processes_at_once_and_without_a_traceback(tmp_path: Path) -> None:
    (tmp_path / "script.py").write_text(SCRIPT)
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
    assert (process.returncode, output, errors.split()) == (1, "", ["Aborted!"])
