"""Rows of masses and trains of coaches, unstable region, 20 digits: processor seconds of proof and verification.

The paper's beam, α = 0.5, η_b = 0.05, η_M = 40, in equal spacing (1.5) and in bogie spacing (1.2 and 8), and coaches
on a two-layer track. `python tests/bench/bench_trains.py 16` stops at 16 contacts. Goals: 16 masses are verified
within 3 times their proof (0.47 s after 0.22 s, in bogie spacing 0.52 s after 0.20 s), 64 within two minutes (23 s).
"""

from __future__ import annotations

import sys
from fractions import Fraction
from pathlib import Path

from measure import seconds

from mpsolve import Case
from mpsolve.certificate.solve import certify_problem
from mpsolve.problem.cases import as_problem
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.problem import Problem

NUMBERS = (1, 2, 3, 4, 8, 16, 32, 64)
COACHES = (1, 2, 4, 8)
SHORT, LONG = Fraction("1.2"), Fraction(8)
EXAMPLE = Path(__file__).parents[2] / "examples" / "train_8_coaches.toml"


def equal(number: int) -> list[Fraction]:
    return [Fraction(3, 2) * k for k in range(number)]


def bogies(number: int) -> list[Fraction]:
    return [(SHORT + LONG) * (k // 2) + SHORT * (k % 2) for k in range(number)]


def row(places: list[Fraction]) -> Case:
    return Case(alpha="0.5", eta_b="0.05", eta_m=["40"] * len(places), positions=places)


def line(name: str, problem: Problem) -> None:
    """Prints what one problem costs."""
    found = certify_problem(problem, region="unstable", digits=20)
    cost = found.cost
    ratio = cost.verification / cost.seconds
    print(
        f"{name:28} {found.status.name:9} {found.count!s:>4} roots {cost.pieces:5} pieces  proof "
        f"{seconds(cost.seconds)}  verification {seconds(cost.verification)}  {ratio:5.1f}",
        flush=True,
    )


def main(most: int = 64) -> None:
    certify_problem(as_problem(row(equal(1))), region="unstable", digits=20)  # what is loaded once
    for number in NUMBERS:
        if number > most:
            break
        for name, places in (("equal", equal(number)), ("bogie", bogies(number))):
            line(f"{number} masses, {name} spacing", as_problem(row(places)))
    train = read_problem(EXAMPLE).problem
    for number in COACHES:
        if 4 * number <= most:
            line(f"{number} coaches, two layers", Problem(train.track, train.vehicles[:number], v=train.v))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 64)
