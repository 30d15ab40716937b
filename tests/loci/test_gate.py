"""Discs next to the end of a line at the branch point hold the root of floats; behind it there is none."""

import math
from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Case, frequencies
from mpsolve.cuts.reached import Reached, all_reached
from mpsolve.loci.gate import gate_of
from mpsolve.problem.cases import as_problem
from mpsolve.problem.family import family_of
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort

CASE = Case(alpha="0.6", eta_b=0, eta_m=(40, 40), positions=(0, "0.5"))


@pytest.fixture(scope="module")
def end() -> Reached:
    family = family_of(as_problem(CASE), {"v": (Fraction(7, 10), Fraction(4, 5))})
    (one,) = all_reached(family, 15, Effort(), silent).points
    return one


def test_the_disc_holds_the_root(end: Reached) -> None:
    gate = gate_of(end, 0.7, 0.8)
    assert gate is not None
    assert gate.x < float(end.x) < gate.x + 0.01
    for x in (gate.x, gate.x / 2 + float(end.x) / 2, float(end.x) - 1e-5):
        here = gate.at(x, math.nextafter(x, 1))
        assert here is not None
        roots = frequencies(CASE, {"v": [x]}, region="sheet").roots[0]
        known = roots[np.isfinite(roots)]
        if len(known):
            assert np.abs(known - here.q).min() < here.radius + 1e-8  # floats lose half of their digits here
        assert here.radius < 1e-6


def test_behind_the_end_the_root_is_on_another_sheet(end: Reached) -> None:
    gate = gate_of(end, 0.7, 0.8)
    assert gate is not None
    x = float(end.x) + 1e-6
    assert gate.at(x, x) is None
    assert gate.at(0.7, 0.7) is None


def test_it_stays_in_the_range(end: Reached) -> None:
    low = float(end.x) - 1e-4
    gate = gate_of(end, low, 0.8)
    assert gate is not None
    assert low + 4e-5 < gate.x < float(end.x)
