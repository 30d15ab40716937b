"""Slopes of roots in parameters: against difference quotients of certified roots, and against identities."""

from fractions import Fraction

import numpy as np
import pytest
from free_cases import BEAM, BOGIE, PAIR, RAIL
from oracle import Truth

from mpsolve import Case, Problem, certify
from mpsolve.outcome import Status
from mpsolve.ranges.sensitivity import sensitivity

PROBLEM = Problem(BEAM, PAIR, v="0.9")


@pytest.mark.parametrize("path", ["v", "track.k", "track.c", "track.N", "vehicles[1].M", "gap[0]", "scale.mass"])
def test_slopes_are_those_of_difference_quotients(path: str) -> None:
    found = sensitivity(PROBLEM, region="unstable", digits=20)
    assert (found.status, found.spectrum.status) == (Status.UNVERIFIED, Status.PROVED)  # slopes have no certificate
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


UNDAMPED = [("0.5", "1", ("40", "40"), 0), ("0.8", "1.5", ("70", "70"), 0), ("0.6", "2", ("30", "10"), "0.2")]


def _undamped(alpha: str, distance: str, eta_m: tuple[str, ...], eta_n: object, eta_b: object = 0) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=eta_m, positions=(0, distance), eta_n=eta_n)  # type: ignore[arg-type]


@pytest.mark.parametrize("values", UNDAMPED)
def test_what_a_little_damping_does_is_told_by_residue_sums(values: tuple[str, str, tuple[str, ...], object]) -> None:
    """dq/dη_b = 2 dq/dc of the undamped beam, against differences of the paper's Δ with complex damping."""
    case = _undamped(*values)
    found = sensitivity(case, digits=20)
    assert (found.status, found.spectrum.status) == (Status.UNVERIFIED, Status.PROVED)  # slopes have no certificate
    truth = Truth(case, 50)
    mp = truth.mp
    moved = [root for root in found.roots if root.q.real > 0]
    assert len(moved) == 2
    for root in moved:
        q, step = truth.middle(root.q), mp.mpf(10) ** -12

        def damped(eta_b: object, q: object = q) -> object:
            truth.eta_b = eta_b
            return truth.delta(q)

        along_damping = (damped(step) - damped(-step)) / (2 * step)  # type: ignore[operator]
        truth.eta_b = mp.mpf(0)
        along_q = (truth.delta(q + step) - truth.delta(q - step)) / (2 * step)
        rate = 2 * root.by["track.c"]
        assert abs(mp.im(-along_damping / along_q) - mp.mpf(rate.imag.mid().str(30, radius=False))) < 1e-14
        assert rate.real.contains(0)
        assert rate.rad() < 1e-13


def test_a_little_damping_destabilises_one_of_two_heavy_masses() -> None:
    found = sensitivity(_undamped(*UNDAMPED[1]), check=False)
    grows = [bool(root.by["track.c"].imag < 0) for root in found.roots if root.q.real > 0]
    assert grows == [False, True]
