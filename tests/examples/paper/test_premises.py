"""What the paper says in passing: the verdicts, and that another wording turns them."""

from __future__ import annotations

from dataclasses import replace

import pytest

from mpsolve.claims import Finding, Verdict
from paper.premises import CLAIMS

BY_ID = {claim.id: claim for claim in CLAIMS}


def found(name: str, **printed: str) -> Finding:
    claim = BY_ID[name]
    changed = {key: tuple(text.split("; ")) for key, text in printed.items()}
    return claim.check(replace(claim, printed={**claim.printed, **changed}))


@pytest.mark.parametrize(
    ("name", "verdict", "other", "instead"),
    [
        ("2-pasternak", Verdict.PROVED, {"force": "compression"}, Verdict.REFUTED),
        ("3-buckling", Verdict.PROVED, {"factor": "4"}, Verdict.REFUTED),
        ("3-doubled", Verdict.SLIP, {"power": "2"}, Verdict.PROVED),
        ("3-distinct", Verdict.CONDITIONAL, {"number": "three"}, Verdict.REFUTED),
        ("4.1-axial", Verdict.PROVED, {"way": "increases"}, Verdict.REFUTED),
        ("4.1-symmetry", Verdict.PROVED, {"matrices": "M; C; K"}, Verdict.REFUTED),
    ],
)
def test_verdicts(name: str, verdict: Verdict, other: dict[str, str], instead: Verdict) -> None:
    assert found(name).verdict is verdict
    assert found(name, **other).verdict is instead


def test_the_frequency_of_the_beam_under_tension_and_compression() -> None:
    """√(1 − N²) is the lowest frequency of a wave only where N > 0."""
    claim = BY_ID["3-frequency"]
    assert claim.check(claim).verdict is Verdict.CONDITIONAL
    assert dict(claim.check(claim).numbers).popitem()[1].startswith("0.86602540378")
    assert claim.check(replace(claim, at={"eta_n": ("-0.5",)})).verdict is Verdict.PROVED
