"""The commands response and compare, from a file to a file."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from mpsolve import Case
from mpsolve.cli import cli
from mpsolve.model.load import Load
from mpsolve.motion import merged, response, superposition

TEXT = """title = "two"
[dimensionless]
alpha = 0.67
eta_b = 0.05
eta_m = [70, 70]
positions = [0, 1.5]
[[load]]
constant = 1
[[load]]
constant = 1
amplitude = 0.2
frequency = 0.3
"""
CASE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
LOADS = (Load(), Load(1, "0.2", "0.3"))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "case.toml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [str(a) for a in arguments])


def test_response_writes_tables_and_pictures(file: Path, tmp_path: Path) -> None:
    expected = response(CASE, LOADS, None, np.linspace(0, 20, 5))
    table = tmp_path / "out.csv"
    result = run("response", file, "-o", table, "--to", "20", "--points", "5")
    assert result.exit_code == 0, result.output
    assert "induced frequency" in result.output
    with table.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for k, row in enumerate(rows):
        assert float(row["tau"]) == expected.tau[k]
        assert float(row["w[xi=1.5]"]) == pytest.approx(expected.w[1, k], abs=1e-12)
        assert float(row["contact_force[1]"]) == pytest.approx(expected.contact_forces[0, k], abs=1e-12)
    arrays = tmp_path / "out.npz"
    assert run("response", file, "-o", arrays, "--to", "20", "--points", "5", "--xi", "0,0.5").exit_code == 0
    with np.load(arrays) as held:
        assert np.allclose(held["w"][0], expected.w[0], rtol=0, atol=1e-12)
        assert np.array_equal(held["xi"], [0, 0.5])
    pytest.importorskip("matplotlib")
    picture = tmp_path / "out.png"
    assert run("response", file, "-o", picture, "--to", "20", "--points", "50").exit_code == 0
    assert picture.read_bytes()[:4] == b"\x89PNG"


def test_compare_holds_the_curves_against_each_other(file: Path, tmp_path: Path) -> None:
    table = tmp_path / "out.csv"
    result = run("compare", file, "-o", table, "--to", "20", "--points", "3")
    assert result.exit_code == 0, result.output
    with table.open(encoding="utf-8", newline="") as stream:
        last = list(csv.DictReader(stream))[-1]
    tau = np.linspace(0, 20, 3)
    whole = response(CASE, LOADS, None, tau)
    assert float(last["complete"]) == pytest.approx(whole.w[0, -1], abs=1e-12)
    added = sum(part.w[0, -1] for part in superposition(CASE, LOADS, None, tau))
    assert float(last["superposition"]) == pytest.approx(added, abs=1e-12)
    assert float(last["one merged mass"]) == pytest.approx(merged(CASE, LOADS, None, tau).w[0, -1], abs=1e-12)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("response", "FILE", "-o", "x.txt"), ".csv"),
        (("response", "FILE", "-o", "x.csv", "--to", "-1"), "--to"),
        (("response", "FILE", "-o", "x.csv", "--xi", "a"), "xi"),
        (("compare", "FILE", "-o", "x.npz"), ".csv"),
    ],
)
def test_input_that_cannot_be_used_is_named(
    file: Path, tmp_path: Path, arguments: tuple[str, ...], said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = run(*(file if a == "FILE" else a for a in arguments))
    assert result.exit_code == 2
    assert said in result.output
    assert sorted(p.name for p in tmp_path.iterdir()) == ["case.toml"]
