"""What was found, as a whole: counts, certificates and their files."""

from __future__ import annotations

import json
from html.parser import HTMLParser
from pathlib import Path

import pytest

from mpsolve import Case, verify
from mpsolve.certificate.certify import certify
from mpsolve.claims import Finding, Paper, Verdict
from mpsolve.claims.report import Report, as_data, collected, document, page
from mpsolve.errors import CertificateError


def test_counts(toy_report: Report) -> None:
    assert toy_report.count(Verdict.PROVED) == 1
    assert not toy_report.complete
    assert toy_report.summary == "4 claims: 1 proved, 1 refuted, 1 not decidable, 1 computed, agrees."


def test_equal_certificates_share_a_file(toy_report: Report) -> None:
    assert toy_report.files == {"i-a": ("i-a_spectrum.json",), "i-b": ("i-a_spectrum.json",), "ii": (), "iii": ()}
    assert list(toy_report.certificates) == ["i-a_spectrum.json"]


def test_different_certificates_of_one_name_are_both_kept(toy: Paper) -> None:
    one, other = (certify(Case(alpha="0.5", eta_b="0.1", eta_m=m), digits=15).certificate for m in ("10", "11"))
    claim = toy.claims[0]
    found = collected(toy, [(claim, Finding(Verdict.PROVED, "So.", certificates=[("x", one), ("x", other)]))])
    assert list(found.certificates.values()) == [one, other]
    assert set(found.files[claim.id]) == set(found.certificates)


def test_certificates_are_valid_and_written(toy_report: Report, tmp_path: Path) -> None:
    (path,) = toy_report.save_certificates(tmp_path / "deep" / "new")
    assert path.name == "i-a_spectrum.json"
    assert verify(path).valid
    with pytest.raises(CertificateError, match="cannot be made"):
        toy_report.save_certificates(path / "under a file")


def test_what_stands_in_place_of_certificates(toy_report: Report, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(Path(toy_report.paper.where).parent)
    said = {claim.id: toy_report.without_certificate(claim, finding) for claim, finding in toy_report.entries}
    assert said["i-a"] == ""
    assert said["ii"] == "No certificate: computed, not proved; recompute with mpsolve audit toy --only ii"
    assert said["iii"] == "No certificate: nothing is proved; recompute with mpsolve audit toy --only iii"


def test_json_and_terminal_say_the_same(toy_report: Report) -> None:
    data, text = as_data(toy_report), document(toy_report).text()
    assert (data["title"], data["paper"]) == ("One mass & its <roots>", "Nobody, one mass")
    assert (data["notation"], data["complete"]) == ("A root is a root.", False)
    assert json.loads(json.dumps(data)) == data
    entries = {entry["id"]: entry for entry in data["claims"]}
    assert list(entries) == ["i-a", "i-b", "ii", "iii"]
    assert sum(data["summary"].values()) == len(entries)
    for entry in data["claims"]:
        assert entry["id"] in text
        assert entry["sentence"].split()[0] in text
    assert toy_report.summary in text.replace("\n", " ")
    first = entries["i-a"]
    assert (first["claim"], first["tried"]) == ("Two roots were found.", "There are 2 roots.")
    assert (first["printed"], first["looked at"]) == ({"roots": ["2"]}, {"eta_m": ["10"]})
    assert (first["certificates"], first["no certificate"]) == (["i-a_spectrum.json"], "")
    assert first["numbers"] == [{"what": "roots", "value": "2"}]
    assert entries["ii"]["no certificate"] in " ".join(text.split())
    assert "→ 2 & more" in text


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


def test_the_page_is_whole_and_loads_nothing(toy_report: Report) -> None:
    text, reader = page(toy_report), Links()
    reader.feed(text)
    assert reader.open == []
    assert all(target.startswith("#") for target in reader.targets)
    assert "url(" not in text
    assert "<script" not in text
    assert all(f'id="{claim.id}"' in text for claim, _ in toy_report.entries)
    assert all(name in text for name in toy_report.certificates)


def test_texts_are_escaped_and_tried_words_stand_beside_those_printed(toy_report: Report) -> None:
    text = page(toy_report)
    assert "One mass &amp; its &lt;roots&gt;" in text
    assert "<li>2 &amp; more</li>" in text
    assert "<blockquote>Two roots were found.</blockquote>\n<p>Tried: There are 2 roots.</p>" in text
    assert text.count("Tried:") == 1
    assert "No certificate: nothing is proved" in text
