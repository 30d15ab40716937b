"""The worst distance of two masses on the paper's beam, and the limiting mass at it: processor seconds, proved."""

from __future__ import annotations

from measure import median

from mpsolve import Case, onset, worst

GOAL = 0.6
PAIR = Case(alpha="0.99", eta_b="0.5", eta_m=(70, 70), positions=(0, 1))


def test_worst() -> None:
    seconds = median(lambda: worst(PAIR, over={"d": ("0.5", 2)}, digits=30, check=False), repeats=3)
    many = median(lambda: worst(PAIR, over={"d": ("0.5", 2)}, digits=1000, check=False), repeats=1)
    mass = median(lambda: onset(PAIR, over={"eta_m": (1, 70)}, worst={"d": (1, 2)}, check=False), repeats=1)
    print(
        f"worst distance: {seconds:.2f} s (goal {GOAL}), 1,000 digits {many:.2f} s; limiting mass there {mass:.2f} s"
    )
