"""Dual numbers carry the derivatives of a formula along every direction, over discs and over balls."""

from __future__ import annotations

from typing import Any

import flint
import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import grid, holds

from mpsolve.discs import Discs
from mpsolve.dual import Dual
from mpsolve.fields import ball_arithmetic

mp = mpmath.MPContext()
mp.dps = 50


def _exp(z: Any) -> Any:
    return mp.exp(z) if isinstance(z, (mp.mpf, mp.mpc)) else z.exp()


FORMULAS = {
    "sums": lambda x, y, c: 3 + x - y - (2 - x) + (y + c) - c + -x,
    "products": lambda x, y, c: x * y * 2 - c * x + y * c - 1j * (x * x * y),
    "quotients": lambda x, y, c: x / y + 1 / x - y / (x * x + c) + c / y - y / c + x / 3,
    "waves": lambda x, y, c: _exp(x * 1j) * y - _exp(y * c) / x,
}
formulas = pytest.mark.parametrize("formula", FORMULAS.values(), ids=FORMULAS)
numbers = st.builds(complex, grid(0.5, 2), grid(0.25, 1.5))
speeds = st.tuples(grid(-2, 2), grid(-2, 2))


def slope(formula: Any, x: complex, y: complex, c: complex, along: tuple[float, float]) -> Any:
    start = mp.mpc(x), mp.mpc(y)
    return mp.diff(lambda t: formula(start[0] + t * along[0], start[1] + t * along[1], mp.mpc(c)), mp.zero)


@formulas
@settings(max_examples=15)
@given(numbers, numbers, numbers, speeds, speeds)
def test_over_discs(formula: Any, x: complex, y: complex, c: complex, one: Any, two: Any) -> None:
    u, v, w = (Discs(np.array([z])) for z in (x, y, c))
    result = formula(Dual(u, [one[0], two[0]]), Dual(v, [one[1], two[1]]), w)
    assert len(result.slopes) == 2
    exact = formula(mp.mpc(x), mp.mpc(y), mp.mpc(c))
    for found, expected in zip(
        (result.value, *result.slopes), (exact, *(slope(formula, x, y, c, a) for a in (one, two))), strict=True
    ):
        middle, radius = (found.m[0], found.r[0]) if isinstance(found, Discs) else (complex(found), 1e-12)
        assert abs(mp.mpc(complex(middle)) - expected) <= mp.mpf(float(radius)) + mp.mpf(10) ** -20
        assert radius < 1e-9 * (1 + abs(complex(expected)))


@formulas
@settings(max_examples=10)
@given(numbers, numbers, numbers, speeds)
def test_over_balls(formula: Any, x: complex, y: complex, c: complex, one: Any) -> None:
    with ball_arithmetic(80):
        u, v, w = (flint.acb(z.real, z.imag) for z in (x, y, c))
        result = formula(Dual(u, [flint.acb(one[0])]), Dual(v, [flint.acb(one[1])]), w)
        assert holds(result.value, formula(mp.mpc(x), mp.mpc(y), mp.mpc(c)))
        wide = flint.acb(result.slopes[0]) + flint.acb(flint.arb(0, 1e-15), flint.arb(0, 1e-15))
        assert holds(wide, slope(formula, x, y, c, one))


def test_a_wide_disc_holds_the_slopes_of_all_its_points() -> None:
    """x ↦ e^{ix}/x about 1 + i/2."""
    x = Discs(np.array([1 + 0.5j]), np.array([0.05]))
    (found,) = ((Dual(x, [1]) * 1j).exp() / Dual(x, [1])).slopes
    for turn in np.exp(2j * np.pi * np.arange(9) / 9):
        z = mp.mpc(1, 0.5) + mp.mpc(complex(turn)) * 0.0499
        assert abs(mp.mpc(complex(found.m[0])) - mp.diff(lambda t: mp.expj(t) / t, z)) <= mp.mpf(float(found.r[0]))
    assert found.r[0] < 0.3


def test_arrays_and_discs_leave_the_operators_to_dual_numbers() -> None:
    x = Dual(Discs(np.array([2.0, 4.0])), [Discs(np.array([1.0, 1.0]))])
    array, other = np.array([1.0, 2.0]), Discs(np.array([1.0, 2.0]))
    for first, second in (
        (array + x, x + array),
        (array * x, x * array),
        (other + x, x + other),
        (other * x, x * other),
    ):
        assert isinstance(first, Dual)
        assert np.all(first.value.m == second.value.m)
    assert isinstance(other - x, Dual)
    assert np.allclose((other / x).value.m, [0.5, 0.5])
    assert np.allclose((array / x).slopes[0].m, [-1 / 4, -2 / 16])
