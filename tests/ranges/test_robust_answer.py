"""Rows and words of an answer about a box of parameters."""

from fractions import Fraction
from types import SimpleNamespace

from free_cases import BEAM, PAIR

from mpsolve import Problem
from mpsolve.outcome import Status
from mpsolve.ranges.robust_answer import Robust


def test_open_boxes_are_rows_and_a_counterexample_is_named() -> None:
    problem, box = Problem(BEAM, PAIR, v=0), {"v": (Fraction(1, 2), Fraction(3, 4))}
    found = Robust(problem, box, Status.UNDECIDED, open=(box,))
    assert found.rows() == [{"v low": 0.5, "v high": 0.75}]
    known = {"counterexample": {"v": Fraction(3, 4)}, "spectrum": SimpleNamespace(trust="proved")}
    assert Robust(problem, box, Status.PROVED, **known).trust == "not stable, roots grow at v = 0.75: proved"
