"""`import mpsolve` in fresh interpreters, against `import numpy` alone, and the modules that each loads.

The package loads its parts when they are asked for, so that `from mpsolve import certify` stands beside them.
"""

from __future__ import annotations

import statistics
import subprocess
import sys

from measure import seconds

GOAL = 0.25
REPEATS = 7
SCRIPT = """
import sys, time
before, start = len(sys.modules), time.process_time()
{statement}
print(time.process_time() - start, len(sys.modules) - before)
"""


def fresh(statement: str) -> tuple[float, int]:
    """Processor seconds and number of modules of one import in an interpreter of its own."""
    command = [sys.executable, "-c", SCRIPT.format(statement=statement)]
    took, modules = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    return float(took), int(modules)


def main() -> None:
    statements = ("import mpsolve", "from mpsolve import certify", "import numpy")
    for statement in statements:  # fills the caches
        fresh(statement)
    runs = [{statement: fresh(statement) for statement in statements} for _ in range(REPEATS)]
    took = {statement: statistics.median(run[statement][0] for run in runs) for statement in statements}
    for statement in statements:
        modules, ratio = runs[0][statement][1], took[statement] / took["import numpy"]
        print(f"{statement:28} {seconds(took[statement])} ({modules} modules)   of import numpy: {ratio:.2f}")
        assert all(run[statement][1] == modules for run in runs)
    print(f"goal for import mpsolve: {GOAL} s")


def test_every_import_loads_the_same() -> None:
    main()


if __name__ == "__main__":
    main()
