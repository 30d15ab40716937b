"""The finite track against the infinite beam, residues, certified roots, one exponential of all, and itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from infinite import response
from track_models import DAMPED
from vehicle_models import BOGIE, TYPICAL

from mpsolve import Case, InputError, Load, Problem, certify, finite_track, receptance, tracks, vehicles
from mpsolve.finite.discretization import discretized
from mpsolve.numbers.float64 import Float64

TWO = DAMPED["two-layer"]


# --- against other ways ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(("alpha", "eta_b", "line"), [("0.5", "0.1", 0.06), ("1.2", "0.05", 0.4)])
def test_the_papers_beam_agrees_with_the_infinite_beam(alpha: str, eta_b: str, line: float) -> None:
    """(13) over 4: EI = 1/4, m = k = 1, c = 2η_b, forces twice those in w_st; also where the motion grows."""
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=("40", "10"), positions=("0", "1.5"))
    times = np.linspace(0.5, 30, 60)
    truth = response(case, [Load(1, "0.5", "0.7", "0.3"), Load("0.5")], times, line=line)
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=2 * float(eta_b))
    problem = Problem(beam, [vehicles.Mass(10).at("1.5"), vehicles.Mass(40)], v=alpha)
    found = finite_track(problem, [Load(2, 1, "0.7", "0.3"), Load(1)], length=80, modes=1200, times=times)
    assert found.error.total < 2e-3 * np.abs(truth).max()
    assert np.abs(found.rail - truth).max() < found.error.total
    first = np.array([found.vehicle["wheel of vehicle 2"], found.vehicle["wheel of vehicle 1"]])
    assert np.abs(first - truth).max() < found.error.total + found.error.vehicle


@pytest.mark.parametrize(
    ("name", "velocity", "duration", "length"),
    [
        ("two-layer", 40, 1.5, 140),
        ("three-layer", 60, 1, 140),
        ("slab", 60, 1, 150),
        ("timoshenko", 30, 2, 160),
        ("rayleigh", 30, 2, 160),
        ("euler-bernoulli", 30, 2, 160),
    ],
)
def test_the_steady_deflection_is_that_of_the_residues(
    name: str, velocity: int, duration: float, length: float
) -> None:
    """Where a constant force has moved long enough, the rail bends as residues at the frequency 0 have it."""
    track = DAMPED[name]
    if name in ("timoshenko", "rayleigh", "euler-bernoulli"):
        track = type(track)(**(track.parameters | {"c": 30000}))
    problem = Problem(track, vehicles.Mass(100), v=velocity)
    places = [-2.5, -1, 0, "0.75", 2]
    found = finite_track(problem, [Load(80000)], length=length, modes=900, times=[duration], places=places)
    steady = 80000 * receptance(track, [float(x) for x in places], 0, velocity)[:, 0].real
    assert np.abs(found.rail[:, 0] - steady).max() < found.error.total + 2e-5 * np.abs(steady).max()
    assert found.error.total < 3e-3 * np.abs(steady).max()
    assert found.contact_force[0, 0] == pytest.approx(80000, rel=1e-4)


def test_the_weights_of_a_bogie_settle_on_the_rail() -> None:
    bogie = vehicles.Bogie(**(BOGIE | {"c": "1e5"}), k_contact="1.4e9")
    problem = Problem(TWO, bogie, v=20)
    found = finite_track(problem, length=100, modes=600, times=[2])
    half = (1813 + 2615 / 2) * 9.80665
    assert found.contact_force[:, 0] == pytest.approx(half, rel=2e-4)
    steady = half * receptance(TWO, [0, 2.56, -2.56], 0, 20)[:, 0].real
    both = [steady[0] + steady[2], steady[0] + steady[1]]
    assert found.rail[:, 0] == pytest.approx(both, abs=found.error.total)
    assert found.error.total < 5e-3 * both[0]
    rear = found.vehicle["rear wheel"][0]
    assert rear - found.rail[0, 0] == pytest.approx(half / 1.4e9, rel=1e-3)
    bend = found.vehicle["frame bounce"][0] - (rear + found.vehicle["front wheel"][0]) / 2
    assert bend == pytest.approx(2615 / 2 * 9.80665 / 2.4e6, rel=1e-3)


def test_a_free_vibration_decays_as_the_slowest_certified_roots() -> None:
    """The bounce of a body over a bogie after the sudden start: e^{iqt} with q of least imaginary part, proved."""
    problem = Problem(TWO, TYPICAL["bogie"], v=30)
    proved = certify(problem, region=("below", 2), check=False)
    roots = [complex(root.q) for root in proved.roots]
    slowest = min((q for q in roots if q.real > 0), key=lambda q: q.imag)
    times = np.linspace(3, 6, 61)
    found = finite_track(problem, length=250, modes=700, times=times)
    moved = np.diff(found.vehicle["body"])
    a, b = np.linalg.lstsq(np.stack([moved[1:-1], moved[:-2]], 1), moved[2:], rcond=None)[0]
    rates = np.log(np.roots([1, -a, -b])) / (times[1] - times[0])
    q = next(-1j * rate for rate in rates if rate.imag > 0)
    assert q == pytest.approx(slowest, rel=1e-4)


@pytest.mark.parametrize("name", ["two-layer", "timoshenko", "floating-ice"])
def test_a_resting_track_is_reciprocal(name: str) -> None:
    """Motion at B under a force at A, and the other way round."""
    problem = Problem(DAMPED[name], [vehicles.Mass(500), vehicles.Mass(500).at(3)], v=0)
    pushes = ([Load(1000, 500, 60), Load(0)], [Load(0), Load(1000, 500, 60)])
    figures = {"length": 60, "modes": 120, "start": 22, "times": np.linspace(0.01, 0.3, 20), "steps": 400}
    first, second = (finite_track(problem, one, **figures) for one in pushes)
    assert np.abs(first.rail[1] - second.rail[0]).max() < 1e-8 * np.abs(first.rail).max()
    assert np.abs(first.rail[1]).max() > 1e-3 * np.abs(first.rail).max()


@pytest.mark.parametrize("name", ["two-layer", "timoshenko", "slab"])
def test_at_rest_everything_is_one_exponential(name: str) -> None:
    """M, C, K of twelve modes and of a bogie on contact springs as one matrix, with constant weights."""
    bogie, length, modes, start = vehicles.Bogie(**BOGIE, k_contact="1.4e9"), 20.0, 12, 8.0
    track = discretized(DAMPED[name].waveguide, length, modes)
    fields, size = len(track.kinds), modes * len(track.kinds)
    pencil = bogie.pencil
    M, C, K = (np.zeros((size + 4, size + 4)) for _ in range(3))
    for whole, parts, own in (
        (M, track.mass, pencil.M),
        (C, track.damping, pencil.C),
        (K, track.stiffness, pencil.K),
    ):
        for j in range(modes):
            whole[j * fields : (j + 1) * fields, j * fields : (j + 1) * fields] = length / 2 * parts[j]
        whole[size:, size:] = np.array(own, float)
    for contact, x in enumerate((start - 1.28, start + 1.28)):
        stretch = np.zeros(size + 4)
        stretch[:size:fields] = -np.sin(track.wavenumbers * x)
        stretch[size + contact] = 1
        K += 1.4e9 * np.outer(stretch, stretch)
    weight = np.zeros(size + 4)
    weight[size:] = 9.80665 * np.array([1813, 1813, 2615, 0])
    rest = np.linalg.solve(K, weight)
    n, h = size + 4, 0.05
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    flow = Float64().exp(A * h).real
    state, truth = np.concatenate([-rest, np.zeros(n)]), []
    for _ in range(4):
        state = flow @ state
        truth.append((state[:n] + rest)[size:])
    problem = Problem(DAMPED[name], bogie, v=0)
    times = h * np.arange(1, 5)
    found = finite_track(problem, length=length, modes=modes, times=times, start=start, steps=4000)
    moved = np.array(list(found.vehicle.values())).T
    assert np.abs(moved - truth).max() < 1e-7 * np.abs(truth).max()


# --- vehicles without mass somewhere --------------------------------------------------------------------------


def _wheel(M: Any, C: Any, K: Any, B: Any, **more: Any) -> Problem:
    return Problem(TWO, vehicles.Vehicle(M=M, C=C, K=K, B=B, places=[0], **more), v=30)


def test_a_spring_without_mass_is_a_contact_spring() -> None:
    k, figures = 10**8, {"length": 60, "modes": 200, "times": np.linspace(0.001, 0.2, 50), "steps": 2000}
    plain = finite_track(_wheel([[900]], [[0]], [[0]], [[1]], k_contact=k), [Load(9000)], **figures)
    rows = ([[900, 0], [0, 0]], [[0, 0], [0, 0]], [[k, -k], [-k, k]], [[0], [1]])
    found = finite_track(_wheel(*rows, names=["wheel", "shoe"]), {"wheel": Load(9000)}, **figures)
    assert np.abs(found.rail - plain.rail).max() < 1e-10 * np.abs(plain.rail).max()
    assert np.abs(found.vehicle["shoe"] - found.rail[0]).max() < 1e-3 * np.abs(plain.rail).max()
    with pytest.raises(InputError, match="would jump") as caught:
        finite_track(_wheel(*rows), {"coordinate 2": Load(1)}, **figures)
    assert caught.value.key == "loads"


def test_a_damper_without_mass_is_the_limit_of_light_ones() -> None:
    k, c, figures = 10**6, 10**5, {"length": 60, "modes": 200, "times": np.linspace(0.01, 0.2, 50), "steps": 1500}
    loads = {"coordinate 1": Load(9000)}

    def rail(light: object) -> Any:
        return finite_track(_wheel([[900, 0], [0, light]], [[c, -c], [-c, c]], [[k, -k], [-k, k]], [[0], [1]]),
                            loads, **figures).rail  # fmt: skip

    bare, light, lighter = rail(0), rail("0.1"), rail("0.05")
    assert 1e-8 < np.abs(light - bare).max() / np.abs(bare).max() < 1e-3
    assert np.abs(light - bare).max() == pytest.approx(2 * np.abs(lighter - bare).max(), rel=0.1)


# --- the method -----------------------------------------------------------------------------------------------


def test_errors_of_the_vehicle_fall_at_the_fourth_order() -> None:
    problem = Problem(TWO, vehicles.Mass(900), v=30)

    def motion(steps: int) -> Any:
        times = np.linspace(0.02, 0.2, 10)
        return finite_track(problem, length=40, modes=20, times=times, steps=steps).vehicle["wheel"]

    fine = motion(3200)
    errors = [np.abs(motion(steps) - fine).max() for steps in (100, 200, 400)]
    assert errors[0] > 12 * errors[1] > 144 * errors[2]


def test_loads_by_name_and_by_contact_are_one_for_masses() -> None:
    problem = Problem(TWO, [vehicles.Mass(900), vehicles.Mass(500).at(2)], v=30)
    figures = {"length": 60, "modes": 100, "times": [0.1, 0.2], "steps": 200}
    by_contact = finite_track(problem, [Load(1, 2, 30), Load(0)], **figures)
    by_name = finite_track(problem, {"wheel of vehicle 1": Load(1, 2, 30)}, **figures)
    assert by_contact.rail == pytest.approx(by_name.rail, rel=1e-11)


@pytest.mark.parametrize(
    ("key", "arguments"),
    [
        ("problem", {"problem": 5}),
        ("length", {"length": 20}),
        ("length", {"length": 0}),
        ("modes", {"modes": 3}),
        ("modes", {"modes": 100.0}),
        ("times", {"times": []}),
        ("times", {"times": [0.2, 0.1]}),
        ("times", {"times": [-1, 1]}),
        ("times", {"steps": 900_000, "modes": 40_000}),
        ("times[1]", {"times": ["soon"]}),
        ("places[1]", {"places": ["here"]}),
        ("start", {"start": 1, "places": [-4]}),
        ("steps", {"steps": 3}),
        ("tolerance", {"tolerance": 1}),
        ("loads", {"loads": [Load(1)] * 2}),
        ("loads", {"loads": "weights"}),
        ("loads[1]", {"loads": [5]}),
        ("loads", {"loads": {"boiler": Load(1)}}),
        ("loads", {"problem": Problem(TWO, vehicles.Vehicle([[1]], [[0]], [[3]], [[1]], [0]), v=1)}),
        ("track", {"problem": Problem(tracks.EulerBernoulli(EI=1, m=1, k=1, N=3), vehicles.Mass(1), v=1)}),
    ],
)
def test_what_cannot_be_used_is_named(key: str, arguments: dict[str, Any]) -> None:
    problem = Problem(TWO, vehicles.Mass(900), v=30)
    with pytest.raises(InputError) as caught:
        finite_track(**({"problem": problem, "length": 60, "modes": 50, "times": [1.0]} | arguments))
    assert caught.value.key == key
