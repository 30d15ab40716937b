"""The bordered matrix next to a branch point vanishes where the plain one does, and is sharper."""

from fractions import Fraction

import numpy as np

from mpsolve import Case
from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.loci.near_cuts import NearCuts, _paired
from mpsolve.loci.tube import tubes
from mpsolve.problem.cases import as_problem
from mpsolve.problem.family import family_of

FAMILY = family_of(
    as_problem(Case(alpha="0.6", eta_b=0, eta_m=(40, 40), positions=(0, "0.5"))),
    {"v": (Fraction(1, 2), Fraction(9, 10))},
)


def _determinants(matrix: FreeMatrix, q: complex, x: float) -> complex:
    boxes = Boxes(np.array([[q], [x]], complex), np.full((2, 1), 1e-12, complex))
    A, G = matrix(boxes)
    assert G.good.all()
    return complex(np.linalg.det(A.a[0]))


def test_both_vanish_at_the_same_root() -> None:
    x, start, size = np.array([0.7]), np.array([0.375 + 0j]), np.array([0.006])
    found = tubes(NearCuts(FAMILY), x, x, start, size)
    assert found.good.all()
    root = complex(found.near[0][0])
    for matrix in (NearCuts(FAMILY), FreeMatrix(FAMILY)):
        here, off = (abs(_determinants(matrix, root + step, 0.7)) for step in (0.0, 1e-3))
        assert here < 1e-2 * off


def test_far_off_it_is_the_plain_one() -> None:
    plain, own = (_determinants(matrix, 0.05 - 0.4j, 0.6) for matrix in (FreeMatrix(FAMILY), NearCuts(FAMILY)))
    assert plain == own


def test_tubes_are_wider_next_to_the_branch_point() -> None:
    """q_lm = 0.39 at 0.7."""
    size = 2.0 ** -np.arange(5.0, 14.0)
    x, q = np.full(9, 0.7), np.full(9, 0.385 + 0j)
    good = []
    for matrix in (FreeMatrix(FAMILY), NearCuts(FAMILY)):
        A, G = matrix(Boxes(np.stack([q, x + 0j]), np.stack([size, 0 * size + 1e-6]).astype(complex)))
        good.append(np.nanmin(np.where(G.good[:, None, None], A.e, np.inf).max((1, 2)) / np.abs(A.a).max((1, 2))))
    assert good[1] < good[0]


def test_pairs_are_those_that_meet() -> None:
    z = np.array([[-1 + 1j, -0.1 + 2j, 0.1 + 2j, 1 + 1j], [-0.1 + 2j, -1 + 1j, 0.1 + 2j, 1 + 1j], [-1, -2, 3, 4]])
    found, near = _paired(z + 0j)
    assert near.tolist() == [True, True, False]
    assert (np.abs(found[:2, :2] - found[:2, 2:]).min(1) < 0.3).all()
