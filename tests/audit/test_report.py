"""The report: terminal, JSON, page, certificates; the command; and a sample of what is stored, computed anew."""

from __future__ import annotations

import json
from html.parser import HTMLParser
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve import InputError, verify
from mpsolve.audit.claims import Claim, Finding, Verdict
from mpsolve.audit.page import page
from mpsolve.audit.quotes import QUOTES
from mpsolve.audit.run import audit, checked, chosen
from mpsolve.audit.tables import as_data, document, summary
from mpsolve.cli import cli
from mpsolve.errors import PrecisionError
from mpsolve.report.text import plain

STORED = Path(__file__).parents[2] / "certs" / "paper"
SAMPLE = ("3-pairs", "fig-7", "4.2-final-10", "xii-a", "x")


class Links(HTMLParser):
    """Everything that a page would load or lead to, and the open tags."""

    def __init__(self) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.targets += [value or "" for name, value in attrs if name in ("src", "href")]
        if tag not in ("meta", "link", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.fixture(scope="module")
def report():
    return audit(chosen(SAMPLE), workers=1)


def test_stored_certificates_are_those_of_the_claims(report) -> None:
    """What the sample proves now is what certs/paper/ holds, and it is valid."""
    assert report.complete
    assert len(report.certificates) > 8
    stored = {json.loads(path.read_text("ascii"))["sha256"] for path in STORED.glob("*.json")}
    assert all(certificate.content["sha256"] in stored for certificate in report.certificates.values())


def test_certificates_are_valid(report, tmp_path: Path) -> None:
    paths = report.save_certificates(tmp_path / "new")
    assert sorted(path.name for path in paths) == sorted(report.certificates)
    for name in sorted(name for name in report.certificates if "alpha" in name)[::3]:  # of single cases: quick
        assert verify(tmp_path / "new" / name).valid


def test_equal_certificates_share_a_file() -> None:
    found = audit(chosen(["x", "4.3-imaginary"]), workers=1)
    assert found.files["x"] == found.files["4.3-imaginary"] == ("x_onset.json",)


def test_json_and_terminal_say_the_same(report) -> None:
    data, text = as_data(report), plain(document(report))
    assert [entry["id"] for entry in data["claims"]] == [claim.id for claim, _ in report.entries]
    assert sum(data["summary"].values()) == len(report.entries)
    for entry in data["claims"]:
        assert entry["id"] in text
        assert entry["verdict"] in {verdict.value for verdict in Verdict}
        assert entry["sentence"]
    assert summary(report) in text.replace("\n", " ")
    assert json.loads(json.dumps(data)) == data


def test_the_page_is_whole_and_loads_nothing(report) -> None:
    text, reader = page(report), Links()
    reader.feed(text)
    assert reader.open == []
    assert all(target.startswith("#") for target in reader.targets)
    assert "url(" not in text
    assert "<script" not in text
    assert all(f'id="{claim.id}"' in text for claim, _ in report.entries)
    assert all(name in text for name in report.certificates)


def test_a_finding_without_certificate_says_so() -> None:
    """In the table, in the JSON and on the page; and the words tried stand beside those printed."""
    found = audit(chosen(["eq-26-one-place", "eq-31"]), workers=1)
    said = "No certificate: proved by computation; recompute with mpsolve audit --only eq-26-one-place"
    assert said in " ".join(plain(document(found)).split())
    data = {entry["id"]: entry for entry in as_data(found)["claims"]}
    assert (data["eq-31"]["no certificate"], data["eq-26-one-place"]["no certificate"]) == ("", said)
    assert said in page(found)
    assert data["eq-31"]["claim"].startswith("where a is a convenient positive number")
    assert "the rear mass" in as_data(found)["notation"]


def test_every_quote_belongs_to_a_claim() -> None:
    assert QUOTES.keys() <= {claim.id for claim in chosen([])}


def test_a_check_without_end_is_a_finding() -> None:
    def stuck(claim: Claim) -> Finding:
        raise PrecisionError(f"{claim.id} needs more digits")

    found = checked(Claim("none", "nowhere", "words", stuck))
    assert (found.verdict, found.stopped) == (Verdict.UNDECIDABLE, True)
    assert "none needs more digits" in found.sentence


def test_names_of_claims() -> None:
    assert [claim.id for claim in chosen(["xii"])] == ["xii-a", "xii-b"]
    with pytest.raises(InputError, match="no claim"):
        chosen(["xiii"])


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    given = ["audit", "--only", "fig-10b", "--only", "3-pairs", "--workers", "1", "--html", "a.html", "--json"]
    result = CliRunner().invoke(cli, [*given, "--certificates", "certs"], catch_exceptions=False)
    assert result.exit_code == 0
    assert json.loads(result.stdout)["summary"]["a slip of the print"] == 1
    assert (tmp_path / "a.html").read_text("utf-8").startswith("<!doctype html>")
    assert [path.name for path in (tmp_path / "certs").iterdir()] == ["3-pairs.json"]


@pytest.mark.parametrize(
    ("arguments", "key"),
    [(["--only", "xiii"], "only"), (["--html", "no/a.html"], "html"), (["--certificates", "file"], "certificates")],
)
def test_bad_input(arguments: list[str], key: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("", "utf-8")
    result = CliRunner().invoke(cli, ["audit", *arguments])
    assert result.exit_code == 2
    assert key in result.stderr
    assert result.stdout == ""
