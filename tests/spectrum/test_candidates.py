"""Candidates: the float roots of a problem, against numbers that others made, and how often each stands for."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Case, Problem, tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.presets.written import problem_of
from mpsolve.problem.cases import as_problem
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.candidates import Area, _crowds, both, find_roots, nearest_root, search
from mpsolve.spectrum.sheet import count_sheet

WIRE = Problem(tracks.String(T=27_000, m="1.07", k=500, c=2), vehicles.Mass("8.5"), v=100)
ROOT = 15.641876611743 + 0.715988110564j
"""An independent program has it."""
REDUCED = reduce_problem(WIRE)
UNIT = float(REDUCED.frequency_unit)
AREA = Area(0.0, 40 / UNIT, -1 / UNIT, 0.9 / UNIT)


def test_a_root_is_found_from_no_hints() -> None:
    found = find_roots(REDUCED, (AREA,), 2, np.zeros(0, complex)) * UNIT
    assert found.shape == (1,)
    assert abs(found[0] - ROOT) < 1e-10


def test_a_search_without_a_number_finds_it_too() -> None:
    assert np.abs(search(REDUCED, AREA, ()) * UNIT - ROOT).min() < 1e-9


def test_newton_leads_to_it_from_near_and_says_where_it_does_not_settle() -> None:
    found = nearest_root(REDUCED, (ROOT + 0.3 - 0.1j) / UNIT)
    assert found is not None
    assert abs(found * UNIT - ROOT) < 1e-9


def test_a_heavy_mass_is_found_next_to_zero() -> None:
    """A mass of 10³⁰ kg on the wire at rest: q² = 2√(T k)/M, by hand, up to the damping."""
    heavy = reduce_problem(Problem(tracks.String(T=27_000, m="1.07", k=500, c=2), vehicles.Mass("1e30"), v=0))
    unit = float(heavy.frequency_unit)
    q = (2 * np.sqrt(27_000 * 500) / 1e30) ** 0.5
    found = find_roots(heavy, (Area(0.0, 2.0, -1.0, 0.01),), 2, np.zeros(0, complex)) * unit
    assert np.abs(found.real / q - 1).min() < 1e-9


def test_pairs_count_twice() -> None:
    assert (both(1 + 1j), both(1e-12 + 1j)) == (2, 1)
    assert AREA.holds(np.array([1.0, 41.0]) / UNIT, 0.0).tolist() == [True, False]


def test_roots_next_to_a_high_line_of_cuts_are_found() -> None:
    """Strong damping, masses far apart: waves to and fro between them, just below and above Im q = η_b."""
    case = Case(alpha="1.1", eta_b="0.9", eta_m=["18.3", "0.698", "0.64"], positions=[0, "8.91", "17.82"])
    reduced = reduce_problem(as_problem(case))
    line = on_line(reduced)
    assert line is not None
    count = count_sheet(line, Effort(evaluations=200_000))
    areas = (Area(0.0, 2.3, -1.4, 0.9, 0.9), Area(0.0, 2.3, 0.9, 3.2, 0.9))
    found = find_roots(reduced, areas, count.total, np.zeros(0, complex))
    assert sum(map(both, found.tolist())) == count.total == 22


def test_bodies_on_soft_springs_are_found_far_below_the_waves_of_the_track() -> None:
    """The body of the Manchester coach vibrates as on a rigid rail: a mass and an inertia on two springs in row."""
    reduced = reduce_problem(problem_of("ballasted", "manchester")[0])
    unit = float(reduced.frequency_unit)
    found = search(reduced, Area(0.0, 2.0, -1.0, 30 / unit), np.zeros(0, complex), 1) * unit
    k = 1 / (1 / 430e3 + 1 / 2400e3)  # of one bogie: the secondary springs over the primary ones
    for moved, stiffness in ((16000.0, 2 * k), (985000.0, 2 * k * 9.5**2)):
        alone = np.sqrt(stiffness / moved)
        assert np.abs(np.abs(found) - alone).min() < 0.03 * alone


def test_roots_that_floats_cannot_tell_apart_end_the_search_and_come_first() -> None:
    """The bogies of a coach are 19 m apart, and the ballast carries nothing so far: each rings as if alone."""
    reduced = reduce_problem(problem_of("ballasted", "manchester")[0])
    unit, steps = float(reduced.frequency_unit), [0]

    def on_the_way() -> None:
        steps[0] += 1

    found = find_roots(reduced, (Area(0.0, 2.0, -1.0, 118 / unit),), 20, np.zeros(0, complex), both, on_the_way)
    assert len(found) < 10  # of ten with Re q > 0
    assert steps[0] < 60  # no grid was searched
    first = np.abs(found[: 10 - len(found)] * unit)
    assert (first > 60).all()  # the car's own six are apart


def test_roots_in_one_place_share_the_zeros_there() -> None:
    """Two bogies of a coach, 10⁻⁸ apart in what floats tell: two zeros in all, whether one or both were found."""
    reduced = reduce_problem(problem_of("ballasted", "manchester")[0])
    function, unit = Floats(reduced), float(reduced.frequency_unit)
    near = nearest_root(reduced, (72.07 + 8.69j) / unit)
    assert near is not None
    alone, both_found = np.array([near]), np.array([near, near * (1 + 1e-9)])
    assert _crowds(function, alone).sum() == pytest.approx(2)
    assert _crowds(function, both_found).sum() == pytest.approx(2)


def test_a_search_ends_with_what_it_has_when_it_has_worked_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    """The work is that of matrices: a train of many coaches would search for ever."""
    reduced = reduce_problem(problem_of("ballasted", "manchester")[0])
    area, points = Area(0.0, 2.0, -1.0, 118 / float(reduced.frequency_unit)), [0]
    step = Floats.step

    def counted(self: Floats, sigma: np.ndarray, known: object) -> object:
        points[0] += len(sigma)
        return step(self, sigma, known)

    monkeypatch.setattr(Floats, "step", counted)
    ends = []
    for most in (2**18, 2**21, 2**40):
        monkeypatch.setattr("mpsolve.spectrum.candidates._MOST", most)
        points[0] = 0
        find_roots(reduced, (area,), 1000, np.zeros(0, complex))
        ends.append(points[0])
    assert 100 < ends[0] < ends[1] < ends[2] / 2
