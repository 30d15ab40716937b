"""Trains: counts by an independent route, and cases that follow from each other."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, seed, settings
from hypothesis import strategies as st
from oracle_general import Floats, count_below
from oracle_general.named import RAIL, TWO_LAYER, masses, problem
from oracle_general.package import as_problem

from mpsolve import Case, tracks, vehicles
from mpsolve.certificate.solve import certify_problem
from mpsolve.numbers.balls import precision
from mpsolve.outcome import Status
from mpsolve.problem.cases import as_problem as of_case
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.regions import HalfPlane
from mpsolve.spectrum.spectrum import Spectrum

EXAMPLE = Path(__file__).parents[2] / "examples" / "train_8_coaches.toml"


def spectrum(given: Problem, check: bool = False, region: object = "unstable") -> Spectrum:
    found = certify_problem(given, region=region, digits=20, check=check)
    assert found.reason is None
    return found


def paper(masses_: list[str], places: list[object], alpha: str = "0.5") -> Problem:
    return of_case(Case(alpha=alpha, eta_b="0.05", eta_m=masses_, positions=places))


@st.composite
def trains(draw: Any) -> dict[str, Any]:
    """Two to six masses at random places on a beam or two layers, below and above their onset."""
    number = draw(st.integers(2, 6))
    places, weights = [0.0], []
    for _ in range(number):
        weights.append(draw(st.sampled_from([500, 2000, 8000, 30000])))
        places.append(places[-1] + draw(st.sampled_from([0.6, 1.2, 2.5, 3.4, 8.0, 25.0])))
    track = draw(st.sampled_from([RAIL, TWO_LAYER]))
    return problem(
        track,
        [one for m, x in zip(weights, places, strict=False) for one in masses(str(m), str(round(x, 3)))],
        str(draw(st.integers(80, 480))),
    )


@seed(13)
@given(trains())
@settings(max_examples=14, deadline=None, database=None)
def test_counts_are_those_of_a_whole_contour_in_floats(train: dict[str, Any]) -> None:
    """The oracle goes round the half-plane with steps of the argument below 0.45, and closes by no formula."""
    found = spectrum(as_problem(train))
    assert found.region == HalfPlane()
    assert found.count == count_below(Floats(train)).number == sum(root.multiplicity for root in found.roots)


@pytest.mark.parametrize(("number", "count"), [(4, 0), (16, 2)])
def test_rows_of_the_paper(number: int, count: int) -> None:
    """α = 0.5, η_b = 0.05, η_M = 40, spacing 1.5: 16 are unstable, verified; the proof of 16 takes few pieces."""
    row = paper(["40"] * number, [Fraction(3, 2) * k for k in range(number)])
    found = spectrum(row, check=True)
    assert (found.status, found.count, len(found.roots)) == (Status.PROVED, count, count)
    assert found.cost.pieces < 300


def test_bogie_spacing_takes_no_more_pieces_than_twice_equal_spacing() -> None:
    places, at = [], Fraction(0)
    for k in range(16):
        places.append(at)
        at += Fraction("1.2") if k % 2 == 0 else Fraction(8)
    equal = spectrum(paper(["40"] * 16, [Fraction(3, 2) * k for k in range(16)]))
    bogies = spectrum(paper(["40"] * 16, list(places)))
    assert bogies.count == 0
    assert bogies.cost.pieces < 2 * equal.cost.pieces


def test_all_roots_of_a_band() -> None:
    """32 masses: three pairs beside each other, as many as the count says."""
    found = spectrum(paper(["40"] * 32, [Fraction(3, 2) * k for k in range(32)]))
    assert found.count == len(found.roots) == 6


def test_eight_coaches_are_stable_and_longer_trains_need_few_more_pieces() -> None:
    train = read_problem(EXAMPLE).problem
    assert (train.pencil.contacts, train.pencil.size) == (32, 80)
    found = spectrum(train, check=True)
    assert (found.status, found.count, found.stable) == (Status.PROVED, 0, True)
    two = spectrum(Problem(train.track, train.vehicles[:2], v=train.v))
    assert found.cost.pieces < 2.5 * two.cost.pieces  # of four times as many contacts


def test_the_file_is_the_train_of_python() -> None:
    train = read_problem(EXAMPLE).problem
    coach = train.vehicles[0].vehicle
    assert isinstance(coach, vehicles.Coach)
    made = Problem(train.track, vehicles.train(coach, count=8, spacing="25"), v="70")
    assert made.pencil == train.pencil


def test_a_train_of_one_is_the_vehicle() -> None:
    train = read_problem(EXAMPLE).problem
    coach = train.vehicles[0].vehicle
    alone = spectrum(Problem(train.track, coach, v=300))
    of_one = spectrum(Problem(train.track, vehicles.train(coach, 1, "25"), v=300))
    assert alone.count == of_one.count == 0
    mass = spectrum(paper(["70"], [0], alpha="1.2"))
    shifted = spectrum(paper(["70"], [100], alpha="1.2"))
    assert mass.count == shifted.count == 2
    assert mass.roots[0].q.overlaps(shifted.roots[0].q)


@pytest.mark.parametrize("v", ["0", "0.5", "0.9"])
def test_a_train_may_be_turned_round(v: str) -> None:
    """G(−ξ) at v is G(ξ) at −v, and turning the train transposes the matrix of the receptances: Δ is the same."""

    def frequencies(weights: list[int], places: list[object]) -> Any:
        beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.4")
        placed = [vehicles.Mass(M).at(x) for M, x in zip(weights, places, strict=True)]
        return [complex(root.q) for root in spectrum(Problem(beam, placed, v=v), region=("below", "0.15")).roots]

    one = frequencies([20, 30, 50], [0, 1, "2.5"])
    assert len(one) == 6
    assert np.allclose(one, frequencies([50, 30, 20], [0, "1.5", "2.5"]), rtol=0, atol=1e-13)
    assert not np.allclose(one, frequencies([20, 50, 30], [0, 1, "2.5"]), rtol=0, atol=1e-4)


def test_masses_that_merge_are_their_sum() -> None:
    """Two masses of 35 that come together: their unstable root tends to that of one mass of 70."""
    single = spectrum(paper(["70"], [0], alpha="1.2")).roots[0].q
    distances = []
    for gap in (Fraction(1, 10), Fraction(1, 100), Fraction(1, 1000)):
        found = spectrum(paper(["35", "35"], [0, gap], alpha="1.2"))
        with precision(80):
            distances.append(min(float(abs(root.q - single).mid()) for root in found.roots))
    assert distances[0] > 5 * distances[1] > 25 * distances[2]
    assert distances[2] < 1e-3


def test_contacts_far_apart_approach_single_ones() -> None:
    """Two equal masses 200 apart: two roots beside that of one, and nearer than those of two masses 50 apart."""
    single = spectrum(paper(["70"], [0], alpha="1.2")).roots[0].q
    spread = []
    for gap in (50, 200):
        found = spectrum(paper(["70", "70"], [0, gap], alpha="1.2"))
        with precision(80):
            near = sorted(float(abs(root.q - single).mid()) for root in found.roots)
        spread.append(near[1])
    assert spread[1] < spread[0] < 0.2
