"""How commands about ranges ask where no range is given, and write answers of several parts."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from mpsolve import cli_answered
from mpsolve.cli_answered import _by_default, _certify
from mpsolve.errors import CertificateError
from mpsolve.problem.inputfile import read_source
from mpsolve.report.ranges_asked import Asked, asked
from mpsolve.report.ranges_words import Said

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
