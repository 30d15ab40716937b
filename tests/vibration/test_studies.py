"""Superposition, merged masses, envelope and the weight of the transient part, for problems and for cases."""

from __future__ import annotations

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import (
    Case,
    InputError,
    Load,
    Problem,
    certify,
    envelope,
    merged,
    response,
    superposition,
    transient_importance,
    vehicles,
)
from mpsolve.problem.cases import as_problem
from mpsolve.vibration import case_studies as study

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "40"), positions=("0", "1.5"))
LOADS = [Load(1), Load(2, 1, "0.3")]
TIMES = np.linspace(0, 40, 41)
PROBLEM = as_problem(CASE)


def test_superposition_and_merged_masses_are_those_of_the_paper() -> None:
    known = sum(part.w for part in study.superposition(CASE, LOADS, None, TIMES))
    found = sum(part.rail for part in superposition(PROBLEM, LOADS, times=TIMES))
    assert found == pytest.approx(known / 2, abs=1e-8 * np.abs(found).max())
    one, other = study.merged(CASE, LOADS, None, TIMES), merged(PROBLEM, LOADS, times=TIMES)
    assert other.rail == pytest.approx(one.w / 2, abs=1e-8 * np.abs(other.rail).max())


def test_envelope_and_the_weight_of_the_transient_part() -> None:
    found = response(PROBLEM, LOADS, times=TIMES)
    own = envelope(found)
    assert np.all(np.abs(found.harmonic[0]) <= own.modulus + 1e-12)
    assert own.modulus[0] <= sum(own.amplitudes)
    other = transient_importance(found)
    assert other.displacement == pytest.approx(-found.transient[:, 0], abs=1e-9)
    assert np.abs(other.velocity).max() > 1e-6
    assert envelope(PROBLEM, LOADS, 0, TIMES).modulus == pytest.approx(own.modulus)
    assert transient_importance(PROBLEM, LOADS).velocity == pytest.approx(other.velocity)


def test_a_bogie_on_layers_has_an_envelope_and_a_weight_too() -> None:
    problem = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=100)
    times = np.linspace(0, 1, 50)
    found = response(problem, times=times, places=[0])
    assert np.all(np.abs(found.harmonic[0]) <= envelope(problem, None, 0, times).modulus * (1 + 1e-12))
    weight = transient_importance(problem)
    assert weight.displacement == pytest.approx(
        -response(problem, times=[0]).transient[:, 0], abs=1e-8 * np.abs(found.rail).max()
    )


def test_cases_keep_their_own() -> None:
    found = response(PROBLEM, LOADS, times=TIMES, spectrum=certify(CASE, check=False))
    assert envelope(CASE, LOADS, 0, TIMES).modulus == pytest.approx(2 * envelope(found).modulus, rel=1e-8)
    one = transient_importance(CASE, LOADS)
    assert one.velocity == pytest.approx(2 * transient_importance(found).velocity, rel=1e-7)


def test_loads_go_with_their_vehicles() -> None:
    bogies = Problem(DAMPED["two-layer"], [TYPICAL["bogie"].at(30), vehicles.Mass(900)], v=20)
    alone = Problem(DAMPED["two-layer"], [vehicles.Mass(900)], v=20)
    times = [0.01, 0.1]
    loads = [Load(5), Load(7), Load(9)]
    found = superposition(bogies, loads, times=times, places=[0])
    assert found[1].rail == pytest.approx(response(alone, [Load(5)], times=times, places=[0]).rail)
    named = superposition(bogies, {"wheel of vehicle 2": Load(5)}, times=times, places=[0])
    assert named[1].rail == pytest.approx(found[1].rail)
    assert not named[0].rail.any()
    with pytest.raises(InputError, match="masses only"):
        merged(bogies, times=times)
    with pytest.raises(InputError, match="Vibration"):
        envelope(bogies.track)


def test_the_extremes_of_an_undamped_envelope_are_the_papers() -> None:
    case = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, "1.5"))
    sheet = certify(case, check=False)
    found = envelope(
        response(as_problem(case), [Load(2)] * 2, times=np.linspace(0, 3000, 30_001), places=[0], spectrum=sheet)
    )
    assert (found.greatest, found.least) == pytest.approx((found.modulus.max(), found.modulus.min()), rel=1e-3)
    assert found.note == ""
