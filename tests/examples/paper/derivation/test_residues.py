"""What sympy derives of the paper's kernel, against sums over p-roots in mpmath (`oracle`)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import mpmath
import pytest
import sympy as sp
from oracle import Truth

from mpsolve import Case
from paper.derivation import characteristic as derived_determinant
from paper.derivation import dispersion
from paper.derivation import residues as derived

BITS = 150
POINTS = [(0.3, -0.2), (0.3, 0.02), (-0.1, 0.4), (2, 3), (5, -1)]
CASE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 12), positions=(0, "1.5"), eta_n="0.3", eta_s="0.1")


class At:
    """The p-roots at one q."""

    def __init__(self, point: tuple[float, float]) -> None:
        self.truth = Truth(CASE, 45)
        self.q = self.truth.mp.mpc(*point)
        self.upper, self.lower = self.truth.p_roots(self.q)

    def value(self, expression: Any) -> Any:
        """An expression of the derivation with these numbers put in; mpmath's own context is the one of sympy."""
        numbers = map(mpmath.mpmathify, (*self.upper, *self.lower))
        return sp.lambdify(derived.roots, expression, "mpmath")(*numbers)


def close(value: Any, truth: Any) -> bool:
    return bool(abs(mpmath.mpmathify(value) - mpmath.mpmathify(truth)) < mpmath.mpf(10) ** -36 * (1 + abs(truth)))


@pytest.fixture(autouse=True)
def _precision() -> Iterator[None]:
    """sympy's lambdified functions compute in mpmath's global context."""
    with mpmath.mp.workprec(BITS + 60):
        yield


@pytest.mark.parametrize("point", POINTS)
def test_the_p_roots_are_those_of_18(point: tuple[float, float]) -> None:
    at, p = At(point), mpmath.mpc("0.7", "-1.1")
    numbers = [mpmath.mpf(x) for x in ("0.67", "0.05", "0.3", "0.1")]
    product = mpmath.fprod(p - mpmath.mpmathify(x) for x in (*at.upper, *at.lower))
    assert close(product, dispersion().lambdify()(p, mpmath.mpmathify(at.q), *numbers))


def test_residues_add_up_to_nothing() -> None:
    at = At(POINTS[0])
    assert derived.weights_sum().rhs == 0
    assert close(at.value(derived.weights_sum().lhs), 0)
    one = derived.partial_fractions()
    assert close(at.value(one.lhs.subs(derived.p, 2)), at.value(one.rhs.subs(derived.p, 2)))


@pytest.mark.parametrize("point", POINTS)
def test_the_characteristic_function_is_26_over_pi_squared(point: tuple[float, float]) -> None:
    at, d = At(point), 1.5
    K = [[mpmath.mpmathify(at.truth.kernel(gap, at.q)) for gap in row] for row in ((0, -d), (d, 0))]
    masses = tuple(mpmath.mpf(x) for x in (70, 12))
    found = derived_determinant(2).lambdify()(mpmath.mpmathify(at.q), masses, K)
    assert close(found / mpmath.pi**2, at.truth.delta(at.q))
