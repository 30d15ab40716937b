"""Inputs at which the earlier functions of ranges failed, each for a kind: now they are decided, and bounds hold."""

from __future__ import annotations

import pytest
from flint import arb

from mpsolve import Case, certify, crossings, onset, read_case, unstable_ranges, worst
from mpsolve.numbers.balls import precision
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
