"""Masses without end: the charts are the problem's own matrix, and the test next to q = 0 finds what vanishes."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import Case, Problem
from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import InputError
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.problem.cases import as_problem
from mpsolve.proof.effort import Effort
from mpsolve.proof.vanishing import nonzero
from mpsolve.ranges.heavy import Heavy, SeenError, charts
from mpsolve.ranges.mirrored import beside_zero
from mpsolve.ranges.scope import scope_of
from mpsolve.tracks import EulerBernoulli, Track
from mpsolve.vehicles import Mass, Oscillator

TRACK = EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
SPRUNG = Problem(TRACK, (Oscillator(wheel=1, k=1, c="0.2", body=4, k_contact=9).at(0), Mass(2).at(3)), v="0.9")


def heavy(problem: Problem) -> Heavy:
    return Heavy(scope_of(problem, {"scale.mass": (Fraction(1), Fraction(2))}), "scale.mass")


def pair(alpha: str, distance: str = "1.5") -> Problem:
    return as_problem(Case(alpha=alpha, eta_b="0.05", eta_m=(1, 1), positions=(0, distance)))


@pytest.mark.parametrize("problem", [pair("0.9"), SPRUNG])
@pytest.mark.parametrize(("q", "x"), [(0.3, 1.25), (0.8, 1.75)])
def test_charts_have_the_zeros_of_the_matrix(problem: Problem, q: float, x: float) -> None:
    family = heavy(problem).scope.family

    def det(matrix: FreeMatrix, parameter: float) -> complex:
        boxes = Boxes(np.array([[q], [parameter]]), np.full((2, 1), 2.0**-60))
        return complex(np.linalg.det(matrix(boxes)[0].a[0]))

    quick, slow = charts(family)
    rows = sum(any(c for _, c in cell) for row in family.S[2] for cell in row) if problem is SPRUNG else 2
    here = det(FreeMatrix(family), x)
    assert det(slow, q * q * x) == pytest.approx(here, rel=1e-12)
    y = q * q * x
    assert det(quick, 1 / y) * y**rows == pytest.approx(here, rel=1e-12)


def model(k: list[complex], e: float = 0.0) -> Quadratic:
    """Of (u₀, u₁): 1, u₀, u₁, u₀², u₀u₁, u₁²."""
    return Quadratic(np.array(k, complex)[:, None], np.array([e]), 2)


@pytest.mark.parametrize(
    ("k", "e", "none"),
    [
        ([0, 0.1j, 1, 0, 0, 0], 0.05, True),  # Re = u₁, Im = 0.1 u₀
        ([0, 0.1j, 1, 0, 0, 0], 0.2, False),
        ([0.01, 0.1j, 1, 0, 0.1j, 0], 0.0, True),  # Re = 0.01 + u₁, Im/u₀ = 0.1(1 + u₁)
        ([1, 0.1j, 1, 0, 0.1j, 0], 0.0, False),  # both vanish at u₁ = −1
        ([0, 0, 1, 0, 0, 0], 0.0, False),  # real all along
        ([0.5, 0, 0, 0.4, 0, 0], 0.05, True),
        ([0.5, 0, 0, 0.4, 0, 0.2], 0.0, True),  # Re is 0.5 at least
        ([0.5, 0, 0, -0.4, 0, -0.2], 0.0, False),  # the parts add up to 0.6
    ],
)
def test_what_vanishes_next_to_zero(k: list[complex], e: float, none: bool) -> None:
    assert bool(nonzero(beside_zero(model(k, e))).nonzero[0]) is none


def test_none_is_real_for_pairs_that_stay_stable() -> None:
    one = heavy(pair("0.5"))
    assert all(part.reason is None for part in one.cover(Fraction(1), Effort(evaluations=5000)))


@pytest.mark.parametrize("track", [DAMPED["timoshenko"], DAMPED["rayleigh"]])
def test_tracks_with_quick_waves_need_no_more_boxes(track: Track) -> None:
    """Their unit of frequency is that of short waves, beside which y is tiny: boxes are measured by their own y."""
    one = heavy(Problem(track, (Mass(900).at(0), Mass(900).at(3)), v=165))
    found = one.cover(2 / one.scope.family.units[0], Effort(evaluations=3000))
    assert all(part.reason is None for part in found)


def test_a_mass_at_which_a_root_is_real_is_seen() -> None:
    one = heavy(pair("0.9"))
    unit = one.scope.family.units[0]
    with pytest.raises(SeenError) as seen:
        one.cover(1 / unit, Effort(evaluations=5000))
    assert float(seen.value.x * unit) == pytest.approx(52.87194079683, rel=1e-4)
    assert all(part.reason is None for part in one.cover(60 / unit, Effort(evaluations=5000)))


def test_only_factors_of_all_masses_have_a_limit() -> None:
    scope = scope_of(SPRUNG, {"v": (Fraction(1, 2), Fraction(1))})
    with pytest.raises(InputError, match="only a factor of all masses"):
        Heavy(scope, "v")
