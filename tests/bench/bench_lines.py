"""Root loci of a pair on a rail over the velocity, beside a root search at each point.

`certify` at each point proves as many points, but nothing between them.
"""

from __future__ import annotations

from fractions import Fraction

from measure import median, seconds

from mpsolve import Case, certify, frequency_lines
from mpsolve.problem.cases import as_problem

LOW, HIGH, POINTS = Fraction("0.5"), Fraction("0.95"), 10
CASE = Case(alpha="0.6", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
VALUES = [LOW + (HIGH - LOW) * Fraction(k, POINTS - 1) for k in range(POINTS)]


def compare() -> None:
    found = []

    def lines(region: str | None) -> float:
        asked = {"over": {"v": (LOW, HIGH)}, "points": VALUES, "region": region, "check": False}
        return median(lambda: found.append(frequency_lines(as_problem(CASE), **asked)), repeats=3)

    whole, ours = lines("sheet"), lines(None)
    cases = [Case(alpha=v, eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5")) for v in VALUES]
    points = median(lambda: [certify(case, digits=15, check=False) for case in cases], repeats=1)
    boxes = found[-1].cost.boxes
    print(f"lines of a pair over the velocity, {POINTS} points: {seconds(ours)}, {boxes} boxes")
    print(f"  on the whole sheet, to the cuts: {seconds(whole)}")
    print(f"  certify at each point:    {seconds(points)}, {points / ours:.1f} times as long")


def test_what_is_timed_is_proved() -> None:
    """All four roots are on lines."""
    found = frequency_lines(CASE, over={"v": (LOW, HIGH)}, points=VALUES[:2], check=False)
    assert found.proved
    assert found.counts == (4,)


if __name__ == "__main__":
    compare()
