"""The whole sheet by paths: the kernel's own ratios against problems in SI, and against certified spectra."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import Case, Problem, certify, frequencies, tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.fast.frequencies import frequencies as kernel

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
PAIR = Problem(BEAM, vehicles.train(vehicles.Mass(70), 2, "1.5"), v="0.67")
RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="770", N="1e5", kp="2e4")


def test_the_papers_ratios_by_path() -> None:
    alpha, eta_b = np.array([0.3, 0.67, 1.1])[:, None], np.array([0, 0.05])
    found = frequencies(PAIR, {"v": alpha, "track.c": 2 * eta_b, "gap[0]": 1.5}, region="sheet")
    direct = kernel(alpha, eta_b, 70.0, 1.5)
    assert found.shape == (3, 2)
    assert np.array_equal(found.count, direct.count)
    assert np.allclose(found.roots, direct.q, rtol=1e-12, equal_nan=True)
    assert np.array_equal(found.unstable, direct.unstable)


def test_si_units_are_those_of_the_problem() -> None:
    masses = [vehicles.Mass("8000").at(0), vehicles.Mass("12000").at("3.4")]
    problem = Problem(RAIL, masses, v=100)
    found = frequencies(problem, {"v": [100, 150, 190]}, region="sheet")
    spectrum = certify(problem.changed("v", 150), region="sheet", digits=15)
    expected = [complex(root.q.mid()) for root in spectrum.roots]
    row = found.roots[1][: found.count[1]]
    assert len(row) == len(expected)
    assert np.allclose(row, expected, rtol=1e-9)


def test_an_irrational_case_is_no_problem_here_but_a_rational_one_is() -> None:
    case = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=(0, "1.5"))
    assert frequencies(case, region="sheet").unstable == 2


def test_what_the_kernel_does_not_take_is_refused_with_a_sentence() -> None:
    found = frequencies(PAIR, {"track.c": [0.1, 2.0]}, region="sheet")
    assert found.status.tolist() == ["ok", "refused"]
    assert "cuts leave their line" in found.reason[1]


@pytest.mark.parametrize(
    "problem",
    [
        Problem(BEAM, vehicles.train(vehicles.Mass(70), 3, 1), v="0.5"),
        Problem(tracks.String(T=1, m=1, k=1, c=1), vehicles.Mass(1), v="0.5"),
    ],
)
def test_other_problems_have_no_sheet(problem: Any) -> None:
    with pytest.raises(InputError, match="one or two masses"):
        frequencies(problem, region="sheet")
