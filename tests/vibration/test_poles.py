"""The roots to the right of a line: found in floats, or certified; nearly double ones are told by their number."""

from __future__ import annotations

import infinite
import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Case, InputError, Load, Problem, certify, response, response_balls, response_mp, tracks, vehicles
from mpsolve.problem.cases import as_problem
from mpsolve.vibration.image import Image
from mpsolve.vibration.poles import certified, room, searched


@pytest.mark.parametrize(("track", "vehicle", "v"), [("two-layer", "bogie", 100), ("slab", "oscillator", 60)])
def test_the_roots_are_the_certified_ones(track: str, vehicle: str, v: int) -> None:
    problem = Problem(DAMPED[track], TYPICAL[vehicle], v=v)
    found, known = searched(problem), certified(Image(problem, ()), certify(problem, check=False))
    assert found.complete
    assert known.complete
    mine, theirs = (
        np.sort_complex([p.sigma for p in poles.poles if p.sigma.real > found.floor * 0.99])
        for poles in (found, known)
    )
    assert mine == pytest.approx(theirs, rel=1e-9)
    assert found.cut == known.cut < known.floor < 0


def test_the_spectrum_of_another_problem_is_refused_by_every_motion() -> None:
    """Its roots would stand under `induced`, with harmonic parts of another motion."""
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.2")
    one, other = (Problem(beam, vehicles.Mass(M), v="0.5") for M in (3, "3.05"))
    spectrum = certify(other, check=False)
    for given, said in ((spectrum, "another problem"), ("pair.json", "type str")):
        with pytest.raises(InputError, match=said):
            response(one, times=[1.0], spectrum=given)
        with pytest.raises(InputError, match=said):
            response_balls(one, times=[1], spectrum=given)
        with pytest.raises(InputError, match=said):
            response_mp(one, times=[1], digits=15, spectrum=given)
    assert response(other, times=[1.0], spectrum=spectrum).error.rail < 1e-8


def test_roots_that_grow_are_found_where_cuts_touch_the_axis() -> None:
    """A Rayleigh beam damped by its foundation: the cuts come down to the axis far out."""
    problem = Problem(DAMPED["rayleigh"], vehicles.Mass(5000), v=420)
    found = searched(problem)
    (root,) = [
        1j * complex(x.q.mid()) for x in certify(problem, region="unstable", check=False).roots if x.q.real > 0
    ]
    assert found.cut == 0 < found.growth
    assert found.poles[0].sigma * Image(problem, ()).rate == pytest.approx(root, rel=1e-9)


def test_two_bogies_far_apart_have_nearly_double_roots() -> None:
    found = searched(Problem(DAMPED["two-layer"], TYPICAL["coach"], v=20))
    assert found.complete
    assert sorted(pole.multiplicity for pole in found.poles) == [1, 1, 1, 1, 2, 2, 2]


BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


@pytest.mark.parametrize("v", [0, "0.5"])
def test_cuts_of_the_papers_beam_are_half_lines(v):
    """At v = 0 they begin at Im q = η_b, |Re q| = √(1 − η_b²); at 0.5 they begin nearer to 0."""
    image = Image(Problem(BEAM, vehicles.Mass(1), v=v), ())
    edge = -0.05 + 1j * np.sqrt(1 - 0.05**2)
    if v == 0:
        assert room(image, edge - 0.3j) == pytest.approx(0.3, rel=1e-6)
        assert room(image, 0.1 + 0j) == pytest.approx(abs(0.1 - edge), rel=1e-6)
    assert room(image, -0.05 + 7j - 0.01) == pytest.approx(0.01, rel=1e-4)  # over the line


def test_a_layered_track_has_rooms_too():
    two = tracks.TwoLayer(EI="6.4e6", m=60, m_sleeper=150, k_pad="1e8", c_pad="5e4", k_ballast="5e7", c_ballast="1e5")
    image = Image(Problem(two, vehicles.Mass(800), v=60), ())
    near = [room(image, complex(-0.1, y)) for y in (0.0, 1.0, 5.0)]
    assert all(x > 0 for x in near)
    assert room(image, 100.0 + 0j) == pytest.approx(100, rel=0.1)


@pytest.mark.parametrize(("alpha", "eta_b", "d"), [("0.9", 0, "1.5"), ("1.1", "0.05", 1)])
def test_what_rings_between_the_cuts_is_harmonic(alpha, eta_b, d):
    """Roots of the whole sheet, on the axis or above the cuts: the mean of the paper's image, by tests/infinite.py,
    on a small circle round each is its amplitude (36)."""
    case, times = Case(alpha=alpha, eta_b=eta_b, eta_m=(40, 40), positions=(0, d)), np.linspace(0, 60, 13)
    found = certify(case, check=False)
    mine = response(as_problem(case), [Load(2)] * 2, times=times, places=[0], spectrum=found)
    known = np.zeros(len(times))
    for q in (complex(root.q.mid()) for root in found.roots if root.q.real > 0):
        turn = 1e-3 * np.exp(2j * np.pi * np.arange(16) / 16)
        kernel = infinite.kernels(case, q + turn, np.array([[0.0, -float(d)], [float(d), 0.0]]))
        system = np.pi * np.eye(2) - 2 * (q + turn)[:, None, None] ** 2 * 40 * np.moveaxis(kernel, -1, 0)
        force = np.moveaxis(kernel, -1, 0).sum(-1) * (4 / (1j * (q + turn)))[:, None]
        image = np.linalg.solve(system, force[..., None])[:, 0, 0]
        known += (2j * np.mean(image * turn) * np.exp(1j * q * times)).real
    assert mine.harmonic[0] == pytest.approx(known, abs=1e-8 * np.abs(known).max())
