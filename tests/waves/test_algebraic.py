"""Polynomials over √2: multiple roots exactly, places in balls."""

from __future__ import annotations

import pytest
from flint import fmpq_poly, fmpz_poly

from mpsolve.waves.algebraic import Algebraic, common, multiple_roots, places, real_roots, split

M = fmpq_poly([-2, 0, 1])
ROOT = Algebraic(fmpz_poly([-2, 0, 1]), 1)  # √2


def over(*coefficients: list[int]) -> list[fmpq_poly]:
    return [fmpq_poly(c) for c in coefficients]


def product(*factors: list[fmpq_poly]) -> list[fmpq_poly]:
    out = over([1])
    for factor in factors:
        new = over(*[[0]] * (len(out) + len(factor) - 1))
        for i, a in enumerate(out):
            for j, b in enumerate(factor):
                new[i + j] = (new[i + j] + a * b) % M
        out = new
    return out


MINUS_ROOT = over([0, -1], [1])  # p − √2
SQUARE = over([-2], [0], [1])  # p² − 2 = (p − √2)(p + √2)
COMPLEX = over([1], [0], [1])  # p² + 1


def test_the_roots_of_an_irreducible_polynomial_ascend() -> None:
    low, high = real_roots(ROOT.m, 100)
    assert low < 0 < high
    assert (high * high).contains(2)
    assert ROOT.ball(300).rel_accuracy_bits() > 280


def test_a_hidden_multiple_root_is_found_exactly() -> None:
    assert multiple_roots(product(MINUS_ROOT, SQUARE), M) == MINUS_ROOT
    assert multiple_roots(product(MINUS_ROOT, MINUS_ROOT, MINUS_ROOT, COMPLEX), M) == MINUS_ROOT
    assert multiple_roots(product(SQUARE, COMPLEX), M) == over([1])


def test_leading_zeros_of_the_field_do_not_count() -> None:
    assert multiple_roots([*product(MINUS_ROOT, SQUARE), M], M) == MINUS_ROOT


def test_common_roots_and_the_rest() -> None:
    assert common(SQUARE, MINUS_ROOT, M) == MINUS_ROOT
    assert split(product(SQUARE, COMPLEX), MINUS_ROOT, M)[0] == MINUS_ROOT
    assert split(SQUARE, over([0], [1]), M) == (over([1]), SQUARE)


def test_real_places_alone_are_given() -> None:
    found = places(product(SQUARE, COMPLEX), ROOT, 100)
    assert [float(x) for x in found] == pytest.approx([-(2**0.5), 2**0.5])
    assert places(COMPLEX, ROOT, 100) == []
    assert places(over([1]), ROOT, 100) == []
