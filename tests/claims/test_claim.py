"""The words and the numbers of a claim."""

from __future__ import annotations

import pytest

from mpsolve.claims import Claim, Finding, Verdict


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
