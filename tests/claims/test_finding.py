"""What a finding keeps, and how it says that it has no certificate."""

from __future__ import annotations

import pytest

from mpsolve import Case
from mpsolve.certificate.certify import certify
from mpsolve.claims import Finding, Verdict


def test_lists_become_tuples_and_missing_certificates_are_left_out() -> None:
    certificate = certify(Case(alpha="0.5", eta_b="0.1", eta_m="10"), digits=15).certificate
    found = Finding(Verdict.PROVED, "So.", [("a", "1")], ["step"], ["hit"], [("x", None), ("y", certificate)])
    assert (found.numbers, found.steps, found.search) == ((("a", "1"),), ("step",), ("hit",))
    assert found.certificates == (("y", certificate),)
    assert found.uncertified == ""


@pytest.mark.parametrize(
    ("verdict", "said"),
    [
        (Verdict.PROVED, "proved by computation"),
        (Verdict.REFUTED, "proved by computation"),
        (Verdict.UNDECIDABLE, "nothing is proved"),
        (Verdict.DISAGREES, "computed, not proved"),
    ],
)
def test_without_a_certificate(verdict: Verdict, said: str) -> None:
    assert Finding(verdict, "So.", certificates=[("x", None)]).uncertified == said


def test_every_verdict_is_shown_as_what_it_is() -> None:
    tones = {verdict.name: verdict.tone for verdict in Verdict}
    assert [name for name, tone in tones.items() if tone == "good"] == ["PROVED", "AGREES"]
    assert [name for name, tone in tones.items() if tone == "bad"] == ["REFUTED", "DISAGREES"]
    assert {tones["CONDITIONAL"], tones["UNDECIDABLE"], tones["SLIP"]} == {"half", "open", "slip"}
