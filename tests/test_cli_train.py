"""The command train: words and JSON, exit statuses, one sentence for what cannot be."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

EXAMPLES = Path(__file__).parents[1] / "examples"


def test_it_says_that_disturbances_grow_along_a_stable_train() -> None:
    done = CliRunner().invoke(cli, ["train", str(EXAMPLES / "endless_train.toml")])
    assert done.exit_code == 0
    assert "grows as it runs back" in done.output
    assert "train of 16: stable" in done.output
    assert "back: at most between 7.0697 and 7.06972" in done.output


def test_json_holds_the_same() -> None:
    done = CliRunner().invoke(cli, ["train", str(EXAMPLES / "endless_train.toml"), "--json"])
    content = json.loads(done.output)
    assert (content["stable"], content["train"]["stable"], content["train"]["count"]) == (False, True, 16)
    assert content["computed"]["long_trains_grow"] is False
    assert 7.06 < content["train"]["back"]["low"] <= content["train"]["back"]["high"] < 7.08


@pytest.mark.parametrize("words", [["--spacing", "0"], []])
def test_one_vehicle_needs_a_distance(words: list[str], tmp_path: Path) -> None:
    file = tmp_path / "one.toml"
    text = (EXAMPLES / "endless_train.toml").read_text("utf-8")
    file.write_text(text.replace("count = 16\nspacing = 1.5\n", ""), encoding="utf-8")
    done = CliRunner().invoke(cli, ["train", str(file), *words])
    assert done.exit_code == 2
    assert "spacing" in done.output


@pytest.mark.slow
def test_eight_coaches_are_answered_within_their_time() -> None:
    done = CliRunner().invoke(cli, ["train", str(EXAMPLES / "train_8_coaches.toml"), "--effort", "4"])
    assert done.exit_code in (0, 1)
    assert "no motion grows" in done.output or "undecided" in done.output
    assert "train of 8: stable" in done.output
    assert "back: " in done.output
