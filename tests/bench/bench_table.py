"""Figure 12 of the paper, onsets of two equal masses over mass and distance: together, and each by itself.

Each entry costs about the same, so that a column is measured, and the rest is in proportion.
"""

from __future__ import annotations

from time import process_time
from typing import Any

from measure import fresh

from mpsolve import Case, onset, stability_table

GOAL, ENTRIES, PROCESSORS = 40, 600, 2
PAIR = Case(alpha="0.5", eta_b="0.05", eta_m=(1, 1), positions=(0, 1))
MASSES, ALONE = range(1, 101), range(10, 101, 30)


def seconds_of(asked: Any) -> float:
    started = process_time()
    asked()
    return process_time() - started


def test_figure_12() -> None:
    over, grid = {"v": (0, 2)}, {"rows": {"eta_m": list(MASSES)}, "columns": {"d": ["1.5"]}}
    column = seconds_of(fresh(lambda: stability_table(PAIR, over=over, digits=15, workers=1, **grid)))  # type: ignore[arg-type]
    cases = [Case(alpha="0.5", eta_b="0.05", eta_m=(m, m), positions=(0, "1.5")) for m in ALONE]
    alone = sum(seconds_of(fresh(lambda case=case: onset(case, over=over, digits=20, check=False))) for case in cases)
    whole = column / len(MASSES) * ENTRIES / PROCESSORS
    print(
        f"figure 12, {ENTRIES} entries on {PROCESSORS} processors: {whole:.0f} s, {whole / GOAL:.2f} of the goal   "
        f"an entry by itself takes {alone / len(ALONE) / (column / len(MASSES)):.1f} times as long"
    )
