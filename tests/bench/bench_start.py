"""Processor time of whole processes, from the shell to the answer, beside that of `import numpy, flint` alone.

Bytecode is written before, as an installation does; the least of several runs counts, as machines are shared.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[2]
REPEATS = 7
TWO_MASSES = str(ROOT / "examples" / "rail_60e1.toml")
GOALS: dict[str, tuple[list[str], float | None]] = {
    "python": (["-c", "pass"], None),
    "import numpy, flint": (["-c", "import numpy, flint"], None),
    "import mpsolve": (["-c", "import mpsolve"], 0.05),
    "from mpsolve import certify": (["-c", "from mpsolve import certify"], 0.2),
    "mpsolve certify, two masses": (["-m", "mpsolve", "certify", TWO_MASSES, "-o", "made.json"], 0.3),
    "the same, Im q < 0": (["-m", "mpsolve", "certify", TWO_MASSES, "--region", "unstable", "-o", "made.json"], 0.3),
    "mpsolve verify": (["-m", "mpsolve", "verify", str(ROOT / "certs" / "rail_60e1.json")], None),
}


def took(arguments: list[str], folder: str) -> float:
    """Processor seconds of an interpreter with these arguments, children of it included."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, *arguments], check=True, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for name, (arguments, goal) in GOALS.items():
            least = min(took(arguments, folder) for _ in range(REPEATS))
            print(f"{name:30} {least:.3f} s{f'   goal {goal} s' if goal else ''}", flush=True)


def test_every_process_ends_well() -> None:
    main()


if __name__ == "__main__":
    main()
