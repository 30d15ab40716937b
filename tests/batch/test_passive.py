"""The corner of the count: passive from there on, by eigenvalues on a finer grid; and when there is none."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import groups_of
from mpsolve.batch.kernel import receptances
from mpsolve.batch.passive import first_passive, outrun

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
# the receptance of this one has a branch point next to the axis, with a window between 0.87 and 0.88 (scaled)
SLAB = tracks.Slab(EI="8.52e6", m="57.1", k_pad="5.16e7", EI_slab="5.52e7", m_slab=823, k="1.97e8", c_pad="87.4", c=0)


def least(problem: Problem, q: np.ndarray) -> np.ndarray:
    ((group,), _) = groups_of(entries_of(problem, {}), np.arange(1))
    V = 1j * q[:, None, None] * receptances(group, np.zeros(len(q), int), 1j * q).G
    values = np.linalg.eigvalsh(V + V.conj().swapaxes(1, 2))
    return np.asarray(values[:, 0] / np.abs(values).max(1))


@pytest.mark.parametrize(
    "problem",
    [
        Problem(BEAM, vehicles.train(vehicles.Mass(40), 2, "1.5"), v="0.8"),
        Problem(BEAM, vehicles.train(vehicles.Mass(40), 8, "0.6"), v="1.3"),
        Problem(SLAB, [vehicles.Mass(57).at(0), vehicles.Mass(82).at("5.06")], v=795),
    ],
)
def test_passive_from_the_corner_on_and_not_below(problem: Problem) -> None:
    ((group,), _) = groups_of(entries_of(problem, {}), np.arange(1))
    rho = float(first_passive(group)[0])
    beyond = np.concatenate([rho * np.linspace(1, 1.1, 2000), rho * np.geomspace(1, 30, 500)])
    assert (least(problem, beyond) > -1e-12).all()
    assert (least(problem, rho * np.linspace(0.5, 1, 2000)) < 0).any()


def test_equal_contacts_are_looked_at_once_for_all_vehicles() -> None:
    problem = Problem(BEAM, vehicles.train(vehicles.Mass(40), 3, 1), v="0.8")
    ((group,), _) = groups_of(entries_of(problem, {"vehicles.M": [1, 20, 300]}), np.arange(3))
    rho = first_passive(group)
    assert (rho == rho[0]).all()


def test_contacts_that_run_ahead_of_all_waves() -> None:
    wire = tracks.String(T=1, m=1, k=1, c=1)
    pair = vehicles.train(vehicles.Oscillator(wheel=1, body=2, k=1, c=0), 2, 1)
    bogie = vehicles.Bogie(wheel=1, frame=1, inertia=1, wheelbase=1, k=1, c=1)
    for v, formation, expected in ((2, pair, True), (0.5, pair, False), (2, bogie, False)):
        ((group,), _) = groups_of(entries_of(Problem(wire, formation, v=v), {}), np.arange(1))
        assert outrun(group) is expected
