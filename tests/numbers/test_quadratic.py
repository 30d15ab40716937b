"""Taylor models hold the functions that they stand for, and their remainders are of third order."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from mpsolve.numbers.quadratic import Quadratic, constant, pairs

RNG = np.random.default_rng(7)
BOXES = 6


def model(m: int, size: float, shape: tuple[int, ...] = ()) -> Quadratic:
    count = 1 + m + len(pairs(m))
    k = RNG.normal(size=(count, BOXES, *shape)) + 1j * RNG.normal(size=(count, BOXES, *shape))
    k[1:] *= size
    k[1 + m :] *= size
    return Quadratic(k, np.zeros((BOXES, *shape)), m)


def value(f: Quadratic, u: Any) -> Any:
    monomials = [1.0, *u, *(u[i] * u[j] for i, j in pairs(f.m))]
    return sum(x * c for x, c in zip(monomials, f.k, strict=True))


def points(m: int) -> list[Any]:
    phases = np.exp(2j * np.pi * RNG.uniform(size=(20, m)))
    return [*RNG.uniform(-1, 1, size=(20, m)), *phases]  # complex ones on the border too


CASES: dict[str, tuple[Callable[..., Quadratic], Callable[..., Any]]] = {
    "sum": (lambda f, g: f + g, lambda x, y: x + y),
    "product": (lambda f, g: f * g, lambda x, y: x * y),
    "quotient": (lambda f, g: g * f.inverse(), lambda x, y: y / x),
    "exponential": (lambda f, g: f.exp() * g, lambda x, y: np.exp(x) * y),
    "multiple": (
        lambda f, g: f.times(np.arange(1.0, BOXES + 1)) + -g,
        lambda x, y: x * np.arange(1.0, BOXES + 1) - y,
    ),
}


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("m", [1, 2, 3])
@pytest.mark.parametrize("size", [1e-1, 1e-3])
def test_the_truth_is_inside(name: str, m: int, size: float) -> None:
    with_models, with_numbers = CASES[name]
    f, g = model(m, size), model(m, size)
    h = with_models(f, g)
    for u in points(m):
        off = np.abs(value(h, u) - with_numbers(value(f, u), value(g, u)))
        assert ((off <= h.e + 1e-14 * np.abs(h.a)) | ~np.isfinite(h.e)).all()  # where it is bounded


@pytest.mark.parametrize("name", ["product", "quotient", "exponential"])
def test_the_remainder_is_of_third_order(name: str) -> None:
    state = RNG.bit_generator.state
    widths = []
    for size in (1e-2, 1e-3):
        RNG.bit_generator.state = state
        widths.append(CASES[name][0](model(2, size), model(2, size)).e)
    assert (widths[0] < 2e4 * np.abs(widths[1]) + 1e-9).all()
    assert (widths[0] / widths[1] > 300).any()


def test_products_of_matrices_hold_the_truth() -> None:
    f, g = model(2, 0.1, (3, 2)), model(2, 0.1, (2, 4))
    h = f @ g
    for u in points(2):
        assert (np.abs(value(h, u) - value(f, u) @ value(g, u)) <= h.e + 1e-13).all()


def test_what_may_vanish_has_no_bounded_inverse() -> None:
    f = constant(np.array([0.0]), 2, 2)
    assert not np.isfinite(f.inverse().e).any()
