"""The words and the numbers of a claim."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from mpsolve import Case, InputError
from mpsolve.certificate.certify import certify
from mpsolve.claims import Claim, Finding, Paper, Verdict


def unsure(_: Claim) -> Finding:
    return Finding(Verdict.UNDECIDABLE, "Who knows.")


def test_printed_numbers_stand_in_the_words() -> None:
    claim = Claim("a", "Section 1", "α = {alpha} at d = {d}.", unsure, {"alpha": ("0.1", "0.2"), "d": ("1",)})
    assert claim.text == "α = 0.1; 0.2 at d = 1."
    assert Claim("b", "Section 1", "braces {as they are}", unsure).text == "braces {as they are}"


def test_a_number_is_printed_or_looked_at() -> None:
    claim = Claim("a", "Section 1", "words", unsure, {"d": ("1", "2")}, {"eta_m": ("10",)})
    assert claim.values("d") == ("1", "2")
    assert claim.number("eta_m") == "10"
    with pytest.raises(ValueError, match="too many"):
        claim.number("d")
    with pytest.raises(KeyError):
        claim.values("alpha")


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


def test_names_of_claims(toy: Paper) -> None:
    assert [claim.id for claim in toy.chosen(["i"])] == ["i-a", "i-b"]
    assert [claim.id for claim in toy.chosen(["ii", "i-b"])] == ["i-b", "ii"]  # the order of the paper
    assert toy.chosen([]) == tuple(toy.claims)
    with pytest.raises(InputError, match="'iv' is no claim: give one of i-a, i-b"):
        toy.chosen(["i", "iv"])


def test_quotes_are_the_papers_words(toy: Paper) -> None:
    assert toy.quote(toy.claim("i-a")) == "Two roots were found."
    assert toy.quote(toy.claim("i-b")) == "There are 3 roots."


def test_a_paper_that_does_not_hold_together(toy: Paper) -> None:
    with pytest.raises(InputError, match="i-a is the name of two claims"):
        replace(toy, claims=[*toy.claims, toy.claims[0]])
    with pytest.raises(InputError, match="iv has a quote"):
        replace(toy, quotes={"iv": "words"})
    with pytest.raises(InputError, match="v has a quote or a place in `slow`"):
        replace(toy, slow=["v"])


def test_the_command_that_checks_it_again(toy: Paper, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(Path(toy.where).parent)
    assert toy.command == "mpsolve audit toy"
    monkeypatch.chdir(tmp_path)
    assert toy.command == f"mpsolve audit {toy.where}"
    assert replace(toy, where="some.module").command == "mpsolve audit some.module"
    assert replace(toy, where="").command == "mpsolve audit FOLDER"
