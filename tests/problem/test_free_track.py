"""The equations of a track with free parameters are, at each point, those of the track with these parameters."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.numbers.several import Ring
from mpsolve.problem.free_track import free_guide, free_matrix
from mpsolve.problem.parameters import changed
from mpsolve.problem.reduced import reduce_problem

LAYERS = {"k_pad": "300e6", "c_pad": "3e4", "m_sleeper": "250", "k_ballast": "100e6", "c_ballast": "8e4"}
PROBLEM = Problem(tracks.TwoLayer(EI="6.38e6", m="60.2", **LAYERS), vehicles.Mass(900).at(0), v=600)
RING = Ring(("track.c_pad", "v"), (Fraction(30_000), Fraction(600)))


@pytest.mark.parametrize("damping", [Fraction(0), Fraction(12_345), Fraction(30_000)])
def test_the_matrix_at_a_point_is_that_of_the_track_there(damping: Fraction) -> None:
    track, _, _ = changed(PROBLEM.track, PROBLEM.vehicles, PROBLEM.v, "track.c_pad", RING.variables[0])
    there = PROBLEM.changed("track.c_pad", damping).track.waveguide.matrix
    rows = [
        [{key: value for key, c in entry.items() if (value := c.at((damping, Fraction(0))))} for entry in row]
        for row in free_matrix(track, RING)
    ]
    assert rows == [list(row) for row in there]


def test_a_track_of_bare_equations_is_taken_as_it_is() -> None:
    assert free_matrix(PROBLEM.track.waveguide, RING) == PROBLEM.track.waveguide.matrix


def test_the_guide_keeps_the_scales_of_the_one_that_it_is_like() -> None:
    track, _, v = changed(PROBLEM.track, PROBLEM.vehicles, PROBLEM.v, "v", RING.variables[1])
    guide = reduce_problem(PROBLEM).guide
    D, N, speed = free_guide(track, guide, RING, RING.constant(v))
    at = {key: c.at(RING.point) for key, c in D.items()}
    assert at == guide.D_rest
    assert {key: c.at(RING.point) for key, c in N.items()} == guide.N_rest
    assert speed.at(RING.point) == guide.v
