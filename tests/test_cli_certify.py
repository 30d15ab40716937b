"""The command `certify`: its reports, its certificate, its exit status, remedies that help, interruption."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from mpsolve import certify, read_case, verify
from mpsolve.certificate import verify2
from mpsolve.certificate.format import Certificate
from mpsolve.cli import cli
from mpsolve.errors import CertificateError

EXAMPLES = Path(__file__).parents[1] / "examples"
RAIL, PLAIN, BOGIE = (EXAMPLES / f"{name}.toml" for name in ("rail_60e1", "dimensionless", "two_layer_bogie"))
TOUCHING = "[dimensionless]\nalpha = 1\neta_b = 0\neta_m = [20]\npositions = [0]\n"
WIRE = """
v = 100
[track]
model = "string"
T = 27000
m = 1.07
k = 500
c = 2
[[vehicle]]
model = "mass"
M = 8.5
"""

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command in an empty working directory."""
    monkeypatch.chdir(tmp_path)
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


@pytest.fixture
def accepted(monkeypatch: pytest.MonkeyPatch) -> None:
    """A verifier that accepts everything: what is tested is the command."""
    monkeypatch.setattr(verify2, "verify_bytes", lambda _raw: verify2.Verdict(True, "", "what it has read"))


def test_certify_prints_the_report_and_writes_the_certificate(run: Run, tmp_path: Path) -> None:
    result = run("certify", RAIL)
    assert result.exit_code == 0
    assert result.stderr == ""
    assert "\x1b" not in result.stdout
    assert "STABLE" in result.stdout
    assert "STABLE at 360 km/h (100 m/s): every vibration decays." in result.stdout
    assert "±18.46795282713178427" in result.stdout
    assert result.stdout.index("Vibrations") < result.stdout.index("In the ratios of the paper")
    assert "mpsolve verify rail_60e1.certificate.json" in result.stdout
    spectrum = certify(read_case(RAIL))
    assert spectrum.certificate is not None
    saved = tmp_path / "rail_60e1.certificate.json"
    assert saved.read_text("utf-8") == spectrum.certificate.text
    assert list(tmp_path.iterdir()) == [saved]


def test_unstable_is_proved_too(run: Run, tmp_path: Path) -> None:
    result = run("certify", PLAIN, "-o", "other.json", "--digits", "15")
    assert result.exit_code == 0
    assert "UNSTABLE at α = 0.67: a vibration at 0.02481 1/τ doubles every 25460 τ." in result.stdout
    assert (tmp_path / "other.json").is_file()


def test_json(run: Run) -> None:
    result = run("certify", PLAIN, "--json", "--digits", 50, "--region", "unstable")
    data = json.loads(result.stdout)
    assert result.exit_code == 0
    assert (data["count"], data["unstable"], data["region"]["kind"], data["digits"]) == (2, 2, "unstable", 50)
    wanted = certify(read_case(PLAIN), digits=60).roots[-1].q.real.str(48, radius=False)
    assert data["roots"][-1]["re"]["value"].startswith(wanted[:48])
    assert data["certificate"] == "dimensionless.certificate.json"


def test_a_rectangle_with_negative_bounds(run: Run) -> None:
    result = run("certify", PLAIN, "--json", "--region", "-0.2,-1/7,-0.1,0.01")
    data = json.loads(result.stdout)
    assert (data["count"], data["region"]["re_max"]["exact"], data["stable"]) == (1, "-1/7", False)


def test_undecided(run: Run, tmp_path: Path) -> None:
    Path("touching.toml").write_text(TOUCHING, encoding="utf-8")
    assert run("certify", "touching.toml").stdout.startswith("STABLE")
    Path("touching.certificate.json").unlink()
    result = run("certify", "touching.toml", "--region", "sheet")
    assert result.exit_code == 1
    assert result.stdout.startswith("UNDECIDED: the velocity is exactly the one at which the cuts join")
    assert result.stderr == ""
    assert [path.name for path in tmp_path.iterdir()] == ["touching.toml"]
    data = json.loads(run("certify", "touching.toml", "--region", "sheet", "--json").stdout)
    assert (data["status"], data["certificate"]) == ("undecided", None)


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        (["none.toml"], "none.toml"),
        (["bad.toml"], "dimensionless.eta_b"),
        ([PLAIN, "--digits", "14"], "--digits"),
        ([PLAIN, "--region", "half"], "--region"),
        ([PLAIN, "--region", "0,1,2"], "--region"),
        ([PLAIN, "--region", "1,0,-2,-1"], "--region: re_max is 0, not above re_min = 1"),
        (
            [PLAIN, "--region", "0,1,-1,1"],
            "--region: im_max and im_min hold the cut line Im q = 0.05 between them, beyond the gap of the cuts",
        ),
        (["over.toml", "--region", "sheet"], "--region"),
        ([PLAIN, "-o", "no/such/place.json"], "--output"),
        ([PLAIN, "-o", "."], "--output"),
        (["bad.toml", "-o", "bad.toml"], "dimensionless.eta_b"),
        (["over.toml", "-o", "over.toml"], "--output"),
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


@pytest.mark.usefixtures("accepted")
def test_an_overdamped_track_is_certified_where_it_can_be(run: Run) -> None:
    """Its branch cuts leave their line, so that the whole sheet has no count."""
    Path("overdamped.toml").write_text(
        RAIL.read_text(encoding="utf-8").replace("c = 770 ", "c = 1.2e5 "), encoding="utf-8"
    )
    result = run("certify", "overdamped.toml", "--json")
    data = json.loads(result.stdout)
    assert (result.exit_code, data["region"]["kind"], data["stable"]) == (0, "below", True)
    assert run("certify", "overdamped.toml", "--region", "unstable").exit_code == 0
    refused = run("certify", "overdamped.toml", "--region", "sheet")
    assert refused.exit_code == 2
    assert "try --region unstable, or give --region below=H with H up to 8.3683" in refused.stderr
    assert "region=" not in refused.stderr


def test_remedies_name_options_that_there_are(run: Run) -> None:
    result = run("certify", PLAIN, "--effort", "1e-9", "--json")
    data = json.loads(result.stdout)
    assert (result.exit_code, data["reason"]["code"]) == (1, "effort")
    assert data["reason"]["remedy"] == "allow more with --effort SECONDS, or try --region unstable"
    text = " ".join(run("certify", PLAIN, "--effort", "1e-9").stdout.split())
    assert "allow more with --effort SECONDS" in text
    assert run("certify", PLAIN, "--effort", 200).exit_code == 0
    for region in ("sheet", "below=1", "0,20,-1,1"):
        Path("wire.toml").write_text(WIRE, encoding="utf-8")
        refused = run("certify", "wire.toml", f"--region={region}")
        assert refused.exit_code == 2
        assert refused.stderr.startswith("mpsolve: --region: ")
        assert "Rectangle" not in refused.stderr
        assert '"below"' not in refused.stderr.split("but")[-1]


@pytest.mark.usefixtures("accepted")
def test_any_track_and_vehicle(run: Run, tmp_path: Path) -> None:
    """The bogie of the example: stable, its vibrations in Hz, what was verified, what it took."""
    result = run("certify", BOGIE)
    assert (result.exit_code, result.stderr) == (0, "")
    lines = result.stdout.splitlines()
    assert lines[0].startswith("A bogie on rail, pads, sleepers and ballast")
    assert lines[2] == "STABLE at 360 km/h (100 m/s): every vibration decays."
    for words in (
        "frequency [Hz]",
        "decays, halves",
        "None is missed",
        "confirms: what it has read",
        "processor time",
    ):
        assert words in result.stdout
    assert (tmp_path / "two_layer_bogie.certificate.json").is_file()
    data = json.loads(run("certify", BOGIE, "--json", "--region", "unstable").stdout)
    assert (data["count"], data["stable"], data["region"]["kind"], data["verified"] != "") == (
        0,
        True,
        "unstable",
        True,
    )


@pytest.mark.usefixtures("accepted")
def test_regions_of_any_problem(run: Run) -> None:
    Path("wire.toml").write_text(WIRE, encoding="utf-8")
    for region, count in (("below=0.9", 2), ("below=0.5", 0), ("15,16,0,0.9", 1), ("unstable", 0)):
        result = run("certify", "wire.toml", f"--region={region}", "--json", "-o", "out.json")
        assert (result.exit_code, json.loads(result.stdout)["count"]) == (0, count)


def test_a_problem_that_is_the_papers_beam_has_its_whole_sheet(run: Run) -> None:
    Path("beam.toml").write_text(
        'v = 100\n[track]\nmodel = "euler-bernoulli"\nEI = 6.4e6\nm = 60\nk = 1e6\nc = 770\n'
        '[[vehicle]]\nmodel = "mass"\nM = 10000\nposition = 3.4\n[[vehicle]]\nmodel = "mass"\nM = 10000\n',
        encoding="utf-8",
    )
    one, other = (run("certify", name, "--json", "-o", "out.json").stdout for name in ("beam.toml", RAIL))
    same = [  # the bodies have the names of the file, and last digits of a ball depend on its way
        [(root["re"]["value"][:22], root["im"]["value"][:22]) for root in json.loads(x)["roots"]]
        for x in (one, other)
    ]
    assert same[0] == same[1]
    assert len(same[0]) == 4
    assert json.loads(one)["region"]["kind"] == "sheet"
    assert verify("out.json").valid
    assert "v_cr" in run("certify", "beam.toml").stdout


def test_what_the_verifier_refuses_is_not_written(run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(verify2, "verify_bytes", lambda _raw: verify2.Verdict(False, "piece 3 is too long"))
    Path("wire.toml").write_text(WIRE, encoding="utf-8")
    result = run("certify", "wire.toml")
    assert result.exit_code == 1
    assert result.stdout.startswith("UNDECIDED: the standalone verifier does not accept the proof: piece 3")
    assert [path.name for path in tmp_path.iterdir()] == ["wire.toml"]


@pytest.mark.parametrize("seconds", ["0", "-1", "nan"])
def test_an_effort_that_is_none(run: Run, seconds: str) -> None:
    result = run("certify", PLAIN, f"--effort={seconds}")
    assert (result.exit_code, result.stderr.startswith("mpsolve: --effort: ")) == (2, True)


def test_an_interruption_is_one_line_and_writes_nothing(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """As a second Ctrl-C ends the work; what signals do is in tests/proof/test_stopping.py."""

    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("mpsolve.certificate.certify.certify", interrupted)
    result = run("certify", PLAIN)
    assert (result.exit_code, result.stdout, result.stderr) == (130, "", "mpsolve: interrupted\n")
    assert not list(tmp_path.iterdir())


@pytest.mark.usefixtures("accepted")
def test_regions_in_si_may_have_units(run: Run) -> None:
    Path("wire.toml").write_text(WIRE, encoding="utf-8")
    regions = ("below=0.5", "below=0.5 1/s", "below=30 1/min", "below=0.5 rad/s")
    heights = [
        json.loads(run("certify", "wire.toml", "--json", "--digits", 15, "--region", region).stdout)["region"]
        for region in regions
    ]
    assert all(region == heights[0] for region in heights)
    refused = run("certify", "wire.toml", "--region", "below=3 kg")
    assert refused.stderr.startswith("mpsolve: --region: is '3 kg', whose unit is kg")
    assert run("certify", PLAIN, "--region", "below=0.01 1/s").exit_code == 2
