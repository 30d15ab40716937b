"""Entries of a batch: their exact problems, formations, and that floats never overrule exact algebra."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from oracle_general.package import as_problem, known
from oracle_general.problems import problems

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import _clearly_felt, entries_of
from mpsolve.vehicles.felt import split_felt

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def test_entries_are_the_problem_with_its_parameters_changed() -> None:
    problem = Problem(BEAM, [vehicles.Mass(5).at(3), vehicles.Mass(7).at(0)], v="0.5")
    entries = entries_of(problem, {"v": [[0.1], [0.2]], "vehicles[0].M": [1.5, 2.5, 1.5], "gap[0]": 4})
    assert entries.shape == (2, 3)
    assert len(entries) == 6
    assert len(entries.formations) == 2  # equal ones once
    last = entries.exact(5)
    assert (float(last.v), float(last.parameters["vehicles[0].M"]), last.parameters["gap[0]"]) == (0.2, 1.5, 4)
    formation = entries.formations[entries.which[5]]
    assert formation.places.tolist() == [0, 4]
    by_contact = formation.B.T @ formation.M @ formation.B
    assert by_contact.tolist() == [[1.5, 0], [0, 5]]  # from rear to front


def test_motions_that_no_contact_feels_are_left_out() -> None:
    twins = vehicles.Vehicle(
        M=[[1, 0, 0], [0, 2, 0], [0, 0, 2]], C=[[0] * 3] * 3, K=[[2, -1, -1], [-1, 1, 0], [-1, 0, 1]],
        B=[[1], [0], [0]], places=[0],
    )  # fmt: skip
    entries = entries_of(Problem(BEAM, twins, v=1), {})
    assert len(entries.formations[0].M) == 2


@given(problems())
@settings(max_examples=40, deadline=None)
def test_floats_that_are_sure_are_right(plain: dict[str, Any]) -> None:
    if not known(plain):
        return
    for placed in as_problem(plain).vehicles:
        pencil = placed.vehicle.pencil
        if _clearly_felt(*(np.array(rows, float) for rows in (pencil.M, pencil.C, pencil.K, pencil.B))):
            parts = split_felt(pencil)
            assert parts.unfelt is None
            assert not parts.neutral


@pytest.mark.parametrize("loose", [True, False])
def test_a_body_on_a_damper_is_neutral(loose: bool) -> None:
    wheel = vehicles.Vehicle(
        M=[[1, 0], [0, 2]], C=[[1, -1], [-1, 1]], K=[[0, 0], [0, 0]] if loose else [[1, -1], [-1, 1]],
        B=[[1], [0]], places=[0],
    )  # fmt: skip
    formation = entries_of(Problem(BEAM, wheel, v=1), {}).formations[0]
    assert np.count_nonzero(formation.neutral) == loose
