"""The cover of one side: the only zero of a range is met, enclosed in its room, and little effort is told."""

import numpy as np
from cut_cases import family

from mpsolve import Case
from mpsolve.cuts.search import Search
from mpsolve.proof.effort import Effort
from mpsolve.ranges.judge import boxes_of

CASE = Case(alpha="0.9", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))


def silent(_stage: str, _share: float) -> None:
    pass


def test_a_zero_is_met_below_the_cut() -> None:
    search = Search(family(CASE, "0.9", "0.99"), -1, 6.0, 15)
    assert search.low_wavenumbers(Effort(evaluations=20_000), silent) is None
    near = [zero for zero in search.found if abs(float(zero.x) - 0.97909502330842) < 1e-12]
    assert len(near) == 1
    assert near[0].p.rad() < 1e-14
    assert near[0].box[0].contains(near[0].p)


def test_spent_effort_is_a_reason() -> None:
    search = Search(family(CASE), -1, 6.0, 15)
    budget = Effort(evaluations=100)
    reason = search.high_wavenumbers(budget, silent) or search.low_wavenumbers(budget, silent)
    assert reason is not None
    assert reason.code == "effort"


def test_slopes_are_not_told_where_waves_meet() -> None:
    """Where the cuts have joined, a′ and b′ meet on them: values are bounded there, slopes are not."""
    pair = Case(alpha="0.9", eta_b="0.05", eta_m=(40, 40), positions=(0, "0.5"))
    search = Search(family(pair, "0.9", "1.1"), -1, 6.0, 15)
    low, high = np.array([[-1.6186], [1.00543]]), np.array([[-1.5986], [1.01143]])
    boxes = boxes_of(low, high, way=1.0)
    assert search.matrix(boxes)[1].good[0]
    assert not search._rooms.matrix(boxes)[1].good[0]
