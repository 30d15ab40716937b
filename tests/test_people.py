"""What people stumbled over, each with the answer that is right: the engine for any track, from file to report."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from mpsolve import Case, PhysicalCase, Problem, certify, frequencies, read_problem, tracks, vehicles
from mpsolve.cli import cli
from mpsolve.page.charts import chart
from mpsolve.page.parts import gather
from mpsolve.problem.over import parse_over
from mpsolve.report.spectrum_data import spectrum_data
from mpsolve.report.spectrum_text import spectrum_document

CATENARY = """
v = "139 m/s"
[track]
model = "euler-bernoulli"
EI = 130
m = 1.35
k = 100
c = 0.5
N = "-20 kN"
[[vehicle]]
model = "mass"
M = 10
count = 2
spacing = 1
"""
RAIL = PhysicalCase(EI="6.4e6", m=60, k="1e6", c=770, v=200, masses=[(10000, 0), (10000, "3.4")])


@pytest.fixture
def catenary(tmp_path: Path) -> Problem:
    file = tmp_path / "catenary.toml"
    file.write_text(CATENARY, "utf-8")
    return read_problem(file).problem


def test_a_catenary_is_asked_about_at_velocities_of_trains(catenary: Problem) -> None:
    """A range in ratios ended at 26 m/s, where all is quiet; in SI it holds the file's velocity, or says that not."""
    found = certify(catenary, region="unstable", digits=15)
    assert (found.proved, found.stable) == (True, False)
    assert parse_over("v=0..500.4 km/h", catenary).outside(catenary) is None
    assert parse_over("v=0..", catenary).high is None
    told = parse_over("v=0..26", catenary).outside(catenary)
    assert told is not None
    assert "v is 139 m/s, outside the range from 0 to 26 m/s" in str(told)


def _exact_numbers(data: Any) -> list[dict[str, str]]:
    if isinstance(data, dict):
        inner = [one for value in data.values() for one in _exact_numbers(value)]
        return [data] if "exact" in data else inner
    return [one for value in data for one in _exact_numbers(value)] if isinstance(data, list) else []


def test_json_has_a_decimal_beside_every_exact_number() -> None:
    data = spectrum_data(certify(RAIL, digits=15, check=False))
    numbers = _exact_numbers(data)
    assert len(numbers) >= 10
    for one in numbers:
        assert float(one["decimal"]) == pytest.approx(eval(one["exact"], {}))  # "6400000", "17/5"
    assert not any("root4" in text for text in json.dumps(data["problem"]).split('"'))


def test_a_case_in_si_is_answered_in_si() -> None:
    found = certify(RAIL, digits=15, check=False)
    masses = [vehicles.Mass(10000).at(x) for x in (0, "3.4")]
    problem = Problem(tracks.EulerBernoulli("6.4e6", 60, "1e6", 770), masses, v=200)
    same = certify(problem, region="unstable", digits=15, check=False)
    (grows,) = (root for root in found.roots if root.q.imag < 0 and root.q.real > 0)
    (again,) = (root for root in same.roots if root.q.real > 0)
    assert grows.q.overlaps(again.q)
    text = spectrum_document(found).text()
    first_screen = text[: text.index("Proved")]
    assert "at 720 km/h (200 m/s)" in text.splitlines()[0]
    assert "[Hz]" in first_screen
    assert "[1/s]" in first_screen
    assert not any(ratio in first_screen for ratio in ("η_M", "α ", "τ", "χ"))


def test_counts_agree() -> None:
    """One vibration in the verdict, one row that grows; its two roots q and −q̄ are named as such in the proof."""
    found = certify(RAIL, region="unstable", digits=15, check=False)
    text = spectrum_document(found).text()
    assert found.unstable == 2
    assert ": a vibration at 3.062 Hz doubles every 19.24 s." in text
    assert text.count("GROWS") == 1
    assert "exactly 2 zeros, counted with multiplicity" in " ".join(text.split())
    assert "−q̄ is a zero too, and both are one vibration" in " ".join(text.split())


def test_a_page_is_not_written_under_the_name_of_another_kind(tmp_path: Path) -> None:
    file = tmp_path / "case.toml"
    file.write_text("[dimensionless]\nalpha = 0.5\neta_b = 0.1\neta_m = [1]\npositions = [0]\n", "utf-8")
    for name in ("x.docx", "x.pdf", "x"):
        result = CliRunner().invoke(cli, ["report", str(file), "-o", str(tmp_path / name)])
        assert result.exit_code == 2
        assert ".html" in result.stderr.lower()
        assert not (tmp_path / name).exists()


def test_the_onset_of_a_contact_wire_is_found_where_it_runs(tmp_path: Path) -> None:
    """The command, asked about v = 0 … 500.4 km/h, does not call stable what `certify` proves unstable at 139 m/s."""
    file = tmp_path / "catenary.toml"
    file.write_text(CATENARY, "utf-8")
    done = CliRunner().invoke(cli, ["onset", str(file), "--over", "v=100..140", "--effort", "20"])
    assert "STABLE for every v" not in done.output
    asked = CliRunner().invoke(cli, ["onset", str(file), "--over", "v=0..26"])
    assert "Warning: v is 139 m/s, outside the range" in asked.output


@pytest.mark.parametrize("points", [101, 301, 1001])
def test_the_time_of_lift_off_does_not_depend_on_the_times_that_are_asked_for(points: int, tmp_path: Path) -> None:
    rail = str(Path(__file__).parents[1] / "examples/rail_60e1.toml")
    words = ["response", rail, "-o", str(tmp_path / "a.csv"), "--to", "0.5s", "--points", str(points)]
    done = CliRunner().invoke(cli, words)
    assert done.exit_code == 0, done.output
    assert "contact 1 lifts off at t = 0.317316" in done.output


@pytest.mark.parametrize("number", [3, 4])
def test_a_page_of_many_masses_comes_back_whole(number: int) -> None:
    """Three masses were undecided with an empty chart, four came to no end: now within the budget, with a chart."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=[70] * number, positions=[f"{1.5 * k}" for k in range(number)])
    parts = gather(case, "", digits=15, seconds=60, tell=lambda *_: None)
    assert parts.spectrum.proved
    assert parts.verdict.startswith("STABLE")
    assert parts.reach.value is not None
    assert parts.reach.value.kind.value == "crosses"
    drawn = chart(parts)
    assert drawn is not None
    assert "hatched: " in drawn.svg
    assert parts.late == ()


def test_two_cases_of_one_name_keep_their_certificates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for folder, M in (("a", 900), ("b", 950)):
        (tmp_path / folder).mkdir()
        track = 'v = 10\n[track]\nmodel = "string"\nT = 20000\nm = 1\nk = 30\nc = 0.2\n'
        text = f'{track}[[vehicle]]\nmodel = "mass"\nM = {M}\n'
        (tmp_path / folder / "case.toml").write_text(text, "utf-8")
        done = CliRunner().invoke(cli, ["certify", f"{folder}/case.toml", "--region", "unstable", "--digits", "15"])
        assert done.exit_code == 0, done.output
    assert len(list(tmp_path.glob("case*.certificate.json"))) == 2


def test_a_table_is_named_as_one() -> None:
    table = str(Path(__file__).parents[1] / "examples/onset_table.toml")
    done = CliRunner().invoke(cli, ["certify", table])
    assert done.exit_code == 2
    assert done.stderr == f"mpsolve: {table}: is a table, as its [rows] shows: use mpsolve table {table}\n"


def test_answers_about_an_si_file_are_in_si(tmp_path: Path) -> None:
    """Options take units, headers name them, and JSON has a decimal beside each exact number."""
    rail = str(Path(__file__).parents[1] / "examples/rail_60e1.toml")
    CliRunner().invoke(cli, ["response", rail, "-o", str(tmp_path / "a.csv"), "--to", "0.1 s", "--xi", "0,3.4"])
    header = (tmp_path / "a.csv").read_text("utf-8").splitlines()[0]
    assert header.startswith("t [s],w at x = 0 m [m]")
    assert "w at x = 3.4 m [m]" in header
    asked = CliRunner().invoke(cli, ["onset", rail, "--over", "v=500..750 km/h", "--json"])
    numbers = _exact_numbers(json.loads(asked.stdout))
    assert {"1250/9", "625/3"} <= {one["exact"] for one in numbers}
    for one in numbers:
        assert float(one["decimal"]) == pytest.approx(float(Fraction(one["exact"])))


def test_two_masses_are_no_two_cases() -> None:
    """Lists of masses and places mean one problem everywhere; arrays are given by the path of what they vary."""
    with pytest.raises(TypeError):
        frequencies(0.67, 0.05, [70, 70], [0, 1.5])  # type: ignore[call-arg, arg-type]
    case = Case(alpha="0.67", eta_b="0.05", eta_m=[70, 70], positions=[0, "1.5"])
    assert frequencies(case).count.shape == ()
    assert int(frequencies(case).count) == 2
