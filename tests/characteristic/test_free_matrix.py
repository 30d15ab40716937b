"""The matrix of a family over boxes holds that of the problem at each of their points, of every kind of parameter."""

from fractions import Fraction

import numpy as np
import pytest
from free_cases import BEAM, BOGIE, RAIL, inside, of_many, pair_over_velocity, random_boxes

from mpsolve import Problem, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.numbers.quadratic import pairs
from mpsolve.problem.family import Family, family_of


def sprung() -> Family:
    over = {"v": (Fraction(10), Fraction(300)), "vehicles[0].k": (Fraction(10**6), Fraction(10**7))}
    return family_of(Problem(RAIL, BOGIE, v=100), over)


def masses() -> Family:
    three = [vehicles.Mass(40).at(0), vehicles.Mass(30).at("1.5"), vehicles.Mass(40).at("3.1")]
    over = {"scale.mass": (Fraction(0), Fraction(2)), "track.N": (Fraction(-1), Fraction(1, 2))}
    return family_of(Problem(BEAM, three, v="0.6"), over)


FAMILIES = {"pair": pair_over_velocity, "many": of_many, "sprung": sprung, "masses": masses}


@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize("share", [0.0, 1e-3, 1e-2])
def test_points_of_boxes_are_inside(name: str, share: float) -> None:
    family = FAMILIES[name]()
    boxes = random_boxes(family, 40, share)
    A, G = FreeMatrix(family)(boxes)
    assert G.good.sum() > (25 if share < 1e-2 else 10 if name != "many" else -1)  # contacts that are far apart
    for n in np.flatnonzero(G.good)[:20]:
        u, q, x = inside(boxes, int(n))
        truth = Floats(family.reduced(x)).matrices(np.array([1j * q]))[0][0]
        weights = np.array([1.0, *u, *(u[i] * u[j] for i, j in pairs(A.m))])
        value = np.tensordot(weights, A.k[:, n], 1)
        assert (np.abs(value - truth) <= A.e[n] + 1e-10 * np.abs(truth).max()).all()


def test_small_boxes_are_tight() -> None:
    family = pair_over_velocity("0.2", "0.6")
    A, G = FreeMatrix(family)(random_boxes(family, 100, 1e-3))
    width = (A.e / np.abs(A.a).max((1, 2))[:, None, None]).max((1, 2))
    assert np.median(width[G.good]) < 1e-3
