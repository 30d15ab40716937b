"""Groups of one problem each, and points of the plane, that tests of batches share."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import Group, groups_of

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1", eta="0.02")
TWO_LAYER = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
BOGIE = vehicles.Bogie(wheel=900, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="1e4", k_contact="1e9")
COACH = vehicles.Coach(body=30000, inertia="1e6", bogie=BOGIE, pivots=17, k2="0.4e6", c2="2e4")
PROBLEMS = {
    "masses, two at one place": Problem(TWO_LAYER, [vehicles.Mass(900).at(x) for x in (0, "2.5", "2.5", 9)], v=100),
    "equal gaps": Problem(BEAM, vehicles.train(vehicles.Mass(40), 6, "1.5"), v="0.8"),
    "coach": Problem(TWO_LAYER, COACH, v=300),
    "at rest": Problem(BEAM, vehicles.train(vehicles.Oscillator(wheel=3, body=5, k=2, c=1), 2, 2), v=0),
}


def group_of(problem: Problem) -> Group:
    ((group,), _) = groups_of(entries_of(problem, {}), np.arange(1))
    return group


def points(n: int = 30) -> Any:
    rng = np.random.default_rng(1)
    return rng.uniform(0.01, 3, n) + 1j * rng.uniform(0, 3, n)
