"""Onsets at the worst value of a second parameter, against onsets at given values, proved in another way."""

from __future__ import annotations

from functools import cache

import pytest
from flint import arb

from mpsolve import Case, Effort, InputError, onset, read_problem
from mpsolve.numbers.balls import precision
from mpsolve.ranges.onset import Kind, Onset

RANGES = {"inside": ("1.05", "1.2"), "end": ("0.8", "0.9"), "start": ("1.4", "1.5")}
MASS = {"scale.mass": ("0.5", 40)}


def pair(alpha: str, eta_b: str, distance: str = "1") -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(1, 1), positions=(0, distance))


@cache
def worst(where: str, digits: int = 20) -> Onset:
    case = pair("0.99", "0.5", RANGES[where][0])
    return onset(case, over=MASS, worst={"gap[0]": RANGES[where]}, digits=digits, check=False)


def at(distance: str, eta_b: str = "0.5") -> Onset:
    return onset(pair("0.99", eta_b, distance), over=MASS, digits=20, check=False)


def test_the_paper_s_limiting_mass_at_the_worst_distance() -> None:
    """α = 0.99, η_b = 0.1: 21.9 of Section 4.3 belongs to d = 1.1; the least one lies at 1.2253."""
    found = onset(pair("0.99", "0.1"), over=MASS, worst={"gap[0]": (1, 2)}, digits=20)
    assert (found.proved, found.kind, found.where) == (True, Kind.CROSSES, "inside"), found.reason
    with precision(120):
        assert abs(found.value - arb("20.7242031280847")) < arb("3e-14")  # of another proof, by discs
        assert abs(found.worst - arb("1.22530013071126")) < arb("1e-14")
        assert found.value.rad() < arb(10) ** -18
    assert found.lower <= 20.7242031280847 <= found.upper  # type: ignore[operator]


@pytest.mark.parametrize("where", ["inside", pytest.param("end", marks=pytest.mark.slow), "start"])
def test_no_value_is_worse(where: str) -> None:
    found = worst(where)
    assert (found.proved, found.where) == (True, where), found.reason
    low, high = map(float, RANGES[where])
    with precision(120):
        assert found.value is not None
        assert found.worst is not None
        for k in range(3):
            assert not at(f"{low + (high - low) * k / 2:.4f}").value < found.value
        here = at(found.worst.mid().str(30, radius=False)) if where == "inside" else at(RANGES[where][where == "end"])
        assert abs(here.value - found.value) < arb(10) ** -16  # it is stationary there, or the end itself


@pytest.mark.parametrize(
    ("low", "high"),
    # beside the worst distance 1.22530013 of all: the least mass rises from the start, however narrow the range;
    # once, in a narrow range, a mass that is not the least was called so
    [
        ("1.24", "1.2402"),
        pytest.param("1.2283", "1.2284", marks=pytest.mark.slow),
        pytest.param("1.235", "1.2351", marks=pytest.mark.slow),
        pytest.param("1.2353", "1.2853", marks=pytest.mark.slow),
    ],
)
def test_beside_the_worst_value_of_all_the_start_is_worst(low: str, high: str) -> None:
    found = onset(pair("0.99", "0.1", low), over=MASS, worst={"gap[0]": (low, high)}, check=False)
    assert (found.proved, found.where) == (True, "start"), found.reason
    with precision(100):
        assert found.worst.overlaps(arb(low))
        assert found.value.overlaps(at(low, "0.1").value)
        assert found.value < at(high, "0.1").value


@pytest.mark.parametrize("high", ["1.2253", pytest.param("1.2254", marks=pytest.mark.slow)])
def test_next_to_an_end_nothing_wrong_is_said(high: str) -> None:
    found = onset(pair("0.99", "0.1"), over=MASS, worst={"gap[0]": ("1.2", high)}, check=False)
    if found.proved:
        with precision(100):
            assert abs(found.value - arb("20.7242031280847")) < arb("1e-9")


@pytest.mark.parametrize("low", ["20.7243", "20.73"])
def test_a_least_crossing_before_the_range_is_no_onset_in_it(low: str) -> None:
    """At most distances nothing grows at its start, and floats see later onsets; but at 1.2253 roots grow there."""
    masses = {"scale.mass": (low, 40)}
    found = onset(pair("0.99", "0.1"), over=masses, worst={"gap[0]": ("1.1", "1.6")}, check=False)
    assert (found.kind, found.value) == (Kind.UNSTABLE_FROM_START, None)
    assert onset(pair("0.99", "0.1", str(float(found.worst))), over=masses).kind is Kind.UNSTABLE_FROM_START
    assert onset(pair("0.99", "0.1", "1.2253"), over=masses, check=False).kind is Kind.UNSTABLE_FROM_START


def test_nothing_grows() -> None:
    found = onset(pair("0.3", "0.5"), over={"scale.mass": (1, 2)}, worst={"gap[0]": (1, "1.2")}, check=False)
    assert (found.proved, found.kind, found.value) == (True, Kind.STABLE, None), found.reason


def test_other_parameters() -> None:
    """The onset velocity at the worst distance: no distance has a lower one."""
    case = Case(alpha="0.5", eta_b="0.1", eta_m=(40, 40), positions=(0, "1.2"))
    found = onset(case, over={"v": ("0.5", "0.99")}, worst={"gap[0]": (1, "1.5")}, check=False)
    assert found.proved, found.reason
    for distance in ("1", "1.2", "1.5"):
        other = Case(alpha="0.5", eta_b="0.1", eta_m=(40, 40), positions=(0, distance))
        there = onset(other, over={"v": ("0.5", "0.99")}, check=False)
        with precision(100):
            assert not there.value < found.value  # type: ignore[operator]


def test_effort_and_input() -> None:
    case = pair("0.99", "0.1")
    found = onset(case, over=MASS, worst={"gap[0]": (1, 2)}, effort=Effort(evaluations=5), check=False)
    assert (found.kind, found.reason.code) == (Kind.UNDECIDED, "effort")  # type: ignore[union-attr]
    with pytest.raises(InputError, match="of two different ones"):
        onset(case, over=MASS, worst=MASS)
    with pytest.raises(InputError, match="unknown"):
        onset(case, over=MASS, worst={"gap[4]": (1, 2)})


@pytest.mark.slow
def test_a_rail_s_onset_velocity_at_the_worst_distance() -> None:
    """Roots that move along the real axis far more than across it."""
    problem = read_problem("examples/rail_60e1.toml").problem
    found = onset(problem, over={"v": (50, 250)}, worst={"gap[0]": (1, 5)}, check=False)
    assert (found.proved, found.where) == (True, "inside"), found.reason
    with precision(100):
        assert abs(found.value - arb("143.767117931479")) < arb("1e-12")
    for gap in ("4.3", "4.4", "4.5"):
        there = onset(problem.changed("gap[0]", gap), over={"v": (50, 250)}, check=False)
        with precision(100):
            assert there.value > found.value  # type: ignore[operator]


def test_nothing_grows_on_an_undamped_beam_whatever_the_second_is() -> None:
    found = onset(pair("0.9", "0"), over=MASS, worst={"gap[0]": (1, 2)})
    assert (found.kind, found.proved, found.value, found.where) == (Kind.STABLE, True, None, "")
