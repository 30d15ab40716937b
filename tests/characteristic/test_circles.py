"""Receptances by circles: where two upper roots meet they are as tight as elsewhere."""

from fractions import Fraction

import numpy as np
from free_cases import BEAM

from mpsolve import Problem, vehicles
from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.floats import Receptance
from mpsolve.characteristic.free_receptance import FreeReceptance
from mpsolve.problem.family import family_of


def test_roots_of_one_side_may_meet_in_a_box() -> None:
    # at v = 0 the upper roots of P⁴/4 + s² + c s + 1 meet where s² + c s + 1 = 0, and near it all through a box
    family = family_of(Problem(BEAM, vehicles.Mass(1), v=0), {"track.k": (Fraction(0), Fraction(2))})
    receptance = FreeReceptance(family)
    unit = float(family.units[0])
    for k, q in ((1.0, 1e-2), (1.0, 0.3)):
        # four roots at equal angles: the two upper ones are as far from each other as from the lower ones
        found = receptance(Boxes(np.array([[q], [k / unit]]), np.array([[1e-3], [1e-3]])))
        assert found.good[0]
        truth = Receptance(family.guide((Fraction(k) / family.units[0],)))(np.array([1j * q]), [Fraction(0)])[0][0][0]
        assert abs(found.G.k[0, 0, 0, 0] - truth) <= found.G.e[0, 0, 0] + 1e-12
        assert found.G.e[0, 0, 0] < 1e-4 * abs(truth)


def test_a_double_upper_root_of_a_compressed_beam_is_no_obstacle() -> None:
    # P⁴/4 + N P² + 1 at rest, q = 0: the roots of one side meet at N = −1
    track = BEAM
    family = family_of(Problem(track, vehicles.Mass(1), v=0), {"track.N": (Fraction(-2), Fraction(0))})
    unit = float(family.units[0])
    found = FreeReceptance(family)(Boxes(np.array([[0.0], [-1.0 / unit]]), np.array([[2e-3], [2e-3]])))
    assert found.good[0]
    assert found.G.e[0, 0, 0] < 1e-3 * abs(found.G.k[0, 0, 0, 0])
    # 1/D at rest with the double roots ±√2: ∫ dp/(2π)/((p²/2 + 1)²) = √2/4, in the scales of the family
    scaled = float(family.base.guide.g)
    assert np.isclose(found.G.k[0, 0, 0, 0].real * scaled, np.sqrt(2) / 4, rtol=1e-5)
