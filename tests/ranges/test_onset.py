"""Onsets that others have computed, and the kinds of an answer."""

import math
import pickle
from fractions import Fraction

import pytest
from flint import arb
from free_cases import BEAM, BOGIE, LAYERS, PAIR, RAIL

from mpsolve import Problem, tracks, vehicles
from mpsolve.numbers.balls import precision
from mpsolve.outcome import Status
from mpsolve.ranges.onset import Kind, onset
from mpsolve.ranges.unstable import unstable_ranges

TIMOSHENKO = tracks.Timoshenko(
    EI=Fraction("210e9") * Fraction("3.037e-5"), m="60.2", J=7860 * Fraction("3.037e-5"), k="1e6", c=770,
    S=Fraction("0.393") * Fraction("80.769e9") * Fraction("76.70e-4"),
)  # fmt: skip
VISCOUS = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770, eta="1e-4")
TEN_TONS = vehicles.Mass(10000)
# onset velocities of an independent float program, to a relative 1e-6
KNOWN = {
    "timoshenko": (Problem(TIMOSHENKO, TEN_TONS, v=1), (0, 400), 309.445688),
    "two-layer": (Problem(LAYERS, vehicles.Mass(900), v=1), (600, 1500), 1413.817865),
    "kelvin-voigt": (Problem(VISCOUS, [TEN_TONS.at(0), TEN_TONS.at("3.4")], v=1), (10, 300), 197.878094),
    "bogie": (Problem(RAIL, BOGIE, v=1), (0, 400), 334.590808),
}


@pytest.mark.parametrize(("number", "known"), [(4, 0.610), (8, 0.551), (16, 0.479)])
def test_rows_of_masses(number: int, known: float) -> None:
    row = [vehicles.Mass(40).at(Fraction(3, 2) * k) for k in range(number)]
    found = onset(Problem(BEAM, row, v=0), over={"v": ("0.1", known + 0.01)}, check=False)
    assert found.kind is Kind.CROSSES
    assert found.value is not None
    assert abs(float(found.value) - known) < 6e-4  # as floats have it, to three digits


@pytest.mark.parametrize("name", KNOWN)
def test_onsets_are_those_of_another_program(name: str) -> None:
    problem, over, known = KNOWN[name]
    found = onset(problem, over={"v": over})
    assert found.status is (Status.UNVERIFIED if name == "timoshenko" else Status.PROVED)  # damped at w alone
    assert found.kind is Kind.CROSSES
    assert found.value is not None
    assert found.value.rad() < 1e-10
    assert abs(float(found.value) / known - 1) < 1e-6


def test_each_kind_of_answer() -> None:
    problem = Problem(BEAM, PAIR, v=0)
    assert onset(problem, over={"v": (0, "0.7")}).kind is Kind.STABLE
    assert onset(problem, over={"v": ("0.75", "0.8")}).kind is Kind.UNSTABLE_FROM_START
    ranges = unstable_ranges(problem, over={"v": ("0.75", 1)})
    assert [part.roots for part in ranges.intervals] == [2, 2]
    assert (float(ranges.intervals[0].start), ranges.intervals[0].q) == (0.75, None)
    assert float(ranges.intervals[-1].end) == 1
    assert not ranges.intervals[0].end.overlaps(ranges.intervals[1].start)


def test_an_answer_gives_balls_and_floats_round_them() -> None:
    problem = Problem(BEAM, PAIR, v=0)
    found = onset(problem, over={"v": ("0.7", "0.75")}, digits=40)
    assert found.value is not None
    assert found.lower is not None
    assert found.upper is not None
    assert found.value > found.lower
    assert found.value < found.upper
    assert math.nextafter(math.nextafter(found.lower, 1), 1) >= found.upper
    again = pickle.loads(pickle.dumps(found))
    assert again.value.mid() == found.value.mid()
    data = found.to_dict()["value"]
    assert (data["lower"], data["upper"]) == (found.lower, found.upper)
    assert found.value.contains(arb(data["decimal"])) or found.value.overlaps(arb(data["decimal"]))


def pair_of(mass: object) -> list[object]:
    return [vehicles.Mass(mass).at(0), vehicles.Mass(mass).at("1.5")]


def beam(eta_b: object) -> tracks.EulerBernoulli:
    return tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=2 * Fraction(str(eta_b)))


@pytest.mark.parametrize(
    ("eta_b", "mass", "passive"),
    [("0.05", 10**6, "1.0201285771054"), ("0.5", 10**6, "1.1899209702955"), ("0.05", 10**4, "1.0201285771054")],
)
def test_a_heavy_mass_loses_stability_just_above_the_passivity_velocity(eta_b: str, mass: int, passive: str) -> None:
    """There the crossing runs to q = 0; the passivity velocities are those of GENERAL's section 6."""
    found = onset(Problem(beam(eta_b), vehicles.Mass(mass), v=1), over={"v": (0, "1.5")}, check=False)
    assert found.kind is Kind.CROSSES
    assert found.lower is not None
    assert found.upper is not None
    assert Fraction(passive) < Fraction(found.lower)
    assert found.upper < float(passive) + 20 / mass
    assert 0 < float(found.q) < 0.02


@pytest.mark.parametrize(
    ("eta_b", "over", "known"),
    [("0.001", (0, 2), 0.670338073432), ("0.001", ("0.6", "0.68"), 0.670338073432),
     ("1e-4", ("0.5", "0.9"), 0.670339465413)],
)  # fmt: skip
def test_small_damping_is_no_obstacle(eta_b: str, over: tuple[object, object], known: float) -> None:
    found = onset(Problem(beam(Fraction(eta_b)), pair_of(70), v="0.5"), over={"v": over}, check=False)
    assert found.kind is Kind.CROSSES
    assert abs(float(found.value) - known) < 1e-11


def test_floats_keep_to_their_side_of_the_onset() -> None:
    found = onset(Problem(BEAM, pair_of(70), v="0.5"), over={"v": (0, 1)}, digits=40, check=False)
    assert found.lower is not None
    assert found.upper is not None
    with precision(200):
        assert arb(found.lower) <= found.value <= arb(found.upper)
    assert math.nextafter(found.lower, 2) == found.upper
