"""Files as they come: standard input, a file of another kind, two files of one name."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click import Context
from click import Path as PathType
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
    assert "is a certificate, not an input file: check it with mpsolve verify" in err


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


ROOT = Path(__file__).parents[1]
FROM_STANDARD_INPUT = {
    "derive -": "rail_60e1",
    "certify - --region unstable -o a.json": "rail_60e1",
    "report - --effort 2 -o a.html": "rail_60e1",
    "onset - --over v=0..100km/h": "rail_60e1",
    "crossings - --over v=0..100km/h": "rail_60e1",
    "worst - --over vehicles.M=8..12t": "rail_60e1",
    "robust - --over v=0..80m/s": "rail_60e1",
    "chart - --over v=0..100km/h --over scale.mass=0.5..2 --depth 2": "rail_60e1",
    "worst - --over gap[0]=1..2": "dimensionless",
    "lines - --over v=0.4..0.5 --points 3": "dimensionless",
    "train -": "endless_train",
    "critical -": "rail_60e1",
    "receptance - --omega 1,2,3": "rail_60e1",
    "response - -o a.csv --to 1s": "rail_60e1",
    "compare - -o b.csv --to 0.1s": "rail_60e1",
    "table - --workers 1": "onset_table",
    "study - -o a.sqlite --workers 1": "study_certified",
    "verify -": "",
}


@pytest.mark.parametrize("words", FROM_STANDARD_INPUT)
def test_every_command_reads_standard_input(words: str, tmp_path: Path) -> None:
    name = FROM_STANDARD_INPUT[words]
    file = ROOT / f"examples/{name}.toml" if name else ROOT / "certs/single_mass.json"
    text = file.read_text("utf-8").replace('problem = "', f'problem = "{ROOT / "examples"}/')  # of a table
    status, out, said = run(*words.split(), stdin=text)
    assert status == 0, said
    assert out
    assert not list(tmp_path.glob("-*"))


def test_no_command_that_reads_a_file_is_left_out() -> None:
    """What takes FILE takes -: but for a store, and a page that stays open."""
    context = Context(cli)
    commands = {name: cli.get_command(context, name) for name in cli.list_commands(context)}
    taking = {
        name
        for name, one in commands.items()
        if one is not None
        and any(isinstance(p.type, PathType) and p.param_type_name == "argument" for p in one.params)
    }
    assert taking - {words.split()[0] for words in FROM_STANDARD_INPUT} == {"audit", "explore", "export", "status"}


def test_a_table_of_a_problem_from_standard_input_finds_the_problem_here(tmp_path: Path) -> None:
    (tmp_path / "rail_60e1.toml").write_text((ROOT / "examples/rail_60e1.toml").read_text("utf-8"), "utf-8")
    status, out, said = run(
        "table", "-", "--workers", "1", stdin=(ROOT / "examples/rail_table.toml").read_text("utf-8")
    )
    assert (status, said) == (0, "")
    assert "776.28541" in out
