"""The cover of one side: the only zero of a range is met, enclosed in its room, and little effort is told."""

from cut_cases import family

from mpsolve import Case
from mpsolve.cuts.search import Search
from mpsolve.proof.effort import Effort

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
