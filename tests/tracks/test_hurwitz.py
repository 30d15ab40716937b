"""Hurwitz's determinants against the roots themselves."""

from __future__ import annotations

import numpy as np
from flint import fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.tracks.hurwitz import hurwitz_minors, is_stable

ROOTS = st.lists(st.sampled_from([-3, -2, -1, 1, 2]), min_size=1, max_size=4)


@given(ROOTS)
def test_the_signs_tell_on_which_side_the_roots_lie(roots: list[int]) -> None:
    coefficients = np.poly(roots)[::-1].astype(int).tolist()
    minors, n = hurwitz_minors(coefficients), len(roots)
    assert all(minor > 0 for minor in minors) == all(root < 0 for root in roots)
    index = n - 2 * (np.arange(n)[None, :] + 1) + np.arange(n)[:, None] + 1
    matrix = np.where((index >= 0) & (index <= n), np.take(coefficients, np.clip(index, 0, n)), 0)
    for k, minor in enumerate(minors, 1):
        assert minor == round(np.linalg.det(matrix[:k, :k]))


def test_over_all_wavenumbers() -> None:
    """s² + (c + y) s + (y − 1)² + k over y = p²."""

    def rows(c: int, k: str) -> list[fmpq_poly]:
        rest = fmpq_poly([1 + fmpq(*map(int, k.split("/"))), -2, 1])
        return [rest, fmpq_poly([c, 1]), fmpq_poly([1])]

    assert is_stable(rows(1, "1/9"))
    assert not is_stable(rows(1, "-1/9"))  # it buckles next to y = 1
    assert not is_stable(rows(-1, "1/9"))
