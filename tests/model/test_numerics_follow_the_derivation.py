"""The numerics use what sympy derives: D, the resolvent form of K, and the characteristic determinant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import mpmath
import pytest

from mpsolve import Case
from mpsolve.derivation.paper import characteristic as derived_determinant
from mpsolve.derivation.paper import dispersion, kernel_resolvent
from mpsolve.fields import MP
from mpsolve.model.branch import Track, pairing, track
from mpsolve.model.characteristic import characteristic
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact

BITS = 150
FIELD = MP(BITS)
TINY = FIELD.context.mpf(2) ** (20 - BITS)
POINTS = [(0.3, -0.2), (0.3, 0.2), (-0.1, 0.4), (2, 3), (5, -1)]
CASE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 12), positions=(0, "1.5"), eta_n="0.3", eta_s="0.1")


def close(value: Any, truth: Any) -> bool:
    return bool(abs(value - truth) < TINY * (1 + abs(truth)))


@pytest.fixture(autouse=True)
def _precision() -> Iterator[None]:
    """sympy's lambdified functions compute in mpmath's global context."""
    with mpmath.mp.workprec(BITS + 60):
        yield


@pytest.fixture
def model() -> Track:
    return track(CASE, FIELD)


@pytest.mark.parametrize("point", POINTS)
def test_the_factors_are_those_of_18(model: Track, point: tuple[float, float]) -> None:
    """D of the derivation equals (p² − s p + t)(p² + s p + t') with the numerical s, h at any p."""
    q, p = FIELD.context.mpc(*point), FIELD.context.mpc("0.7", "-1.1")
    D = dispersion().lambdify()
    pair = pairing(model, q)
    t, t_below = (pair.y + pair.c2 + pair.h) / 2, (pair.y + pair.c2 - pair.h) / 2
    numbers = (model.alpha, model.eta_b, FIELD.number(CASE.eta_n), FIELD.number(CASE.eta_s))
    assert close((p * p - pair.s * p + t) * (p * p + pair.s * p + t_below), D(p, q, *numbers))


@pytest.mark.parametrize("point", POINTS)
def test_the_kernel_is_the_derived_one(model: Track, point: tuple[float, float]) -> None:
    q = FIELD.context.mpc(*point)
    pair, r = pairing(model, q), q - FIELD.i * model.eta_b
    ahead, behind = (formula.lambdify() for formula in kernel_resolvent())
    distance = FIELD.context.mpf("1.5")
    arguments = (pair.s, 8 * model.alpha * r, pair.c2)
    assert close(kernel(model, pair, AHEAD, distance), ahead(distance, *arguments))
    assert close(kernel(model, pair, BEHIND, distance), behind(-distance, *arguments))


@pytest.mark.parametrize("point", POINTS)
def test_the_characteristic_function_is_26_over_pi_squared(model: Track, point: tuple[float, float]) -> None:
    q = FIELD.context.mpc(*point)
    pair, d = pairing(model, q), model.positions[1]
    contact = kernel_at_contact(model, pair)
    K = ((contact, kernel(model, pair, BEHIND, d)), (kernel(model, pair, AHEAD, d), contact))
    derived = derived_determinant(2).lambdify()(q, model.eta_m, K)
    assert close(characteristic(model, q), derived / FIELD.pi**2)
