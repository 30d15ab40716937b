"""Unfelt and neutral motions planted into random vehicles are found, exactly: the determinants are one polynomial."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import pytest
from flint import fmpq, fmpq_mat
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mpsolve import vehicles
from mpsolve.vehicles.felt import Parts, split_felt
from mpsolve.vehicles.vehicle import Pencil, Rows

Matrix = list[list[Fraction]]
SMALL = st.integers(-3, 3).map(Fraction)


@dataclass(frozen=True)
class Planted:
    """A pencil in other coordinates than those in which its unfelt and neutral motions are plain to see."""

    pencil: Pencil
    neutral: int
    unfelt: int


def product(a: Matrix, b: Matrix) -> Matrix:
    return [[sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0)) for column in zip(*b, strict=True)]
            for row in a]  # fmt: skip


def transposed(a: Matrix) -> Matrix:
    return [list(row) for row in zip(*a, strict=True)]


def rows(a: Matrix) -> Rows:
    return tuple(map(tuple, a))


@st.composite
def semidefinite(draw: st.DrawFn, n: int) -> Matrix:
    rank = draw(st.integers(0, n))
    a = [[draw(SMALL) for _ in range(rank)] for _ in range(n)]
    return [[sum((x * y for x, y in zip(p, q, strict=True)), Fraction(0)) for q in a] for p in a]


def block(*parts: Matrix) -> Matrix:
    n = sum(map(len, parts))
    out, at = [[Fraction(0)] * n for _ in range(n)], 0
    for part in parts:
        for i, row in enumerate(part):
            out[at + i][at : at + len(row)] = row
        at += len(part)
    return out


@st.composite
def planted(draw: st.DrawFn) -> Planted:
    kept, neutral, unfelt, contacts = (draw(st.integers(*ends)) for ends in ((1, 3), (0, 1), (0, 2), (1, 2)))
    felt, n = kept + neutral, kept + neutral + unfelt
    M, C, K = (block(draw(semidefinite(felt)), draw(semidefinite(unfelt))) for _ in range(3))
    for i in range(kept, felt):  # nothing but a damper and a mass
        for j in range(felt):
            K[i][j] = K[j][i] = Fraction(0)
    B = [[draw(SMALL) if i < kept else Fraction(0) for _ in range(contacts)] for i in range(n)]
    change = [[draw(SMALL) for _ in range(n)] for _ in range(n)]
    assume(determinant(change) != 0)
    M, C, K = (product(product(transposed(change), a), change) for a in (M, C, K))
    H = [[M[i][j] + C[i][j] + K[i][j] for j in range(n)] for i in range(n)]
    assume(determinant(H) != 0)
    assume(all(any(row[j] for row in B) for j in range(contacts)))
    B = product(transposed(change), B)
    pencil = Pencil(
        rows(M), rows(C), rows(K), rows(B), tuple(map(Fraction, range(contacts))), (Fraction(0),) * contacts,
        ("",) * n,
    )  # fmt: skip
    return Planted(pencil, neutral, unfelt)


def determinant(a: Matrix) -> Fraction:
    if not a:
        return Fraction(1)
    value = fmpq_mat(len(a), len(a), [fmpq(x.numerator, x.denominator) for row in a for x in row]).det()
    return Fraction(int(value.p), int(value.q))


def pencil_at(M: Any, C: Any, K: Any, s: Fraction) -> Matrix:
    return [[k + c * s + m * s * s for m, c, k in zip(*three, strict=True)] for three in zip(M, C, K, strict=True)]


def bordered(S: Matrix, B: Any, G: Matrix) -> Fraction:
    """det [[S, −B], [Bᵀ, G]]."""
    top = [[*row, *(-x for x in B[i])] for i, row in enumerate(S)]
    low = [[*(B[i][j] for i in range(len(S))), *row] for j, row in enumerate(G)]
    return determinant(top + low)


def identity(pencil: Pencil, parts: Parts, G: Matrix, s: Fraction) -> tuple[Fraction, Fraction]:
    """(Δ, Δ̂ σ^neutral det S_u / det² of the basis) at σ = s with any G in place of the receptance."""
    whole = bordered(pencil_at(pencil.M, pencil.C, pencil.K, s), pencil.B, G)
    S = pencil_at(parts.M, parts.C, parts.K, s)
    for i in range(len(S) - parts.neutral, len(S)):
        S[i] = [x / s for x in S[i]]
    value = bordered(S, parts.B, G) * s**parts.neutral
    if parts.unfelt is not None:
        value *= determinant(pencil_at(*parts.unfelt, s))
    if parts.basis is not None:
        value /= determinant([list(row) for row in parts.basis]) ** 2
    return whole, value


@settings(max_examples=60)
@given(planted(), st.data())
def test_the_determinant_is_the_product_of_its_parts(case: Planted, data: st.DataObject) -> None:
    """At more points than its degree, with a random G each: the polynomials in σ are the same."""
    parts = split_felt(case.pencil)
    contacts = case.pencil.contacts
    for s in range(1, 2 * case.pencil.size + 3):
        G = [[data.draw(SMALL) for _ in range(contacts)] for _ in range(contacts)]
        whole, value = identity(case.pencil, parts, G, Fraction(s, 3))
        assert whole == value


@settings(max_examples=60)
@given(planted())
def test_what_was_planted_is_found_and_the_rest_is_clean(case: Planted) -> None:
    parts = split_felt(case.pencil)
    unfelt = len(parts.unfelt[0]) if parts.unfelt is not None else 0
    assert parts.neutral + unfelt >= case.unfelt + case.neutral or parts.neutral >= case.neutral
    assert unfelt >= case.unfelt
    assert len(parts.M) + unfelt == case.pencil.size
    for i in range(len(parts.M) - parts.neutral, len(parts.M)):
        assert not any(parts.K[i])
        assert not any(parts.B[i])
    again = split_felt(Pencil(
        parts.M, parts.C, parts.K, parts.B, case.pencil.places, case.pencil.h, ("",) * len(parts.M)
    ))  # fmt: skip
    assert again.unfelt is None
    assert again.neutral == parts.neutral
    if parts.basis is None:
        return
    Q = [list(row) for row in parts.basis]
    for old, new, rest in zip(
        (case.pencil.M, case.pencil.C, case.pencil.K),
        (parts.M, parts.C, parts.K),
        parts.unfelt or ((), (), ()),
        strict=True,
    ):
        whole = product(product(transposed(Q), [list(row) for row in old]), Q)
        assert whole == block([list(row) for row in new], [list(row) for row in rest])
    touch = product(transposed(Q), [list(row) for row in case.pencil.B])
    assert rows(touch[: len(parts.B)]) == parts.B
    assert not any(any(row) for row in touch[len(parts.B) :])


def test_two_equal_oscillators_on_one_wheel_hide_one_mode() -> None:
    vehicle = vehicles.Vehicle(
        M=[[5, 0, 0], [0, 1, 0], [0, 0, 1]],
        C=[[0, 0, 0], [0, 0, 0], [0, 0, 0]],
        K=[[6, -3, -3], [-3, 3, 0], [-3, 0, 3]],
        B=[[1], [0], [0]],
        places=[0],
    )
    parts = split_felt(vehicle.pencil)
    assert parts.unfelt is not None
    M, _, K = parts.unfelt
    assert K[0][0] / M[0][0] == 3
    assert parts.neutral == 0


def test_a_body_on_a_damper_alone_is_neutral() -> None:
    vehicle = vehicles.Vehicle(M=[[3, 0], [0, 5]], C=[[2, -2], [-2, 2]], K=[[0, 0], [0, 0]], B=[[1], [0]], places=[0])
    parts = split_felt(vehicle.pencil)
    assert parts.neutral == 1
    assert parts.unfelt is None
    assert identity(vehicle.pencil, parts, [[Fraction(7)]], Fraction(2, 5))[0] != 0


@pytest.mark.parametrize("places", [[0], [0, 1]])
def test_a_vehicle_that_is_felt_everywhere_is_left_as_it_is(places: list[int]) -> None:
    n = len(places)
    eye = [[int(i == j) for j in range(n)] for i in range(n)]
    vehicle = vehicles.Vehicle(M=eye, C=eye, K=eye, B=eye, places=places)
    assert split_felt(vehicle.pencil) == Parts(
        vehicle.pencil.M, vehicle.pencil.C, vehicle.pencil.K, vehicle.pencil.B, 0, None, None
    )
