"""One proved onset velocity against the obvious alternative: bisection in α around an uncertified root search.

The alternative asks cxroots for the number of roots in a rectangle below the real axis, and halves the bracket
until the onset has 8 digits, or the count no longer converges. It proves nothing: a stable window, a root beyond
the rectangle or a miscount go unseen.
"""

from __future__ import annotations

import sys
from typing import Any

import pytest
from measure import delta_and_slope, fresh, median, seconds

from mpsolve import Case, onset

NEEDS = "the comparison needs cxroots: pip install '.[bench]'"
ETA_B, ETA_M, PLACES = "0.05", (70, 70), (0, "1.5")
CASE = Case(alpha="0.5", eta_b=ETA_B, eta_m=ETA_M, positions=PLACES)
GOAL = 0.3
BRACKET, DIGITS = (0.5, 0.9), 8


def unstable(cxroots: Any, alpha: float, method: str) -> bool:
    """Whether cxroots counts a root in 0.01 < Re q < 1, −0.5 < Im q < 0."""
    delta = delta_and_slope(Case(alpha=alpha, eta_b=ETA_B, eta_m=ETA_M, positions=PLACES))
    rectangle = cxroots.Rectangle((0.01, 1), (-0.5, 0))
    return bool(rectangle.count_roots(lambda q: delta(q)[0], lambda q: delta(q)[1], int_method=method) > 0)


def proved(digits: int) -> Any:
    """The first onset."""
    return onset(CASE, over={"v": ("0.01", 1)}, digits=digits, check=False)


def bisected(cxroots: Any, method: str) -> tuple[float, float]:
    """The bracket, as far as the count converges: next to the onset a root lies almost on the rectangle."""
    low, high = BRACKET
    while high - low > 10.0**-DIGITS:
        middle = (low + high) / 2
        try:
            below = unstable(cxroots, middle, method)
        except cxroots.root_counting.RootError:
            break
        low, high = (low, middle) if below else (middle, high)
    return low, high


def compare(cxroots: Any, method: str = "romb") -> None:
    answers: list[tuple[float, float]] = []
    ours, thousand = (median(fresh(lambda digits=digits: proved(digits)), repeats=3) for digits in (30, 1000))
    theirs = median(lambda: answers.append(bisected(cxroots, method)), repeats=1)
    value, (low, high) = proved(30).value, answers[0]
    print(
        f"onset, 30 digits, proved {seconds(ours)}, {ours / GOAL:.2f} of the goal   "
        f"1000 digits: {thousand / ours:.2f} of that (goal: 1.5 or less)   "
        f"bisection with cxroots ({method}), to {high - low:.1g} {seconds(theirs)}   ratio {theirs / ours:.1f}"
    )
    assert low < float(value.mid()) < high


def test_bisection_finds_the_proved_onset() -> None:
    compare(pytest.importorskip("cxroots", reason=NEEDS))


def main(method: str) -> None:
    try:
        import cxroots
    except ImportError:
        print(f"skipped: {NEEDS}")
        return
    compare(cxroots, method)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "romb")
