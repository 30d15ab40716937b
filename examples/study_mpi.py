"""A study on the processes of an MPI job: any `concurrent.futures.Executor` will do, and mpi4py has one.

    pip install 'mpsolve[mpi]'
    mpiexec -n 17 python -m mpi4py.futures examples/study_mpi.py

The first process hands out the entries and writes the store, the other sixteen compute. The store has to be on a disk
of the first process's own machine. After an interruption the same command goes on.
"""

from __future__ import annotations

from pathlib import Path

from mpsolve import Study, study

SPEC = Path(__file__).with_name("study_certified.toml")
STORE = Path("study_mpi.sqlite")


def run(store: Path = STORE) -> Study:
    """The study in SPEC, computed by all processes of the MPI job but the first."""
    from mpi4py.futures import MPIPoolExecutor  # only here: the rest of the file needs no MPI

    with MPIPoolExecutor() as executor:
        return study(SPEC, executor, store=store, ahead=256)


if __name__ == "__main__":
    made = run()
    print(f"{made.finished} of {made.total} entries: {dict(made.tally)}")
    made.save(STORE.with_suffix(".csv"))
