"""What was found, as a whole: counts, certificates and their files."""

from __future__ import annotations

from pathlib import Path

import pytest

from mpsolve import Case, verify
from mpsolve.certificate.certify import certify
from mpsolve.claims import Finding, Paper, Verdict
from mpsolve.claims.report import Report, collected
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
