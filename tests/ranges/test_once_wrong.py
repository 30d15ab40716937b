"""Inputs at which the earlier functions of ranges failed, each for a kind: now they are decided, and bounds hold."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from flint import arb

from mpsolve import (
    Case,
    Effort,
    certify,
    crossings,
    cut_points,
    onset,
    read_case,
    sensitivity,
    unstable_ranges,
    worst,
)
from mpsolve.numbers.balls import precision
from mpsolve.numbers.packed import dyadic
from mpsolve.problem.cases import as_problem
from mpsolve.ranges.onset import Kind


def pair(eta_b: str, eta_m: int | str, distance: str = "1.5", alpha: str = "0.7") -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, distance))


def test_a_float_handed_out_as_a_bound_is_one() -> None:
    """`stable_below` was above the onset: floats were rounded to nearest."""
    found = onset(pair("0.05", 70, "1"), over={"alpha": (0, 1)}, digits=40, check=False)
    with precision(300):
        assert arb(found.lower) <= found.value
        assert arb(found.upper) >= found.value


@pytest.mark.parametrize("beside", [-1, 1])
def test_an_answer_at_the_very_end_of_a_range_is_in_it_or_not(beside: int) -> None:
    """1e-20 beside the end: compared in 53 bits it was on the wrong side, and the count before it was never ended."""
    case, little = pair("0.05", 70), Fraction(beside, 10**20)
    value = dyadic(crossings(case, over={"v": ("0.66", "0.69")}, digits=40, check=False).crossings[0].value.mid())
    for over, inside in (((value + little, "0.69"), beside < 0), (("0.66", value + little), beside > 0)):
        found = crossings(case, over={"v": over}, digits=40, check=inside)
        assert found.counts is not None, found.reason
        assert (len(found.crossings), found.certificate is not None) == (int(inside), inside)
        assert {0, 2} >= set(found.counts)
        assert onset(case, over={"v": over}, digits=40, check=False).kind is (
            Kind.CROSSES if inside else Kind.UNSTABLE_FROM_START if beside > 0 else Kind.STABLE
        )


@pytest.mark.parametrize("beside", [-1, 1])
def test_a_cut_point_at_the_very_end_of_a_range_is_in_it_or_not(beside: int) -> None:
    """Not provably outside was taken for inside."""
    case = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, "0.5"))
    value = dyadic(cut_points(case, over={"v": ("0.7", "0.8")}, digits=40).points[0].value.mid())
    end = value + Fraction(beside, 10**20)
    found = cut_points(case, over={"v": (end, "0.8")}, digits=40)
    assert (found.proved, len(found.points)) == (True, int(beside < 0))


def test_ends_have_the_digits_that_were_asked_for() -> None:
    """The end of the range itself had a radius of 1e-16 whatever was asked."""
    found = unstable_ranges(pair("0.05", 70), over={"alpha": ("0.7", "0.8")}, digits=100, check=False)
    with precision(500):
        assert found.intervals[0].end.overlaps(arb("0.8"))
        assert found.intervals[0].end.rad() < arb(10) ** -99


@pytest.mark.parametrize("eta_b", ["0.99", pytest.param("1", marks=pytest.mark.slow)])
def test_critical_damping_is_no_limit(eta_b: str) -> None:
    """An error of an inner call came out, about an argument that the caller lacked."""
    found = worst(pair(eta_b, 70, "1", "0.99"), over={"d": ("0.9", "1.2")}, check=False)
    assert (found.proved, found.where) == (True, "inside"), found.reason
    region = certify(as_problem(pair(eta_b, 70, "1.04", "0.99")), region="unstable", digits=15, check=False)
    here = min(float(root.q.imag.mid()) for root in region.roots)
    assert float(found.q.imag.mid()) <= here < float(found.q.imag.mid()) + 1e-5  # type: ignore[union-attr]


def test_two_crossings_that_nearly_meet_are_both_found() -> None:
    """A stable window of 9e-4 beside a tangency: the second crossing was never sought."""
    heavy = "56.538095493450703825985840189429867707"
    found = crossings(pair("0.05", heavy), over={"alpha": ("0.92", "0.94")}, check=False)
    assert (found.proved, found.counts) == (True, (2, 0, 2)), found.reason
    first, second = found.crossings
    with precision(80):
        assert second.value - first.value < arb("9.1e-4")
    for alpha, number in (("0.9305", 2), ("0.931", 0), ("0.9316", 2)):
        case = pair("0.05", heavy, alpha=alpha)
        assert certify(as_problem(case), region="unstable", digits=15, check=False).unstable == number


def test_a_case_in_si() -> None:
    """Some functions took no `PhysicalCase`."""
    found = worst(read_case("examples/rail_60e1.toml"), over={"gap[0]": (4, 6)}, check=False)
    assert (found.proved, found.where) == (True, "inside"), found.reason


def test_little_damping_is_decided() -> None:
    """0.6 to 0.68 was decided, 0 to 2 was not."""
    found = onset(pair("0.001", 70), over={"alpha": (0, 1)}, check=False)
    assert (found.proved, found.kind) == (True, Kind.CROSSES), found.reason
    with precision(80):
        assert abs(found.value - arb("0.670338073431986")) < arb("1e-14")


def test_a_range_that_starts_unstable_says_so() -> None:
    """The onset was the start of the range, with only a missing frequency to tell."""
    found = onset(pair("0.05", 70), over={"alpha": ("0.8", "0.9")}, check=False)
    assert (found.kind, found.value) == (Kind.UNSTABLE_FROM_START, None)


def test_a_tangency_leaves_no_splinters() -> None:
    """Seven parts of 1e-12 stood beside the two that there are."""
    heavy = "56.538095493450703825985840189429867707"
    found = unstable_ranges(pair("0.05", heavy), over={"alpha": ("0.8", "1.1")}, check=False)
    assert [part.roots for part in found.intervals] == [2, 2], found.reason


@pytest.mark.parametrize(("masses", "value"), [(3, 0.576100006077866), (4, 0.604561878246094)])
def test_rows_of_masses_are_decided(masses: int, value: float) -> None:
    """Three were open in part, four entirely; float counts at both sides, which know no boxes, agree."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(70,) * masses, positions=tuple(1.5 * k for k in range(masses)))
    found = onset(case, over={"alpha": (0, "0.7")}, check=False)
    assert (found.proved, found.kind) == (True, Kind.CROSSES), found.reason
    assert float(found.value) == pytest.approx(value, rel=1e-14)
    for alpha, number in ((value - 1e-3, 0), (value + 1e-3, 2)):
        beside = as_problem(case).changed("v", alpha)
        assert certify(beside, region="unstable", digits=15, check=False).unstable == number


def test_a_lowest_point_at_the_end_of_a_range() -> None:
    found = worst(pair("0.05", 70, "1", "0.99"), over={"d": ("0.5", "0.8")}, check=False)
    assert (found.proved, found.where) == (True, "end"), found.reason


def test_digits_may_be_of_numpy() -> None:
    found = onset(pair("0.05", 70), over={"alpha": ("0.6", "0.7")}, digits=np.int64(15), check=False)  # type: ignore[arg-type]
    assert found.kind is Kind.CROSSES


def test_slopes_of_a_case_in_si() -> None:
    found = sensitivity(read_case("examples/rail_60e1.toml"), region="unstable", check=False)
    assert (found.proved, dict(found.left_out)) == (True, {}), found.reason


def test_little_effort_comes_back_with_what_is_known() -> None:
    found = crossings(pair("0.05", 70), over={"alpha": (0, 2)}, effort=Effort(evaluations=60), check=False)
    assert found.reason is not None
    assert (found.reason.code, found.counts) == ("effort", None)
    assert "crossings" in found.known


@pytest.mark.parametrize(("eta_b", "value"), [("0.05", 1.02013470295674), ("0.5", 1.18992400338347)])
def test_an_onset_next_to_the_passivity_velocity(eta_b: str, value: float) -> None:
    """A mass of 10⁶: its crossing runs to q = 0, and the onset was open."""
    case = Case(alpha="0.5", eta_b=eta_b, eta_m=(10**6,), positions=(0,))
    found = onset(case, over={"alpha": ("0.5", "1.5")}, check=False)
    assert (found.proved, found.kind) == (True, Kind.CROSSES), found.reason
    assert float(found.value) == pytest.approx(value, rel=1e-14)
    assert float(found.q) < 0.01  # type: ignore[arg-type]
