"""Without damping and slower than its waves a beam lets no passive vehicle grow; faster, some do."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest
from forging import as_file

from mpsolve import Case, Problem, Status, certify, tracks, vehicles
from mpsolve.certificate import verify2
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.lossless import PASSIVE, none_unstable, passive_everywhere
from mpsolve.spectrum.regions import HalfPlane

PAPER: dict[str, Any] = {"EI": "1/4", "m": 1, "k": 1}
BOGIE = vehicles.Bogie(wheel=2, frame=5, inertia=3, wheelbase=1, k=4, c="0.5", k_contact=30)


def line(v: object, c: object = 0, N: object = 0) -> Any:
    return on_line(reduce_problem(Problem(tracks.EulerBernoulli(**PAPER, c=c, N=N), vehicles.Mass(7), v=v)))


@pytest.mark.parametrize("N", ["0", "0.3", "-2"])
def test_up_to_the_velocity_of_the_paper_and_no_further(N: str) -> None:
    """The bracket EI y² − (N + m v²) y + k is tangent to 0 where (N + v²)² = 1; here at v = √(1 − N)."""
    limit = np.sqrt(1 - float(N))
    assert passive_everywhere(line(repr(float(limit * (1 - 1e-12))), N=N))
    assert not passive_everywhere(line(repr(float(limit * (1 + 1e-12))), N=N))


def test_at_the_critical_velocity_itself_and_with_damping() -> None:
    assert passive_everywhere(line(1))
    assert not passive_everywhere(line("0.5", c="0.1"))  # its damping is not on this line: the count does that


def test_the_count_needs_no_path() -> None:
    count = none_unstable(line("0.5"))
    assert (count.region, count.total, count.paths, count.why, count.half) == (HalfPlane(), 0, (), PASSIVE, "passive")


@pytest.mark.parametrize("vehicle", [vehicles.Mass(70), BOGIE], ids=["mass", "bogie with dampers"])
def test_any_passive_vehicle(vehicle: Any) -> None:
    found = certify(Problem(tracks.EulerBernoulli(**PAPER), vehicle, v="0.99"), region="unstable", digits=15)
    assert (found.status, found.stable, found.closing, found.note) == (Status.PROVED, True, PASSIVE, "")


@pytest.mark.parametrize("alpha", ["1e-9", "0.99999999", "1"])
def test_where_the_whole_sheet_stays_open_stability_is_told(alpha: str) -> None:
    found = certify(Case(alpha=alpha, eta_b=0, eta_m=(10, 10), positions=(0, 1)), digits=15)
    assert (found.status, found.stable, found.region) == (Status.PROVED, True, HalfPlane())
    assert "left out" in found.note or alpha == "1"


@pytest.mark.parametrize("alpha", ["0.99", "0.9999", "0.999999"])
def test_next_to_where_the_cuts_join_a_pair_of_real_roots_is_enclosed(alpha: str) -> None:
    found = certify(Case(alpha=alpha, eta_b=0, eta_m=(10, 10), positions=(0, 1)), digits=15)
    assert (found.status, found.count, found.unstable, found.note) == (Status.PROVED, 2, 0, "")
    assert all(root.q.imag == 0 for root in found.roots)


@pytest.mark.parametrize("alpha", ["1.01", "1.05"])
def test_faster_the_roots_of_both_halves_are_mirrors(alpha: str) -> None:
    found = certify(Case(alpha=alpha, eta_b=0, eta_m=(10, 10), positions=(0, 1)), region="sheet", digits=15)
    assert (found.status, found.count, found.unstable) == (Status.PROVED, 4, 2)
    q = {complex(root.q.mid()) for root in found.roots}
    assert {z.conjugate() for z in q} == q == {-z for z in q}


def forged(content: dict[str, Any]) -> verify2.Verdict:
    return verify2.verify_bytes(as_file(content))


def test_the_verifier_takes_it_for_no_other_problem() -> None:
    found = certify(Problem(tracks.EulerBernoulli(**PAPER), vehicles.Mass(70), v="0.9"), region="unstable", digits=15)
    content = found.certificate.content
    assert forged(copy.deepcopy(content)).valid
    faster = copy.deepcopy(content)
    faster["equations"]["velocity"] = "1001/1000"
    assert "not undamped and passive" in forged(faster).reason
    damped = copy.deepcopy(content)
    damped["equations"]["track"]["matrix"][0][0].append([0, 1, "1/10"])
    assert not forged(damped).valid
    other = copy.deepcopy(content)
    other["claim"]["region"] = {"kind": "sheet"}
    assert not forged(other).valid
