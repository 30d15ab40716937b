"""The search about a branch point: it finds what Newton's method in balls enclosed, and nothing on other sheets."""

from __future__ import annotations

import pytest

from mpsolve import Case
from mpsolve.characteristic.proved import Proved
from mpsolve.problem.cases import as_problem
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.enclose import enclose
from mpsolve.spectrum.near_roots import near_branch_points
from mpsolve.spectrum.sheet import count_sheet


@pytest.mark.parametrize(
    ("alpha", "eta", "mass", "number"), [("0.5", "0.01", "1e-5", 1), ("0.5", 0, "1e-6", 1), ("0.67", "0.05", "70", 0)]
)
def test_each_is_next_to_a_root(alpha: str, eta: object, mass: str, number: int) -> None:
    reduced = reduce_problem(as_problem(Case(alpha=alpha, eta_b=eta, eta_m=[mass], positions=[0])))
    line = on_line(reduced)
    assert line is not None
    count = count_sheet(line, Effort(evaluations=100_000))
    found = near_branch_points(count)
    assert len(found) == number
    for sigma in found:
        ball = enclose(Proved(reduced), sigma, 20)
        away = abs(complex(ball.q.mid()) * 1j / float(reduced.frequency_unit) - complex(sigma))
        assert away < 1e-15
