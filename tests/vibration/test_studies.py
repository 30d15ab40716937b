"""Superposition, merged masses, envelope and the weight of the transient part, for problems and for cases."""

from __future__ import annotations

from pathlib import Path

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
    deflection_shape,
    envelope,
    merged,
    response,
    superposition,
    transient_importance,
    vehicles,
)
from mpsolve.problem.cases import as_problem

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "40"), positions=("0", "1.5"))
LOADS = [Load(1), Load(2, 1, "0.3")]
TIMES = np.linspace(0, 40, 41)
PROBLEM = as_problem(CASE)


def test_superposition_and_merged_masses_are_those_of_the_paper() -> None:
    known = sum(part.w for part in superposition(CASE, LOADS, None, TIMES))
    found = sum(part.rail for part in superposition(PROBLEM, LOADS, times=TIMES))
    assert found == pytest.approx(known / 2, abs=1e-8 * np.abs(found).max())
    one, other = merged(CASE, LOADS, None, TIMES), merged(PROBLEM, LOADS, times=TIMES)
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


UNDAMPED = Case(alpha="0.5", eta_b=0, eta_m=(70, 70), positions=(0, "1.5"))
DAMPED_PAIR = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))


def test_the_envelope_bounds_the_vibration_and_is_reached() -> None:
    spectrum, tau = certify(UNDAMPED), np.linspace(0, 3000, 60_001)
    found, moved = envelope(UNDAMPED, None, 0, tau, spectrum), response(UNDAMPED, None, 0, tau, spectrum)
    assert np.all(np.abs(moved.harmonic[0]) <= found.modulus + 1e-12)
    assert found.greatest is not None
    assert found.least is not None
    assert len(found.amplitudes) == 2
    assert found.modulus.max() == pytest.approx(found.greatest, rel=1e-3)
    assert found.modulus.min() == pytest.approx(found.least, rel=1e-3)
    assert np.abs(moved.harmonic[0]).max() == pytest.approx(found.greatest, rel=1e-2)
    alone = envelope(Case(alpha="0.5", eta_b=0, eta_m=70), None, 0, (0, 5))
    assert alone.greatest == alone.least == pytest.approx(alone.modulus[1])
    decaying = envelope(DAMPED_PAIR, None, 0, (0,))
    assert decaying.greatest is decaying.least is None
    assert decaying.note
    moved_off = Case(alpha="0.5", eta_b=0, eta_m=70, positions=5)
    assert envelope(moved_off).amplitudes == pytest.approx(alone.amplitudes)
    with pytest.raises(InputError, match="xi: holds 2 positions"):
        envelope(UNDAMPED, xi=(0, 1))  # type: ignore[arg-type]


def test_superposition_is_right_for_masses_that_hardly_count() -> None:
    """Forces alone superpose; the motion of a light mass is that of its force, up to its own size."""
    light = Case(alpha="0.5", eta_b="0.1", eta_m=("0.5", "0.5"), positions=(0, "1.5"))
    loads, tau = (Load(1), Load("0.5", "0.3", "0.4")), (0, 5, 40)
    parts = superposition(light, loads, (0, 1), tau)
    assert len(parts) == 2
    together = response(light, loads, (0, 1), tau).w
    assert np.abs(sum(part.w for part in parts) - together).max() < 0.1
    heavy = [part.w for part in superposition(DAMPED_PAIR, None, None, tau)]
    assert np.abs(sum(heavy) - response(DAMPED_PAIR, None, None, tau).w).max() > 1e-2


def test_the_merged_mass_is_the_limit_of_a_vanishing_distance() -> None:
    close = Case(alpha="0.5", eta_b="0.1", eta_m=(30, 40), positions=(0, "0.01"))
    tau = (0, 5, 40)
    single = merged(close, None, 0, tau)
    assert single.case.merged.eta_m == (70,)
    assert np.allclose(single.w, response(close, None, 0, tau).w, rtol=0, atol=3e-2)
    assert np.allclose(single.w, response(Case(alpha="0.5", eta_b="0.1", eta_m=70), (Load(2),), 0, tau).w, atol=1e-12)


def test_the_transient_part_makes_up_what_the_others_miss() -> None:
    found, whole = transient_importance(DAMPED_PAIR), response(DAMPED_PAIR, None, None, (0,))
    assert np.allclose(found.displacement, -whole.transient[:, 0], rtol=0, atol=1e-12)
    step = 1e-4
    moved = response(DAMPED_PAIR, None, None, (0, step, 2 * step))
    start = moved.steady + moved.harmonic
    slope = (-3 * start[:, 0] + 4 * start[:, 1] - start[:, 2]) / (2 * step)
    assert np.allclose(found.velocity, slope, rtol=0, atol=1e-9)


def test_a_shape_vanishes_far_away_and_passes_through_the_contact_points(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    from mpsolve.report.figures_motion import animation, draw_shape

    found = deflection_shape(DAMPED_PAIR, None, np.linspace(-12, 13.5, 103), (10, 30))
    contact = response(DAMPED_PAIR, None, None, (10, 30))
    assert found.w.shape == (103, 2)
    assert np.abs(found.w[[0, -1]]).max() < 0.1 * np.abs(found.w).max()
    assert np.interp(0.0, found.xi, found.w[:, 1]) == pytest.approx(contact.w[0, 1], abs=1e-12)
    ax = Figure().add_subplot()
    assert draw_shape(found, ax) is ax
    assert np.array_equal(ax.lines[0].get_ydata(), found.w[:, -1])
    path = tmp_path / "shape.gif"
    animation(found).save(path, writer="pillow")
    assert path.read_bytes()[:6] == b"GIF89a"
    with pytest.raises(InputError, match="xi"):
        deflection_shape(DAMPED_PAIR, None, (0,), (1,))
