"""Input that cannot be used: one sentence, exit status 2, no file."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

CASE = "[dimensionless]\nalpha = 0.5\neta_b = 0.3\neta_m = [20]\npositions = [0]\n"
STUDY = '[study]\nkind = "certified"\nmasses = 1\n[parameters]\nalpha = 0.5\neta_b = 0.05\neta_m = 40\n'
LONG = "x" * 300


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (f"response case.toml -o {LONG}.csv", "File name too long"),
        (f"compare case.toml -o {LONG}.csv", "File name too long"),
        (f"report case.toml -o {LONG}.html", "File name too long"),
        (f"certify case.toml -o {LONG}.json", "File name too long"),
        (f"onset case.toml -o {LONG}.json", "File name too long"),
        (f"table case.toml -o {LONG}.csv", "File name too long"),
        (f"chart case.toml -o {LONG}.svg", "File name too long"),
        (f"study study.toml -o {LONG}.sqlite", "File name too long"),
        (f"certify {LONG}.toml", "File name too long"),
        ("response case.toml -o plain", "plain does not end in .csv, .json, .npz"),
        ("study study.toml -o s.sqlite --dask nonsense", "--dask: is 'nonsense'"),
        (
            "receptance fast.toml --omega 0,1,3",
            "--omega: has points where the receptance is infinite, or out of float64's reach",
        ),
        ("report table.toml", "quantity: is unknown"),
        ("chart study.toml -o c.svg", "study.toml: is a study, as its [study] shows: use mpsolve study study.toml"),
        ("status case", "case does not exist"),
        ("export . --to csv", ". is a directory"),
    ],
)
def test_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: str, said: str) -> None:
    monkeypatch.chdir(tmp_path)
    files = {
        "case.toml": CASE,
        "fast.toml": CASE.replace("0.5", "1e300"),
        "study.toml": STUDY,
        "table.toml": 'quantity = "onset velocity"\n',
    }
    for name, text in files.items():
        Path(name).write_text(text, "utf-8")
    done = CliRunner().invoke(cli, words.split())
    assert done.exit_code == 2
    assert (done.stdout, len(done.stderr.splitlines())) == ("", 1)
    assert done.stderr.startswith("mpsolve: ")
    assert said in done.stderr
    assert {one.name for one in tmp_path.iterdir()} == files.keys()
