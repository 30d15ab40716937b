"""Discs of float64 hold every result, nothing is lost to rounding or underflow, and nan never looks proved."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve.discs import DiscField, Discs, exponential_quotient, where
from mpsolve.numbers.exact import Exact

mp = mpmath.MPContext()
mp.dps = 700  # what float64 spans, exactly
some = settings(max_examples=100)

parts = st.floats(-1, 1)
moderate = st.integers(-20, 20).map(lambda e: 10.0**e)
extreme = st.one_of(st.sampled_from([0.0, 5e-324, 1e-308, 1e308]), st.integers(-320, 307).map(lambda e: 10.0**e))
tame = st.tuples(parts, parts, moderate, st.one_of(st.just(0.0), moderate.map(lambda x: x * 1e-3)))
wild = st.tuples(parts, parts, extreme, extreme)


def disc(data: tuple[float, float, float, float]) -> Discs:
    """One disc in an array, as they are used."""
    x, y, size, r = data
    return Discs(np.array([complex(x * size, y * size)]), np.array([r]))


def points(z: Discs) -> list[Any]:
    """Points of the disc, exactly: the middle, and some of the border."""
    m, r = mp.mpc(complex(z.m[0])), mp.mpf(float(z.r[0]))
    inner = r * (1 - mp.mpf(2) ** -200)
    towards = [-m / abs(m)] if m else []
    return [m, *(m + inner * u for u in (1, -1, mp.j, mp.mpc(0.6, -0.8), *towards))]


def claims(z: Discs) -> bool:
    """Something is said about the result."""
    r = float(np.broadcast_to(z.r, z.m.shape)[0])
    return bool(np.isfinite(r) and np.isfinite(z.m[0]))


def holds(z: Discs, exact: Any) -> bool:
    if not claims(z):
        return not bool(z.nonzero()[0])
    return bool(abs(mp.mpc(complex(z.m[0])) - exact) <= mp.mpf(float(np.broadcast_to(z.r, z.m.shape)[0])))


binary = pytest.mark.parametrize(
    "apply", [lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b, lambda a, b: a / b]
)


@binary
@some
@given(st.one_of(tame, wild), st.one_of(tame, wild))
def test_four_operations(apply: Callable[[Any, Any], Any], a: Any, b: Any) -> None:
    a, b = disc(a), disc(b)
    with np.errstate(all="ignore"):
        result = apply(a, b)
        for u in points(a):
            for v in points(b):
                try:
                    assert holds(result, apply(u, v))
                except ZeroDivisionError:
                    assert not claims(result)


@binary
@some
@given(st.one_of(tame, wild), st.one_of(parts, extreme))
def test_exact_numbers_on_either_side(apply: Callable[[Any, Any], Any], a: Any, x: float) -> None:
    a = disc(a)
    for number in (x, complex(x, -x / 3), np.array([x]), np.array([complex(x, -x)])):
        exact = mp.mpc(complex(np.ravel(number)[0]))
        with np.errstate(all="ignore"):
            after, before = apply(a, number), apply(number, a)
        for u in points(a):
            for result, pair in ((after, (u, exact)), (before, (exact, u))):
                try:
                    with np.errstate(all="ignore"):
                        assert holds(result, apply(*pair))
                except ZeroDivisionError:
                    assert not claims(result)


@some
@given(st.one_of(tame, wild))
def test_bounds_of_the_modulus(a: Any) -> None:
    z = disc(a)
    with np.errstate(all="ignore"):
        lower, upper, apart = float(z.lower[0]), float(z.upper[0]), bool(z.nonzero()[0])
    sizes = [abs(u) for u in points(z)]
    assert all(size <= mp.mpf(upper) for size in sizes)
    assert np.isnan(lower) or all(mp.mpf(lower) <= size for size in sizes)
    assert apart == (lower > 0)
    if apart:
        assert mp.mpf(z.r[0]) < abs(mp.mpc(complex(z.m[0])))


@some
@given(st.one_of(tame, wild))
def test_square_roots_follow_one_branch(a: Any) -> None:
    z = disc(a)
    with np.errstate(all="ignore"):
        root = z.sqrt()
    middle = mp.sqrt(mp.mpc(complex(z.m[0])))
    if not claims(root):
        return
    assert z.nonzero()[0]
    start = min(middle, -middle, key=lambda s: abs(s - mp.mpc(complex(root.m[0]))))
    for u in points(z):
        branch = max(mp.sqrt(u), -mp.sqrt(u), key=lambda s: mp.re(s * mp.conj(start)))
        assert holds(root, branch)


def small_points(z: Discs) -> list[Any]:
    with mp.workdps(60):
        return [+u for u in points(z)]


exponents = st.tuples(
    parts, parts, st.one_of(st.integers(-30, 0).map(lambda e: 10.0**e), st.floats(0, 250)), st.floats(0, 1.2)
)
narrow = exponents.map(lambda e: (e[0], e[1], e[2], e[3] * 1e-12))
deep = st.floats(-1200, -200).map(lambda x: (1.0, 0.0, x, 0.5))


@settings(max_examples=150)
@given(st.one_of(exponents, narrow, deep))
def test_exponential(a: Any) -> None:
    z = disc(a)
    with np.errstate(all="ignore"):
        result = z.exp()
    assert claims(result) == (a[3] <= 1 and z.m[0].real < 230) or z.m[0].real > 229
    for u in small_points(z):
        with mp.workdps(60):
            assert holds(result, mp.exp(u))


@settings(max_examples=150)
@given(st.one_of(exponents, narrow, tame, deep))
def test_exponential_quotient(a: Any) -> None:
    z = disc(a)
    with np.errstate(all="ignore"):
        result = exponential_quotient(z)
    for u in small_points(z):
        with mp.workdps(60 + 2 * int(max(0, -mp.log10(abs(u) + mp.mpf(10) ** -300)))):
            assert holds(result, mp.expm1(u) / u if u else mp.one)


def test_results_stay_sharp() -> None:
    """The bounds are of use: a few hundred roundings wide, and the true spread of a wide disc."""
    rng = np.random.default_rng(3)
    a, b = (Discs(rng.normal(size=50) + 1j * rng.normal(size=50)) for _ in range(2))
    for result in (a + b, a * b, a / b, a.sqrt(), a.exp(), exponential_quotient(a)):
        assert np.all(result.r < 1e-11 * (1 + np.abs(result.m)))
    wide = Discs(b.m, 1e-3 * np.abs(b.m))
    assert np.all(wide.inverse().r < 1.01e-3 / np.abs(b.m))
    assert np.all(wide.sqrt().r < 0.501e-3 * np.sqrt(np.abs(b.m)))
    assert np.all((a * wide).r < 1.001e-3 * np.abs(a.m * b.m))
    near = exponential_quotient(Discs(np.zeros(1), 1e-3))
    assert near.r[0] < 4e-3
    assert abs(near.m[0] - 1) < 1e-15


def test_many_at_once_are_each_alone() -> None:
    """Halvings of the exponential are shared by an array, and a bad number does not spoil its neighbours."""
    z = Discs(np.array([0.3j, 2 - 40j, np.nan, np.inf, -600.0, 1e30]), np.array([0.0, 1e-9, 0, 0, 1.0, 0]))
    with np.errstate(all="ignore"):
        e = z.exp()
    for k in (0, 1):
        assert abs(complex(mp.exp(mp.mpc(complex(z.m[k])))) - e.m[k]) <= e.r[k] < 1e-6
    assert e.r[4] >= float(mp.exp(-599))
    assert np.all(np.isinf(e.r[[2, 3, 5]]))


@pytest.mark.parametrize("m", [1.0, np.nan, np.inf, 1e200, complex(1, np.nan), complex(np.inf, np.nan)])
@pytest.mark.parametrize("r", [0.0, 1.0, np.nan, np.inf, 1e300])
def test_what_is_not_bounded_proves_nothing(m: complex, r: float) -> None:
    """Neither `nonzero` nor a comparison of bounds is ever true of it, whatever comes after."""
    bad, good = Discs(np.array([m]), np.array([r])), Discs(np.array([2.0 - 1j]), np.array([0.1]))
    with np.errstate(all="ignore"):
        results = [bad.inverse(), bad.sqrt(), bad.exp(), exponential_quotient(bad), bad * bad]
        for other in (good, bad, 0.0, 3.0, 1j):
            results += [bad + other, bad - other, other - bad, bad * other, other / bad]
        results += [good / bad, where(np.array([True]), bad, good), bad[np.array([0])]]
        open_input = not (np.isfinite(m) and np.isfinite(r) and r < abs(m))
        for z in [bad, *results]:
            if not claims(z):
                assert not z.nonzero()[0]
                assert not z.lower[0] > 0
                assert not z.upper[0] < np.inf
        if open_input:
            assert not bad.nonzero()[0]
            assert not (bad.inverse().r < np.inf).any()
            assert not (bad.sqrt().r < np.inf).any()


@pytest.mark.parametrize(
    ("z", "r"),
    [(1e160, 1e170), (1e200, 0.9999e200), (1.2345e-160, 0), (1e-170, 0), (1e-140, 0.5e-140), (1e-131, 1e-132)],
)
def test_squares_that_leave_the_normal_numbers(z: float, r: float) -> None:
    """|m|² under- or overflows, so that |m| itself is not known from it."""
    a, unit = Discs(np.array([z + 0j]), np.array([r])), Discs(np.array([0j]), np.array([1.0]))
    with np.errstate(all="ignore"):
        assert holds(a * unit, mp.mpf(z))
        assert holds(a.inverse(), 1 / mp.mpf(z))
        assert holds(a.inverse(), 1 / (mp.mpf(z) + mp.mpf(r) / 2))
        assert not (r >= z and a.nonzero()[0])


@pytest.mark.parametrize("text", ["0", "1/3", "0.05", "root4(2)", "70", "1e-200", "123456789/7"])
def test_numbers_hold_the_exact_value(text: str) -> None:
    exact = Exact(text)
    z = DiscField().number(exact)
    assert abs(mp.mpf(complex(z.m).real) - exact.mpf(mp)) <= mp.mpf(float(z.r))
    assert float(z.r) <= 1e-14 * abs(float(exact)) + 1e-100


def test_pi_and_the_wave_of_a_field() -> None:
    field = DiscField()
    assert abs(mp.mpf(complex(field.pi.m).real) - mp.pi) <= mp.mpf(float(field.pi.r))
    z, x = Discs(np.array([0.7 + 0.4j, 1e-9, 30 + 9j, 0]), np.array([1e-3, 1e-3, 1e-6, 0])), 1.5
    wave = field.one_minus_exp(z, Discs(np.array(x)))
    for k in range(4):
        for turn in (0, 1, -1, 1j):
            p = mp.mpc(complex(z.m[k])) + mp.mpf(float(z.r[k])) * turn
            exact = (1 - mp.expj(p * x)) / p if p else -mp.j * x
            assert abs(mp.mpc(complex(wave.m[k])) - exact) <= mp.mpf(float(wave.r[k]))


anything = st.one_of(st.floats(allow_nan=True, allow_infinity=True), extreme)
sizes_of_all = st.tuples(anything, anything, st.one_of(st.floats(0), st.just(float("nan"))))


def sound(z: Discs) -> bool:
    """Every disc is bounded, with a finite middle, or has r = ∞."""
    r = np.broadcast_to(z.r, np.shape(z.m))
    return bool(np.all(np.where(np.isfinite(r), np.isfinite(z.m) & (r >= 0), r == np.inf)))


@settings(max_examples=400)
@given(sizes_of_all, sizes_of_all, st.one_of(anything, st.complex_numbers()))
def test_what_is_not_bounded_has_an_infinite_radius(a: Any, b: Any, number: complex) -> None:
    with np.errstate(all="ignore"):
        one, two = (Discs(np.array([complex(x, y)]), np.array([r])) for x, y, r in (a, b))
        results = [one, two, -one, one[np.array([0])], one + two, one - two, one * two, one / two, one.inverse()]
        results += [one.sqrt(), one.exp(), exponential_quotient(one), where(np.array([True]), one, two)]
        for exact in (number, np.array([number]), np.array([complex(number)])):
            results += [one + exact, exact + one, one - exact, exact - one, one * exact, exact * one]
            results += [one / exact, exact / one]
        results += [3 - one, 1e308 * one * 1e308, one * 0, (one * 1e308) * 0.0, one - one]
        assert all(sound(z) for z in results)
        assert not any(z.nonzero()[0] for z in results if z.r[0] == np.inf)


def test_a_product_that_overflows_is_not_bounded() -> None:
    with np.errstate(all="ignore"):
        for z in (
            Discs(np.array([1e75 + 0j])) * (-2.9e238 + 0j),
            Discs(np.array([1e75 + 0j])) * np.array([-2.9e238]),
        ):
            assert z.r[0] == np.inf
