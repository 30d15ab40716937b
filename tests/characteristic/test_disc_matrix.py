"""The characteristic matrix on discs: entries hold the truth, and its determinant is Δ̂ up to a constant."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from receptance_truth import Receptance
from track_models import DAMPED
from vehicle_models import TYPICAL, random_vehicles

from mpsolve import vehicles
from mpsolve.characteristic.bordering import direct_contacts
from mpsolve.characteristic.disc_matrix import Arrays, _polynomials
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem

BEAM = DAMPED["euler-bernoulli"]
PLACED = {
    "masses": [vehicles.Mass(900), vehicles.Mass(400).at("2.5")],
    "one place": [vehicles.Mass(900), vehicles.Oscillator(wheel=900, body=5000, k="1e6", c=10)],
    "mixed": [vehicles.Mass(900).at(-3), TYPICAL["oscillator"], TYPICAL["bogie"].at(9)],
    "tight bogie": vehicles.Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.56", k="2.4e6", c="8e3"),
    "by matrices": TYPICAL["matrices"],
}


def pencil(reduced: Reduced, truth: Receptance, sigma: Any) -> list[list[Any]]:
    return [
        [
            sum((truth.number(reduced.S[k][i][j]) * sigma**k for k in range(3)), truth.mp.mpc(0))
            for j in range(reduced.bodies)
        ]
        for i in range(reduced.bodies)
    ]


def kernels(reduced: Reduced, truth: Receptance, sigma: Any) -> list[list[Any]]:
    places = [reduced.places[k] for k in reduced.index]
    values = {x - y: truth.value(x - y, sigma) for x in places for y in places}
    return [[values[x - y] for y in places] for x in places]


def full(reduced: Reduced, truth: Receptance, sigma: Any) -> Any:
    """Δ̂ of the reduced problem, by its definition."""
    S, G, n, c = pencil(reduced, truth, sigma), kernels(reduced, truth, sigma), reduced.bodies, reduced.contacts
    B = [[truth.number(x) for x in row] for row in reduced.B]
    rows = [[*S[i], *(-x for x in B[i])] for i in range(n)]
    rows += [
        [*(B[i][j] for i in range(n)), *(G[j][k] + (truth.number(reduced.h[j]) if j == k else 0) for k in range(c))]
        for j in range(c)
    ]
    return truth.mp.det(truth.mp.matrix(rows))


def value(arrays: Arrays, m: complex, r: float, up: int) -> Any:
    """The matrix as jets, its splitting and receptances proved."""
    _, G, good = arrays.evaluate(np.array([m]), np.array([r]), up)
    assert good.all()
    return arrays.matrix(G, np.array([m]))


def ratio(reduced: Reduced, truth: Receptance, arrays: Arrays, m: complex, up: int) -> complex:
    A = value(arrays, m, 0.0, up)
    return complex(truth.mp.det(truth.mp.matrix(A.a[0].tolist())) / full(reduced, truth, truth.mp.mpc(m)))


@pytest.mark.parametrize("name", PLACED)
def test_the_determinant_is_a_constant_times_the_full_one(name: str) -> None:
    reduced = reduce_problem(Problem(BEAM, PLACED[name], v=40))
    arrays, truth = Arrays(reduced), Receptance(reduced.guide, 30)
    found = [ratio(reduced, truth, arrays, m, 2) for m in (1 + 0.3j, 0.4 + 2j, 2.5 - 1j)]
    size = np.prod([float(abs(d.b)) for d in direct_contacts(reduced)])
    assert abs(found[0]) == pytest.approx(1 / size, rel=1e-8)
    assert found == pytest.approx([found[0]] * 3, rel=1e-8)


@settings(max_examples=10)
@given(random_vehicles())
def test_the_same_for_any_vehicle(vehicle: vehicles.AnyVehicle) -> None:
    reduced = reduce_problem(Problem(BEAM, [vehicle, vehicles.Mass(10).at(50)], v=10))
    arrays, truth = Arrays(reduced), Receptance(reduced.guide, 30)
    found = [ratio(reduced, truth, arrays, m, 2) for m in (1 + 0.3j, 0.4 + 2j)]
    assert found[0] == pytest.approx(found[1], rel=1e-6)


def test_entries_hold_the_truth_over_a_disc_and_are_not_wide() -> None:
    reduced = reduce_problem(Problem(BEAM, PLACED["mixed"], v=40))
    arrays, truth = Arrays(reduced), Receptance(reduced.guide, 40)
    m, r = 1 + 0.3j, 1e-2
    A = value(arrays, m, r, 2)
    direct = direct_contacts(reduced)
    gone = {d.body: d for d in direct}
    rest = [i for i in range(reduced.bodies) if i not in gone]
    indirect = [j for j in range(reduced.contacts) if j not in {d.contact for d in direct}]
    assert gone
    assert indirect
    for sigma in truth.rim(m, r, 4):
        S, G = pencil(reduced, truth, sigma), kernels(reduced, truth, sigma)
        B = [[truth.number(x) for x in row] for row in reduced.B]
        rows = [
            [S[i][k] for k in rest]
            + [
                -B[i][j] - sum(S[i][d.body] * G[d.contact][j] / truth.number(d.b) for d in gone.values())
                for j in range(reduced.contacts)
            ]
            for i in range(reduced.bodies)
        ]
        rows += [
            [B[k][i] for k in rest]
            + [G[i][j] + (truth.number(reduced.h[i]) if i == j else 0) for j in range(reduced.contacts)]
            for i in indirect
        ]
        for i, row in enumerate(rows):
            for j, entry in enumerate(row):
                off = abs(entry - truth.mp.mpc(A.a[0, i, j]) - truth.mp.mpc(A.b[0, i, j]) * (sigma - truth.mp.mpc(m)))
                assert off <= float(A.e[0, i, j]), (i, j)
    scale = np.abs(A.a[0]).max(1, keepdims=True)
    assert (A.e[0] <= 0.1 * scale).all()
    thin = value(arrays, m, 0.0, 2)
    assert (thin.e[0] <= 1e-9 * np.abs(thin.a[0]).max(1, keepdims=True)).all()


def test_the_pencil_holds_the_truth_where_masses_dominate() -> None:
    """The term in t² is the remainder: at the rim it is all used."""
    reduced = reduce_problem(Problem(BEAM, TYPICAL["bogie"], v=40))
    arrays, truth = Arrays(reduced), Receptance(reduced.guide, 40)
    m, r = np.array([0.5 + 1j]), np.array([0.7])
    rows = [tuple(each[i][j] for each in reduced.S) for i in range(reduced.bodies) for j in range(reduced.bodies)]
    S = _polynomials(arrays._table(rows), m, r)
    for sigma in truth.rim(m[0], 0.7, 8):
        for n, x in enumerate(np.ravel(pencil(reduced, truth, sigma))):
            a, b = truth.mp.mpc(S.a[0, n]), truth.mp.mpc(S.b[0, n])
            off = abs(x - a - b * (sigma - truth.mp.mpc(m[0])))
            assert off <= float(S.e[0, n])
            second = abs(float(rows[n][2])) * 0.49
            assert S.e[0, n] <= second * (1 + 1e-9) + 1e-13 * (1 + abs(complex(x)))


def test_the_receptance_between_places_is_that_of_their_signed_distance() -> None:
    reduced = reduce_problem(Problem(BEAM, PLACED["masses"], v=40))
    truth = Receptance(reduced.guide, 30)
    _, G, _ = Arrays(reduced).evaluate(np.array([1 + 0.3j]), np.zeros(1), 2)
    for i, a in enumerate(reduced.places):
        for j, b in enumerate(reduced.places):
            assert abs(complex(truth.value(Fraction(a - b), 1 + 0.3j)) - G.a[0, i, j]) <= G.e[0, i, j] + 1e-15
    assert abs(G.a[0, 0, 1] - G.a[0, 1, 0]) > 1e-3
