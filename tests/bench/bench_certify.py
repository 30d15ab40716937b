"""Two masses, whole sheet, 30 digits, all proved, against cxroots: the same roots in rectangles, uncertified.

cxroots gets Δ and Δ_q on numpy arrays as the search for candidates has them, and its Romberg integration. Its default
evaluates one point at a time and takes longer: `bench_certify.py quad` compares with that. cxroots verifies nothing;
what our verifier takes besides is printed too. The rectangles are symmetric about the imaginary axis and keep off
the cuts. One repetition of cxroots a case: seconds to minutes.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import Any

import pytest
from measure import Counted, delta_and_slope, fresh, median, seconds

from mpsolve import Case, certify

GOAL = 50
NEEDS = "the comparison needs cxroots: pip install '.[bench]'"
PAIR = {"eta_m": ("70", "70"), "positions": ("0", "1.5")}


@dataclass(frozen=True)
class Duel:
    """A case and rectangles (left, right), (bottom, top) that hold all of its roots between them."""

    name: str
    case: Case
    rectangles: tuple[tuple[tuple[float, float], tuple[float, float]], ...]


DUELS = [
    Duel(  # q_lm = 0.45
        "subcritical, damped", Case(alpha="0.67", eta_b="0.05", **PAIR), (((-1, 1), (-1, 0.04)),)
    ),
    Duel(  # the roots are real, in the gap between the cuts: q_lm = 0.62
        "subcritical, undamped", Case(alpha="0.5", eta_b="0", **PAIR), (((-0.55, 0.55), (-0.5, 0.5)),)
    ),
    Duel(  # the cuts are joined: one rectangle on either side of them
        "supercritical, damped",
        Case(alpha="1.2", eta_b="0.05", **PAIR),
        (((-1, 1), (-1, 0.04)), ((-1, 1), (0.06, 1))),
    ),
]


def found_by_cxroots(cxroots: Any, duel: Duel, method: str) -> tuple[list[complex], int]:
    """The roots in all rectangles, and the number of evaluations of Δ and of Δ_q."""
    delta = delta_and_slope(duel.case)
    f, df = Counted(lambda q: delta(q)[0]), Counted(lambda q: delta(q)[1])
    roots: list[complex] = []
    for across, along in duel.rectangles:
        result = cxroots.Rectangle(across, along).roots(f, df, int_method=method)
        for root, number in zip(result.roots, result.multiplicities, strict=True):
            roots += [complex(root)] * int(number)
    return roots, f.points + df.points


def compare(cxroots: Any, duel: Duel, method: str = "romb") -> None:
    proof = median(fresh(lambda: certify(duel.case, digits=30, check=False)))
    spectrum = certify(duel.case, digits=30)
    checked = proof + spectrum.cost.verification
    answers: list[tuple[list[complex], int]] = []
    theirs = median(lambda: answers.append(found_by_cxroots(cxroots, duel, method)), repeats=1)
    (roots, evaluations), balls = answers[0], [root.q for root in spectrum.roots]
    print(
        f"{duel.name:24} {spectrum.count} roots   proof {seconds(proof)} ({spectrum.cost.evaluations} evaluations), "
        f"with its verification {seconds(checked)}   "
        f"cxroots ({method}) {seconds(theirs)} ({evaluations} float64 points)   "
        f"cxroots/proof = {theirs / proof:.0f}  (goal: {GOAL} or more), verified {theirs / checked:.0f}"
    )
    assert spectrum.proved
    assert len(roots) == spectrum.count
    assert all(min(abs(complex(ball.mid()) - root) for root in roots) < 1e-9 for ball in balls)


@pytest.mark.parametrize("duel", DUELS, ids=lambda duel: duel.name)
def test_cxroots_finds_what_is_certified(duel: Duel) -> None:
    compare(pytest.importorskip("cxroots", reason=NEEDS), duel)


def main(method: str) -> None:
    try:
        import cxroots
    except ImportError:
        print(f"skipped: {NEEDS}")
        return
    for duel in DUELS:
        compare(cxroots, duel, method)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "romb")
