"""Receptances over boxes: by residues and by circles they are the same; where roots may meet circles are taken."""

from fractions import Fraction

import numpy as np
from free_cases import BEAM, pair_over_velocity, random_boxes

from mpsolve import Problem, vehicles
from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.circles import by_circles
from mpsolve.characteristic.free_receptance import FreeReceptance, may_meet
from mpsolve.problem.family import family_of


def test_residues_and_circles_agree_at_the_middles() -> None:
    family = pair_over_velocity("0.2", "0.7")
    receptance = FreeReceptance(family)
    boxes = random_boxes(family, 30, 1e-3)
    found = receptance(boxes)
    y, rho = boxes.variables
    forms, ahead, which = receptance.distances
    with np.errstate(all="ignore"):
        wave = receptance.track.split(boxes)
        xi = forms(y, rho)
        circled = by_circles(wave, receptance.track.N(y, rho), xi[:, ahead], True, True)
    both = found.good & wave.good & np.isfinite(circled.e).all(1)
    assert both.mean() > 0.7
    order = [np.flatnonzero(ahead).tolist().index(k) for k in (which[0, 0], which[1, 0])]
    for place, k in zip(((0, 0), (1, 0)), order, strict=True):
        one = found.G.k[:, both, place[0], place[1]]
        other = circled.k[:, both, k]
        allowed = found.G.e[both, place[0], place[1]] + circled.e[both, k]
        assert (np.abs(one[0] - other[0]) <= allowed).all()
        assert np.median(found.G.e[both, place[0], place[1]] / circled.e[both, k]) < 3


def test_circles_are_taken_where_roots_of_one_side_meet() -> None:
    family = family_of(Problem(BEAM, vehicles.Mass(1), v=0), {"track.N": (Fraction(-2), Fraction(0))})
    receptance = FreeReceptance(family)
    boxes = Boxes(np.array([[0.0], [-1.0 / float(family.units[0])]]), np.array([[2e-3], [2e-3]]))
    y, rho = boxes.variables
    z, _ = receptance.track.nodes(receptance.track.D(y, rho))
    assert may_meet(z, receptance.track.up).all()
    assert receptance(boxes).good.all()


def test_a_wave_that_has_died_away_is_no_obstacle() -> None:
    # far apart the waves turn by more than any model can follow, and are less than nothing
    family = family_of(
        Problem(BEAM, [vehicles.Mass(1).at(0), vehicles.Mass(1).at(400)], v="0.1"),
        {"gap[0]": (Fraction(300), Fraction(500))},
    )
    unit = float(family.units[0])
    found = FreeReceptance(family)(Boxes(np.array([[0.1], [400 / unit]]), np.array([[1e-3], [100 / unit]])))
    assert found.good.all()
    assert found.G.e[0, 0, 1] < 1e-20


def test_what_is_left_out_of_faint_waves_falls_with_the_box() -> None:
    # in a long train waves that are nearly dead decide: roots lie 1e-6 beside the axis
    family = family_of(
        Problem(BEAM, vehicles.train(vehicles.Mass(40), 12, "1.5"), v="0.5"),
        {"v": (Fraction("0.4"), Fraction("0.6"))},
    )
    receptance, middle = FreeReceptance(family), np.array([[0.2], [0.5 / float(family.units[0])]])
    wide, narrow = (receptance(Boxes(middle, np.full((2, 1), size))).G.e.max() for size in (4e-3, 5e-4))
    assert narrow < wide / 300
