"""Values and their floats are rounded outward; data is plain."""

import json
import pickle
import sys
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from mpsolve import Case
from mpsolve.errors import InputError
from mpsolve.loci.answer import FrequencyLine, FrequencyLines, LineEnd
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import as_problem
from mpsolve.problem.over import Over
from mpsolve.ranges.answer import within
from mpsolve.ranges.chart import Chart
from mpsolve.ranges.crossed import Crossing, Crossings
from mpsolve.ranges.entry import Entry
from mpsolve.ranges.onset import Kind, Onset
from mpsolve.ranges.robust_answer import Robust
from mpsolve.ranges.sensitivity import Moved, Sensitivity
from mpsolve.ranges.table import Table
from mpsolve.ranges.unstable import Unstable, UnstableRanges
from mpsolve.ranges.worst import Worst

CASE = Case(alpha="0.5", eta_b="0.05", eta_m=(1, 1), positions=(0, 1))
OVER = {"v": (Fraction(1, 3), Fraction(2))}
REASON = Reason("why", "1 < 2 & so on", {}, "")
FIRST = (as_problem(CASE), OVER, Status.UNVERIFIED)
AT = Crossing(arb(1.5), arb(0.5), 2)
END = LineEnd("range")
SCALED = Over("v", Fraction(1, 3), Fraction(2), "m/s", "m/s")
ENTRY = Entry("proved", "1.2", OVER["v"])
ANSWERS: dict[str, tuple[Result, int]] = {
    "crossings": (Crossings(*FIRST, crossings=(AT,), counts=(0, 2)), 1),
    "ranges": (UnstableRanges(*FIRST, intervals=(Unstable(arb(1.5), None, arb(0.5), 2),)), 1),
    "onset": (Onset(*FIRST, kind=Kind.CROSSES, value=arb(1.5), q=arb(0.5)), 1),
    "open": (Onset(as_problem(CASE), OVER, Status.UNDECIDED, REASON), 1),
    "worst": (Worst(*FIRST, value=arb(1.5), q=acb(0.5, -0.1), where="inside"), 1),
    "robust": (Robust(*FIRST, stable=None, open=({"v": (Fraction(1), Fraction(2))},)), 1),
    "chart": (Chart(*FIRST, x=(Fraction(1),), y=(Fraction(2),)), 0),
    "sensitivity": (Sensitivity(*FIRST, roots=(Moved(acb(0.5, -0.1), {"v": acb(1)}),)), 1),
    "table": (Table("onset", SCALED, ("a", (Fraction(1),)), ("b", (Fraction(2),)), 5, ((ENTRY,),)), 1),
    "lines": (
        FrequencyLines(*FIRST, lines=(FrequencyLine((Fraction(1),), (acb(0.5, -0.1),), (END, END), 2),), counts=(2,)),
        1,
    ),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_each_answer_is_data_and_a_table(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    found, rows = ANSWERS[name]
    copy = pickle.loads(pickle.dumps(found))
    assert copy.to_dict() == found.to_dict()
    assert json.loads(found.to_json())["proved"] is (name != "open")
    shown = found._repr_html_()
    assert shown.count("<tr>") == (rows + 1 if rows else 0)
    assert (type(found).__name__ if name != "table" else "onset of v") in shown
    monkeypatch.setitem(sys.modules, "pandas", SimpleNamespace(DataFrame=list))
    frame: Any = found.to_frame()
    assert len(frame) == rows


def test_without_pandas_something_else_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(InputError, match="pip install pandas"):
        ANSWERS["onset"][0].to_frame()


def test_a_notebook_shows_reasons_as_text() -> None:
    assert "1 &lt; 2 &amp; so on" in ANSWERS["open"][0]._repr_html_()


def test_exact_numbers_have_decimals_beside_them() -> None:
    data = json.loads(ANSWERS["onset"][0].to_json())
    assert data["over"]["v"][0] == {"exact": "1/3", "decimal": 1 / 3}
    assert float(data["value"]["decimal"]) == 1.5
    assert data["value"]["lower"] <= 1.5 <= data["value"]["upper"]


def test_whether_a_ball_lies_in_a_range() -> None:
    interval = (Fraction(1, 3), Fraction(2, 3))
    assert within(arb(0.5), interval) is True
    assert within(arb(0.7), interval) is False
    with precision(100):
        assert within(arb(1) / 3, interval) is None
