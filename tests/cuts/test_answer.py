"""Answers about cut points pickle, tabulate and become data."""

import pickle

from mpsolve import Case, cut_points
from mpsolve.cuts.answer import CutPoints


def test_the_answer_travels_and_tabulates() -> None:
    found = cut_points(Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, "0.5")), over={"v": ("0.7", "0.8")})
    again: CutPoints = pickle.loads(pickle.dumps(found))
    assert again.points[0].side == "gap"
    (row,) = found.rows()
    assert abs(row["value"] - 0.7404667534244332) < 1e-14
    assert found.to_dict()["points"][0]["appears"] is False
