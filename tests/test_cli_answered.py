"""How commands about ranges ask where no range is given, and write answers of several parts."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

from mpsolve import cli_answered
from mpsolve.cli import cli
from mpsolve.cli_answered import _by_default, _certify
from mpsolve.errors import CertificateError
from mpsolve.presets.written import input_file, problem_of
from mpsolve.problem.inputfile import read_source
from mpsolve.report.ranges_asked import Asked, asked
from mpsolve.report.ranges_words import Said, _skipped

SOURCE = read_source("examples/two_layer_bogie.toml")
PAIR = read_source("examples/rail_60e1.toml")


def questions(source: Any, defaults: str, grows: bool = False, proved: bool = True) -> list[Asked]:
    """What is asked one after another, of an answerer that always says the same."""
    seen: list[Asked] = []

    def answer(question: Asked, _tell: object) -> Said:
        seen.append(question)
        found: Any = SimpleNamespace(proved=proved)
        return Said("onset", found, question, "", "", grows)

    _by_default(asked(source.given, source.title, ()), answer, None, defaults)
    return seen


def test_velocities_step_by_step_up_to_the_first_onset() -> None:
    everything = questions(SOURCE, "first")
    assert [one.over["v"][0] for one in everything[1:]] == [one.over["v"][1] for one in everything[:-1]]
    assert everything[0].over["v"][0] == 0
    assert len(questions(SOURCE, "first", grows=True)) == len(questions(SOURCE, "first", proved=False)) == 1
    assert len(everything) > 1


def test_a_gap_and_a_chart() -> None:
    (gap,) = questions(PAIR, "gap")
    assert gap.over == {"gap[0]": (PAIR.given.masses[1].position.as_fraction() / 2, 2 * gap.overs[0].low * 2)}
    (chart,) = questions(SOURCE, "chart")
    low, high = chart.over["v"]
    assert low <= 100 <= high
    assert set(chart.over) == {"v", "scale.mass"}


def test_certificates_of_several_parts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    saved: list[Path] = []
    one: Any = SimpleNamespace(answer=SimpleNamespace(certificate=SimpleNamespace(save=saved.append), note=""))
    _certify(tmp_path / "c.json", [one, one], quiet=False)
    assert [path.name for path in saved] == ["c.json", "c-2.json"]
    assert capsys.readouterr().out.split() == [str(path) for path in saved]
    one.answer.certificate, one.answer.note = None, "it is undamped"
    with pytest.raises(CertificateError, match="no certificate is written: it is undamped"):
        _certify(tmp_path / "c.json", [one], quiet=False)


def test_parts_are_told_as_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mpsolve.report.ranges_data.ranges_data", lambda name, *_: {"question": name})
    one: Any = SimpleNamespace(name="onset", verdict="", answer=None, asked=None)
    assert cli_answered._data([one]) == {"question": "onset"}
    assert json.loads(json.dumps(cli_answered._data([one, one])))["parts"] == [{"question": "onset"}] * 2


def sheared() -> Any:
    """The ballast of a three-layer track with shear, whose waves run at √(47e6/(2657/3)) = 230.4 m/s."""
    problem = problem_of("zhai-2004", "manchester")[0].changed("track.shear", "47 MN")
    return SimpleNamespace(given=problem, title="")


def test_velocities_round_a_wave_speed_are_skipped_and_said() -> None:
    for defaults in ("near", "first"):
        seen = questions(sheared(), defaults)
        ends = [(one.skipped, one.over["v"]) for one in seen]
        reached: Any = 0
        for skipped, (low, high) in ends:  # no velocity is left out without a word
            assert (skipped or (reached, low)) == (reached, low)
            assert skipped is not None or low == reached
            reached = high
        (left_out,) = [skipped for skipped, _ in ends if skipped]
        assert left_out[0] ** 2 < 47 * 10**6 / Fraction(2657, 3) < left_out[1] ** 2
        (said,) = [line for one in seen for line in _skipped(one)]
        assert said == (
            "Nothing is said of v from 821 km/h to 837.6 km/h, round a wave speed "
            "(shear waves of the ballast, √(shear/m_ballast)): certify decides single ones."
        )


def test_the_report_says_so(tmp_path: Path) -> None:
    file = tmp_path / "wire.toml"
    file.write_text(input_file("contact-wire"), "utf-8")
    shown = CliRunner().invoke(cli, ["onset", str(file)])
    assert (
        "Nothing is said of v from 566.1 km/h to 577.6 km/h, round a wave speed (waves of the string" in shown.stdout
    )
