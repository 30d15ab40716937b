"""Rows of a case and of a root: exact where that is short, marked where it is not, one row or two."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import acb, arb

from mpsolve import Case, Exact, PhysicalCase
from mpsolve.numbers.balls import precision
from mpsolve.report.rows import beam_rows, ratio_rows, root_rows, shown


@pytest.mark.parametrize(("x", "said"), [("0.05", "0.05"), ("6.4e6", "6400000"), ("1/3", "≈ 0.33333333")])
def test_shown(x: str, said: str) -> None:
    assert shown(Exact(x)) == said


def test_a_beam_in_si_and_its_ratios() -> None:
    case = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=100, N=1000, masses=[(900, 0)])
    rows = {name: value for name, value, _ in beam_rows(case)}
    assert rows["EI"] == "6400000 N m²"
    assert rows["M1"] == "900 kg"
    assert rows["v_cr"].startswith("≈ 290.39181")
    assert "v_cr′" in rows
    ratios = {name: value for name, value, _ in ratio_rows(Case(alpha="0.5", eta_b=0, eta_m=[3], positions=["1/3"]))}
    assert (ratios["α"], ratios["η_M1"]) == ("0.5", "3")


@pytest.mark.parametrize(
    ("q", "rows"),
    [(acb(2, -1), [("q1 =", "±2 - 1 i")]), (acb(0, 3), [("q1 =", "0 + 3 i")]), (acb(5, 0), [("q1 =", "±5")])],
)
def test_a_root_in_one_row(q: Any, rows: list[tuple[str, str]]) -> None:
    motion: Any = SimpleNamespace(root=SimpleNamespace(q=q))
    assert root_rows(1, motion, 15) == rows


def test_a_long_root_in_two() -> None:
    long = acb(arb(1) / 3, arb(1) / 7)
    motion: Any = SimpleNamespace(root=SimpleNamespace(q=long))
    assert [label for label, _ in root_rows(2, motion, 15)] == ["q2 ="]
    with precision(400):
        motion = SimpleNamespace(root=SimpleNamespace(q=acb(arb(1) / 3, arb(1) / 7)))
        assert [label for label, _ in root_rows(2, motion, 60)] == ["Re q2 =", "Im q2 ="]
