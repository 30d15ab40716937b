"""Tables of onsets: the known values, every digit correctly rounded, the same for any number of workers."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from flint import arb

from mpsolve.errors import CertificateError, InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.exact import Exact
from mpsolve.problem import specs
from mpsolve.stability import table
from mpsolve.stability.table import Entry, OnsetTable, onset_table
from mpsolve.stability.table_text import _prose

EXAMPLES = Path(__file__).parents[2] / "examples"
ONSET, MASS, RANGES = table.QUANTITIES
ONE_MASS: dict[str, Any] = {
    "quantity": ONSET,
    "fixed": {"masses": 1, "alpha": ["0.99", "1.1"]},
    "rows": {"parameter": "eta_b", "values": ["0.05", 0]},
    "columns": {"parameter": "eta_m", "values": [70, 80]},
}


def grid(parameter: str, *values: object) -> dict[str, object]:
    return {"parameter": parameter, "values": list(values)}


def one(**changes: Any) -> Entry:
    """The single entry of a table with one row and one column."""
    spec = {"quantity": ONSET, "rows": grid("eta_m", 70), "columns": grid("d", "1.5")} | changes
    return onset_table(spec, workers=1).entries[0][0]


@pytest.fixture(scope="module")
def made() -> OnsetTable:
    return onset_table(ONE_MASS, workers=1)


def test_two_masses() -> None:
    entry = one(digits=16, fixed={"eta_b": "0.05", "alpha": ["0.66", "0.67"]})
    assert (entry.status, entry.value, entry.reason) == ("proved", "0.6669189572845496", "")
    assert entry.ball is not None
    with ball_arithmetic(200):
        assert abs(entry.ball - arb("0.666918957284549573")) < arb("1e-17")
    assert entry.certificate is not None
    assert entry.certificate.content["kind"] == "crossings"


def test_one_mass_among_distances() -> None:
    fixed = {"eta_b": "0.05", "alpha": ["1.05", "1.1"]}
    entry = one(digits=20, fixed=fixed, columns=grid("d", "one mass"))
    assert entry.value == "1.0749004571386740524"


def test_onset_mass() -> None:
    spec = {"quantity": MASS, "digits": 32, "fixed": {"eta_b": "0.1", "d": "1.1"}}
    spec |= {"rows": grid("alpha", "0.99"), "columns": grid("eta_n", 0)}
    assert onset_table(spec, workers=1).entries[0][0].value == "21.885372513990844653952782919388"
    still = onset_table(spec | {"fixed": {"eta_b": 0, "d": "1.1"}}, workers=1).entries[0][0]
    assert (still.status, still.value, still.reason) == ("stable", None, "stable for every mass")


def test_all_ends() -> None:
    spec = {"quantity": RANGES, "digits": 18, "fixed": {"eta_b": "0.05", "alpha": ["0.88", "0.97"]}}
    spec |= {"rows": grid("eta_m", 50), "columns": grid("d", "1.5")}
    found = onset_table(spec, workers=1)
    entry = found.entries[0][0]
    assert entry.value == "[0.88, 0.886090895755563193) (0.967198482398974872, 0.97]"
    assert [span.roots for span in entry.spans] == [2, 2]
    assert json.loads(found.to_json())["entries"][0][0]["spans"][0]["starts_at_crossing"] is False
    assert "all velocity ratios" in found.to_latex()


def test_statuses(made: OnsetTable) -> None:
    assert [[entry.status for entry in row] for row in made.entries] == [["proved"] * 2, ["undecided"] * 2]
    assert not made.proved
    assert "the cuts join" in made.entries[1][0].reason
    assert " (open: alpha in [1, 1.0" in made.entries[1][0].reason
    assert (made.rows, made.columns) == ((Exact("0.05"), Exact(0)), (Exact(70), Exact(80)))
    fixed = {"eta_b": "0.05", "masses": 1}
    for alpha, status, said in (
        (["0.9", "0.95"], "stable", "no onset for alpha in [0.9, 0.95]"),
        (["1.08", "1.1"], "unstable", "unstable from alpha = 1.08 on, the start of the range"),
    ):
        entry = one(fixed=fixed | {"alpha": alpha}, columns=grid("eta_n", 0))
        assert (entry.status, entry.value, entry.reason, entry.text) == (status, None, said, status)


def test_fewer_digits_are_the_rounded_ones(made: OnsetTable) -> None:
    ball = made.entries[0][0].ball
    assert ball is not None
    for digits in (1, 7, 14):
        value = one(
            digits=digits, fixed={"eta_b": "0.05", "masses": 1, "alpha": ["1.05", "1.1"]}, columns=grid("eta_n", 0)
        ).value
        assert value is not None
        places = len(value.partition(".")[2])
        with ball_arithmetic(200):
            assert abs(ball - arb(value)) <= arb(10) ** -places / 2
        assert len(value.replace(".", "")) == digits


def test_any_number_of_workers(made: OnsetTable) -> None:
    told: list[tuple[str, float]] = []
    other = onset_table(ONE_MASS, workers=2, progress=lambda stage, part: told.append((stage, part)))
    assert other.to_json() == made.to_json()
    assert other == made
    assert told == [("table", k / 4) for k in (1, 2, 3, 4)]


def test_csv(made: OnsetTable) -> None:
    lines = list(csv.reader(io.StringIO(made.to_csv())))
    assert lines[0] == ["eta_b \\ eta_m", "70", "80", "note"]
    assert lines[1] == ["0.05", "1.07490045713867", made.entries[0][1].value, ""]
    assert lines[2][:3] == ["0", "undecided", "undecided"]
    assert lines[2][3].startswith("eta_m = 70: at alpha_C the cuts join")


def test_json(made: OnsetTable) -> None:
    data = json.loads(made.to_json())
    assert (data["format"], data["version"], data["quantity"]) == ("mpsolve table", 1, ONSET)
    assert data["alpha"] == {"start": "0.99", "end": "1.1"}
    assert data["rows"] == {"parameter": "eta_b", "values": ["0.05", "0"]}
    entry = data["entries"][0][0]
    assert entry["value"] == "1.07490045713867"
    assert abs(Fraction(entry["ball"]["value"]) - Fraction("1.0749004571386740524")) < Fraction(1, 10**18)
    assert data["entries"][1][1]["value"] is None


def test_latex(made: OnsetTable) -> None:
    text = made.to_latex()
    assert text.count("\\begin{tabular}{lll}") == text.count("\\end{tabular}") == 1
    assert "$0.05$ & $1.07490045713867$ & " in text
    assert "$0$ & undecided$^{1}$ & undecided$^{2}$ \\\\" in text
    assert "the cuts join: start above it" in text
    assert _prose("a_b 5% alpha < x^2 of eta_n") == "a\\_b 5\\% $\\alpha$ $<$ x$^2$ of $\\eta_N$"
    assert all(text.count(mark) == 1 for mark in ("\\toprule", "\\midrule", "\\bottomrule"))
    assert text.count("$") % 2 == 0


def test_files(made: OnsetTable, tmp_path: Path) -> None:
    for name, text in (("a.csv", made.to_csv()), ("a.JSON", made.to_json()), ("a.tex", made.to_latex())):
        assert made.save(tmp_path / name).read_text("utf-8") == text
    with pytest.raises(InputError, match=r"^output: .*a\.txt does not end in \.csv, \.json, \.tex"):
        made.save(tmp_path / "a.txt")
    saved = made.save_certificates(tmp_path / "new" / "folder")
    assert [path.name for path in saved] == ["eta_b_0.05-eta_m_70.json", "eta_b_0.05-eta_m_80.json"]
    assert made.entries[0][1].certificate is not None
    assert saved[1].read_text("utf-8") == made.entries[0][1].certificate.text
    with pytest.raises(CertificateError, match="cannot be made"):
        made.save_certificates(tmp_path / "a.csv")


def test_names_of_certificates() -> None:
    rows, columns = specs.Grid("d", ("one mass", Exact("1/3"))), specs.Grid("eta_n", (Exact("-0.5"),))
    named = OnsetTable("", ONSET, 15, {}, None, rows, columns, ())
    assert [named.certificate_name(i, 0) for i in (0, 1)] == ["d_one_mass-eta_n_-0.5.json", "d_#2-eta_n_-0.5.json"]


def test_what_cannot_be_computed_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise PrecisionError("too wide")

    monkeypatch.setattr(table, "onset_search", fail)
    entry = one(fixed={"eta_b": "0.05"})
    assert (entry.status, entry.reason) == ("undecided", "too wide")


@pytest.mark.parametrize(
    ("name", "shape", "first"),
    [("figure12", (100, 7), (1, ("1",), ("0",))), ("onset_table", (3, 3), (2, ("50", "50"), ("0", "1")))],
)
def test_examples_are_what_they_say(
    name: str, shape: tuple[int, int], first: tuple[int, object, object], monkeypatch: pytest.MonkeyPatch
) -> None:
    jobs: list[Any] = []

    def collect(_work: object, given: list[Any], *_: object) -> list[Entry]:
        jobs.extend(given)
        return [Entry("stable")] * len(given)

    monkeypatch.setattr(table, "run_bunches", collect)
    found = onset_table(EXAMPLES / f"{name}.toml")
    assert (len(found.entries), len(found.entries[0])) == shape
    assert found.title
    case = jobs[0].case
    assert (case.count, tuple(map(str, case.eta_m)), tuple(map(str, case.positions))) == first
    assert jobs[0].case.eta_b == Exact("0.05")


def changed(**changes: object) -> dict[str, object]:
    spec = {
        "quantity": ONSET,
        "fixed": {"eta_b": "0.05"},
        "rows": grid("eta_m", 70),
        "columns": grid("d", 1),
    } | changes
    return {key: value for key, value in spec.items() if value is not None}


@pytest.mark.parametrize(
    ("spec", "said"),
    [
        (changed(quanity=ONSET), r"^quanity: is unknown: did you mean quantity\?"),
        (changed(quantity=None), r"^quantity: is missing: give one of "),
        (changed(quantity="onset speed"), r'^quantity: is .* did you mean "onset \w+"\?'),
        (changed(quantity=3), r"^quantity: is a number: give one of "),
        (changed(title=1), r"^title: is a number, not a text"),
        (changed(digits=0), r"^digits: is 0: give a whole number"),
        (changed(digits=2.5), r"^digits: is 2.5"),
        (changed(rows=None), r"^rows: is missing: add \[rows\]"),
        (changed(rows=[1]), r"^rows: is a list, not a section"),
        (changed(rows={"parameter": "d"}), r"^rows.values: is missing"),
        (changed(rows={"parameter": "d", "value": [1]}), r"^rows.value: is unknown: did you mean values\?"),
        (changed(rows=grid("eta_M", 1)), r'^rows.parameter: is .*did you mean "eta_m"\?'),
        (changed(rows=grid("alpha", 1)), r"^rows.parameter: is 'alpha'"),
        (changed(rows=grid("d", 2)), r"^columns.parameter: is d, as in rows"),
        (changed(rows=grid("eta_m")), r"^rows.values: is empty"),
        (changed(rows=grid("eta_m", 1, "x")), r"^rows.values\[2\]: 'x' is not a number"),
        (changed(rows=grid("eta_m", "0.5", "1/2")), r"^rows.values\[2\]: is 0.5, which is there already"),
        (changed(rows=grid("eta_m", 1, -1)), r"^rows.values\[2\]: is -1, but must be above 0"),
        (changed(columns=grid("d", 0)), r"^columns.values\[1\]: is 0, but must be above 0"),
        (changed(rows={"parameter": "eta_m", "values": 3}), r"^rows.values: is a number: give a list"),
        (changed(rows={"parameter": "eta_m", "values": {"start": 1, "stop": 2}}), r"^rows.values.step: is missing"),
        (changed(rows={"parameter": "eta_m", "values": {"start": 1, "stop": 2, "stepp": 1}}), r"did you mean step\?"),
        (
            changed(rows={"parameter": "eta_m", "values": {"start": 1, "stop": 2, "step": -1}}),
            r"^rows.values.step: is -1, which does not lead",
        ),
        (
            changed(rows={"parameter": "eta_m", "values": {"start": 1, "stop": 2, "step": "1e-9"}}),
            r"^rows.values.step: makes 1000000001 values",
        ),
        (changed(fixed={"eta_b": 1, "etan": 0}), r"^fixed.etan: is unknown: did you mean eta_n\?"),
        (changed(fixed={"eta_b": 1, "d": 0}), r"^fixed.d: is given in columns too"),
        (changed(fixed={}), r"^fixed.eta_b: is missing: give the damping ratio"),
        (changed(fixed={"eta_b": "-1"}), r"^fixed.eta_b: is -1"),
        (changed(fixed={"eta_b": 1, "eta_n": 2}), r"^fixed.eta_n: eta_n − eta_s is 2|^fixed.eta_n: "),
        (changed(fixed={"eta_b": 1, "masses": 4}), r"^fixed.masses: is 4: give 1, 2 or 3"),
        (changed(fixed={"eta_b": 1, "masses": 1}), r"^fixed.masses: is 1, but a distance"),
        (changed(fixed={"eta_b": 1, "alpha": 1}), r"^fixed.alpha: is a number, but alpha is looked for"),
        (changed(fixed={"eta_b": 1, "alpha": [1, 1]}), r"^fixed.alpha: ends at 1"),
        (changed(fixed={"eta_b": 1, "alpha": [-1, 1]}), r"^fixed.alpha: starts at -1"),
        (changed(columns=grid("eta_s", 0)), r"^fixed.d: is missing: give the distance of the masses"),
        (changed(quantity=MASS, rows=grid("eta_n", 0)), r"^fixed.alpha: is missing"),
        (changed(quantity=MASS, rows=grid("alpha", 1), fixed={"eta_b": 1, "eta_m": 1}), r"^fixed.eta_m: is given"),
        (changed(quantity=MASS, rows=grid("eta_n", 0), fixed={"eta_b": 1, "alpha": [0, 1]}), r"^fixed.alpha: is a r"),
        (3, r"^spec: is a number: give a mapping"),
        ("no/such.toml", r"^no/such.toml: does not exist"),
    ],
)
def test_bad_specs_name_their_key(spec: Any, said: str) -> None:
    with pytest.raises(InputError, match=said):
        onset_table(spec, workers=1)


@pytest.mark.parametrize("workers", [0, -1, 1.5, True])
def test_bad_workers(workers: Any) -> None:
    with pytest.raises(InputError, match=r"^workers: "):
        onset_table(changed(), workers=workers)


def test_steps_are_exact_and_inclusive() -> None:
    content: Mapping[str, Any] = {
        "rows": {"parameter": "d", "values": {"start": "0.1", "stop": "0.3", "step": "0.1"}}
    }
    assert specs.grid(content, "rows", ("d",)).labels == ("0.1", "0.2", "0.3")
    content = {"rows": {"parameter": "d", "values": {"start": 3, "stop": "1.1", "step": -1}}}
    assert specs.grid(content, "rows", ("d",)).labels == ("3", "2")
