"""A cluster: Dask workers as processes, one of which is killed in mid-study."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from mpsolve import open_study, study

pytest.importorskip("distributed", reason="a cluster needs the extra `dask`")

ROOT = Path(__file__).parents[2]
SPEC = """
[study]
kind = "certified"
[dimensionless]
alpha = 0.4
eta_b = 0.05
eta_m = [40]
positions = [0]
[parameters]
v = { start = 0.4, stop = 0.47, step = 0.01 }
"""
CLUSTER = """
import os
import signal
import subprocess
import sys
import time

from distributed import Client, LocalCluster

from mpsolve import Problem, prove_stable, study, tracks, vehicles
from mpsolve.studies import robust

killed = []

def kill_one(finished, total):
    if not killed:
        killed.append(next(iter(pids.values())))
        os.kill(killed[0], signal.SIGKILL)

if __name__ == "__main__":
    processes = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with processes as cluster, Client(cluster) as client:
        client.wait_for_workers(2)
        pids = client.run(os.getpid)
        made = study("s.toml", client.get_executor(), store="killed.sqlite", progress=kill_one)
        assert made.finished == made.total == 8
        until = time.monotonic() + 60  # the scheduler may not know of the death yet
        while killed[0] in client.run(os.getpid, on_error="ignore").values():
            assert time.monotonic() < until
            time.sleep(0.05)
        client.wait_for_workers(2)
        print("killed", len(killed))
        beam = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
        problem = Problem(beam, [vehicles.Mass(40).at(0)], v="0.5")
        robust._PARTS = 2
        box = {"over": {"v": ("0.2", "0.3")}, "store": "box.sqlite", "check": False}
        print("stable", prove_stable(problem, executor=client.get_executor(), **box).stable)
        command = [sys.executable, "-m", "mpsolve", "study", "s.toml", "-o", "command.sqlite"]
        print(subprocess.run([*command, "--dask", cluster.scheduler_address], check=True, text=True).returncode)
"""


def test_a_killed_worker_changes_nothing(tmp_path: Path) -> None:
    """The cluster runs apart from the tests, so that its threads and warnings do."""
    (tmp_path / "s.toml").write_text(SPEC)
    script = tmp_path / "cluster.py"
    script.write_text(CLUSTER)
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, script],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    said = done.stdout.splitlines()  # of the script, and of a command in a process of its own
    assert sorted(said) == sorted(
        ["killed 1", "stable True", "8 of 8 entries finished: 8 proved.", "command.sqlite", "0"]
    )
    alone = study(tmp_path / "s.toml", store=tmp_path / "alone.sqlite", workers=1)
    for name in ("killed", "command"):
        other = open_study(tmp_path / f"{name}.sqlite")
        for kind in ("csv", "json", "npz"):
            files = [one.save(one.path.with_suffix(f".{kind}")) for one in (alone, other)]
            assert files[0].read_bytes() == files[1].read_bytes()
