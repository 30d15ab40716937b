"""The example for an MPI job, run as its first lines say: the same bytes as in one process."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from mpsolve import study

EXAMPLES = Path(__file__).parents[2] / "examples"
MPIEXEC = shutil.which("mpiexec", path=str(Path(sys.executable).parent)) or shutil.which("mpiexec")
OPEN_MPI = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
}
RUN = [MPIEXEC or "mpiexec", "-n", "3", sys.executable, "-m", "mpi4py.futures", str(EXAMPLES / "study_mpi.py")]


@pytest.mark.skipif(
    MPIEXEC is None or find_spec("mpi4py") is None,
    reason="needs an MPI library and mpi4py: pip install '.[mpi]' mpich",
)
def test_an_mpi_job_makes_the_bytes_of_one_process(tmp_path: Path) -> None:
    environment = os.environ | OPEN_MPI  # Open MPI refuses root and more processes than processors unless told so
    done = subprocess.run(
        RUN, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("12 of 12 entries: {'proved': 12}")
    alone = study(EXAMPLES / "study_certified.toml", store=tmp_path / "alone.sqlite", workers=1)
    assert alone.save(tmp_path / "alone.csv").read_bytes() == (tmp_path / "study_mpi.csv").read_bytes()
