"""The command: its report, its certificate, its exit status, and silence where silence is due."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import mpsolve
from mpsolve import certify, read_case
from mpsolve.certificate.format import Certificate
from mpsolve.cli import cli
from mpsolve.errors import CertificateError
from mpsolve.model import derivation
from mpsolve.model.steps import equation_of_motion

EXAMPLES = Path(__file__).parents[1] / "examples"
RAIL, PLAIN = EXAMPLES / "rail_60e1.toml", EXAMPLES / "dimensionless.toml"
TOUCHING = "[dimensionless]\nalpha = 1\neta_b = 0\neta_m = [20]\npositions = [0]\n"

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command in an empty working directory."""
    monkeypatch.chdir(tmp_path)
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


def test_certify_prints_the_report_and_writes_the_certificate(run: Run, tmp_path: Path) -> None:
    result = run("certify", RAIL)
    assert result.exit_code == 0
    assert result.stderr == ""
    assert "\x1b" not in result.stdout
    assert "STABLE" in result.stdout
    assert "±0.14305214747605116538084978921" in result.stdout
    assert "mpsolve verify rail_60e1.certificate.json" in result.stdout
    spectrum = certify(read_case(RAIL))
    assert spectrum.certificate is not None
    saved = tmp_path / "rail_60e1.certificate.json"
    assert saved.read_text("utf-8") == spectrum.certificate.text
    assert list(tmp_path.iterdir()) == [saved]


def test_unstable_is_proved_too(run: Run, tmp_path: Path) -> None:
    result = run("certify", PLAIN, "-o", "other.json", "--digits", "15")
    assert result.exit_code == 0
    assert "UNSTABLE: 2 induced" in result.stdout
    assert (tmp_path / "other.json").is_file()


def test_json(run: Run) -> None:
    result = run("certify", PLAIN, "--json", "--digits", 50, "--region", "unstable")
    data = json.loads(result.stdout)
    assert result.exit_code == 0
    assert (data["count"], data["unstable"], data["region"], data["digits"]) == (2, 2, "unstable", 50)
    wanted = certify(read_case(PLAIN), digits=60).roots[-1].q.real.str(48, radius=False)
    assert data["roots"][-1]["re"]["value"].startswith(wanted[:48])
    assert data["certificate"] == "dimensionless.certificate.json"


def test_a_rectangle_with_negative_bounds(run: Run) -> None:
    result = run("certify", PLAIN, "--json", "--region", "-0.2,-1/7,-0.1,0.01")
    data = json.loads(result.stdout)
    assert (data["count"], data["region"]["re_max"], data["stable"]) == (1, "-1/7", None)


def test_undecided(run: Run, tmp_path: Path) -> None:
    Path("touching.toml").write_text(TOUCHING, encoding="utf-8")
    result = run("certify", "touching.toml")
    assert result.exit_code == 1
    assert result.stdout.startswith("UNDECIDED: alpha equals alpha_C")
    assert result.stderr == ""
    assert [path.name for path in tmp_path.iterdir()] == ["touching.toml"]
    data = json.loads(run("certify", "touching.toml", "--json").stdout)
    assert (data["status"], data["certificate"]) == ("undecided", None)


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        (["none.toml"], "none.toml"),
        (["bad.toml"], "dimensionless.eta_b"),
        ([PLAIN, "--digits", "14"], "digits"),
        ([PLAIN, "--region", "half"], "region"),
        ([PLAIN, "--region", "0,1,2"], "region"),
        ([PLAIN, "--region", "1,0,-2,-1"], "region.re_max"),
        ([PLAIN, "--region", "0,1,-1,1"], "region.im_max"),
        (["over.toml", "--region", "sheet"], "eta_b"),
        ([PLAIN, "-o", "no/such/place.json"], "output"),
        ([PLAIN, "-o", "."], "output"),
        (["bad.toml", "-o", "bad.toml"], "dimensionless.eta_b"),
        (["over.toml", "-o", "over.toml"], "output"),
    ],
)
def test_bad_input_names_its_key_in_one_sentence(run: Run, arguments: list[object], key: str) -> None:
    Path("bad.toml").write_text(TOUCHING.replace("eta_b = 0", "eta_b = -1"), encoding="utf-8")
    Path("over.toml").write_text(TOUCHING.replace("eta_b = 0", "eta_b = 1.5"), encoding="utf-8")
    result = run("certify", *arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.startswith(f"mpsolve: {key}: ")
    assert result.stderr.count("\n") == 1


def test_a_certificate_that_cannot_be_written(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_self: Certificate, path: Path) -> Path:
        raise CertificateError(f"{path} cannot be written: No space left on device")

    monkeypatch.setattr(Certificate, "save", fail)
    result = run("certify", PLAIN, "--json")
    assert result.exit_code == 1
    assert json.loads(result.stdout)["certificate"] is None
    assert result.stderr == "mpsolve: dimensionless.certificate.json cannot be written: No space left on device\n"


def test_verify_says_a_line_for_each_file(run: Run) -> None:
    run("certify", PLAIN, "-o", "good.json")
    Path("broken.json").write_text('{"format": "mpsolve certificate"', encoding="utf-8")
    result = run("verify", "good.json")
    claim = (
        "exactly 4 induced frequencies on the whole physical sheet, 2 of them with Im q < 0; "
        "case alpha = 67/100, eta_b = 1/20, eta_n = 0, eta_s = 0, eta_m = 70, 70 at 0, 3/2"
    )
    assert (result.exit_code, result.stdout) == (0, f"valid: good.json: {claim}\n")
    result = run("verify", "broken.json", "good.json", "missing.json")
    assert result.exit_code == 1
    assert [line.split(":")[0] for line in result.stdout.splitlines()] == ["invalid", "valid", "invalid"]


def test_derive(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    steps = (equation_of_motion(),)
    monkeypatch.setattr(derivation, "derivation", lambda masses: steps[:masses])
    assert "Equation of motion" in run("derive", "--masses", 1).stdout
    assert run("derive", "--latex").stdout.startswith("\\documentclass")


def test_derive_refuses_a_number_of_masses(run: Run) -> None:
    result = run("derive", "--masses", 0)
    assert result.exit_code == 2
    assert result.stderr.startswith("mpsolve: masses: ")


def test_version(run: Run) -> None:
    assert run("--version").stdout == f"mpsolve {mpsolve.__version__}\n"


def test_as_a_process_in_a_pipe(tmp_path: Path) -> None:
    """UTF-8 in any locale, no control codes, no progress, the same text as in the library."""
    environment = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    environment["PYTHONPATH"] = str(Path(mpsolve.__file__).parents[1])
    command = [sys.executable, "-m", "mpsolve", "certify", str(RAIL)]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    assert "√(k/m)" in done.stdout.decode("utf-8")
    assert b"\x1b" not in done.stdout
    assert (tmp_path / "rail_60e1.certificate.json").is_file()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full on this system")
def test_standard_output_on_a_full_disk(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "mpsolve", "certify", str(RAIL)]
    environment = {**os.environ, "PYTHONPATH": str(Path(mpsolve.__file__).parents[1])}
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            command, cwd=tmp_path, env=environment, stdout=full, stderr=subprocess.PIPE, check=False
        )
    told = done.stderr.decode("utf-8")
    assert (done.returncode, told.count("\n")) == (1, 1)
    assert told.startswith("mpsolve: standard output cannot be written (No space left on device): make room")
    assert (tmp_path / "rail_60e1.certificate.json").is_file()


def test_importing_the_command_is_light() -> None:
    """Beside what `import mpsolve` loads, the module needs click alone."""
    code = "import sys, mpsolve; before = {*sys.modules}; import mpsolve.cli; print(*{*sys.modules} - before)"
    environment = {**os.environ, "PYTHONPATH": str(Path(mpsolve.__file__).parents[1])}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    loaded = {name.partition(".")[0] for name in done.stdout.split()}
    assert not loaded & {"rich", "sympy", "matplotlib"}
    assert not [name for name in done.stdout.split() if name.startswith("mpsolve.report")]


def test_an_overdamped_track_is_certified_where_it_can_be(run: Run) -> None:
    """Its branch cuts leave their line, so that the whole sheet has no count: Im q < 0 is what is asked for then."""
    Path("overdamped.toml").write_text(
        RAIL.read_text(encoding="utf-8").replace("c = 770 ", "c = 1.2e5 "), encoding="utf-8"
    )
    result = run("certify", "overdamped.toml", "--json")
    data = json.loads(result.stdout)
    assert (result.exit_code, data["region"], data["stable"], data["status"]) == (0, "unstable", True, "proved")
    refused = run("certify", "overdamped.toml", "--region", "sheet")
    assert refused.exit_code == 2
    assert "try --region unstable" in refused.stderr
    assert "region=" not in refused.stderr


def test_remedies_name_options_that_there_are(run: Run) -> None:
    result = run("certify", PLAIN, "--max-pieces", 20, "--json")
    data = json.loads(result.stdout)
    assert (result.exit_code, data["why"]["code"]) == (1, "pieces")
    assert data["reason"].endswith("more than 20 pieces: try --region unstable, or allow more with --max-pieces")
    assert run("certify", PLAIN, "--max-pieces", 2000).exit_code == 0
