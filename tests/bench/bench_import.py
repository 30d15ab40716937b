"""`import mpsolve` in fresh interpreters, against `import numpy` alone; the modules that each loads beside it."""

from __future__ import annotations

import statistics
import subprocess
import sys

from measure import seconds

GOAL = 0.25
REPEATS = 7
SCRIPT = """
import sys, time
before, start = len(sys.modules), time.perf_counter()
import {name}
print(time.perf_counter() - start, len(sys.modules) - before)
"""


def fresh(name: str) -> tuple[float, int]:
    """Seconds and number of modules of one import in an interpreter of its own."""
    command = [sys.executable, "-c", SCRIPT.format(name=name)]
    took, modules = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    return float(took), int(modules)


def main() -> None:
    names = ("mpsolve", "numpy")
    runs = [{name: fresh(name) for name in names} for _ in range(REPEATS + 1)][1:]  # the first fills the caches
    took = {name: statistics.median(run[name][0] for run in runs) for name in names}
    modules = {name: runs[0][name][1] for name in names}
    both = "   ".join(f"import {name} {seconds(took[name])} ({modules[name]} modules)" for name in names)
    print(f"{both}   mpsolve/numpy = {took['mpsolve'] / took['numpy']:.2f}  (goal for mpsolve: {GOAL} s)")
    assert all(run[name][1] == modules[name] for run in runs for name in names)


def test_every_import_loads_the_same() -> None:
    main()


if __name__ == "__main__":
    main()
