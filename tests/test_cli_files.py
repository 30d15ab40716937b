"""Files as they come: standard input, a file of another kind, two files of one name."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

EXAMPLES = Path(__file__).parents[1] / "examples"
STRING = (
    'v = 10\n[track]\nmodel = "string"\nT = 20000\nm = 1\nk = 30\nc = 0.2\n[[vehicle]]\nmodel = "mass"\nM = {M}\n'
)
QUICK = ("--region", "unstable", "--digits", "15")


@pytest.fixture(autouse=True)
def _inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def run(*arguments: str, stdin: str | None = None) -> tuple[int, str, str]:
    result = CliRunner().invoke(cli, arguments, input=stdin)
    return result.exit_code, result.stdout, result.stderr


def test_a_dash_reads_standard_input(tmp_path: Path) -> None:
    status, out, _ = run("certify", "-", *QUICK, stdin=STRING.format(M=10))
    assert (status, "STABLE" in out) == (0, True)
    assert (tmp_path / "stdin.certificate.json").is_file()
    assert run("certify", "-", stdin="v = ")[2].startswith("mpsolve: standard input: is not valid TOML")
    assert run("certify", "-", stdin="")[2].startswith("mpsolve: standard input: holds no problem")


@pytest.mark.parametrize(
    ("command", "file", "said"),
    [
        ("certify", "onset_table.toml", "is a table, as its [rows] shows: use mpsolve table"),
        ("certify", "study_certified.toml", "is a study, as its [study] shows: use mpsolve study"),
        ("receptance", "onset_table.toml", "is a table, as its [rows] shows: use mpsolve table"),
        ("table", "rail_60e1.toml", "is a case, as its [physical] shows: use mpsolve certify"),
        ("table", "two_layer_bogie.toml", "is a problem, as its [track] shows: use mpsolve certify"),
        ("table", "study_certified.toml", "is a study, as its [study] shows: use mpsolve study"),
    ],
)
def test_another_kind_of_file_is_named(command: str, file: str, said: str) -> None:
    path = EXAMPLES / file
    more = ("--omega", "1,2,2") if command == "receptance" else ()
    status, out, err = run(command, str(path), *more)
    assert (status, out) == (2, "")
    assert err == f"mpsolve: {path}: {said} {path}\n"


def test_a_certificate_is_no_input() -> None:
    status, _, err = run("certify", str(EXAMPLES.parent / "certs" / "two_layer_bogie.json"))
    assert status == 2
    assert "is JSON, not TOML: a certificate is checked by mpsolve verify" in err


def test_two_files_of_one_name_leave_two_certificates(tmp_path: Path) -> None:
    for folder, mass in (("a", 10), ("b", 20), ("a", 10)):
        (tmp_path / folder).mkdir(exist_ok=True)
        file = tmp_path / folder / "case.toml"
        file.write_text(STRING.format(M=mass), "utf-8")
        assert run("certify", str(file), *QUICK)[0] == 0
    made = sorted(tmp_path.glob("*.json"))
    assert len(made) == 2
    masses = {json.loads(file.read_text("utf-8"))["equations"]["vehicle"]["M"][0][0] for file in made}
    assert masses == {"10", "20"}
    assert run("verify", *map(str, made))[0] == 0
