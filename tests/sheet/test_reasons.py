"""Edges where a count was refused for the wrong reason: it is decided, or the remedy that is printed helps."""

from __future__ import annotations

from typing import Any

import pytest
from oracle import Truth

from mpsolve import Case, PhysicalCase, Rectangle
from mpsolve.certificate.sheet import SheetSpectrum as Spectrum
from mpsolve.certificate.sheet import certify_sheet as certify


def pair(alpha: Any, eta_b: Any, eta_m: Any = 10, d: Any = 1, **rest: Any) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d), **rest)


DECIDED = {
    "light masses at rest": (pair(0, "0.02", "0.01"), 4, 0),
    "a root 2e-9 beside the branch point": (pair("0.9999", 0, 70, "1.5"), 2, 0),
    "roots beside q = 0, supercritical": (pair("1.001", 0), 4, 2),
    "almost no damping": (pair("0.5", "1e-30"), 4, 0),
    "hardly apart": (pair(0, "0.02", 10, "0.01", eta_n="0.001"), 4, 0),
    "immense masses": (pair("0.344", "0.05", "7e27", "1.51"), 4, 0),
}


@pytest.mark.parametrize("name", DECIDED)
def test_cases_at_an_edge_are_decided(name: str) -> None:
    case, count, unstable = DECIDED[name]
    found = certify(case, digits=20)
    assert found.proved, found.reason
    assert (found.count, found.unstable) == (count, unstable)
    truth = Truth(case, 90)
    for root in found.roots:
        q = truth.middle(root.q)
        step = abs(truth.delta(q)) / abs(truth.mp.diff(truth.delta, q, h=abs(q) * truth.mp.mpf(10) ** -45))
        assert step < abs(q) * truth.mp.mpf(10) ** -20


@pytest.mark.slow
@pytest.mark.parametrize(("case", "count"), [(pair(20, "0.1"), 28), (pair("0.5", "0.1", eta_n="-1e6"), 2)])
def test_many_roots_and_strong_tension_are_decided(case: Case, count: int) -> None:
    found = certify(case, digits=15)
    assert found.proved, found.reason
    assert found.count == count


def why(found: Spectrum, code: str, *words: str) -> str:
    """The remedy, of an undecided answer with this code; the sentence speaks of these words."""
    assert not found.proved
    assert found.why is not None
    assert found.why.code == code
    assert found.reason == str(found.why)
    for word in words:
        assert word in found.reason
    return found.why.remedy


def test_the_branch_point_is_named_and_the_unstable_region_helps() -> None:
    case = Case(alpha=0, eta_b="0.1", eta_m=[5] * 4, positions=range(4))
    remedy = why(certify(case), "branch-point", "branch point of the cuts at Re q = 0.99498744")
    assert remedy == 'ask for the region "unstable"'
    assert "a root lies" not in certify(case).reason


@pytest.mark.slow
def test_the_unstable_region_helps_next_to_a_load_at_rest() -> None:
    case = pair("1e-9", "0.1")
    assert why(certify(case), "branch-point") == 'ask for the region "unstable"'
    assert certify(case, region="unstable", digits=15).unstable == 0


@pytest.mark.slow
def test_the_unstable_region_helps_at_rest() -> None:
    case = pair(0, "0.02", 10, "0.01")
    remedy = why(certify(case), "resting-branch-point", "a root may lie next to the branch point Re q = 0.99979998")
    assert remedy == 'ask for the region "unstable"'
    assert certify(case, region="unstable", digits=15).unstable == 0


@pytest.mark.parametrize("alpha", ["1.0001", "0.999999"])
def test_next_to_the_critical_velocity_another_velocity_helps(alpha: str) -> None:
    remedy = why(certify(pair(alpha, 0)), "near-critical", f"alpha = {alpha}", "alpha_C = 1")
    assert remedy == "take alpha further from alpha_C"
    further = "1.001" if alpha > "1" else "0.999"
    assert certify(pair(further, 0), digits=15).proved


def test_pieces_run_out_and_more_of_them_help() -> None:
    remedy = why(certify(pair("0.67", "0.05"), max_pieces=30), "pieces", "more than 30 pieces")
    assert "raise max_pieces" in remedy
    assert certify(pair("0.67", "0.05"), max_pieces=3000, digits=15).proved


def test_a_rectangle_beside_the_cut_is_told_to_keep_away() -> None:
    box = Rectangle("-2", "2", "-0.01", "0.0999999999999999")
    remedy = why(certify(pair("0.5", "0.1"), region=box), "beside-cut", "im_max = 0.0999999999999999", "eta_b = 0.1")
    assert remedy == "take im_max further from eta_b"
    assert certify(pair("0.5", "0.1"), region=Rectangle("-2", "2", "-0.01", "0.05"), digits=15).proved


@pytest.mark.parametrize("size", ["1e9", "1e12"])
def test_an_immense_rectangle_is_refused_at_once_and_its_size_named(size: str) -> None:
    box = Rectangle(f"-{size}", size, f"-{size}", 0)
    found = certify(pair("0.5", "0.1"), region=box)
    assert (
        why(found, "rectangle-too-large", "no root has |q − i eta_b| ≥ 128") == "end it at ±128, which loses no root"
    )
    assert found.evaluations == 0


@pytest.mark.slow
def test_the_rectangle_that_is_advised_is_proved() -> None:
    assert certify(pair("0.5", "0.1"), region=Rectangle(-128, 128, -128, 0), digits=15).count == 0


@pytest.mark.slow
def test_more_roots_than_a_certificate_lists_are_told_by_their_number() -> None:
    case = pair("0.5", "0.1", d=1100)
    remedy = why(certify(case), "too-many-roots", "316 roots", "300")
    assert remedy == 'ask for the region "unstable", or for a rectangle about the roots that matter'
    assert certify(case, region="unstable", digits=15).unstable == 0
    assert certify(case, region=Rectangle("0.05", "0.5", "-0.2", "0.08"), digits=15).count == 2
    soft = PhysicalCase(EI="6.4", m=60, k="1e6", c=770, v=100, masses=[("1e4", 0), ("1e4", "3.4")])
    why(certify(soft), "too-many-roots", "664 roots")


def test_a_reason_that_a_root_is_missing_says_how_many() -> None:
    from mpsolve.sheet import reasons

    assert "unstable" in reasons.missing_helps(pair("0.67", "0.05"), "sheet")
    assert "unstable" not in reasons.missing_helps(pair("0.67", 0), "sheet")
    assert reasons.root_on_contour(0.25).numbers["near"] == "0.25"
