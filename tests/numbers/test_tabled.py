"""A table of any length is printed, cut, and escaped for a notebook."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from mpsolve.numbers.tabled import Tabled


@dataclass
class Rows(Tabled):
    number: int

    def records(self) -> list[Mapping[str, Any]]:
        return [{"row": k, "x": k / 3} if k else {"row": 0} for k in range(self.number)]

    def _headline(self) -> str:
        return "a < b"


def test_rows_stand_below_their_names() -> None:
    assert str(Rows(2)).splitlines() == ["a < b", "row  x", "0", "1    0.33333333"]
    assert Rows(1)._repr_html_() == "<p>a &lt; b</p><table><tr><th>row</th></tr><tr><td>0</td></tr></table>"


def test_a_long_table_is_cut_and_an_empty_one_is_its_headline() -> None:
    assert (str(Rows(0)), Rows(0)._repr_html_()) == ("a < b", "<p>a &lt; b</p>")
    for shown in (str(Rows(250)), Rows(250)._repr_html_()):
        assert "and 150 more rows" in shown
        assert "149" not in shown
