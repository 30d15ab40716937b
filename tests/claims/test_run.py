"""The same findings in any number of processes; a check without an end is a finding."""

from __future__ import annotations

from dataclasses import replace

import pytest

from mpsolve import InputError
from mpsolve.claims import Claim, Finding, Paper, Verdict
from mpsolve.claims.report import Report
from mpsolve.claims.run import audit, checked
from mpsolve.errors import PrecisionError


def verdicts(report: Report) -> dict[str, Verdict]:
    return {claim.id: finding.verdict for claim, finding in report.entries}


def test_verdicts(toy_report: Report) -> None:
    assert list(verdicts(toy_report).items()) == [
        ("i-a", Verdict.PROVED),
        ("i-b", Verdict.REFUTED),
        ("ii", Verdict.AGREES),
        ("iii", Verdict.UNDECIDABLE),
    ]


def test_other_processes_load_the_paper_by_its_path(toy: Paper, toy_report: Report) -> None:
    """They cannot import it by its name, which is on no search path."""
    heard: list[float] = []
    found = audit(toy, ["i", "iii"], workers=2, tell=lambda _, part: heard.append(part))
    assert verdicts(found) == {name: one for name, one in verdicts(toy_report).items() if name != "ii"}
    assert [c.content["sha256"] for c in found.certificates.values()] == [
        c.content["sha256"] for c in toy_report.certificates.values()
    ]
    assert heard[-1] == 1


def test_slow_claims_begin_first(toy: Paper) -> None:
    begun: list[str] = []

    def noted(claim: Claim) -> Finding:
        begun.append(claim.id)
        return Finding(Verdict.PROVED, "So.")

    claims = [replace(claim, check=noted) for claim in toy.claims]
    report = audit(replace(toy, claims=claims, where=""), workers=1)
    assert begun == ["ii", "i-a", "i-b", "iii"]
    assert [claim.id for claim, _ in report.entries] == ["i-a", "i-b", "ii", "iii"]


def test_a_check_without_end_is_a_finding() -> None:
    def stuck(claim: Claim) -> Finding:
        raise PrecisionError(f"{claim.id} needs more digits")

    found = checked(Claim("none", "nowhere", "words", stuck))
    assert (found.verdict, found.stopped) == (Verdict.UNDECIDABLE, True)
    assert "none needs more digits" in found.sentence


def test_bad_input(toy: Paper) -> None:
    with pytest.raises(InputError, match="no claim"):
        audit(toy, ["iv"])
    with pytest.raises(InputError, match="workers"):
        audit(toy, workers=0)
