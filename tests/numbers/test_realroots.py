"""Signs on the half-line against polynomials that are made from their roots."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq_poly
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.numbers.realroots import as_fmpq, is_positive, negative_point, positive_roots, samples, sign_at

roots = st.lists(st.tuples(st.fractions(-4, 4, max_denominator=60), st.integers(1, 3)), max_size=4)


def from_roots(values: list[tuple[Fraction, int]]) -> fmpq_poly:
    f = fmpq_poly([1])
    for root, power in values:
        f *= fmpq_poly([-as_fmpq(root), 1]) ** power
    return f


@given(roots, st.booleans())
def test_roots_and_signs_are_those_it_was_made_from(values: list[tuple[Fraction, int]], pair: bool) -> None:
    f = from_roots(values) * (fmpq_poly([1, -1, 1]) if pair else 1)  # y² − y + 1 has no real root
    powers: dict[Fraction, int] = {}
    for root, power in values:
        powers[root] = powers.get(root, 0) + power
    expected = sorted((root, power) for root, power in powers.items() if root > 0)
    found = positive_roots(f)
    assert [power for _, power in found] == [power for _, power in expected]
    assert all((ball - as_fmpq(root)).contains(0) for (ball, _), (root, _) in zip(found, expected, strict=True))
    points, edges = samples(f), [Fraction(0), *(root for root, _ in expected), None]
    assert len(points) == len(edges) - 1
    for low, point, high in zip(edges, points, edges[1:], strict=False):
        assert low < point
        assert high is None or point < high
    odd = any(power % 2 for _, power in expected)
    assert is_positive(f) == (not expected and sign_at(f, Fraction(0)) > 0)
    assert (negative_point(f) is None) == (not odd)  # the leading coefficient is 1
    if odd:
        assert sign_at(f, negative_point(f)) < 0


@pytest.mark.parametrize("gap", [1, Fraction(1, 10**30), Fraction(1, 10**80)])
def test_roots_close_together_are_told_apart(gap: Fraction) -> None:
    near = from_roots([(Fraction(1), 1), (1 + Fraction(gap), 1)])
    assert len(positive_roots(near)) == 2
    assert negative_point(near) is not None
    assert negative_point(near + fmpq_poly([as_fmpq(Fraction(gap) ** 2)])) is None
