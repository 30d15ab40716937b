"""What stands in which entry: the determinants with and without direct contacts, and their slopes."""

from fractions import Fraction
from typing import Any

import pytest
from multiprecision import Multiprecision
from residue import Residues
from track_models import DAMPED

from mpsolve import tracks, vehicles
from mpsolve.characteristic.bordering import Bordering, direct_contacts
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem

RAIL = DAMPED["euler-bernoulli"]
BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1", N="0.1")
BOGIE = vehicles.Bogie(wheel=18, frame=26, inertia=14, wheelbase="1.5", k=2, c="0.3", k_contact=15)


@pytest.mark.parametrize("mass", [Fraction(3), Fraction(900)])
def test_direct_contacts_are_taken_out(mass: Fraction) -> None:
    """The determinant changes by the constant ±Π b, its slope with it; a sprung wheel and a bogie's wheels remain."""
    reduced = reduce_problem(
        Problem(BEAM, [BOGIE.at(1), vehicles.Mass(mass).at(-1), vehicles.Mass(2).at("0.5")], "0.7")
    )
    whole, small = Bordering.of(reduced, eliminate=False), Bordering.of(reduced)
    K, truth = Multiprecision(60), Residues(reduced.guide, 60)
    factor = K.number(Fraction(1))
    for one in small.direct:
        factor *= K.number(one.b)
    assert len(small.direct) == 2
    for sigma in (0.5 + 0.25j, 0.125 - 1.5j):
        s, h = K.mp.mpmathify(sigma), K.mp.mpf(10) ** -15

        def det(border: Bordering, s: Any) -> Any:
            return K.det(border.at(K, s, [truth(x, s) for x in border.distances]))

        assert abs(abs(det(whole, s) / det(small, s) / factor) - 1) < 1e-40
        G, G_sigma = ([f(x, s) for x in small.distances] for f in (truth, truth.slope))
        A, A_sigma = small.at(K, s, G), small.slope_at(K, s, G, G_sigma)
        trace = K.solve(A, A_sigma)
        rate = sum(trace[i, i] for i in range(A.rows))
        change = (det(small, s + h) - det(small, s - h)) / (2 * h) / det(small, s)
        assert abs(rate / change - 1) < 1e-20


def test_direct_contacts_are_those_alone_on_their_body() -> None:
    loose = vehicles.Vehicle(
        M=[[1, 0], [0, 1]], C=[[0, 0], [0, 0]], K=[[0, 0], [0, 0]], B=[[1, 1, 0], [0, 0, 2]], places=[0, 1, 3]
    )
    found = direct_contacts(reduce_problem(Problem(RAIL, loose, v=1)))
    assert [(d.body, d.contact) for d in found] == [(1, 2)]
    sprung = vehicles.Oscillator(wheel=9, body=5, k=1, c=2, k_contact=7)
    assert not direct_contacts(reduce_problem(Problem(RAIL, sprung, v=1)))


def test_equal_entries_stand_once() -> None:
    """Of a row of equal masses at equal distances every diagonal is one entry."""
    masses = Bordering.of(reduce_problem(Problem(BEAM, vehicles.train(vehicles.Mass(3), 8, 1), "0.7")))
    assert len(masses.distances) == len({cell for row in masses.cells for cell in row}) == 15
    assert len(masses.polynomials) == 3  # 0, −S/b and −b


def test_waves_add_no_polynomial() -> None:
    reduced = reduce_problem(Problem(BEAM, [BOGIE.at(1), vehicles.Mass(3).at(-1)], "0.7"))
    one, two, three = (Bordering.of(reduced, waves=waves) for waves in (0, 1, 2))
    assert one.polynomials == two.polynomials == three.polynomials
    assert [len(border.cells) for border in (one, two, three)] == [7, 8, 9]
