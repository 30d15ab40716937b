"""The commands about stability: their reports, certificates, files and exit statuses."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result
from flint import acb, arb

from mpsolve.certificate.format import Certificate
from mpsolve.cli import cli
from mpsolve.errors import CertificateError
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.exact import Exact
from mpsolve.outcome import Status
from mpsolve.report.layout import WIDTH
from mpsolve.stability.distance import CriticalDistance

EXAMPLES = Path(__file__).parents[1] / "examples"
RAIL, PLAIN = EXAMPLES / "rail_60e1.toml", EXAMPLES / "dimensionless.toml"
ONE = "[dimensionless]\nalpha = 1.0749\neta_b = 0.05\neta_m = [35]\npositions = [0]\n"
RAIL_ONE = """
[physical]
EI = 6.4e6
m = 60
k = 1e6
c = 770
v = 313
[[mass]]
M = 10000
position = 0
"""
TABLE = """
quantity = "onset velocity"
[fixed]
masses = 1
alpha = [1.05, 1.1]
[rows]
parameter = "eta_b"
values = [0.05]
[columns]
parameter = "eta_m"
values = [70, 80]
"""
CHART = """
[fixed]
masses = 1
eta_b = 0.05
alpha = [1.05, 1.1]
[x]
parameter = "eta_m"
values = [70]
"""

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command in a working directory that holds the inputs above."""
    monkeypatch.chdir(tmp_path)
    undamped = ONE.replace("eta_b = 0.05", "eta_b = 0")
    texts = {"one": ONE, "rail": RAIL_ONE, "table": TABLE, "chart": CHART, "undamped": undamped}
    for name, text in texts.items():
        Path(f"{name}.toml").write_text(text, encoding="utf-8")
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


def flat(text: str) -> str:
    return " ".join(text.split())


def test_onset(run: Run) -> None:
    result = run("onset", PLAIN, "--from", "0.6", "--to", "0.7", "--digits", 18)
    assert (result.exit_code, result.stderr) == (0, "")
    said = (
        "PROVED: stable from α = 0.6 up to the onset at α = 0.666918957284549573, where two roots ±q enter Im q < 0."
    )
    assert said in flat(result.stdout)
    assert "α of the input it is what is looked for" in flat(result.stdout)
    assert max(map(len, result.stdout.splitlines())) <= WIDTH
    assert "mpsolve verify dimensionless.onset.certificate.json" in flat(result.stdout)
    stored = json.loads(Path("dimensionless.onset.certificate.json").read_text("ascii"))
    assert (stored["kind"], stored["family"]["parameter"]) == ("crossings", "alpha")


def test_onset_in_physical_units(run: Run) -> None:
    result = run("onset", RAIL, "--from", "0.65", "--to", "0.67", "--json", "-o", "c.json")
    data = json.loads(result.stdout)
    assert (result.exit_code, data["format"], data["status"]) == (0, "mpsolve onset", "proved")
    onset = data["onset"]
    alpha, speed, hourly = (float(onset[key]["value"]) for key in ("alpha", "v_m_per_s", "v_km_per_h"))
    v_cr = (1e6 / 60) ** 0.5 / (1e6 / (4 * 6.4e6)) ** 0.25
    assert abs(alpha - 0.658362736387928) < 1e-14
    assert abs(speed - alpha * v_cr) < 1e-10
    assert abs(hourly - 3.6 * speed) < 1e-10
    assert abs(float(onset["frequency_Hz"]["value"]) - 3.1301178) < 1e-7
    assert data["physical"]["v"] == "100"
    assert data["certificate"] == "c.json"
    text = flat(run("onset", "rail.toml", "--from", "1.06", "--to", "1.09").stdout)
    assert "v [m/s] v [km/h] frequency [Hz]" in text
    assert "v of the input it is what is looked for" in text


def test_all_ranges(run: Run) -> None:
    result = run("onset", "one.toml", "--all", "--to", "1.5", "--from", "1")
    assert result.exit_code == 0
    assert (
        "PROVED: of all velocity ratios 1 ≤ α ≤ 1.5, the case is unstable for 1.11060452552928632594803030071"
        in flat(result.stdout)
    )
    assert "< α ≤ 1.5, and for no others." in flat(result.stdout)
    data = json.loads(run("onset", "one.toml", "--all", "--to", "1.1", "--from", "1", "--json").stdout)
    assert (data["format"], data["unstable"], data["unknown"]) == ("mpsolve unstable velocities", [], [])
    assert data["proved"].startswith("PROVED: stable for every velocity ratio in 1 ≤ α ≤ 1.1.")


def test_no_onset(run: Run) -> None:
    text = flat(run("onset", "one.toml", "--to", "1.1", "--from", "1").stdout)
    assert "PROVED: stable for every velocity ratio in 1 ≤ α ≤ 1.1, so there is no onset there." in text
    text = flat(run("onset", "one.toml", "--to", "1.3", "--from", "1.25").stdout)
    assert "PROVED: unstable from the start of the range on, α = 1.25" in text


@pytest.mark.parametrize("more", [[], ["--all"]])
def test_undecided(run: Run, more: list[str]) -> None:
    result = run("onset", "undamped.toml", "--to", "1.1", *more)
    text = flat(result.stdout)
    assert (result.exit_code, result.stderr) == (1, "")
    assert text.startswith("UNDECIDED: ")
    assert "is open: the edge of the cut is not resolved at this effort" in text
    assert "A shorter range (--from, --to)" in text
    assert not list(Path().glob("*.json"))
    data = json.loads(run("onset", "undamped.toml", "--to", "1.1", "--json", *more).stdout)
    assert (data["status"], data["proved"], data["certificate"]) == ("undecided", "", None)
    assert 1 < data["strips"][0]["end"] < 1.05


def test_crossings(run: Run) -> None:
    result = run("crossings", "one.toml", "--digits", 20)
    text = flat(result.stdout)
    assert result.exit_code == 0
    assert "PROVED: stable as long as the largest mass ratio is below η = 70.000780" in text
    assert "η1 2.0000223 70.000781 ±0.13735993 2 roots" in text
    assert Path("one.crossings.certificate.json").is_file()
    data = json.loads(run("crossings", "one.toml", "--digits", 20, "--json").stdout)
    assert data["counts"] == [0, 2]
    assert data["crossings"][0]["M_kg"] is None


def test_crossings_in_kilograms(run: Run) -> None:
    data = json.loads(run("crossings", "rail.toml", "--json").stdout)
    crossing = data["crossings"][0]
    eta, kilograms = float(crossing["eta"]["value"]), float(crossing["M_kg"][0]["value"])
    chi = (1e6 / (4 * 6.4e6)) ** 0.25
    assert abs(kilograms - eta * 60 / chi) < 1e-9
    assert abs(float(crossing["factor"]["value"]) - kilograms / 10000) < 1e-14
    assert "M1 [kg]" in run("crossings", "rail.toml").stdout


def test_stable_and_undecided_crossings(run: Run) -> None:
    Path("slow.toml").write_text(ONE.replace("1.0749", "0.5").replace("eta_b = 0.05", "eta_b = 0"), encoding="utf-8")
    result = run("crossings", "slow.toml")
    assert (result.exit_code, "PROVED: stable for every size of the masses" in result.stdout) == (0, True)
    result = run("crossings", "undamped.toml")
    assert (result.exit_code, result.stdout.startswith("UNDECIDED: not all crossing")) == (1, True)


def test_table(run: Run) -> None:
    result = run("table", "table.toml", "--workers", 1, "--certificates", "folder")
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout.splitlines()[1].startswith("0.05,1.07490045713867,")
    assert len(list(Path("folder").iterdir())) == 2
    saved = run("table", "table.toml", "--workers", 1, "-o", "a.tex")
    assert (saved.exit_code, saved.stdout) == (0, "2 entries: 2 proved.\na.tex\n")
    assert "$1.07490045713867$" in Path("a.tex").read_text("utf-8")


def test_a_table_with_open_entries(run: Run) -> None:
    Path("open.toml").write_text(TABLE.replace("[0.05]", "[0]").replace("1.05", "0.99"), encoding="utf-8")
    result = run("table", "open.toml", "--workers", 1, "-o", "a.json")
    assert (result.exit_code, result.stdout) == (1, "2 entries: 2 undecided.\na.json\n")


def test_a_table_that_cannot_be_written_is_printed(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(path: Path, _text: str) -> Path:
        raise CertificateError(f"{path} cannot be written: No space left on device")

    monkeypatch.setattr("mpsolve.stability.table.write_whole", fail)
    result = run("table", "table.toml", "--workers", 1, "-o", "a.csv")
    assert result.exit_code == 1
    assert result.stdout.splitlines()[1].startswith("0.05,1.07490045713867,")
    assert result.stderr == "mpsolve: a.csv cannot be written: No space left on device\n"


def test_chart(run: Run) -> None:
    result = run("chart", "chart.toml", "-o", "a.json", "--workers", 1)
    assert (result.exit_code, result.stdout) == (0, "1 of 1 columns proved.\na.json\n")
    pytest.importorskip("matplotlib", reason="a picture needs matplotlib")
    assert run("chart", "chart.toml", "-o", "a.svg", "--workers", 1).exit_code == 0
    assert Path("a.svg").read_text("utf-8").startswith("<?xml")


@pytest.fixture
def distance(monkeypatch: pytest.MonkeyPatch) -> Callable[[CriticalDistance], list[Any]]:
    """Puts an answer in the place of the search, which takes long; gives what it is asked for."""

    def answers(found: CriticalDistance) -> list[Any]:
        asked: list[Any] = []
        monkeypatch.setattr("mpsolve.stability.distance.critical_distance", lambda *x: asked.append(x) or found)
        return asked

    return answers


def critical(imag: str) -> CriticalDistance:
    with ball_arithmetic(200):
        blur = arb(0, "1e-40")
        d, q = arb("1.25") + blur, acb(arb("0.15") + blur, arb(imag) + blur)
    return CriticalDistance(d, q, Status.PROVED, "", 30)


def test_critical_distance(run: Run, distance: Callable[[CriticalDistance], list[Any]]) -> None:
    asked = distance(critical("-0.02"))
    result = run("critical-distance", RAIL, "--from", 1, "--to", "2.5")
    assert (result.exit_code, len(asked[0][2]), asked[0][5]) == (0, 2, (1, Exact("2.5")))
    text = flat(result.stdout)
    assert "1 ≤ d ≤ 2.5, Im q over all roots is smallest at d = 1.25000" in text
    assert "where the vibration grows fastest." in text
    assert "1.2500000 2.8116" in text or "1.2500000 2.8117" in text
    data = json.loads(run("critical-distance", RAIL, "--from", 1, "--to", "2.5", "--json").stdout)["critical"]
    assert abs(float(data["distance_m"]["value"]) - 1.25 / (1e6 / (4 * 6.4e6)) ** 0.25) < 1e-12
    assert abs(float(data["growth_rate_per_s"]["value"]) - 0.02 * (1e6 / 60) ** 0.5) < 1e-12
    distance(critical("0.02"))
    text = flat(run("critical-distance", PLAIN, "--from", 1, "--to", "2.5").stdout)
    assert "so the case is stable at every one of them." in text
    assert "Im q = 0.02000" in text
    distance(CriticalDistance(None, None, Status.UNDECIDED, "why", 30))
    result = run("critical-distance", PLAIN, "--from", 1, "--to", "2.5")
    assert (result.exit_code, "UNDECIDED: the critical distance in 1 ≤ d ≤ 2.5 is open: why." in result.stdout) == (
        1,
        True,
    )


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        (["onset", "none.toml"], "none.toml"),
        (["onset", "one.toml", "--from", "x"], "--from"),
        (["onset", "one.toml", "--from", "2"], "--to"),
        (["onset", "one.toml", "--from", "-1"], "--from"),
        (["onset", "one.toml", "--to", "root4(2)"], "--to"),
        (["onset", "one.toml", "--digits", "14"], "digits"),
        (["onset", "one.toml", "-o", "one.toml"], "output"),
        (["crossings", "one.toml", "--digits", "0"], "digits"),
        (["crossings", "one.toml", "-o", "no/c.json"], "output"),
        (["table", "one.toml"], "one.toml"),
        (["table", "none.toml", "-o", "one.csv"], "none.toml"),
        (["table", "table.toml", "-o", "a.txt"], "output"),
        (["table", "table.toml", "--workers", "0"], "workers"),
        (["table", "table.toml", "--certificates", "one.toml"], "certificates"),
        (["chart", "chart.toml", "-o", "a.gif"], "output"),
        (["chart", "table.toml", "-o", "a.png"], "table.toml"),
    ],
)
def test_bad_input_names_its_key_in_one_sentence(run: Run, arguments: list[object], key: str) -> None:
    Path("one.csv").write_text("", encoding="utf-8")
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.startswith(f"mpsolve: {key}: ")
    assert result.stderr.count("\n") == 1


def test_a_certificate_that_cannot_be_written(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_self: Certificate, path: Path) -> Path:
        raise CertificateError(f"{path} cannot be written: No space left on device")

    monkeypatch.setattr(Certificate, "save", fail)
    result = run("crossings", "one.toml")
    assert result.exit_code == 1
    assert "PROVED" in result.stdout
    assert "Certificate" not in result.stdout
    assert result.stderr.endswith("No space left on device\n")
