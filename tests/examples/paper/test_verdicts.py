"""Verdicts follow the printed numbers: a wrong number is refuted, a right one in its place proved."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb

from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.errors import PrecisionError
from paper import PAPER, undamped

CLAIMS = {claim.id: claim for claim in PAPER.claims}


def found(name: str, at: dict | None = None, **printed: str) -> Finding:
    """The finding of a claim with other printed numbers, or looked at elsewhere."""
    claim: Claim = CLAIMS[name]
    changed = {key: tuple(text.split("; ")) for key, text in printed.items()}
    claim = replace(claim, printed={**claim.printed, **changed}, at={**claim.at, **(at or {})})
    return claim.check(claim)


@pytest.mark.parametrize(
    ("name", "right", "wrong"),
    [
        ("4.2-final-10", {}, {"alpha": "0.37; 0.67; 0.72"}),
        ("4.2-final-40-near", {}, {"alpha": "0.74; 0.86; 0.88"}),
        ("fig-8-variable", {}, {"alone": "0.5; 1"}),
        ("fig-6-constant", {}, {"alone": "2; 2.5"}),
        ("v-embedded-undamped", {}, {"lower": "outside"}),
        ("ii", {}, {"limit": "α_C"}),
        ("vi-mass", {}, {"way": "higher"}),
        ("x", {}, {"range": "supercritical"}),
        ("iv", {}, {"level": "2η_b"}),
        ("fig-11-unstable", {"alpha": "0.8", "unstable": "0.8 1.5"}, {"alpha": "0.8", "unstable": "0.8 1"}),
    ],
)
def test_a_right_number_is_proved_and_a_wrong_one_refuted(name: str, right: dict, wrong: dict) -> None:
    assert found(name, **right).verdict is Verdict.PROVED
    assert found(name, **wrong).verdict is Verdict.REFUTED


def test_the_onset_of_section_4_3() -> None:
    one = {"d": "1", "eta_m": "70"}
    assert found("4.3-onset", **one, alpha="0.97").verdict is Verdict.PROVED
    assert found("4.3-onset", **one, alpha="0.96").verdict is Verdict.REFUTED


def test_a_velocity_next_above_the_onset_that_is_stable_again_proves_nothing() -> None:
    """η_M = 37.7734, d = 1.5: unstable from 0.77085 to 0.78901 only, so that 0.8 is stable."""
    narrow = found("4.3-onset", d="1.5", eta_m="37.7734", alpha="0.8")
    assert narrow.verdict is Verdict.UNDECIDABLE
    assert "stable again at 0.8" in narrow.sentence


def test_balls_that_overlap_refute_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(PrecisionError, match="overlap"):
        found("fig-11-decay", {"d": ("1",)}, alpha="0.5", eta_m="70; 70.00000000000000000000001")
    monkeypatch.setattr(undamped, "higher_end", lambda _m, _d: arb(0.8, 0.01))
    assert found("vi-mass").verdict is Verdict.UNDECIDABLE


def test_the_limiting_masses_of_conclusion_xii_and_what_reproduces_them() -> None:
    """Both printed numbers are refuted; the search finds d = 1.1, with the damping ratios exchanged, by itself."""
    for name, other in (("xii-a", "0.1"), ("xii-b", "0.05")):
        printed = found(name)
        assert printed.verdict is Verdict.REFUTED
        assert any("d = 1.1 both" in line and "exchanged" in line for line in printed.search)
        assert any(f"η_b = {other}, d = 1.1" in line for line in printed.search)
    assert found("xii-a", eta_m="33.1").verdict is Verdict.PROVED
    assert found("xii-b", eta_m="20.8").verdict is Verdict.PROVED


def test_the_order_of_the_lines_with_damping() -> None:
    assert found("v-embedded-damped").verdict is Verdict.REFUTED
    assert found("vi-outside-damped").verdict is Verdict.REFUTED
    assert found("v-embedded-damped", at={"cases": ("0.05 0.5 40 1",)}).verdict is Verdict.UNDECIDABLE


def test_numbers_of_pairs() -> None:
    assert found("3-most-pairs", at={"searched": ()}).verdict is Verdict.REFUTED
    assert found("3-most-pairs", pairs="6").verdict is Verdict.UNDECIDABLE
    assert found("v-pairs-damped").verdict is Verdict.REFUTED
    assert found("v-pairs-damped", at={"cases": ("0.05 0.5 70 1",)}).verdict is Verdict.UNDECIDABLE
    assert found("3-pairs").verdict is Verdict.CONDITIONAL
    assert found("3-pairs", at={"alpha": ("0.5",)}).verdict is Verdict.UNDECIDABLE


def test_four_signs_without_damping() -> None:
    """Four purely imaginary roots at α = 1.4, η_M = 70, d = 2; none at α = 1.2."""
    place = {"eta_m": ("70",), "d": ("2",)}
    assert found("iii", at={**place, "alpha": ("1.4",)}).verdict is Verdict.REFUTED
    assert found("iii", at={**place, "alpha": ("1.2",)}).verdict is Verdict.CONDITIONAL


def test_distances() -> None:
    assert found("vi-distance").verdict is Verdict.REFUTED
    assert found("v-distance").verdict is Verdict.REFUTED
    assert found("v-distance", at={"alpha": ()}).verdict is Verdict.UNDECIDABLE


def test_the_subcritical_velocity() -> None:
    assert found("4.3-subcritical").verdict is Verdict.CONDITIONAL
    assert found("4.3-subcritical", eta_b="0.04:0.01:0.19").verdict is Verdict.PROVED
    assert found("4.3-subcritical", alpha="1.01").verdict is Verdict.REFUTED


def test_the_axis_that_a_root_crosses() -> None:
    assert found("4.4-method").verdict is Verdict.SLIP
    assert found("4.4-method", axis="real").verdict is Verdict.PROVED


def test_amplitudes() -> None:
    assert found("vii").verdict is Verdict.PROVED
    assert found("vii", at={"alpha": ("0.5",)}).verdict is Verdict.UNDECIDABLE
    assert found("fig-3").verdict is Verdict.REFUTED
    assert found("fig-3", alpha="0.5; 0.8").verdict is Verdict.PROVED
    assert found("fig-7").verdict is Verdict.PROVED
    assert found("fig-7", at={"alpha": ("0.3", "0.5")}).verdict is Verdict.UNDECIDABLE
    assert found("fig-A.2").verdict is Verdict.AGREES
    assert found("fig-A.2", first="1").verdict is Verdict.DISAGREES
    assert found("5-not-damping").verdict is Verdict.REFUTED


def test_one_proved_fall_refutes_a_trend() -> None:
    """(ix) says that differences grow as η_M falls, and grow with d up to one limit, after which they fall."""
    near = {"alpha": ("0.9",), "d": ("2.5",)}
    assert found("ix-mass", at=near).verdict is Verdict.REFUTED
    assert len(found("ix-mass", at=near).certificates) == 2
    assert found("ix-mass", at={**near, "d": ("2", "3")}).verdict is Verdict.CONDITIONAL
    assert found("ix-distance", at={"eta_m": ("40",)}).verdict is Verdict.CONDITIONAL  # up to d = 3, then down
    assert found("ix-distance", at={"eta_m": ("70",)}).verdict is Verdict.REFUTED  # down, then up
    assert (
        found("ix-distance", at={"eta_m": ("40",), "d": ("0.5", "1", "1.5")}).verdict is Verdict.REFUTED
    )  # no limit


def test_a_last_velocity_is_certified_at_itself_and_the_next() -> None:
    names = [name for name, _ in found("4.2-final-10", d="0.5:0.5:0.5", alpha="0.37").certificates]
    assert names == ["4.2-final-10_d0.5_alpha0.37", "4.2-final-10_d0.5_alpha0.38"]


def test_what_is_proved_for_a_list_only_is_a_condition() -> None:
    pairs = found("v-pairs-undamped")
    assert pairs.verdict is Verdict.CONDITIONAL
    assert "not proved" in pairs.sentence
    assert len(pairs.certificates) == 6


def test_superposition() -> None:
    """(viii) draws the line at d = 4.5, Section 4.2 has none even there: the first tells of the second."""
    few = {"alpha": ("0.9",), "eta_m": ("70",)}
    line = found("viii-superposition", at=few)
    assert line.verdict is Verdict.CONDITIONAL
    assert "contradicts Section 4.2" in line.sentence
    assert "more than at d = 4 for η_M = 70, α = 0.9" in line.sentence
    assert found("4.2-superposition", at=few).verdict is Verdict.CONDITIONAL
    limit = {"alpha": ("0.5",), "d": ("4.5", "9")}
    assert found("ix-superposition", at=limit).verdict is Verdict.CONDITIONAL
    assert found("ix-superposition", at={**limit, "d": ("9", "4.5")}).verdict is Verdict.UNDECIDABLE


def test_the_number_of_frequencies_and_the_interval() -> None:
    more = found("5-more-frequencies", at={"cases": ("0 0.8 40 0.5",)})
    assert (more.verdict, len(more.certificates)) == (Verdict.REFUTED, 2)
    assert found("5-more-frequencies", at={"cases": ("0 0.5 40 0.5",)}).verdict is Verdict.UNDECIDABLE
    assert found("1-interval").verdict is Verdict.REFUTED
    assert found("1-interval", at={"eta_m": ("70",), "alpha": ("0.8",)}).verdict is Verdict.UNDECIDABLE


def test_figure_9() -> None:
    few = {"lines": ("70 0.5", "70 1"), "alpha": ("0.9",)}
    assert found("4.3-no-duplication", at=few).verdict is Verdict.CONDITIONAL
    assert found("4.3-no-duplication", at={**few, "eta_b": ("0",)}).verdict is Verdict.UNDECIDABLE
    assert "cut in 1 (η_M = 70, d = 0.5)" in found("vi-cut-damped", at=few).sentence
    masses = {"d": ("1.5:1.5:1.5",) * 2, "alpha": ("0.5",)}
    assert found("4.3-rapidly", at=masses).verdict is Verdict.CONDITIONAL
    assert found("4.3-rapidly", at={**masses, "eta_m": ("70", "10")}).verdict is Verdict.UNDECIDABLE


def test_the_transient_part_is_temporary() -> None:
    short = {"d": ("0.5",)}
    assert found("5-temporary", at=short).verdict is Verdict.AGREES
    assert found("5-temporary", at={**short, "tau": ("8", "40")}).verdict is Verdict.DISAGREES  # too much is left
    assert found("5-temporary", at={"d": ("1.5",), "tau": ("8", "40")}).verdict is Verdict.DISAGREES  # it grows


def test_what_reproduces_the_most_pairs() -> None:
    few = {"cases": ("0.99 1.4 10 4.5",), "searched": ("0",)}
    (line,) = found("3-most-pairs", at=few).search
    assert line.endswith("as printed")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "verdict"),
    [
        ("xi", Verdict.CONDITIONAL),
        ("4.3-limit", Verdict.CONDITIONAL),
        ("fig-12-text", Verdict.CONDITIONAL),
        ("fig-12-caption", Verdict.REFUTED),
        ("fig-12-order", Verdict.CONDITIONAL),
    ],
)
def test_long_checks(name: str, verdict: Verdict) -> None:
    assert found(name).verdict is verdict
