"""All crossings of a range: against the engine for one beam, against float counts on both sides, at any digits."""

import json
import pickle
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from flint import arb
from free_cases import BEAM, LAYERS, PAIR

from mpsolve import Case, Problem, tracks, vehicles, worst
from mpsolve.certificate.solve import certify_problem
from mpsolve.errors import InputError
from mpsolve.numbers.balls import precision
from mpsolve.outcome import Status
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.ranges.crossed import Crossings
from mpsolve.ranges.crossings import crossings
from mpsolve.ranges.seen import count_seen
from mpsolve.spectrum.regions import HalfPlane

PROBLEM = Problem(BEAM, PAIR, v="0.9")
# what an engine of its own for this beam, now gone, had: crossings over v up to 1, q at the first; the limiting mass
ENDS = ("0.7378769370925182021555856", "0.8255781350018997590002508", "0.9936459316672103993710953")
Q, MASS = 0.19630126451137173, 52.87194079683106


@pytest.fixture(scope="module")
def in_velocity() -> Crossings:
    return crossings(PROBLEM, over={"v": (0, 1)}, digits=30)


def test_a_real_root_that_no_contact_feels_through_the_track_is_no_crossing() -> None:
    """Two equal bodies over one place: against each other they vibrate at √(k/M), whatever the track."""
    bodies = [vehicles.Oscillator(wheel=1, body=2, k=1).at(0)] * 2
    pair = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1"), bodies, v="0.5")
    found = crossings(pair, over={"vehicles[0].k": ("0.5", 2)})
    assert (found.proved, found.crossings, found.counts) == (True, (), (0,))
    lowest = worst(pair, over={"vehicles[0].k": ("0.5", 2)})
    assert lowest.value is not None
    assert lowest.value.overlaps(arb(1))
    assert lowest.q.real.overlaps(arb("0.5").sqrt())  # type: ignore[union-attr]
    assert lowest.q.imag.contains(0)  # type: ignore[union-attr]


def test_velocities_are_those_of_the_engine_for_one_beam(in_velocity: Crossings) -> None:
    assert in_velocity.status is Status.PROVED
    assert in_velocity.counts == (0, 2, 0, 2)
    assert [c.direction for c in in_velocity.crossings] == [2, -2, 2]
    for crossing, end in zip(in_velocity.crossings, ENDS, strict=True):
        assert crossing.value.overlaps(arb(end, 1e-20))
        assert crossing.value.rad() < 1e-29
        assert crossing.lower <= float(end) <= crossing.upper
    assert np.isclose(float(in_velocity.crossings[0].q), Q)


def test_masses_are_those_of_the_engine_for_one_beam() -> None:
    found = crossings(PROBLEM, over={"scale.mass": ("0.02", 3)})
    assert found.status is Status.PROVED
    (one,) = found.crossings
    assert np.isclose(float(one.value) * 40, MASS, rtol=1e-13)
    assert one.direction == 2


@pytest.mark.parametrize(
    ("problem", "over"),
    [
        (Problem(BEAM, PAIR, v="0.9"), {"gap[0]": ("0.5", 6)}),
        (Problem(BEAM, PAIR, v="0.9"), {"track.c": ("0.02", "0.5")}),
        (
            Problem(LAYERS, [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")], v=1300),
            {"vehicles[1].M": (10, 2000)},
        ),
    ],
)
def test_counts_between_are_those_that_floats_see(problem: Problem, over: dict[str, tuple[object, object]]) -> None:
    found = crossings(problem, over=over, check=False)
    assert found.status is Status.UNVERIFIED
    path, (low, high) = next(iter(found.over.items()))
    ends = [low, *(Fraction(float(c.value)) for c in found.crossings), high]
    assert found.counts is not None
    for (a, b), count in zip(pairwise(ends), found.counts, strict=True):
        for share in (Fraction(1, 100), Fraction(99, 100)):
            reduced = reduce_problem(problem.changed(path, a + share * (b - a)))
            assert count_seen(reduced, 30.0) == count


def test_a_divergence_is_a_single_root_at_0() -> None:
    # two masses of 2 joined by a spring: f(0) changes its sign with the velocity
    joined = vehicles.Vehicle(
        M=[[2, 0], [0, 2]], C=[[0, 0], [0, 0]], K=[[3, -3], [-3, 3]], B=[[1, 0], [0, 1]], places=["-0.5", "0.5"]
    )
    found = crossings(Problem(BEAM, joined, v="1.2"), over={"v": ("1.05", "1.4")}, digits=20)
    single = [c for c in found.crossings if float(c.q) == 0]
    assert found.status is Status.PROVED
    assert len(single) == 1
    assert abs(single[0].direction or 0) == 1
    assert found.counts is not None
    assert any(count % 2 for count in found.counts)


def test_the_answer_travels(in_velocity: Crossings) -> None:
    again = pickle.loads(pickle.dumps(in_velocity))
    assert again.counts == in_velocity.counts
    with precision(64):
        assert again.crossings[0].value.overlaps(in_velocity.crossings[0].value)
    data = json.loads(in_velocity.to_json())
    assert data["status"] == "proved"
    assert data["crossings"][0]["value"]["decimal"].startswith("0.73787693709")
    assert len(list(in_velocity.rows())) == 3


def test_spent_effort_leaves_the_question_open() -> None:
    found = crossings(PROBLEM, over={"v": (0, 1)}, effort=Effort(evaluations=50))
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "effort"
    assert found.counts is None
    with pytest.raises(TypeError):
        bool(found)


@pytest.mark.parametrize(
    ("over", "said"),
    [({}, "give ranges"), ({"vv": (0, 1)}, "unknown"), ({"v": (1, 0)}, "in order"), ({"v": 3}, "give a range"),
     ({"v": (0, 1), "track.k": (1, 2)}, "one path"), ({"track.N": (0, "1.01")}, "stable and damped")],
)  # fmt: skip
def test_what_cannot_be_asked_is_refused(over: dict[str, object], said: str) -> None:
    with pytest.raises(InputError, match=said):
        crossings(PROBLEM, over=over)


@pytest.mark.parametrize("ends", [(0, 2), ("0.9", "1.1")])
def test_masses_at_which_stability_changes_in_wide_and_narrow_ranges(ends: tuple[object, object]) -> None:
    """The crossing mass of the paper's pair at α = 0.67, as the engine of its beam has it: 66.7175598…"""
    case = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
    found = crossings(case, over={"scale.mass": ends}, effort=Effort(seconds=60), check=False)
    (one,) = found.crossings
    assert abs(70 * float(one.value.mid()) - 66.71755984618989) < 1e-11
    assert found.counts == (0, 2)


def twins(mass: object) -> list[object]:
    return [vehicles.Mass(mass).at(0), vehicles.Mass(mass).at("1.5")]


@pytest.mark.parametrize("over", [("0.92", "0.94"), ("0.8", "1.1")])
def test_two_crossings_next_to_a_tangency_are_told_apart(over: tuple[object, object]) -> None:
    """A window of 9·10⁻⁴; its ends as `unstable_velocities` of the narrower range has them."""
    mass = "56.538095493450703825985840189429867707"
    found = crossings(Problem(BEAM, twins(mass), v="0.9"), over={"v": over}, digits=30, check=False)
    assert found.counts == (2, 0, 2)
    assert np.allclose([float(c.value) for c in found.crossings], [0.9306112006925, 0.9315117341371], atol=1e-12)


def test_ends_have_a_hundred_digits() -> None:
    found = crossings(Problem(BEAM, twins(70), v="0.5"), over={"v": (0, "1.5")}, digits=100, check=False)
    assert found.counts == (0, 2)
    assert found.crossings[0].value.rad() < 1e-99


@pytest.mark.parametrize("path", ["v", "track.k"])
def test_two_sprung_masses_diverge_where_the_static_determinant_vanishes(path: str) -> None:
    """f(0) = −0.699 at v = 1.3; where it is 0 tells a sum of two residues at q = 0, found without the engine."""
    damped = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=1)
    joined = vehicles.Vehicle(
        M=[[10, 0], [0, 10]], C=[[0, 0], [0, 0]], K=[[10, -10], [-10, 10]], B=[[1, 0], [0, 1]], places=[0, "1.5"]
    )

    def f(v: float, k: float) -> float:
        """det(I + G Y) at q = 0 of the spring alone."""
        p = np.roots([0.25, 0, -v * v, -1j * v, k])
        slope = p**3 - 2 * v * v * p - 1j * v
        up = p.imag > 0

        def G(xi: float) -> float:
            side = up if xi >= 0 else ~up
            return float(((1j if xi >= 0 else -1j) * np.exp(1j * p * xi) / slope)[side].sum().real)

        gain = np.array([[G(0.0), G(-1.5)], [G(1.5), G(0.0)]])
        return float(np.linalg.det(np.eye(2) + gain @ np.array([[10.0, -10.0], [-10.0, 10.0]])))

    assert abs(f(1.3, 1.0) + 0.699) < 1e-3
    found = crossings(Problem(damped, joined, v="1.3"), over={path: ("0.9", "1.4")}, check=False)
    (one,) = found.crossings
    assert float(one.q) == 0
    x = float(one.value)
    at = (lambda y: f(y, 1.0)) if path == "v" else (lambda y: f(1.3, y))
    assert abs(at(x)) < 1e-9
    assert (one.direction, found.counts) == ((1, (0, 1)) if path == "v" else (-1, (1, 0)))


def test_growing_roots_of_a_half_disc_are_no_count(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the theorem at high frequencies fails at the point, a half-disc is counted: more may grow outside."""

    def within_1(problem: Problem, **asked: Any) -> Any:
        return certify_problem(problem, **(asked | {"region": HalfPlane(Fraction(1))}))

    monkeypatch.setattr("mpsolve.ranges.base.certify_problem", within_1)
    found = crossings(PROBLEM, over={"v": ("0.75", "0.85")}, check=False)
    assert found.proofs[0].base.unstable == 2
    assert found.status is Status.UNDECIDED
    assert found.counts is None
    assert len(found.crossings) == 1
