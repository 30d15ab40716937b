"""The paper as a whole: names and quotes, and a sample of what is stored, computed anew by the engine."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from mpsolve import verify
from mpsolve.claims.load import audit, load
from mpsolve.claims.report import as_data, document, page

ROOT = Path(__file__).parents[3]
STORED = ROOT / "certs" / "paper"
PAPER = load(ROOT / "examples" / "paper")
SAMPLE = ("3-pairs", "fig-7", "4.2-final-10", "xii-a", "x")


@pytest.fixture(scope="module")
def report():
    return audit(PAPER, SAMPLE, workers=1)


def test_every_conclusion_has_a_claim() -> None:
    numerals = ["i", "ii", "iii", "iv", "v", "vi", "vii", "viii", "ix", "x", "xi", "xii"]
    assert all(PAPER.chosen([numeral]) for numeral in numerals)
    assert len(PAPER.claims) == 138
    assert all(claim.place and claim.text for claim in PAPER.claims)


def test_stored_certificates_are_those_of_the_claims(report) -> None:
    """What the sample proves now is what certs/paper/ holds: the claims and roots; pieces of a path may be others."""
    assert report.complete
    assert len(report.certificates) > 8
    stored = {said(json.loads(path.read_text("ascii"))) for path in STORED.glob("*.json")}
    assert all(said(certificate.content) in stored for certificate in report.certificates.values())


def said(content: dict) -> str:
    """What a certificate says of which equations."""
    told = {key: content.get(key) for key in ("kind", "equations", "case", "basis", "claim", "roots")}
    return json.dumps(told, sort_keys=True)


def test_certificates_are_valid(report, tmp_path: Path) -> None:
    paths = report.save_certificates(tmp_path / "new")
    assert sorted(path.name for path in paths) == sorted(report.certificates)
    for name in sorted(name for name in report.certificates if "alpha" in name)[::3]:  # of single cases: quick
        assert verify(tmp_path / "new" / name).valid


def test_equal_certificates_share_a_file() -> None:
    found = audit(PAPER, ["x", "4.3-imaginary"], workers=1)
    assert found.files["x"] == found.files["4.3-imaginary"] == ("x_onset.json",)


def test_a_finding_without_certificate_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """In the table, in the JSON and on the page; and the words tried stand beside those printed."""
    monkeypatch.chdir(ROOT)
    found = audit(PAPER, ["eq-26-one-place", "eq-31"], workers=1)
    command = "mpsolve audit examples/paper --only eq-26-one-place"
    said = f"No certificate: proved by computation; recompute with {command}"
    assert said in " ".join(document(found).text().split())
    data = {entry["id"]: entry for entry in as_data(found)["claims"]}
    assert (data["eq-31"]["no certificate"], data["eq-26-one-place"]["no certificate"]) == ("", said)
    assert said in page(found)
    assert data["eq-31"]["claim"].startswith("where a is a convenient positive number")
    assert "the rear mass" in as_data(found)["notation"]
