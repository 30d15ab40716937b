"""Taylor pieces with remainders against mpmath at 50 digits: they hold the truth, and they are not much wider."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.errors import PrecisionError
from mpsolve.numbers.jets import TINY, Jet, U, exponential, nearest, powers_up_to

MP = mpmath.MPContext()
MP.dps = 50
Function = Callable[[Any], Any]


def jet_of(rng: np.random.Generator, n: int, size: float, spread: float) -> tuple[Jet, list[Function]]:
    """n jets of shape (n, 1), and for each a quadratic polynomial that it holds with almost nothing to spare."""
    a, b, c = (rng.normal(size=(n, 1)) + 1j * rng.normal(size=(n, 1)) for _ in range(3))
    a, r = a * size, 10.0 ** rng.uniform(-6, 0, n)
    r[::4] = 0
    b, c = b * size * spread, c * size * spread**2
    e = np.abs(c) * (r * r)[:, None] * (1 + 1e-12)

    def quadratic(k: int) -> Function:
        return lambda t: MP.mpc(a[k, 0]) + MP.mpc(b[k, 0]) * t + MP.mpc(c[k, 0]) * t * t

    return Jet(a, b, e, r), [quadratic(k) for k in range(n)]


def excess(jet: Jet, k: int, f: Function) -> Any:
    """The largest of |f − a − b t| / e at points of the rim: above 1 the jet is wrong, far below it is too wide."""
    a, b, e = MP.mpc(jet.a[k].ravel()[0]), MP.mpc(jet.b[k].ravel()[0]), MP.mpf(float(jet.e[k].ravel()[0]))
    points = [MP.mpf(float(jet.r[k])) * MP.expj(2 * MP.pi * j / 16) for j in range(16)]
    off = max(abs(f(t) - a - b * t) for t in points)
    return off / e if off else off


OPERATIONS: dict[str, tuple[Callable[[Jet, Jet], Jet], Callable[[Function, Function], Function]]] = {
    "sum": (lambda f, g: f + g, lambda f, g: lambda t: f(t) + g(t)),
    "twice": (lambda f, _: f + f, lambda f, _: lambda t: 2 * f(t)),
    "number": (lambda f, _: f * 0.7 + (1.5 - 2j), lambda f, _: lambda t: f(t) * MP.mpf(0.7) + (1.5 - 2j)),
    "product": (lambda f, g: f * g, lambda f, g: lambda t: f(t) * g(t)),
    "inverse": (lambda f, _: f.inverse(), lambda f, _: lambda t: 1 / f(t)),
    "exponential": (lambda f, _: f.exp(), lambda f, _: lambda t: MP.exp(f(t))),
    "minus": (lambda f, _: -f, lambda f, _: lambda t: -f(t)),
}


@pytest.mark.parametrize("name", OPERATIONS)
@pytest.mark.parametrize("size", [1e-3, 0.1, 1.0, 30.0])
def test_an_operation_holds_its_truth_and_is_mostly_no_more_than_five_times_as_wide(name: str, size: float) -> None:
    make, truth = OPERATIONS[name]
    rng = np.random.default_rng(len(name) * 100 + int(size * 10))
    f, fs = jet_of(rng, 60, size, 0.2)
    g, gs = jet_of(rng, 60, 1.0, 0.2)
    g = Jet(g.a, g.b, 0 * g.e, f.r)
    gs = [(lambda t, k=k: MP.mpc(g.a[k, 0]) + MP.mpc(g.b[k, 0]) * t) for k in range(60)]
    got = make(f, g)
    bounded = [k for k in range(60) if np.isfinite(got.e[k, 0])]
    assert len(bounded) > 40
    ratios = [excess(got, k, truth(fs[k], gs[k])) for k in range(60)]
    assert np.median([float(ratios[k]) for k in bounded if got.r[k]]) > 0.2
    for k in bounded:
        ratio = ratios[k]
        assert ratio <= 1, (k, ratio)
        floor = 2e3 * max(1.0, size) * U * float(abs(truth(fs[k], gs[k])(0)) + abs(got.b[k, 0]) * got.r[k])
        if got.r[k] == 0 and name not in ("sum", "twice"):
            assert got.e[k, 0] <= floor + 1e-280


def test_a_thin_product_loses_a_few_units_in_the_last_place() -> None:
    rng = np.random.default_rng(5)
    f, fs = jet_of(rng, 400, 1.0, 0.0)
    f = Jet(f.a, f.b, 0 * f.e, 0 * f.r)
    both = f * f
    errors = [float(excess(both, k, lambda t, k=k: fs[k](t) ** 2)) for k in range(400)]
    assert max(errors) <= 1
    assert max(errors) > 0.05
    assert (both.e <= 10 * U * np.abs(both.a) + TINY * 2).all()


@pytest.mark.parametrize("size", [0.0, 1e-300, 1e-9, 0.05, 0.2, 0.25, 0.26, 0.5, 0.51, 1.0, 7.0, 80.0, 700.0])
def test_the_exponential_is_within_its_bound_at_every_size(size: float) -> None:
    z = size * np.exp(1j * np.linspace(0, 2 * np.pi, 40))
    value, relative = exponential(z)
    for k, point in enumerate(z):
        truth = MP.exp(MP.mpc(point))
        if abs(truth) > 1e-290 and np.isfinite(value[k]):
            assert abs(MP.mpc(value[k]) - truth) <= relative[k] * abs(truth)
            assert abs(MP.mpc(value[k]) - truth) <= relative[k] * abs(truth) / 8  # as its docstring says
    assert (relative <= 2.0**-46 * max(1.0, 4.1 * size)).all()


def test_a_batch_is_as_good_as_its_entries_alone() -> None:
    z = np.array([1e-3 + 1e-3j, 0.1j, -0.2])
    for point in z:
        assert abs(exponential(np.array([point]))[0][0] - np.exp(point)) < 1e-14


def test_what_underflows_stays_held() -> None:
    tiny = Jet(np.array([[1e-200 + 0j]]), np.array([[0j]]), np.zeros((1, 1)), np.zeros(1))
    assert (tiny * tiny).e[0, 0] >= 1e-290
    deep = Jet(np.array([[-800 + 3j]]), np.array([[1 + 0j]]), np.zeros((1, 1)), np.array([0.5]))
    got = deep.exp()
    assert got.a[0, 0] == 0
    assert got.e[0, 0] >= 1e-290
    assert (powers_up_to(np.array([1e-200]), 4) >= [1, 1e-200, TINY, TINY]).all()


@pytest.mark.parametrize("bad", [np.nan, np.inf, 1e200])
def test_what_is_not_finite_is_never_bounded(bad: float) -> None:
    f = Jet(np.array([[bad + 0j]]), np.array([[1j]]), np.zeros((1, 1)), np.array([1.0]))
    with np.errstate(all="ignore"):
        for got in (f * f, (f * f).inverse(), f.exp(), f * f + f * f, (f * f).exp()):
            assert not (np.isfinite(got.e) & np.isfinite(got.a)).all()


def test_a_function_that_may_vanish_has_no_bounded_inverse() -> None:
    f = Jet(np.array([[1.0 + 0j]]), np.array([[0.5j]]), np.array([[0.5]]), np.array([1.0]))
    assert f.inverse().e[0, 0] == np.inf
    assert Jet(f.a, 140j * f.a, 0 * f.e, f.r * 0.5).exp().e[0, 0] == np.inf


def test_a_product_of_matrices_holds_its_truth_and_is_not_wide() -> None:
    """Remainders at their largest: all entries positive, t = r."""
    rng = np.random.default_rng(7)
    a, b, e = (rng.uniform(0.1, 1, (4, 3, 5)) for _ in range(3))
    c, d, f = (rng.uniform(0.1, 1, (4, 5, 2)) for _ in range(3))
    r = np.array([0.0, 1e-8, 0.1, 1.0])
    got = Jet(a + 0j, b + 0j, 1e-3 * e, r) @ Jet(c + 0j, d + 0j, 1e-3 * f, r)
    for k in range(4):
        for i, j in np.ndindex(3, 2):
            t = MP.mpf(float(r[k]))
            left = [MP.mpf(float(a[k, i, m])) + MP.mpf(float(b[k, i, m])) * t for m in range(5)]
            right = [MP.mpf(float(c[k, m, j])) + MP.mpf(float(d[k, m, j])) * t for m in range(5)]
            most = sum(
                (x + MP.mpf(float(1e-3 * e[k, i, m]))) * (y + MP.mpf(float(1e-3 * f[k, m, j])))
                for m, (x, y) in enumerate(zip(left, right, strict=True))
            )
            line = MP.mpc(got.a[k, i, j]) + MP.mpc(got.b[k, i, j]) * t
            assert abs(most - line) <= float(got.e[k, i, j]) <= float(abs(most - line)) * (1 + 1e-9) + 1e-12


def test_a_thin_product_of_matrices_is_within_rounding() -> None:
    rng = np.random.default_rng(8)
    a, c = (rng.normal(size=(1, 4, 4)) + 1j * rng.normal(size=(1, 4, 4)) for _ in range(2))
    zero = np.zeros((1, 4, 4))
    got = Jet(a, 0 * a, zero, np.zeros(1)) @ Jet(c, 0 * c, zero, np.zeros(1))
    for i, j in np.ndindex(4, 4):
        truth = sum(MP.mpc(a[0, i, m]) * MP.mpc(c[0, m, j]) for m in range(4))
        assert abs(truth - MP.mpc(got.a[0, i, j])) <= float(got.e[0, i, j]) < 1e-12


def test_a_sum_over_an_axis_is_held() -> None:
    rng = np.random.default_rng(2)
    a = rng.normal(size=(3, 50)) + 1j * rng.normal(size=(3, 50))
    f = Jet(a, a[:, ::-1], np.abs(a) * 1e-9, np.array([0.0, 0.1, 1.0]))
    got = f.sum(1)
    for k in range(3):
        a_sum, b_sum = (sum(map(MP.mpc, x[k])) for x in (f.a, f.b))
        lost = abs(MP.mpc(got.a[k]) - a_sum) + abs(MP.mpc(got.b[k]) - b_sum) * float(f.r[k])
        assert float(sum(f.e[k])) + float(lost) <= got.e[k] <= 1.001 * float(sum(f.e[k])) + 1e-12


@given(st.fractions(), st.integers(-700, 700))
def test_the_nearest_float_is_near(x: Fraction, k: int) -> None:
    exact = x * Fraction(2) ** k
    assert abs(Fraction(nearest(exact)) - exact) <= Fraction(U) * abs(exact)


@pytest.mark.parametrize("x", [Fraction(10) ** 320, Fraction(1, 10**320), -(Fraction(10) ** 305)])
def test_a_number_far_from_1_is_refused(x: Fraction) -> None:
    with pytest.raises(PrecisionError, match="units"):
        nearest(x)


@pytest.mark.parametrize("length", [0.3, 1.0, 3.0, 20.0, 60.0])
def test_the_exponential_over_a_disc_of_any_size(length: float) -> None:
    """e^{a + bt} for |bt| ≤ length, at points of the disc, against cmath; far waves stay bounded, near ones tight."""
    rng = np.random.default_rng(int(length * 10))
    a = rng.uniform(-40, 1, 30) + 1j * rng.uniform(-30, 30, 30)
    b = np.exp(1j * rng.uniform(0, 6, 30)) * length
    r = np.ones(30)
    jet = Jet(a, b, np.zeros(30), r).exp()
    assert np.isfinite(jet.e).all()
    for t in np.exp(1j * np.linspace(0, 6, 25)):
        for k in range(30):
            left = cmath.exp(a[k] + b[k] * t) - jet.a[k] - jet.b[k] * t
            assert abs(left) <= jet.e[k] * (1 + 1e-12)
    assert (jet.e <= 1.5 * np.abs(np.exp(a)) * np.exp(length)).all()


def test_a_disc_that_is_far_too_large_is_not_bounded() -> None:
    jet = Jet(np.array([0j]), np.array([70 + 0j]), np.zeros(1), np.ones(1)).exp()
    assert jet.e[0] == np.inf
    mixed = Jet(np.array([0j, 0j]), np.array([70 + 0j, 0.5 + 0j]), np.zeros(2), np.ones(2)).exp()
    assert mixed.e[0] == np.inf
    assert mixed.e[1] < 0.2
