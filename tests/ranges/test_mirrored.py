"""Models next to q = 0 in two parts: each holds its function at complex points of the box."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from mpsolve.numbers.quadratic import Quadratic, pairs
from mpsolve.ranges.mirrored import at_zero, beside_zero


def own(u: Any) -> Any:
    """Re s on the real box: even in q."""
    return 0.3 + 0.5 * u[1] - 0.4 * u[2] + 0.2 * u[0] ** 2 + 0.1 * u[1] * u[2] + 0.01 * u[0] ** 2 * u[1]


def other(u: Any) -> Any:
    """Im s/u₀."""
    return 0.02 - 0.003 * u[1] + 0.004 * u[2] + 0.01 * u[0] ** 2 + 0.002 * u[1] ** 2


def model(noise: complex = 0.0) -> Quadratic:
    """Of own + i u₀ other, what is of third order in the rest; noise: of the constant."""
    k = np.zeros((10, 1), complex)
    terms = {
        (): 0.3 + noise,
        (0,): 0.02j,
        (1,): 0.5,
        (2,): -0.4,
        (0, 0): 0.2,
        (0, 1): -0.003j,
        (0, 2): 0.004j,
        (1, 2): 0.1,
    }
    order = [(), (0,), (1,), (2,), *pairs(3)]
    for key, value in terms.items():
        k[order.index(key)] = value
    return Quadratic(k, np.array([0.01 + 0.01 + 0.002 + abs(noise)]), 3)


def value(s: Quadratic, u: Any) -> Any:
    k = s.k[:, 0]
    return (
        k[0]
        + sum(k[1 + i] * u[i] for i in range(3))
        + sum(k[4 + n] * u[i] * u[j] for n, (i, j) in enumerate(pairs(3)))
    )


def points(number: int) -> Any:
    rng = np.random.default_rng(5)
    return np.sqrt(rng.uniform(size=(3, number))) * np.exp(2j * np.pi * rng.uniform(size=(3, number)))


@pytest.mark.parametrize("noise", [0.0, 0.005 + 0.01j])
def test_models_hold_their_functions(noise: complex) -> None:
    """On the complex polydisc, a function that is analytic there, for one λ."""
    s, u = model(noise), points(2000)
    beside, here = beside_zero(s), at_zero(s)
    times = beside.k[0, 0].imag / 0.02
    assert times > 1
    true = own(u) + 1j * times * other(u)
    assert (np.abs(value(beside, u) - true) <= beside.e).all()
    assert beside.e[0] < 1.01 * (1 + times) * s.e[0]
    still = u * np.array([[0], [1], [1]])
    assert (np.abs(value(here, still) - own(still)) <= here.e).all()


@pytest.mark.parametrize("part", [beside_zero, at_zero])
def test_what_is_read_from_another_place_does_not_hold(part: Callable[[Quadratic], Quadratic]) -> None:
    """Slopes that stand at the wrong variable are seen by the test above."""
    s = model()
    k = s.k[[0, 1, 3, 2, *range(4, 10)]]
    wrong, u = part(Quadratic(k, s.e, 3)), points(2000)
    true = own(u) + 1j * (wrong.k[0, 0].imag / 0.02) * other(u) if part is beside_zero else own(u)
    assert (np.abs(value(wrong, u) - true) > wrong.e).any()


def test_roots_at_zero_are_zeros_of_the_real_part_alone() -> None:
    """The other part vanishes at u₀ = 0 only."""
    here = at_zero(model())
    u = np.array([[0.1], [-0.6], [0.0]])
    assert value(here, u).imag[0] != 0
    assert value(here, u * np.array([[0], [1], [1]])).imag[0] == 0
