"""The worst distance of two masses on the paper's beam, and the limiting mass at it: processor seconds, proved."""

from __future__ import annotations

from measure import fresh, median

from mpsolve import Case, crossings, onset, worst

GOAL, GOAL_CROSSINGS = 0.6, 0.15
PAIR = Case(alpha="0.99", eta_b="0.5", eta_m=(70, 70), positions=(0, 1))


def test_worst() -> None:
    seconds = median(fresh(lambda: worst(PAIR, over={"d": ("0.5", 2)}, digits=30, check=False)), repeats=3)
    many = median(fresh(lambda: worst(PAIR, over={"d": ("0.5", 2)}, digits=1000, check=False)), repeats=1)
    mass = median(fresh(lambda: onset(PAIR, over={"eta_m": (1, 70)}, worst={"d": (1, 2)}, check=False)), repeats=3)
    print(
        f"worst distance: {seconds:.2f} s, 1,000 digits {many:.2f} s   "
        f"limiting mass there {mass:.2f} s, {mass / GOAL:.2f} of the goal"
    )


def test_crossings_in_mass() -> None:
    bounded, endless = (
        median(fresh(lambda high=high: crossings(PAIR, over={"scale.mass": (0, high)}, check=False)), repeats=5)
        for high in (2, None)
    )
    print(
        f"crossings in mass: {bounded:.2f} s, {bounded / GOAL_CROSSINGS:.2f} of the goal   "
        f"without end {endless:.2f} s, {endless / bounded:.1f} of that"
    )
