"""The motion of any problem, against inversion by mpmath, the paper's beam, the finite track, and what must hold."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from catalogue_models import made
from image_truth import Image as Truth
from infinite import inverted
from receptance_truth import Receptance
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import (
    Case,
    InputError,
    Irregularity,
    Load,
    Problem,
    certify,
    finite_track,
    read_problem,
    response,
    tracks,
    vehicles,
)
from mpsolve.errors import PrecisionError
from mpsolve.presets.written import input_file, names, preset
from mpsolve.problem.cases import as_problem
from mpsolve.problem.reduced import scale_guide, track_guide
from mpsolve.vehicles.loads import rigid_bounce

BOGIE = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=100)


# --- other ways -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("track", tracks.CATALOGUE, ids=lambda model: model.name)
def test_the_image_inverted_by_mpmath(track: Any) -> None:
    """The third way, for every track, at one time, with a harmonic load: de Hoog's method has about eight digits."""
    few = [vehicle for vehicle in map(made, vehicles.CATALOGUE) if vehicle.pencil.contacts < 3]
    problem = Problem(made(track), few[tracks.CATALOGUE.index(track) % len(few)], v="0.3")
    loads = [Load(3, 1, "0.9", "0.7"), Load(2)][: problem.pencil.contacts]
    B = np.array(problem.pencil.B, float)
    terms = [
        (B[:, j], float(one.constant), float(one.amplitude), float(one.frequency), float(one.phase))
        for j, one in enumerate(loads)
    ]
    places = [Fraction(-1), Fraction(1, 2)]
    known = Truth(problem, terms, places).inverted(2.0)
    found = response(problem, loads, places=places, times=[0.7, 2])
    rows = np.array([*found.vehicle.values(), *found.contact_force, *found.rail])[:, -1]
    size, m = problem.pencil.size, problem.pencil.contacts
    for part in (slice(0, size), slice(size, size + m), slice(size + m, None)):
        assert np.abs(rows - known)[part].max() < 1e-6 * np.abs(known)[part].max()


@pytest.mark.parametrize(
    ("alpha", "eta_b", "masses", "places", "loads"),
    [
        ("0.67", "0.05", ("70", "70"), ("0", "1.5"), [Load(1), Load(1, "0.1", "0.3", 1)]),
        ("0.99", "0.1", ("10", "20"), ("0", "1.1"), [Load(1), Load(0, 1, "0.5")]),
        ("0.5", "0", ("4",), ("0",), [Load(1, "0.2", "0.1")]),
        ("1.3", "0.4", ("3",), ("0",), [Load(1)]),
    ],
)
def test_the_papers_beam(alpha: str, eta_b: str, masses: Any, places: Any, loads: Any) -> None:
    """w in w_st per unit force is twice the deflection under unit forces; unstable, undamped and fast cases too."""
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=masses, positions=places)
    times = np.array([0.0, 0.5, 3.0, 17.0, 60.0])
    spectrum = certify(case, check=False)
    growth = max([0.0, *(-float(root.q.imag.mid()) for root in spectrum.roots)])
    known = np.array([inverted(case, loads, (0, 0.75, -4), tau, 1.02 * growth) for tau in times[1:]]).T
    found = response(as_problem(case), loads, places=[0, "0.75", -4], times=times)
    largest = np.abs(found.rail).max()
    assert found.rail[:, 0] == pytest.approx(0, abs=1e-8 * largest)
    assert np.abs(found.rail[:, 1:] - known / 2).max() <= found.error.rail + 1e-10 * largest
    assert found.error.rail <= 1e-8 * largest


@pytest.mark.parametrize("vehicle", vehicles.CATALOGUE, ids=lambda model: model.name)
@pytest.mark.parametrize("track", tracks.CATALOGUE, ids=lambda model: model.name)
def test_the_finite_track_agrees_to_the_sum_of_both_errors(track: Any, vehicle: Any) -> None:
    """The second way, for every track and vehicle there is."""
    problem = Problem(made(track), made(vehicle), v="0.3")
    _agree(problem, [Load(1, "0.5", 1, "0.3")] + [Load(1)] * (problem.pencil.contacts - 1), np.array([2.0, 3, 4]), 1)


@pytest.mark.parametrize("name", names("track"))
def test_every_preset_of_a_track(name: str, tmp_path: Path) -> None:
    """Numbers from practice: weights that come on suddenly, or unit forces on what a frame holds up."""
    file = tmp_path / "file.toml"
    file.write_text(input_file(name, "wheelset" if preset("track", name).on == "rail" else None), "utf-8")
    problem = read_problem(file).problem
    guide = scale_guide(problem)
    unit, last = 2.0**guide.length, 8 * 2.0**guide.time
    loads = None if rigid_bounce(problem.pencil) else [Load(1)] * problem.pencil.contacts
    _agree(problem, loads, last * np.array([0.3, 0.7, 1]), unit)


def _agree(problem: Problem, loads: Any, times: Any, unit: float) -> None:
    places = [float(x) for x in problem.pencil.places]
    length = 60 * unit + places[-1] - places[0] + float(problem.v) * times[-1]
    known = finite_track(problem, loads, length=length, modes=int(7 * length / unit), times=times, tolerance=1e-3)
    found = response(problem, loads, times=times)
    size = np.abs(found.rail).max()
    assert np.abs(found.rail - known.rail).max() <= found.error.rail + known.error.total
    for name, row in known.vehicle.items():
        assert np.abs(found.vehicle[name] - row).max() <= known.error.vehicle + found.error.vehicle[name]
    assert np.abs(found.contact_force - known.contact_force).max() <= known.error.force + found.error.contact_force
    assert known.error.total < 0.1 * size
    assert found.error.rail < 1e-8 * size


# --- what must hold -------------------------------------------------------------------------------------------


def test_it_starts_from_rest_and_ends_in_the_steady_state() -> None:
    found = response(BOGIE, times=[0, 1e-6, 40], places=[0, "1.28"])
    assert np.abs(found.rail[:, 0]).max() == 0
    assert np.abs(found.rail[:, 1]).max() < 1e-6 * np.abs(found.rail).max()
    assert found.contact_force[:, 0].tolist() == [0, 0]
    assert found.rail[:, 2] == pytest.approx(found.steady[:, 2], rel=1e-6)
    weight = 9.80665 * (2 * 1813 + 2615 + 16000) / 2
    assert found.contact_force[:, 2] == pytest.approx([weight, weight], rel=1e-2)
    assert found.contact_force[:, 2].sum() == pytest.approx(2 * weight, rel=1e-6)


def test_certified_roots_give_the_same_motion() -> None:
    spectrum = certify(BOGIE, check=False)
    times = np.linspace(0, 1, 50)
    one, other = response(BOGIE, times=times), response(BOGIE, times=times, spectrum=spectrum)
    assert one.rail == pytest.approx(other.rail, abs=1e-10 * np.abs(one.rail).max())
    assert other.harmonic == pytest.approx(one.harmonic, abs=1e-10 * np.abs(one.rail).max())
    unstable = response(BOGIE, times=times, spectrum=certify(BOGIE, region="unstable", check=False))
    assert unstable.rail == pytest.approx(one.rail, abs=1e-8 * np.abs(one.rail).max())
    assert not unstable.harmonic.any()


def test_a_steady_start_has_no_shock_and_the_motion_is_linear() -> None:
    times = np.linspace(0, 0.5, 40)
    still = response(BOGIE, times=times, initial="steady")
    assert still.rail == pytest.approx(np.repeat(still.steady[:, :1], 40, 1), rel=1e-12)
    assert still.lift_off is None
    n = BOGIE.pencil.contacts
    both = response(BOGIE, [Load(500, 100, 60)] * n, times=times, initial="steady")
    alone = response(BOGIE, [Load(0, 100, 60)] * n, times=times)
    constant = response(BOGIE, [Load(500)] * n, times=times, initial="steady")
    assert both.rail == pytest.approx(alone.rail + constant.rail, abs=1e-9 * np.abs(both.rail).max())
    twice = response(BOGIE, [Load(0, 200, 60)] * n, times=times)
    assert twice.rail == pytest.approx(2 * alone.rail, abs=1e-9 * np.abs(twice.rail).max())


def test_an_irregularity_compresses_the_contact() -> None:
    """On a stiff track a wheel follows: Bᵀy − w + r = h f at every time."""
    rough = [Irregularity(1e-4, 100.0), Irregularity(2e-4, 150.0, 0.4)]
    times = np.linspace(0.01, 0.4, 60)
    found = response(BOGIE, times=times, irregularities=rough, initial="steady")
    r = np.array([one.amplitude * (np.sin(one.frequency * times + one.phase) - np.sin(one.phase)) for one in rough])
    wheels = np.array([found.vehicle["rear wheel"], found.vehicle["front wheel"]])
    assert wheels - found.rail + r == pytest.approx(found.contact_force / 1.4e9, abs=1e-8 * np.abs(found.rail).max())
    assert found.contact_force.std(1).min() > 1e3
    assert np.abs(found.steady_harmonic).max() > 0


def test_the_start_alone_is_rest():
    found = response(BOGIE, times=[0])
    assert found.rail == pytest.approx(0, abs=1e-15)


def test_growth_doubles_in_the_time_that_the_root_tells() -> None:
    problem = as_problem(Case(alpha="1.2", eta_b="0.05", eta_m=("40",), positions=("0",)))
    found = response(problem, [Load(1)], times=np.linspace(0, 400, 2001))
    growth = max(-part.q.imag for part in found.induced)
    assert growth > 0.01
    moving = np.abs(found.rail - found.steady)[0]
    peak = [moving[(found.times > a) & (found.times < a + 99)].max() for a in (200, 300)]
    assert peak[1] / peak[0] == pytest.approx(np.exp(100 * growth), rel=0.1)


def test_long_times_and_waves_far_away() -> None:
    found = response(BOGIE, times=[1e-3, 1.0, 1e4], places=[0, 30, -30])
    assert np.isfinite(found.rail).all()
    assert found.rail[:, -1] == pytest.approx(found.steady[:, -1], abs=1e-10 * np.abs(found.steady).max())
    assert found.error.rail < 1e-8 * np.abs(found.rail).max()


def test_what_float64_loses_far_out_is_left_out(tmp_path: Path) -> None:
    """p-roots of a damped beam on the way to the start, and those of very short waves far beyond all frequencies."""
    beam = Problem(made(tracks.EulerBernoulli), vehicles.Mass(1), v="0.2")
    assert response(beam, [Load(1)], times=[0, 1]).error.rail < 1e-8
    file = tmp_path / "file.toml"
    file.write_text(input_file("zhai-2004", "manchester"), "utf-8")
    coach = read_problem(file).problem
    found = response(coach, times=[40])
    assert found.rail[:, 0] == pytest.approx(found.steady[:, 0], rel=1e-3)


# --- what is refused ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("key", "options"),
    [
        ("times", {"times": [-1]}),
        ("times", {"times": []}),
        ("initial", {"times": [1], "initial": "soft"}),
        ("loads", {"times": [1], "loads": [Load(1)]}),
        ("loads", {"times": [1], "loads": {"nose": Load(1)}}),
        ("irregularities", {"times": [1], "irregularities": [Irregularity(1, 1)]}),
        ("places", {"times": [1], "places": ["x"]}),
    ],
)
def test_input_that_cannot_be_used_is_named(key: str, options: dict[str, Any]) -> None:
    with pytest.raises(InputError) as error:
        response(BOGIE, **options)
    assert error.value.key.startswith(key)


def test_a_load_at_an_induced_frequency_is_refused() -> None:
    """A body that no contact feels, on a spring without damping, is loaded at its own frequency."""
    lonely = vehicles.Vehicle(
        M=[[100, 0], [0, 4]], C=[[0, 0], [0, 0]], K=[[0, 0], [0, 100]], B=[[1], [0]], places=[0]
    )
    problem = Problem(DAMPED["two-layer"], lonely, v=10)
    with pytest.raises(InputError, match="grows without end"):
        response(problem, {"coordinate 2": Load(0, 1, 5)}, times=[1])
    assert np.isfinite(
        response(problem, {"coordinate 2": Load(0, 1, "5.1")}, times=[1]).vehicle["coordinate 2"]
    ).all()


def test_a_body_that_sinks_without_end_is_refused() -> None:
    sinking = vehicles.Oscillator(wheel=900, body=500, k=0, c=1000)
    with pytest.raises(InputError, match="are constant"):
        response(Problem(DAMPED["two-layer"], sinking, v=10), times=[1])


def test_a_track_that_buckles_is_refused() -> None:
    track = tracks.EulerBernoulli(EI=1, m=1, k=1, c=1, N=3)
    with pytest.raises(InputError, match="unstable"):
        response(Problem(track, vehicles.Mass(1), v=1), times=[1])


def test_the_file_of_the_examples() -> None:
    problem = read_problem("examples/two_layer_bogie.toml").problem
    found = response(problem, places=[0, "3.4"], times=np.linspace(0, 2, 2000))
    assert found.rail.shape == (2, 2000)
    assert set(found.vehicle) == {"rear wheel", "front wheel", "frame bounce", "frame pitch"}
    assert found.error.rail < 1e-8 * np.abs(found.rail).max()
    assert found.rail == pytest.approx(found.steady + found.harmonic + found.transient, abs=1e-18)


def test_a_root_far_out_is_found() -> None:
    """A light slab under a load much faster than its waves grows at a frequency far above those of the vehicle."""
    track = tracks.Slab(EI=11, m=32, k_pad=18, c_pad="7.25", EI_slab="0.25", m_slab=15, k=9, c=9)
    problem = Problem(track, vehicles.Mass(23), v=26)
    found = response(problem, times=np.linspace(0, 0.1, 20))
    root = next(root for root in certify(problem, region="unstable", check=False).roots if root.q.real > 0)
    assert [part.q for part in found.induced] == pytest.approx([complex(root.q.mid())], rel=1e-9)
    assert found.error.rail < 1e-8 * np.abs(found.rail).max()


def test_a_track_without_stiffness_at_rest_is_refused() -> None:
    with pytest.raises((InputError, PrecisionError)):
        response(Problem(tracks.EulerBernoulli(EI=1, m=1, k=0), vehicles.Mass(1), v=0), times=[1])


@pytest.mark.parametrize("faster", ["1.0003", "1.5", "4"])
def test_a_load_that_outruns_the_waves_of_a_string(faster: str) -> None:
    """The rail under it stays at rest and bears the weight at once; behind it moves as under a constant force."""
    string = DAMPED["string"]
    problem = Problem(string, TYPICAL["mass"], v=Fraction(faster) * Fraction("158.851"))
    times, place = [0.05, 0.3], Fraction(-5)
    found = response(problem, times=times, places=[0, place])
    weight = 900 * 9.80665
    assert found.contact_force[0] == pytest.approx([weight] * 2, rel=1e-7)
    guide = track_guide(string, problem.v)
    truth = Receptance(guide, 25)
    unit, g, rate = Fraction(2) ** guide.length, float(guide.g), 2.0**guide.time
    for k, t in enumerate(times):
        known = mpmath.invertlaplace(
            lambda s: weight * g * truth.value(place / unit, s * rate) / s, t, method="dehoog"
        )
        assert found.rail[1, k] == pytest.approx(float(known), rel=1e-5)
        assert abs(found.rail[0, k]) < 1e-9 * abs(found.rail[1, k])


LIGHT = tracks.EulerBernoulli(EI="6.38e6", m="60.2", k="1e6", c="7.7e-4")


@pytest.mark.parametrize(
    ("track", "v", "t"),
    [
        (DAMPED["euler-bernoulli"], "289.682274572382", 0.06),  # the critical velocity
        (LIGHT, "289.682274572382", 0.06),  # and next to no damping
        (LIGHT, 0, 0.06),
        (DAMPED["two-layer"], 1861, 0.01),  # growth by e^421 a second
        (DAMPED["timoshenko"], "1996.6", 0.003),  # next to the speed of shear
    ],
)
def test_hard_inputs_are_right(track: Any, v: Any, t: float) -> None:
    """By inversion of the image, where de Hoog's method resolves it."""
    problem = Problem(track, TYPICAL["mass"], v=v)
    found = response(problem, times=[t / 20, t], places=[0])
    known = Truth(problem, [([1.0], 900 * 9.80665, 0.0, 0.0, 0.0)], [Fraction(0)]).inverted(t)
    size = np.abs(known[2:]).max()
    assert np.abs(found.rail[:, 1] - known[2:]).max() <= found.error.rail + 1e-8 * size
    assert abs(found.contact_force[0, 1] - known[1]) <= found.error.contact_force + 2e-6 * abs(known[1])
    assert found.error.rail < 1e-8 * np.abs(found.rail).max()


def test_a_million_periods_end_in_the_steady_state_or_grow_as_told() -> None:
    problem = Problem(LIGHT, TYPICAL["mass"], v=100)
    found = response(problem, times=[3e4, 3e9], places=[0])  # 1/c is 1e5 s
    assert found.rail[0, 1] == pytest.approx(found.steady[0, 1], rel=1e-8)
    assert found.error.rail < 1e-8 * np.abs(found.rail).max()
    fast = Problem(DAMPED["two-layer"], TYPICAL["mass"], v=1861)
    with pytest.raises(InputError, match="exceeds e"):
        response(fast, times=[10])
