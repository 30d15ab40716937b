"""Slopes of roots in parameters: against difference quotients of certified roots, and against identities."""

from fractions import Fraction

import numpy as np
import pytest
from free_cases import BEAM, BOGIE, PAIR, RAIL

from mpsolve import Problem, certify
from mpsolve.outcome import Status
from mpsolve.ranges.sensitivity import sensitivity

PROBLEM = Problem(BEAM, PAIR, v="0.9")


@pytest.mark.parametrize("path", ["v", "track.k", "track.c", "track.N", "vehicles[1].M", "gap[0]", "scale.mass"])
def test_slopes_are_those_of_difference_quotients(path: str) -> None:
    found = sensitivity(PROBLEM, region="unstable", digits=20)
    assert found.status is Status.PROVED
    step = Fraction(1, 10**6)
    value = PROBLEM.parameters[path]
    ends = [certify(PROBLEM.changed(path, value + s * step), region="unstable", check=False) for s in (1, -1)]
    for k, root in enumerate(found.roots):
        q = [complex(end.roots[k].q.mid()) for end in ends]
        assert np.isclose(complex(root.by[path].mid()), (q[0] - q[1]) / (2e-6), rtol=1e-5)
        assert float(root.by[path].real.rad()) < 1e-10


def test_all_parameters_of_a_bogie_have_slopes() -> None:
    problem = Problem(RAIL, BOGIE, v=350)
    found = sensitivity(problem, region="unstable")
    assert not found.left_out
    for root in found.roots:
        assert set(root.by) == set(problem.parameters)
        masses = [path for path in root.by if path.split(".")[-1] in ("wheel", "frame", "inertia", "body")]
        whole = sum(root.by[path] * float(problem.parameters[path]) for path in masses)
        assert np.isclose(complex(whole.mid()), complex(root.by["scale.mass"].mid()), rtol=1e-9)
