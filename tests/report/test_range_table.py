"""Tables are read key by key, and written with every entry where it belongs, whatever reads them."""

from __future__ import annotations

import csv
import io
import json
from fractions import Fraction
from pathlib import Path

import pytest
from flint import arb

from mpsolve import InputError, Problem, tracks, vehicles
from mpsolve.outcome import Reason
from mpsolve.problem.over import Over
from mpsolve.ranges.entry import Entry
from mpsolve.ranges.table import Table
from mpsolve.report.range_table import read_table, summary, table_csv, table_json, table_tex

PROBLEM = Problem(tracks.String(T=1, m=1, k=1, c=1), vehicles.Mass(1), v="0.5")
WHOLE = (Fraction(0), Fraction(10))
OPEN = Reason("effort", "spent", {}, "more")
ENTRIES = (
    (Entry("proved", "12.5", WHOLE, None, (arb(3.5, 0.25),)), Entry("stable", "stable", WHOLE)),
    (Entry("undecided", "undecided", WHOLE, OPEN), Entry("unstable", "unstable", WHOLE)),
)  # fmt: skip
TABLE = Table(
    "onset", Over("v", *WHOLE, "m/s", "km/h"), ("track.k_pad", (Fraction(1), Fraction(1, 2))),
    ("d", (Fraction(2), Fraction(5, 2))), 6, ENTRIES, "50 % & more",
)  # fmt: skip


def test_csv_has_the_grid_and_the_unit() -> None:
    rows = list(csv.reader(io.StringIO(table_csv(TABLE))))
    assert rows == [
        ["track.k_pad \\ d: onset of v [km/h]", "2", "2.5"],
        ["1", "12.5", "stable"],
        ["0.5", "undecided", "unstable"],
    ]


def test_json_has_balls_and_reasons() -> None:
    content = json.loads(table_json(TABLE))
    ((first, _), (third, _)) = content["entries"]
    (((middle, shift), (radius, scale)),) = first["balls"]
    assert int(middle) * 2.0**shift == 3.5
    assert 0.25 <= int(radius) * 2.0**scale < 0.2501
    assert third["reason"]["code"] == "effort"
    assert content["over"] == {"path": "v", "low": "0", "high": "10", "unit": "km/h", "si": "m/s"}


def test_latex_has_nothing_that_it_reads_otherwise() -> None:
    text = table_tex(TABLE)
    assert "\\texttt{track.k\\_pad} & $2$ & $2.5$ \\\\" in text
    assert "$1$ & $12.5$ & stable \\\\" in text
    assert "{$d$}" in text
    assert text.startswith("% 50 % & more\n")


def test_the_summary_counts() -> None:
    assert summary(TABLE).startswith("4 entries: 1 proved, 1 stable, 1 unstable, 1 undecided. ")


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("over = ", "# "), "over: is missing"),
        (('over = "v=0..1"', "over = 3"), "over: is a number, not a text"),
        (("values = [1, 2]", "values = 1"), r"rows\.values: is"),
        (("values = [1, 2]", "values = { start = 0, stop = 1, step = 1e-7 }"), "makes 10000001 values"),
        (("[columns]", "[pillars]"), "pillars"),
    ],
)
def test_what_a_file_gets_wrong_is_named(change: tuple[str, str], said: str, tmp_path: Path) -> None:
    text = 'problem = "a.toml"\nover = "v=0..1"\n[rows]\nparameter = "track.k"\nvalues = [1, 2]\n[columns]\n'
    text += 'parameter = "vehicles.M"\nvalues = [1]\n'
    track = '[track]\nmodel = "string"\nT = 1\nm = 1\nk = 1\nc = 1\n'
    (tmp_path / "a.toml").write_text(f'v = 0.5\n{track}[[vehicle]]\nmodel = "mass"\nM = 1\n', encoding="utf-8")
    (tmp_path / "table.toml").write_text(text.replace(*change), encoding="utf-8")
    with pytest.raises(InputError, match=said):
        read_table(tmp_path / "table.toml")
