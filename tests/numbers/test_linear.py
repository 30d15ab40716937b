"""The kernel of an exact matrix, against matrices whose kernels are known by construction."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve.numbers.linear import completed, kernel, solved

ROWS = [[Fraction(x) for x in row] for row in ([1, 2, 3, 4], [2, 4, 6, 9], [3, 6, 9, 13])]


def test_the_kernel_is_all_that_is_mapped_to_nothing() -> None:
    found = kernel(ROWS, 4)
    assert len(found) == 2
    assert all(sum(a * b for a, b in zip(row, vector, strict=True)) == 0 for row in ROWS for vector in found)
    assert kernel([[Fraction(1), Fraction(0)], [Fraction(1), Fraction(1)]], 2) == []


@pytest.mark.parametrize("first", [[], [[1, 1, 0]], [[1, 1, 0], [0, 0, 2]]])
def test_a_basis_is_completed_by_what_is_missing(first: list[list[int]]) -> None:
    given = [[Fraction(x) for x in vector] for vector in first]
    units = [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]
    more = completed(given, units)
    assert len(more) == 3 - len(given)
    assert kernel([list(column) for column in zip(*given, *more, strict=True)], 3) == []


def test_a_system_is_solved() -> None:
    rows = [[Fraction(x) for x in row] for row in ([0, 2, 1], [1, 1, 0], [3, 0, 5])]
    x = [Fraction(1, 3), Fraction(-2), Fraction(7)]
    assert solved(rows, [sum((a * b for a, b in zip(row, x, strict=True)), Fraction(0)) for row in rows]) == x
