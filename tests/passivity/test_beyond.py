"""Outside the rectangle the mobility is passive; where contacts outrun the track's waves there is no theorem."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.floats import Receptance
from mpsolve.characteristic.paths import Paths
from mpsolve.characteristic.start import start
from mpsolve.passivity.beyond import Beyond, plan_beyond
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.proof.effort import Effort

LAYERS = tracks.TwoLayer("6380430", "60.2", "300e6", "3e4", "250", "100e6", "8e4")
BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
WIRE = tracks.String(27000, "1.07", 500, 2)


def masses(track: object, v: object, places: list[object]) -> Reduced:
    return reduce_problem(Problem(track, [vehicles.Mass(1).at(x) for x in places], v=v))


def planned(reduced: Reduced, least: float = 0.0) -> Beyond | str:
    return plan_beyond(Paths(Arrays(reduced), start(reduced.guide)), Effort(evaluations=50_000), least)


def least_power(reduced: Reduced, q: np.ndarray) -> np.ndarray:
    """The least eigenvalue of V + V* at scaled q, by residue sums in floats."""
    distances = sorted({a - b for a in reduced.places for b in reduced.places})
    G = dict(zip(distances, Receptance(reduced.guide)(1j * q, distances, slope=False)[0], strict=True))
    V = np.array([[1j * q * G[a - b] for b in reduced.places] for a in reduced.places]).transpose(2, 0, 1)
    return np.linalg.eigvalsh(V + V.conj().transpose(0, 2, 1))[:, 0]


@pytest.mark.parametrize(
    ("track", "v", "places"),
    [(LAYERS, 680, [0, "2.5"]), (BEAM, "0.8", [0, "1.5", 3, "4.5"]), (WIRE, 100, [0, 10]), (BEAM, "1.3", [0])],
)
def test_no_power_is_given_outside_the_rectangle(track: object, v: object, places: list[object]) -> None:
    reduced = masses(track, v, places)
    found = planned(reduced)
    assert isinstance(found, Beyond)
    random = np.random.default_rng(7)
    far = found.rho * 10 ** random.uniform(0, 1.5, 300)
    points = np.concatenate(
        [far - 1j * random.uniform(0, 1, 300) * far, 1j * -found.depth * random.uniform(1, 9, 50)]
    )
    assert (least_power(reduced, points) > 0).all()
    assert found.walls.points[0] == found.rho
    assert found.walls.points[-1] == complex(0, -found.depth)
    assert found.axis.points[-1].real >= found.tail.X or found.rho >= found.tail.X


def test_the_rectangle_is_as_wide_as_asked() -> None:
    found = planned(masses(BEAM, "0.5", [0, "1.5"]), least=3.0)
    assert isinstance(found, Beyond)
    assert found.rho >= 3


def test_there_is_none_where_contacts_outrun_the_waves() -> None:
    found = planned(masses(WIRE, 200, [0, 10]))
    assert isinstance(found, str)
    assert "faster" in found or "overtake" in found, found
