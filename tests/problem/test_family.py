"""A family at a point is the problem there: the same characteristic function, from polynomials in the parameters."""

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.errors import InputError
from mpsolve.problem.family import Family, family_of
from mpsolve.problem.reduced import Reduced, reduce_problem

LAYERS = {"k_pad": "300e6", "c_pad": "3e4", "m_sleeper": "250", "k_ballast": "100e6", "c_ballast": "8e4"}
TRACK = tracks.TwoLayer(EI="6.38e6", m="60.2", **LAYERS)
BOGIE = vehicles.Bogie(wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250, k_contact="1e9")
PROBLEM = Problem(TRACK, [BOGIE.at(0), vehicles.Mass(900).at("8.5")], v=600)
WIDE = {
    "v": (Fraction(10), Fraction(1000)),
    "track.k_ballast": (Fraction(50 * 10**6), Fraction(150 * 10**6)),
    "vehicles[0].k": (Fraction(10**6), Fraction(10**7)),
    "vehicles[0].wheelbase": (Fraction(2), Fraction(3)),
    "gap[0]": (Fraction(8), Fraction(9)),
    "vehicles[0].k_contact": (Fraction(10**8), Fraction(10**10)),
    "scale.mass": (Fraction(0), Fraction(2)),
}


def point(family: Family, share: Fraction) -> tuple[Fraction, ...]:
    return tuple(a + (b - a) * share for a, b in family.box)


def delta(reduced: Reduced, q: np.ndarray) -> np.ndarray:
    return Floats(reduced).delta(1j * q / float(reduced.frequency_unit))[0]


@pytest.mark.parametrize("share", [Fraction(1, 3), Fraction(1), Fraction(9, 10)])
def test_delta_at_a_point_is_that_of_the_problem_up_to_a_constant(share: Fraction) -> None:
    family = family_of(PROBLEM, WIDE)
    x = point(family, share)
    q = np.array([20 + 3j, 300 - 5j, 900 + 1j, 2000 + 0j])
    ratio = delta(family.reduced(x), q) / delta(reduce_problem(family.at(x)), q)
    assert np.allclose(ratio, ratio[0], rtol=1e-9)
    values = [a + (b - a) * share for a, b in WIDE.values()]
    assert [family.at(x).parameters[path] for path in WIDE][:-1] == values[:-1]  # a factor is 1 again


def test_the_polynomials_are_those_of_the_track() -> None:
    family = family_of(PROBLEM, {"v": (Fraction(0), Fraction(700)), "track.c_pad": (Fraction(0), Fraction(10**5))})
    x = point(family, Fraction(1, 2))
    assert family.guide(x).D == reduce_problem(family.at(x)).guide.D
    assert family.guide(x).N == reduce_problem(family.at(x)).guide.N
    assert family.guide(point(family, Fraction(0))).v == 0


def test_a_neutral_mode_stays_divided_out() -> None:
    loose = Problem(TRACK, vehicles.Oscillator(wheel=900, body=5000, k=0, c=20000), v=600)
    family = family_of(
        loose, {"scale.mass": (Fraction(1, 2), Fraction(2)), "vehicles[0].c": (Fraction(1), Fraction(9))}
    )
    x, q = point(family, Fraction(1, 4)), np.array([20 + 3j, 300 - 5j])
    ratio = delta(family.reduced(x), q) / delta(reduce_problem(family.at(x)), q)
    assert np.allclose(ratio, ratio[0], rtol=1e-9)


@pytest.mark.parametrize(
    ("over", "said"),
    [
        ({"track.kk": (Fraction(1), Fraction(2))}, "track.kk"),
        ({"v": (Fraction(-1), Fraction(2))}, "below 0"),
        ({"gap[0]": (Fraction(1), Fraction(9))}, "overtake"),
        ({"track.k_pad": (Fraction(-1), Fraction(9))}, "k_pad"),
        ({"vehicles[0].k_contact": (Fraction(0), Fraction(10**9))}, "begins at 0"),
    ],
)
def test_what_cannot_be_is_refused(over: dict[str, tuple[Fraction, Fraction]], said: str) -> None:
    with pytest.raises(InputError, match=said):
        family_of(PROBLEM, over)


def test_a_range_that_a_later_parameter_sets_again_is_refused() -> None:
    pair = Problem(TRACK, vehicles.train(vehicles.Mass(900), 2, "2.5"), v=600)
    one = {"vehicles[0].M": (Fraction(100), Fraction(1000))}
    both = {"vehicles.M": (Fraction(100), Fraction(200))}
    with pytest.raises(InputError, match=r"vehicles\[0\].M: moves nothing"):
        family_of(pair, one | both)
    family = family_of(pair, both | one)
    assert [placed.vehicle.M for placed in family.at([x for _, x in family.box]).vehicles] == [1000, 200]
    assert family_of(pair, {"scale.mass": (Fraction(1), Fraction(2))} | both).felt == (False, False)
