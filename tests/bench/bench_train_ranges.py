"""Trains over ranges: processor seconds of onsets, of the convective threshold of a row, and of amplification.

Beside them Δ and Δ_σ of 16 masses in balls, against the plain way: the same receptances, and the slope as a sum of 16
determinants with one row each replaced by its slope, which took 13.0 ms at 128 bits. Both take 1.5 ms now: 0.7 ms the
elimination by halves (FLINT's own determinant and solution of the whole take 1.4), 0.25 ms the p-roots and their
residues, 0.15 ms waves and sums, 0.25 ms the entries of both matrices. Goals: the onset of a
coach on two layers at 15 digits under 20 s, of 16 axles on the paper's beam under 60 s.

A compiled kernel was tried and left out. The product of second-order models (numba 0.68 against numpy, one thread) is
5.0 times as fast for 64 numbers, 1.2 times for 512, and slower from 8192 on. In the onset of two masses (308 boxes,
0.34 s) all those products are 4 % of the time, and no single routine is above 10 %: a compiled one cannot bring the
factor of 3 that would pay for a second implementation of a proof's arithmetic.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from flint import acb, acb_mat
from measure import seconds

from mpsolve import Problem, amplification, onset, tracks, train_velocities, vehicles
from mpsolve.characteristic.proved import Proved
from mpsolve.numbers.balls import precision
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.reduced import reduce_problem

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
EXAMPLE = Path(__file__).parents[2] / "examples" / "train_8_coaches.toml"
SIGMA, BITS, REPEATS = 0.01 + 0.2j, 128, 5


def timed(work: Callable[[], Any]) -> tuple[Any, float]:
    start = time.process_time()
    return work(), time.process_time() - start


def row(count: int, v: str) -> Problem:
    return Problem(BEAM, vehicles.train(vehicles.Mass(40), count, "1.5"), v=v)


def plain_slope(A: acb_mat, slope: acb_mat) -> Any:
    """The derivative of det A, row by row."""
    rows, moved, total = A.tolist(), slope.tolist(), acb(0)
    for k in range(len(rows)):
        total += acb_mat([moved[i] if i == k else rows[i] for i in range(len(rows))]).det()
    return total


def determinants(count: int = 16) -> float:
    """How many times as long the plain way takes, at one point each."""
    proved = Proved(reduce_problem(row(count, "0.5")))
    with precision(BITS):
        sigma = acb(SIGMA.real, SIGMA.imag)

        def ours() -> Any:
            return [proved.delta(sigma) for _ in range(REPEATS)]

        def plain() -> Any:
            out = []
            for _ in range(REPEATS):
                A, slope = proved.matrices(sigma)
                out.append((A.det(), plain_slope(A, slope)))
            return out

        (mine, spent), (theirs, longer) = timed(ours), timed(plain)
    assert mine[0][1].overlaps(theirs[0][1])
    print(f"Δ, Δ_σ of {count} masses in balls  {seconds(spent / REPEATS)}   plain {seconds(longer / REPEATS)}")
    return longer / spent


def ranges() -> None:
    train = read_problem(EXAMPLE).problem
    coach = Problem(train.track, train.vehicles[:1], v=train.v)
    asked: list[tuple[str, Callable[[], Any]]] = [
        ("onset of a coach on two layers, 50 to 350 m/s", lambda: onset(coach, over={"v": (50, 350)}, check=False)),
        ("onset of 16 masses, α 0.1 to 0.6", lambda: onset(row(16, "0.5"), over={"v": ("0.1", "0.6")}, check=False)),
        ("convective threshold of the row, α 0 to 0.6", lambda: train_velocities(row(1, "0.5"), "1.5", (0, "0.6"))),
        ("amplification of 16 masses, α = 0.4", lambda: amplification(row(16, "0.4"))),
    ]
    for name, work in asked:
        found, spent = timed(work)
        print(f"{name:46} {found.status.name:10} {seconds(spent)}", flush=True)


if __name__ == "__main__":
    determinants()
    ranges()
