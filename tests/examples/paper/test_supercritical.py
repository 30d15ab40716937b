"""Conclusion (i) is proved only where every α is accounted for."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from mpsolve.claims import Verdict
from paper import PAPER, supercritical

CLAIMS = {claim.id: claim for claim in PAPER.claims}
ONE = replace(CLAIMS["i-one-mass"], at={"eta_m": ("40",), "alpha": ("1.4",)})


def test_one_mass_is_proved_unstable() -> None:
    found = ONE.check(ONE)
    assert found.verdict is Verdict.CONDITIONAL  # one mass is proved, not all
    assert "not proved" in found.sentence
    assert len(found.certificates) == 1


def test_a_gap_is_never_overlooked(monkeypatch: pytest.MonkeyPatch) -> None:
    """A follower that loses the root from 1.2 to 1.25: the case is unstable, but nothing says so."""
    right = supercritical.stays_below

    def holed(problem: object, over: dict[str, tuple[Fraction, Fraction]], q: object) -> bool:
        low, high = over["v"]
        return not (low < Fraction("1.25") and high > Fraction("1.2")) and right(problem, over, q)

    monkeypatch.setattr(supercritical, "stays_below", holed)
    monkeypatch.setattr(supercritical, "_HALVINGS", 3)
    found = ONE.check(ONE)
    assert found.verdict is Verdict.UNDECIDABLE
    assert "α from 1.1" in found.sentence


def test_a_stable_range_refutes(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if the strip above α_C ended at 1/2 already: the case is certified stable below α_C."""
    monkeypatch.setattr(supercritical, "_STRIPS", ("0.5",))
    monkeypatch.setattr(supercritical, "_HALVINGS", 1)
    monkeypatch.setattr(supercritical, "unstable_up_to", lambda *_: True)
    assert ONE.check(ONE).verdict is Verdict.REFUTED
