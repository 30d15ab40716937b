"""Conclusion (i) is proved only where every α is accounted for, by exact comparison."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import flint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.claims import Verdict
from mpsolve.stability.velocities import UnstableRanges
from paper import PAPER, supercritical
from paper.supercritical import uncovered

CLAIMS = {claim.id: claim for claim in PAPER.claims}
ONE = replace(CLAIMS["i-one-mass"], at={"eta_m": ("40",), "alpha": ("1.4",)})
whole = st.integers(0, 20).map(Fraction)


@given(st.lists(st.tuples(whole, whole).map(lambda pair: (min(pair), max(pair))), max_size=6))
def test_what_is_uncovered(ranges: list[tuple[Fraction, Fraction]]) -> None:
    """Held against every half-integer point, which is inside a range or inside a gap."""
    gaps = uncovered(ranges, Fraction(3), Fraction(17))
    for k in range(6, 34):
        point = Fraction(2 * k + 1, 4)
        inside = any(low <= point <= high for low, high in ranges)
        assert inside != any(low < point < high for low, high in gaps)


def test_one_mass_is_proved_unstable() -> None:
    found = ONE.check(ONE)
    assert found.verdict is Verdict.CONDITIONAL  # one mass is proved, not all
    assert "not proved" in found.sentence
    assert len(found.certificates) == 1


@pytest.mark.parametrize("beside", [0.0, 0.01])
def test_a_gap_is_never_overlooked(monkeypatch: pytest.MonkeyPatch, beside: float) -> None:
    """A search that has lost 1.2 to 1.25, next to an open range or not: the case is unstable, but nothing says so."""
    right = supercritical.unstable_velocities

    def holed(*given: object, **more: object) -> UnstableRanges:
        found = right(*given, **more)
        (all_,) = found
        first = replace(all_, end=flint.arb(1.2), q_end=flint.arb(1))
        second = replace(all_, start=flint.arb(1.25 + beside), q_start=flint.arb(1))
        unknown = ((1.25, 1.25 + beside),) if beside else ()
        return replace(found, intervals=(first, second), unknown=(*found.unknown, *unknown))

    monkeypatch.setattr(supercritical, "unstable_velocities", holed)
    found = ONE.check(ONE)
    assert found.verdict is Verdict.UNDECIDABLE
    assert "α from 1.2 to 1.2" in found.sentence


def test_a_stable_range_refutes(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if the strip above α_C ended at 1/2 already: the case is certified stable in the middle of the gap."""
    monkeypatch.setattr(supercritical, "_STRIPS", ("0.5",))
    monkeypatch.setattr(supercritical, "unstable_up_to", lambda *_: True)
    monkeypatch.setattr(supercritical, "_not_followed", lambda *_: [])
    assert ONE.check(ONE).verdict is Verdict.REFUTED
