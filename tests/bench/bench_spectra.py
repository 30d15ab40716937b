"""Any track and vehicle: the unstable half-plane proved and verified, and rectangles against cxroots, uncertified.

cxroots gets Δ̂ and its slope on numpy arrays, and its Romberg integration, its fastest rule here. One repetition of
cxroots a case: it takes seconds to minutes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from measure import Counted, fresh, median, seconds

from mpsolve import Problem, Rectangle, certify, tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.reduced import reduce_problem

GOAL = 50
NEEDS = "the comparison needs cxroots: pip install '.[bench]'"
LAYERS = tracks.TwoLayer("6380430", "60.2", "300e6", "3e4", "250", "100e6", "8e4")
RAIL = tracks.EulerBernoulli("6.4e6", 60, "1e6", 770)
WIRE = tracks.String(27000, "1.07", 500, 2)
SPRUNG = vehicles.Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.5", k="2.4e6", c="3e4", k_contact="1.5e9")


@dataclass(frozen=True)
class Duel:
    """A problem, and a rectangle (left, right), (bottom, top) off the cuts that holds some of its roots."""

    name: str
    problem: Problem
    across: tuple[float, float]
    along: tuple[float, float]


DUELS = [
    Duel(
        "pair on two layers",
        Problem(LAYERS, [vehicles.Mass(900), vehicles.Mass(900).at("2.5")], v=680),
        (300, 700),
        (-10, 60),
    ),
    Duel("bogie on two layers", Problem(LAYERS, SPRUNG, v=800), (20, 700), (-20, 60)),
    Duel(
        "pair on a rail",
        Problem(RAIL, [vehicles.Mass(10000), vehicles.Mass(10000).at("3.4")], v=200),
        (5, 60),
        (-2, 4),
    ),
    Duel("contact wire", Problem(WIRE, vehicles.Mass("8.5"), v=100), (5, 30), (-2, "0.8")),
]


def rectangle(duel: Duel) -> Rectangle:
    return Rectangle(*duel.across, *duel.along)


def found_by_cxroots(cxroots: Any, duel: Duel) -> tuple[list[complex], int]:
    """The roots in the rectangle, and the number of evaluations of Δ̂ and of its slope."""
    reduced = reduce_problem(duel.problem)
    function, unit = Floats(reduced), float(reduced.frequency_unit)

    def at(q: Any, order: int) -> Any:
        q = np.asarray(q, dtype=complex)
        value = function.delta(1j * np.atleast_1d(q).ravel() / unit)[order].reshape(q.shape)
        return value * (1j / unit) if order else value

    f, df = Counted(lambda q: at(q, 0)), Counted(lambda q: at(q, 1))
    sides = [tuple(map(float, side)) for side in (duel.across, duel.along)]
    result = cxroots.Rectangle(*sides).roots(f, df, int_method="romb")
    roots = [complex(r) for r, n in zip(result.roots, result.multiplicities, strict=True) for _ in range(int(n))]
    return roots, f.points + df.points


def compare(cxroots: Any, duel: Duel) -> None:
    spectrum = certify(duel.problem, region=rectangle(duel), digits=20)
    ours = median(fresh(lambda: certify(duel.problem, region=rectangle(duel), digits=20, check=False)))
    answers: list[tuple[list[complex], int]] = []
    theirs = median(lambda: answers.append(found_by_cxroots(cxroots, duel)), repeats=1)
    roots, evaluations = answers[0]
    cost = spectrum.cost
    print(
        f"{duel.name:20} {spectrum.count} roots   proof {seconds(ours)} ({cost.evaluations} evaluations)   "
        f"verification {seconds(cost.verification)}   cxroots (romb) {seconds(theirs)} ({evaluations} evaluations)   "
        f"cxroots/proof = {theirs / ours:.0f}  (goal: {GOAL} or more)"
    )
    assert spectrum.proved, spectrum.reason
    assert len(roots) == spectrum.count
    assert all(min(abs(complex(root.q.mid()) - other) for other in roots) < 1e-6 for root in spectrum.roots)


@pytest.mark.parametrize("duel", DUELS, ids=lambda duel: duel.name)
def test_cxroots_finds_what_is_certified(duel: Duel) -> None:
    compare(pytest.importorskip("cxroots", reason=NEEDS), duel)


def main() -> None:
    for duel in DUELS:
        half_plane = certify(duel.problem, region="unstable", digits=20)
        ours = median(fresh(lambda duel=duel: certify(duel.problem, region="unstable", digits=20, check=False)))
        print(
            f"{duel.name:20} Im q < 0: {half_plane.count} roots   proof {seconds(ours)}, with the track's theorem   "
            f"verification {seconds(half_plane.cost.verification)}   {half_plane.cost.pieces} pieces"
        )
    try:
        import cxroots
    except ImportError:
        print(f"skipped: {NEEDS}")
        return
    for duel in DUELS:
        compare(cxroots, duel)


if __name__ == "__main__":
    main()
