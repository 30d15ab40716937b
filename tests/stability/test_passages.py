"""All passages of a range: counts between them are those that `certify` finds, and what is open is called open."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest

from mpsolve import Case
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.exact import Exact
from mpsolve.sheet.far import prove_far
from mpsolve.stability.family import Family
from mpsolve.stability.passages import Passages, _down, _events, _gaps, _runs, _up, passages
from mpsolve.stability.search import Strip
from mpsolve.stability.zero import Zero

PAIR = {"eta_m": (30, 30), "positions": (0, 1)}
RUNS = {
    "one mass": (Family(Case(alpha=0, eta_b="0.05", eta_m=70), "alpha"), "1", "1.2"),
    "two masses": (Family(Case(alpha=0, eta_b="0.1", eta_m=(70, 30), positions=(0, 1)), "alpha"), "0.8", "1.1"),
    "distance": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "distance"), "0.5", "2"),
    "damping": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "eta_b"), "0.05", "0.5"),
    "axial force": (Family(Case(alpha=0, eta_b="0.1", eta_m=20, eta_n="0.25", eta_s="0.05"), "alpha"), "0.7", "1.2"),
}


def run(name: str, **options: Any) -> Passages:
    family, start, end = RUNS[name]
    return passages(family, Exact(start), Exact(end), 20, **options)


@pytest.mark.parametrize("name", RUNS)
def test_the_counts_are_those_of_single_cases(name: str) -> None:
    result = run(name)
    assert result.proved
    assert len(result.counts) == len(result.zeros) + 1
    assert all(count is not None and count >= 0 for count in result.counts)
    rng = np.random.default_rng(1)
    edges = [float(result.start), *(float(zero.t.mid()) for zero in result.zeros), float(result.end)]
    for low, high, count in zip(edges, edges[1:], result.counts, strict=False):
        share = Fraction(int(rng.integers(1, 99)), 100)
        t = Exact(Fraction(low) + (Fraction(high) - Fraction(low)) * share)
        assert certify(result.family.case_at(t), digits=15, region="unstable").unstable == count


@pytest.mark.parametrize("name", ["one mass", pytest.param("distance", marks=pytest.mark.slow)])
def test_parts_of_a_range_have_the_passages_of_the_whole(name: str) -> None:
    """Cut next to a passage, on either side: none is lost, none is found twice."""
    family, start, end = RUNS[name]
    whole = run(name)
    with ball_arithmetic(100):
        near = Fraction(whole.zeros[0].t.str(25, radius=False))
    for offset in (Fraction(1, 10**9), -Fraction(1, 10**9)):
        cut = Exact(near + offset)
        parts = [passages(family, Exact(start), cut, 20), passages(family, cut, Exact(end), 20)]
        assert all(part.proved for part in parts)
        assert len(parts[0].zeros) == (1 if offset > 0 else 0)
        both = [zero for part in parts for zero in part.zeros]
        assert len(both) == len(whole.zeros)
        assert all(a.t.overlaps(b.t) for a, b in zip(both, whole.zeros, strict=True))
        assert (*parts[0].counts, *parts[1].counts[1:]) == whole.counts


@pytest.mark.parametrize("name", ["one mass", "damping"])
def test_no_root_lies_beyond_the_radius(name: str) -> None:
    result = run(name)
    W = (2 * result.radius) ** 0.5
    with ball_arithmetic(64) as field:
        for t in np.linspace(float(result.start), float(result.end), 7):
            prove_far(result.family.at(field, flint.arb(t)), W)


def test_too_little_effort_leaves_a_strip_and_no_wrong_count() -> None:
    result = run("distance", budget=50)
    assert not result.proved
    assert result.strips
    full = run("distance")
    for zero in full.zeros:
        t = float(zero.t.mid())
        assert any(s.start <= t <= s.end for s in result.strips) or any(t in _span(z) for z in result.zeros)
    for (low, high), count in zip(_gaps(result.events, result.start, result.end), result.counts, strict=True):
        middle = (low + high) / 2
        if count is not None and low < high:
            assert count == full.counts[sum(float(z.t.mid()) < middle for z in full.zeros)]


class _span:  # noqa: N801
    def __init__(self, zero: Zero) -> None:
        self.t = float(zero.t.mid())

    def __contains__(self, t: float) -> bool:
        return abs(t - self.t) < 1e-9


def test_a_range_that_ends_at_a_passage_is_not_proved() -> None:
    """…or has the passage on one side of its end, decided: never neither."""
    family, start, _ = RUNS["one mass"]
    with ball_arithmetic(200):
        exact = run("one mass").zeros[0].t.str(18, radius=False)
    for text in (exact, exact[:-4]):
        result = passages(family, Exact(start), Exact(text), 20)
        reached = Fraction(text) > Fraction("1.0749004571386740524")
        assert not result.proved or len(result.zeros) == int(reached)


# --- events and gaps --------------------------------------------------------------------------------------------


def zero(t: float, direction: int = 1) -> Zero:
    return Zero(flint.arb(0.1), flint.arb(t), (Fraction(0.1), Fraction(t)), (1e-3, 1e-3), direction)


def test_what_overlaps_a_strip_becomes_part_of_it() -> None:
    strips = [Strip(0.2, 0.4, "a"), Strip(0.3, 0.35, "b"), Strip(0.4, 0.5, "c")]
    events = _events([zero(0.1), zero(0.3), zero(0.45), zero(0.7)], strips)
    assert [type(event) for event in events] == [Zero, Strip, Zero]
    assert (events[1].start, events[1].end) == (0.2, 0.5)
    gaps = _gaps(events, Exact(0), Exact(1))
    assert len(gaps) == 4
    assert gaps[0][1] < 0.1 < gaps[1][0]
    assert gaps[1][1] == 0.2
    assert gaps[2][0] == 0.5
    assert [list(run) for run in _runs(events)] == [[0, 1], [2, 3]]


def test_no_events_leave_one_gap() -> None:
    assert _gaps((), Exact("0.1"), Exact("0.3")) == [(_up(Exact("0.1")), _down(Exact("0.3")))]
    assert [list(run) for run in _runs(())] == [[0]]


@pytest.mark.parametrize("text", ["0.1", "1/3", "2", "1.0749004571386740524"])
def test_ends_are_rounded_outward(text: str) -> None:
    exact = Exact(text).as_fraction()
    assert Fraction(_down(Exact(text))) <= exact <= Fraction(_up(Exact(text)))
    assert _up(Exact(text)) - _down(Exact(text)) <= 2.3e-16 * float(exact) + 5e-324
