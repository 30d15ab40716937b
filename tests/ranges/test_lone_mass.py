"""One mass on an undamped beam: the inequality in floats, certified points, and where the theorem does not tell."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from flint import arb

from mpsolve import (
    Case,
    Problem,
    Status,
    certify,
    crossings,
    onset,
    prove_stable,
    tracks,
    unstable_ranges,
    vehicles,
    worst,
)
from mpsolve.progress import silent
from mpsolve.ranges import lone_mass
from mpsolve.ranges.lone_mass import NOTE, faster, without_damping
from mpsolve.ranges.onset import Kind

BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1)
LONE = Problem(BEAM, vehicles.Mass(10), v="1.2")
PAIR = Problem(BEAM, [vehicles.Mass(10), vehicles.Mass(10).at("1.5")], v="1.2")
STIFF = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", N="-2e5")
SOFT = tracks.EulerBernoulli(EI="1/4", m=1, k=1, N="0.3")  # W″ < 0 at p = 0


def taken(beam: tracks.EulerBernoulli, v: float, q: float) -> float:
    """−Im G(0, q − i·small), by residues of the p-roots above the real axis."""
    EI, m, k, T = (float(x) for x in (beam.EI, beam.m, beam.k, beam.kp - beam.N))
    z = q * (1 - 1e-9j)
    D = [EI, 0, T - m * v * v, 2 * m * v * z, k - m * z * z]
    upper = sorted(np.roots(D), key=lambda p: -p.imag)[:2]
    return float(-(1j * sum(1 / np.polyval(np.polyder(D), p) for p in upper)).imag)


@pytest.mark.parametrize(("beam", "v"), [(BEAM, 1.01), (BEAM, 1.2), (BEAM, 2.9), (STIFF, 300), (STIFF, 500)])
def test_the_beam_gives_below_a_frequency_and_takes_above_it(beam: tracks.EulerBernoulli, v: float) -> None:
    assert faster(Problem(beam, vehicles.Mass(1), v=1), {"v": (Fraction(v), Fraction(v) * Fraction(101, 100))})
    EI, m, k, T = (float(x) for x in (beam.EI, beam.m, beam.k, beam.kp - beam.N))
    p = -np.geomspace(1e-3, 1e3, 200_001) * (k / EI) ** 0.25
    b = -(v * p + np.sqrt((EI * p**4 + T * p**2 + k) / m)).min()
    assert b > 0
    assert all(taken(beam, v, x * b) < 0 for x in (0.03, 0.3, 0.6, 0.9, 0.999))
    assert all(taken(beam, v, x * b) > 0 for x in (1.001, 1.1, 2, 10))


def test_the_onset_is_where_the_cuts_join() -> None:
    found = onset(Case(alpha="0.5", eta_b=0, eta_m=(70,), positions=(0,)), over={"alpha": (0, 2)}, digits=30)
    assert (found.kind, found.proved, found.note) == (Kind.CROSSES, True, NOTE)
    assert found.value.overlaps(arb(1))
    assert found.value.rad() < 1e-30
    stiff = crossings(Problem(STIFF, vehicles.Mass(500), v=100), over={"v": (0, 500)})
    assert stiff.counts == (0, 2)
    assert float(stiff.crossings[0].value) == pytest.approx(((2 * 6.4e12**0.5 + 2e5) / 60) ** 0.5)


@pytest.mark.parametrize("v", ["1.1", "1.7", "2.8"])
@pytest.mark.parametrize("M", ["0.3", "8", "200"])
def test_two_roots_grow_at_certified_points(v: str, M: str) -> None:
    assert certify(Problem(BEAM, vehicles.Mass(M), v=v), region="unstable", check=False).unstable == 2


def test_ranges_above() -> None:
    assert crossings(LONE, over={"vehicles[0].M": (1, None)}).counts == (2,)
    assert onset(LONE, over={"v": ("1.05", 2)}).kind is Kind.UNSTABLE_FROM_START
    (part,) = unstable_ranges(LONE, over={"v": (0, 2)}).intervals
    assert (part.roots, part.lower, part.upper) == (2, 1, 2)
    assert prove_stable(LONE, over={"v": (0, 2), "vehicles[0].M": (1, 9)}).stable is False


@pytest.mark.parametrize(
    ("problem", "over"),
    [
        (LONE, {"v": (1, 2)}),  # begins where the cuts join
        (LONE, {"v": ("0.5", "3.1")}),  # beyond, W″² W < v² W′² somewhere
        (PAIR, {"v": (0, 2)}), (PAIR, {"gap[0]": (1, 2)}), (LONE, {"track.k": (1, "1.1")}),
        (Problem(SOFT, vehicles.Mass(10), v="1.2"), {"v": (0, 2)}),
        (Problem(BEAM, vehicles.Oscillator(wheel=1, body=5, k=1, c=0), v="1.2"), {"v": (0, 2)}),
    ],
)  # fmt: skip
def test_where_it_does_not_tell(problem: Problem, over: dict[str, tuple[object, object]]) -> None:
    for ask in (crossings, worst):
        found = ask(problem, over=over)
        assert found.reason is not None
        assert found.reason.code == "undamped"
    assert "stable up to" in onset(PAIR, over={"v": (0, 2)}).known


def test_nothing_is_lowest_where_nothing_grows() -> None:
    found = worst(PAIR, over={"v": (0, 1)})
    assert found.proved
    assert found.value is None
    assert found.growth is None
    assert crossings(PAIR, over={"v": (0, 1)}).counts == (0,)


def test_with_damping_it_is_silent() -> None:
    damped = LONE.changed("track.c", "0.1")
    assert faster(damped, {"v": (Fraction(0), Fraction(2))}) is None
    assert faster(LONE, {"track.c": (Fraction(0), Fraction(1))}) is None


OVER = {"v": (Fraction(1, 2), Fraction(2))}


def test_a_pair_comes_where_the_cuts_join() -> None:
    found = without_damping(LONE, OVER, 20, None, silent, check=False)
    (one,) = found.crossings
    assert (found.counts, one.direction, float(one.value), float(one.q)) == ((0, 2), 2, 1.0, 0.0)
    assert found.status is Status.UNVERIFIED


def test_an_open_count_stays_open(monkeypatch: pytest.MonkeyPatch) -> None:
    near = LONE.changed("v", "1.0000001")  # two branch points next to each other
    found = certify(near, region="unstable", check=False)
    assert not found.proved
    monkeypatch.setattr(lone_mass, "base_at", lambda *_, **__: found)
    answer = without_damping(LONE, OVER, 20, None, silent, check=False)
    assert answer.status is Status.UNDECIDED
    assert answer.counts is None
    assert answer.crossings == ()
